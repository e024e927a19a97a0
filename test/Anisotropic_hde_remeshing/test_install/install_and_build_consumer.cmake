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

# CMake drops /usr/include from the command line, and with it the order that is to be tested. So a CGAL that lies there
# is seen through links from a folder elsewhere, which CMake passes by -isystem like that of any other installation.
function(link_to_cgal config_dir result_name)
  set(${result_name} "${config_dir}" PARENT_SCOPE)
  if(config_dir MATCHES "^/usr/" AND EXISTS /usr/include/CGAL/config.h)
    file(MAKE_DIRECTORY "${WORK_DIR}/cgal/include" "${WORK_DIR}/cgal/lib/cmake")
    file(CREATE_LINK /usr/include/CGAL "${WORK_DIR}/cgal/include/CGAL" SYMBOLIC)
    file(CREATE_LINK "${config_dir}" "${WORK_DIR}/cgal/lib/cmake/CGAL" SYMBOLIC)
    set(${result_name} "${WORK_DIR}/cgal/lib/cmake/CGAL" PARENT_SCOPE)
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
link_to_cgal("${CGAL_CONFIG_DIR}" cgal_dir)

run("${CMAKE_COMMAND}" --install "${PACKAGE_BINARY_DIR}" --config "${CONFIGURATION}" --prefix "${WORK_DIR}/prefix")
if(EXISTS "${WORK_DIR}/prefix/include/CGAL")
  message(FATAL_ERROR "The headers were installed where they hide CGAL's: ${WORK_DIR}/prefix/include/CGAL")
endif()
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
  "-DCGAL_DIR=${cgal_dir}")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/consumer")
run("${WORK_DIR}/consumer/package_linked_first")
run("${WORK_DIR}/consumer/CGAL_linked_first")
