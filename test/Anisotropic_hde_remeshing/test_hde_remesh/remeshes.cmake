# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

include("${CMAKE_CURRENT_LIST_DIR}/checks.cmake")

set(mesh "${MESHES}/hand.off")

expect_success(--help)
expect_success(--version)

# every format, out and back in
expect_success("${mesh}" out.off --iterations 2 --faces 1500 --json out.json)
foreach(extension IN ITEMS obj ply stl)
  expect_success(out.off out.${extension} --iterations 1 --quiet)
  expect_success(out.${extension} again.off --iterations 1 --quiet --no-distance)
endforeach()
foreach(file IN ITEMS out.off out.json out.obj out.ply out.stl again.off)
  if(NOT EXISTS "${WORK_DIR}/${file}")
    report("${file} was not written")
  endif()
endforeach()

# the same mesh for any number of threads
expect_success("${mesh}" one_thread.off --iterations 3 --threads 1 --quiet)
expect_success("${mesh}" two_threads.off --iterations 3 --threads 2 --quiet)
file(READ "${WORK_DIR}/one_thread.off" one_thread)
file(READ "${WORK_DIR}/two_threads.off" two_threads)
if(NOT one_thread STREQUAL two_threads)
  report("one thread and two threads make different meshes")
endif()
