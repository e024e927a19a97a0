# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Finds the folder of CGAL's meshes and lets CGAL::data_file_path("meshes/...") read from it. The folder is that of the
# variable CGAL_DATA_DIR, which CGAL sets where its data lie next to it, or else unpacked from the archive in Debian's
# package libcgal-demo.

function(cgal_ahr_unpack_data archives)
  foreach(archive IN LISTS archives)
    execute_process(
      COMMAND "${CMAKE_COMMAND}" -E tar xf "${archive}" data/meshes data/points_3
      WORKING_DIRECTORY "${PROJECT_BINARY_DIR}"
      RESULT_VARIABLE result)
    if(result EQUAL 0 AND EXISTS "${PROJECT_BINARY_DIR}/data/meshes/bunny00.off")
      message(STATUS "Unpacked CGAL's meshes from ${archive}")
      return()
    endif()
  endforeach()
endfunction()

if(NOT EXISTS "${CGAL_DATA_DIR}/meshes/bunny00.off")
  set(CGAL_DATA_DIR "${PROJECT_BINARY_DIR}/data")
  if(NOT EXISTS "${CGAL_DATA_DIR}/meshes/bunny00.off" OR NOT EXISTS "${CGAL_DATA_DIR}/points_3/kitten.xyz")
    file(GLOB data_archives
      "/usr/share/doc/libcgal*/data.tar*"
      "${PROJECT_BINARY_DIR}/libcgal-demo/usr/share/doc/libcgal*/data.tar*") # where scripts/ put it on a Debian without doc
    cgal_ahr_unpack_data("${data_archives}")
  endif()
endif()

if(EXISTS "${CGAL_DATA_DIR}/meshes/bunny00.off")
  message(STATUS "CGAL's meshes: ${CGAL_DATA_DIR}/meshes")
  # for scripts, which read it from the cache
  set(CGAL_AHR_DATA_DIR "${CGAL_DATA_DIR}" CACHE INTERNAL "The folder of CGAL's data files")
  add_compile_definitions("CGAL_DATA_DIR=\"${CGAL_DATA_DIR}\"")
else()
  message(WARNING "CGAL's meshes were not found, tests that read them will fail. Install Debian's libcgal-demo or set "
    "CGAL_DATA_DIR to the folder data of CGAL's release.")
endif()
