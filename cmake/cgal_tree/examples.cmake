# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The examples in a tree of CGAL.

cmake_minimum_required(VERSION 3.16...3.29)
project(Anisotropic_hde_remeshing_Examples)

include(common.cmake)
if(NOT TARGET CGAL::Eigen3_support)
  return()
endif()

file(GLOB examples CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" *.cpp)
if(CGAL_VERSION VERSION_LESS 6.2)
  list(REMOVE_ITEM examples dual_contouring_example.cpp)
endif()
add_programs(${examples})
