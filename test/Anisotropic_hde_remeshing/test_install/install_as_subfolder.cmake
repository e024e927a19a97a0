# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Run by ctest as a script, with the variables set by CMakeLists.txt beside it. Installs the project in subfolder/, which has this
# package as a subfolder, without the package and with it. Nothing is compiled.

cmake_minimum_required(VERSION 3.16)

# install_project(NAME OPTION...): into the folder NAME; sets `installed` to the files
function(install_project name)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${PROJECT_DIR}" -B "${WORK_DIR}/build_${name}" -G "${GENERATOR}"
      "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}"
      "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
      "-DPACKAGE_SOURCE_DIR=${PACKAGE_SOURCE_DIR}"
      "-DCGAL_DIR=${CGAL_CONFIG_DIR}"
      ${ARGN}
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "the project cannot be configured (${result})")
  endif()
  execute_process(
    COMMAND "${CMAKE_COMMAND}" --install "${WORK_DIR}/build_${name}" --prefix "${WORK_DIR}/${name}"
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "the project cannot be installed (${result})")
  endif()
  file(GLOB_RECURSE files RELATIVE "${WORK_DIR}/${name}" "${WORK_DIR}/${name}/*")
  set(installed "${files}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
install_project(without)
if(NOT installed STREQUAL "share/own.txt")
  message(FATAL_ERROR "More is installed than what is the project's own: ${installed}")
endif()
install_project(with -DCGAL_AHR_INSTALL=ON)
foreach(file IN ITEMS share/own.txt include/CGAL/anisotropic_hde_remeshing.h)
  if(NOT file IN_LIST installed)
    message(FATAL_ERROR "${file} is not installed where the package is asked for: ${installed}")
  endif()
endforeach()
