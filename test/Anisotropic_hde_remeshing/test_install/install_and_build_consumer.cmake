# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Run by ctest as a script, with the variables set by CMakeLists.txt beside it.

cmake_minimum_required(VERSION 3.16)

function(run)
  list(JOIN ARGN " " command)
  message("-- ${command}")
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${PACKAGE_BINARY_DIR}" --config "${CONFIGURATION}" --prefix "${WORK_DIR}/prefix")
# the folder may be that of CGAL's headers: no file may take the place of one of CGAL's
file(GLOB_RECURSE headers RELATIVE "${WORK_DIR}/prefix/include" "${WORK_DIR}/prefix/include/*")
foreach(header IN LISTS headers)
  if(NOT header MATCHES "[Aa]nisotropic_hde_remeshing|[Rr]bf_implicit_function|rbf_surface_reconstruction|Radial_basis_functions")
    message(FATAL_ERROR "The name of an installed header is not the package's own: ${header}")
  endif()
endforeach()
if(EXISTS "${WORK_DIR}/prefix/bin/hde_remesh")
  run("${WORK_DIR}/prefix/bin/hde_remesh" --help)
endif()

run("${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${WORK_DIR}/consumer" -G "${GENERATOR}"
  "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${CXX_COMPILER_LAUNCHER}"
  "-DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=TRUE"
  "-DCMAKE_BUILD_TYPE=Debug"
  "-DCMAKE_CXX_FLAGS_DEBUG=-O0" # to compile quickly
  "-DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix"
  "-DCGAL_DIR=${CGAL_CONFIG_DIR}"
  "-DEXPECTS_COMPILED_LIBRARY=${WITH_COMPILED_LIBRARY}")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/consumer")
run("${WORK_DIR}/consumer/consumer")
run("${WORK_DIR}/consumer/without_target")
if(WITH_COMPILED_LIBRARY)
  run("${WORK_DIR}/consumer/consumer_of_compiled")
  run("${WORK_DIR}/consumer/consumer_of_compiled_static")
endif()
