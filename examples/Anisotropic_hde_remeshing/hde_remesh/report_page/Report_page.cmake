# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The page of --report: its parts are files in the sources, and one string in the program, in report_page_template.h.

set(report_page_dir "${CMAKE_CURRENT_LIST_DIR}")
set(report_page_scripts text histograms meshes camera painter views downloads gestures main) # in this order
set(report_page_parts page.html style.css ${report_page_scripts})
list(TRANSFORM report_page_parts REPLACE "^([a-z]+)$" "\\1.js")
list(TRANSFORM report_page_parts PREPEND "${report_page_dir}/")
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${report_page_parts})
endif()

file(READ "${report_page_dir}/page.html" report_page_html)
file(READ "${report_page_dir}/style.css" report_page_style)
string(REGEX REPLACE "^/[*][^*]*[*]/\n\n" "" report_page_style "${report_page_style}") # the page has a head of its own
string(REPLACE "@STYLE@" "${report_page_style}" report_page_html "${report_page_html}")
set(report_page_script "")
foreach(name IN LISTS report_page_scripts)
  file(READ "${report_page_dir}/${name}.js" text)
  string(REGEX REPLACE "^(//[^\n]*\n)+\n" "" text "${text}")
  string(APPEND report_page_script "${text}")
endforeach()
string(REPLACE "@SCRIPTS@" "${report_page_script}" report_page_html "${report_page_html}")
configure_file("${report_page_dir}/report_page_template.h.in"
  "${CMAKE_CURRENT_BINARY_DIR}/report_page/report_page_template.h" @ONLY)
