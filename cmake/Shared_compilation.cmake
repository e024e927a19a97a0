# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# What most examples and tests have in common, compiled once: the headers of others, and the remesher and the solver in their usual
# types. share_compilation(TARGET) lets a program have part in it.

if(CGAL_AHR_WITH_SHARED_COMPILATION)
  add_library(shared_instantiations STATIC EXCLUDE_FROM_ALL "${CMAKE_CURRENT_LIST_DIR}/shared_instantiations.cpp")
  target_link_libraries(shared_instantiations PUBLIC Anisotropic_hde_remeshing::Anisotropic_hde_remeshing)
  target_compile_definitions(shared_instantiations PUBLIC CGAL_AHR_WITH_SHARED_INSTANTIATIONS)
  # The package's own headers would have them compiled anew at every change.
  target_precompile_headers(shared_instantiations PRIVATE
    <CGAL/Exact_predicates_inexact_constructions_kernel.h>
    <CGAL/Surface_mesh.h>
    <CGAL/AABB_tree.h>
    <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
    <Eigen/Dense>)
endif()

function(share_compilation target)
  if(TARGET shared_instantiations)
    target_link_libraries(${target} PRIVATE shared_instantiations)
    target_precompile_headers(${target} REUSE_FROM shared_instantiations)
  endif()
endfunction()
