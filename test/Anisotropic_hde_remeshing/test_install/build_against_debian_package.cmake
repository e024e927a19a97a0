# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Packs the headers, unpacks them and builds the program of the README, its source and its CMakeLists.txt as they stand there.

cmake_minimum_required(VERSION 3.16)

function(run)
  list(JOIN ARGN " " command)
  message("-- ${command}")
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()

# write_block(LANGUAGE FILE): the first block of code of the README in a language
function(write_block language file)
  set(fence "```")
  file(READ "${README}" text)
  string(FIND "${text}" "${fence}${language}\n" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "README.md has no block of ${language}")
  endif()
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "\n" end_of_line)
  math(EXPR end_of_line "${end_of_line} + 1")
  string(SUBSTRING "${text}" ${end_of_line} -1 text)
  string(FIND "${text}" "${fence}" end)
  string(SUBSTRING "${text}" 0 ${end} text)
  file(WRITE "${file}" "${text}")
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")
# CPack builds all targets first where the generator is that of Makefiles; the headers need none
run("${CPACK}" --config "${PACKAGE_BINARY_DIR}/CPackConfig.cmake" -G DEB -C "${CONFIGURATION}" -B "${WORK_DIR}"
  -D CPACK_COMPONENTS_ALL=headers -D CPACK_CMAKE_GENERATOR=Ninja)
file(GLOB package "${WORK_DIR}/libcgal-anisotropic-hde-remeshing-dev_*_all.deb")
if(NOT package)
  message(FATAL_ERROR "CPack made no package of that name in ${WORK_DIR}")
endif()
run("${DPKG_DEB}" --info "${package}")
run("${DPKG_DEB}" --extract "${package}" "${WORK_DIR}/root")

write_block(cpp "${WORK_DIR}/program/remesh_example.cpp")
write_block(cmake "${WORK_DIR}/program/CMakeLists.txt")
run("${CMAKE_COMMAND}" -S "${WORK_DIR}/program" -B "${WORK_DIR}/build"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${CXX_COMPILER_LAUNCHER}"
  "-DCMAKE_BUILD_TYPE=Release"
  "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG" # to compile quickly
  "-DCMAKE_PREFIX_PATH=${WORK_DIR}/root/usr"
  "-DCGAL_DIR=${CGAL_CONFIG_DIR}")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
