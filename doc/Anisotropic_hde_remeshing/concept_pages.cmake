# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# A concept is a class for Doxygen 1.9. Here its page is said to be that of a concept, and the line that includes its header, which
# nobody can include, is taken out. Usage: cmake -DMANUAL_DIR=FOLDER -DCONCEPTS=FOLDER -P concept_pages.cmake

cmake_minimum_required(VERSION 3.16)

file(GLOB concepts RELATIVE "${CONCEPTS}" "${CONCEPTS}/*.h")
foreach(concept ${concepts})
  get_filename_component(concept "${concept}" NAME_WE)
  file(GLOB pages "${MANUAL_DIR}/class${concept}.html" "${MANUAL_DIR}/class${concept}_1_1*.html"
    "${MANUAL_DIR}/class${concept}-members.html")
  if(NOT pages)
    message(FATAL_ERROR "The manual has no page of the concept ${concept}")
  endif()
  foreach(page ${pages})
    file(READ "${page}" text)
    string(REGEX REPLACE "<p><code>#include [^\n]*${concept}[^\n]*</code></p>" "" text "${text}")
    string(REPLACE "${concept} Class Reference" "${concept} Concept Reference" text "${text}")
    file(WRITE "${page}" "${text}")
  endforeach()
endforeach()

set(page "${MANUAL_DIR}/group__PkgAnisotropicHdeRemeshingConcepts.html")
file(READ "${page}" text)
string(REPLACE "Classes</h2>" "Concepts</h2>" text "${text}")
string(REPLACE ">class &#160;<" ">concept &#160;<" text "${text}")
file(WRITE "${page}" "${text}")
