# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Finds what the package needs beside CGAL and links it. Used by the package's own build and by its config file, so that
# both are set up in one way. To be included after find_package(CGAL). Where something necessary is missing,
# CGAL_AHR_MISSING says what.

set(CGAL_AHR_MISSING "")
if(CGAL_VERSION VERSION_LESS 5.5)
  # not left to find_package, as CGAL 6 does not declare itself compatible with a request for 5.5
  set(CGAL_AHR_MISSING "Anisotropic_hde_remeshing needs CGAL 5.5 or newer, not ${CGAL_VERSION}.")
endif()

# CGAL's support files make the targets CGAL::Eigen3_support and CGAL::TBB_support of what has been found.
find_package(Eigen3 QUIET)
include(CGAL_Eigen3_support)
if(NOT TARGET CGAL::Eigen3_support)
  set(CGAL_AHR_MISSING "Anisotropic_hde_remeshing needs Eigen 3 (Debian: libeigen3-dev).")
endif()

if(CGAL_AHR_WITH_TBB)
  find_package(TBB QUIET)
  include(CGAL_TBB_support)
  if(NOT TARGET CGAL::TBB_support)
    message(STATUS "Anisotropic_hde_remeshing: TBB was not found, the package runs sequentially.")
  endif()
endif()

function(anisotropic_hde_remeshing_setup_target target)
  target_compile_features(${target} INTERFACE cxx_std_17)
  target_link_libraries(${target} INTERFACE CGAL::CGAL CGAL::Eigen3_support)
  if(CGAL_AHR_WITH_TBB AND TARGET CGAL::TBB_support)
    target_link_libraries(${target} INTERFACE CGAL::TBB_support)
  endif()
endfunction()
