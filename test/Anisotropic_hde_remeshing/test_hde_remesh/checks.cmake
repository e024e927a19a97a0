# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Checks for the scripts beside this file, which include it.

cmake_minimum_required(VERSION 3.16)

file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")

# report(MESSAGE): goes on, so that one failure does not hide another; the script fails at its end
function(report message)
  message(SEND_ERROR "${message}")
endfunction()

# run_hde_remesh(ARGUMENT...): in WORK_DIR; sets `status`, `output` and `errors`
macro(run_hde_remesh)
  execute_process(
    COMMAND "${HDE_REMESH}" ${ARGN}
    WORKING_DIRECTORY "${WORK_DIR}"
    RESULT_VARIABLE status
    OUTPUT_VARIABLE output
    ERROR_VARIABLE errors)
endmacro()

# expect_success(ARGUMENT...)
macro(expect_success)
  run_hde_remesh(${ARGN})
  if(NOT status EQUAL 0)
    report("hde_remesh ${ARGN}\nexit status ${status}\n${output}${errors}")
  endif()
endmacro()

# expect_failure(STATUS REGEX ARGUMENT...): that exit status, and one line of error that matches
function(expect_failure expected_status regex)
  run_hde_remesh(${ARGN})
  string(REGEX MATCHALL "\n" line_ends "${errors}")
  list(LENGTH line_ends number_of_lines)
  if(NOT status EQUAL expected_status OR NOT errors MATCHES "${regex}" OR NOT number_of_lines EQUAL 1)
    report("hde_remesh ${ARGN}\nwanted: exit status ${expected_status}, one line that matches ${regex}\n
got: exit status ${status}, ${errors}")
  endif()
endfunction()
