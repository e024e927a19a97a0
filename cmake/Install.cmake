# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Installs the headers and the config package.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Next to CGAL's headers: no file here has the name of one of CGAL's.
set(CGAL_AHR_INSTALL_INCLUDE_DIR "${CMAKE_INSTALL_INCLUDEDIR}")
set(CGAL_AHR_INSTALL_CMAKE_DIR "${CMAKE_INSTALL_DATADIR}/cmake/Anisotropic_hde_remeshing")

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/Anisotropic_hde_remeshingConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/cmake/Anisotropic_hde_remeshingConfig.cmake"
  INSTALL_DESTINATION "${CGAL_AHR_INSTALL_CMAKE_DIR}"
  PATH_VARS CGAL_AHR_INSTALL_INCLUDE_DIR
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/cmake/Anisotropic_hde_remeshingConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)

install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/CGAL" DESTINATION "${CGAL_AHR_INSTALL_INCLUDE_DIR}" COMPONENT headers)
install(
  FILES
    "${PROJECT_BINARY_DIR}/cmake/Anisotropic_hde_remeshingConfig.cmake"
    "${PROJECT_BINARY_DIR}/cmake/Anisotropic_hde_remeshingConfigVersion.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/Anisotropic_hde_remeshing_target.cmake"
  DESTINATION "${CGAL_AHR_INSTALL_CMAKE_DIR}" COMPONENT headers)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT headers)
