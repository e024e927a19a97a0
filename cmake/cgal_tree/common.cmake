# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# What a program of the package needs in a tree of CGAL. This file lies beside the CMakeLists.txt of the examples and of the tests.

find_package(CGAL REQUIRED)
find_package(Eigen3 QUIET)
include(CGAL_Eigen3_support)
find_package(TBB QUIET)
include(CGAL_TBB_support)
if(NOT TARGET CGAL::Eigen3_support)
  message(NOTICE "These programs need Eigen 3, and are not compiled.")
  return()
endif()

# add_programs(FILE...): each a program, and a test that runs it
function(add_programs)
  foreach(file IN LISTS ARGN)
    get_filename_component(name "${file}" NAME_WE)
    create_single_source_cgal_program("${file}")
    target_compile_features(${name} PRIVATE cxx_std_17)
    target_link_libraries(${name} PRIVATE CGAL::Eigen3_support)
    if(TARGET CGAL::TBB_support)
      target_link_libraries(${name} PRIVATE CGAL::TBB_support)
    endif()
  endforeach()
endfunction()
