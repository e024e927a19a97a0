# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# What most examples and tests have in common, compiled once: the headers of others, and the remesher and the solver in their usual
# types. share_compilation(TARGET) lets a program have part in it.

# The package's own headers would have them compiled anew at every change.
set(precompiled_headers
  <CGAL/Exact_predicates_inexact_constructions_kernel.h>
  <CGAL/Surface_mesh.h>
  <CGAL/AABB_tree.h>
  <CGAL/Orthogonal_k_neighbor_search.h>
  <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
  <CGAL/Polygon_mesh_processing/detect_features.h>
  <CGAL/hilbert_sort.h>
  <Eigen/Dense>
  <Eigen/Sparse>
  <boost/geometry/algorithms/covered_by.hpp>
  <boost/geometry/algorithms/intersects.hpp>
  <boost/geometry/geometries/box.hpp>
  <boost/geometry/geometries/point.hpp>
  <boost/geometry/index/rtree.hpp>
  <boost/geometry/strategies/strategies.hpp>)
if(CGAL_AHR_WITH_TBB AND TARGET CGAL::TBB_support)
  list(APPEND precompiled_headers <tbb/parallel_for.h> <tbb/parallel_sort.h>)
endif()

# compile_quickly(TARGET): with little optimisation, where CGAL_AHR_WITH_QUICK_COMPILATION asks for it. Half of the time of a compiler
# goes into the rest, and the shared instantiations, in which programs spend most of theirs, have all of it.
function(compile_quickly target)
  if(CGAL_AHR_WITH_QUICK_COMPILATION AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

set(instantiations_dir "${CMAKE_CURRENT_LIST_DIR}/shared_instantiations")
set(parallel_instantiations "${instantiations_dir}/parallel.cpp")
set(sequential_instantiations "${instantiations_dir}/sequential.cpp")

# add_precompiled_headers(TARGET): what has them compiled; they are for one level of optimisation
function(add_precompiled_headers target)
  file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/${target}.cpp" CONTENT "// nothing but the precompiled headers\n")
  add_library(${target} OBJECT EXCLUDE_FROM_ALL "${PROJECT_BINARY_DIR}/${target}.cpp")
  target_link_libraries(${target} PRIVATE Anisotropic_hde_remeshing::Anisotropic_hde_remeshing)
  target_compile_definitions(${target} PRIVATE CGAL_AHR_WITH_SHARED_INSTANTIATIONS)
  target_precompile_headers(${target} PRIVATE ${precompiled_headers})
endfunction()

if(CGAL_AHR_WITH_SHARED_COMPILATION)
  add_precompiled_headers(optimised_headers)
  add_precompiled_headers(quick_headers)
  compile_quickly(quick_headers)

  if(CGAL_AHR_WITH_COMPILED_LIBRARY)
    # the library is that of the installation
    add_library(shared_instantiations INTERFACE)
    target_link_libraries(shared_instantiations INTERFACE Anisotropic_hde_remeshing::compiled_static)
    add_library(sequential_instantiations INTERFACE)
    target_link_libraries(sequential_instantiations INTERFACE shared_instantiations)
  else()
    add_library(shared_instantiations STATIC EXCLUDE_FROM_ALL ${parallel_instantiations})
    target_link_libraries(shared_instantiations PUBLIC Anisotropic_hde_remeshing::Anisotropic_hde_remeshing)
    target_compile_definitions(shared_instantiations PUBLIC CGAL_AHR_WITH_SHARED_INSTANTIATIONS)
    target_precompile_headers(shared_instantiations REUSE_FROM optimised_headers)
    add_library(sequential_instantiations STATIC EXCLUDE_FROM_ALL ${sequential_instantiations})
    target_link_libraries(sequential_instantiations PUBLIC shared_instantiations)
    target_precompile_headers(sequential_instantiations REUSE_FROM optimised_headers)
  endif()
endif()

# share_instantiations(TARGET [PARALLEL] [OTHER_TYPES]): PARALLEL if it calls nothing with Sequential_tag; OTHER_TYPES if it has kernels,
# embeddings or metrics other than those that are compiled here
function(share_instantiations target)
  if(TARGET shared_instantiations)
    if("PARALLEL" IN_LIST ARGN AND CGAL_AHR_WITH_TBB AND TARGET CGAL::TBB_support)
      target_link_libraries(${target} PRIVATE shared_instantiations)
    else()
      target_link_libraries(${target} PRIVATE sequential_instantiations)
    endif()
    if("OTHER_TYPES" IN_LIST ARGN)
      target_compile_definitions(${target} PRIVATE CGAL_AHR_WITH_OTHER_TYPES)
    endif()
  endif()
endfunction()

# share_compilation(TARGET [PARALLEL] [OTHER_TYPES] [QUICK]): QUICK if it may be compiled quickly
function(share_compilation target)
  share_instantiations(${target} ${ARGN})
  set(headers optimised_headers)
  if("QUICK" IN_LIST ARGN)
    compile_quickly(${target})
    set(headers quick_headers)
  endif()
  if(TARGET ${headers})
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endif()
endfunction()
