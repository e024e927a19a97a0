# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The tests in a tree of CGAL: those of the headers.

cmake_minimum_required(VERSION 3.16...3.29)
project(Anisotropic_hde_remeshing_Tests)

include(common.cmake)
if(NOT TARGET CGAL::Eigen3_support)
  return()
endif()

file(GLOB tests CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" test_*.cpp)
add_programs(${tests})
