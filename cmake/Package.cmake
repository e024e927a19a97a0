# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Debian packages of the headers, of the compiled library and of the program: cmake --build BUILD_DIR --target package. The archive of
# the sources that is released: cmake --build BUILD_DIR --target package_source. To be included after all that is installed.

set(package_info "${PROJECT_SOURCE_DIR}/package_info/Anisotropic_hde_remeshing")
file(STRINGS "${package_info}/description.txt" CPACK_PACKAGE_DESCRIPTION_SUMMARY LIMIT_COUNT 1)
file(READ "${package_info}/long_description.txt" CPACK_PACKAGE_DESCRIPTION)
file(STRINGS "${package_info}/maintainer" CPACK_PACKAGE_CONTACT LIMIT_COUNT 1)
set(CPACK_PACKAGE_VENDOR "${CPACK_PACKAGE_CONTACT}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL headers)

# a package's description is that of its component
set(CPACK_COMPONENT_HEADERS_DESCRIPTION
  "${CPACK_PACKAGE_DESCRIPTION}\nThis package holds the headers, and what find_package() of CMake reads.")
set(CPACK_DEBIAN_HEADERS_PACKAGE_NAME libcgal-anisotropic-hde-remeshing-dev)
set(CPACK_DEBIAN_HEADERS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_HEADERS_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev")
set(CPACK_DEBIAN_HEADERS_PACKAGE_RECOMMENDS libtbb-dev)

if(CGAL_AHR_WITH_COMPILED_LIBRARY)
  list(APPEND CPACK_COMPONENTS_ALL library)
  set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
    "${CPACK_PACKAGE_DESCRIPTION}\nThis package holds the compiled library, shared and static, for programs that are to compile quickly.")
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libcgal-anisotropic-hde-remeshing-compiled-dev)
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
  # the library is for the version of CGAL that it was compiled with
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "libcgal-anisotropic-hde-remeshing-dev (= ${Anisotropic_hde_remeshing_VERSION}), libcgal-dev (>= ${CGAL_VERSION})")
  if(CGAL_AHR_COMPILED_WITH_TBB)
    string(APPEND CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS ", libtbb-dev")
  endif()
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
endif()

if(TARGET hde_remesh)
  list(APPEND CPACK_COMPONENTS_ALL program)
  set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}\nThis package holds the program hde_remesh.")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME hde-remesh)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
endif()

configure_file("${CMAKE_CURRENT_LIST_DIR}/copyright.in" copyright @ONLY)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER "${component}" name)
  install(FILES "${PROJECT_BINARY_DIR}/copyright" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME}"
    COMPONENT "${component}" EXCLUDE_FROM_ALL)
endforeach()

# what a clone has, without what git and builds leave
set(CPACK_SOURCE_GENERATOR TXZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME "Anisotropic_hde_remeshing-${Anisotropic_hde_remeshing_VERSION}")
set(CPACK_SOURCE_IGNORE_FILES "/build[^/]*/" "/[.]git" "/[.]ci/" "/[.]cache/" "/[.]clangd/" "/compile_commands[.]json$" "[.]orig$"
  "[.]swp$" "~$")

include(CPack)
