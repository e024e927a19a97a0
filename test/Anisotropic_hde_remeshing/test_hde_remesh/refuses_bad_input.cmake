# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

include("${CMAKE_CURRENT_LIST_DIR}/checks.cmake")

set(mesh "${MESHES}/hand.off")
file(WRITE "${WORK_DIR}/out.off" "as it was")

# what cannot be understood
expect_failure(2 "OUT" in.off)
expect_failure(2 "--unknown" "${mesh}" out.off --unknown)
expect_failure(2 "--faces" "${mesh}" out.off --faces many)
expect_failure(2 "--kernel" "${mesh}" out.off --kernel cubic)
expect_failure(2 "--length" "${mesh}" out.off --length 1 --faces 100)

# values
expect_failure(1 "--faces.* 0" "${mesh}" out.off --faces 0)
expect_failure(1 "--length.* -1" "${mesh}" out.off --length=-1)
expect_failure(1 "--sigma.* nan" "${mesh}" out.off --sigma nan)
expect_failure(1 "--threads.* 0" "${mesh}" out.off --threads 0)

# files
file(WRITE "${WORK_DIR}/empty.off" "")
file(WRITE "${WORK_DIR}/no_faces.off" "OFF\n0 0 0\n")
file(WRITE "${WORK_DIR}/quad.off" "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
file(WRITE "${WORK_DIR}/nan.off" "OFF\n4 2 0\n0 0 0\n1 0 nan\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n")
file(WRITE "${WORK_DIR}/infinite.off" "OFF\n4 2 0\n0 0 0\n1 0 inf\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n")
foreach(name IN ITEMS missing empty no_faces quad nan infinite)
  expect_failure(1 "${name}\\.off" ${name}.off out.off)
endforeach()
expect_failure(1 "mesh\\.unknown" mesh.unknown out.off)
expect_failure(1 "out\\.unknown" "${mesh}" out.unknown)
expect_failure(1 "no_such_folder" "${mesh}" no_such_folder/out.off --iterations 1)

file(READ "${WORK_DIR}/out.off" left)
if(NOT left STREQUAL "as it was")
  report("out.off was changed by a run that failed")
endif()
file(GLOB files RELATIVE "${WORK_DIR}" "${WORK_DIR}/*" "${WORK_DIR}/.*")
list(SORT files)
if(NOT files STREQUAL "empty.off;infinite.off;nan.off;no_faces.off;out.off;quad.off")
  report("files left behind: ${files}")
endif()
