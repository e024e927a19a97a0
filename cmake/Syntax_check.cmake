# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The target syntax_check compiles all programs, but writes no code, which takes most of the time: templates are instantiated, so
# that it finds all that does not compile. scripts/build_elsewhere.sh does so with other compilers and versions of CGAL.
# syntax_check_examples, _hde_remesh, _tests, _benchmarks are its parts.

add_custom_target(syntax_check)

# add_syntax_check(TARGET SOURCE...)
function(add_syntax_check target)
  add_library(${target} OBJECT EXCLUDE_FROM_ALL ${ARGN})
  target_link_libraries(${target} PRIVATE Anisotropic_hde_remeshing::Anisotropic_hde_remeshing)
  # the programs' common instantiations are made once, in shared_instantiations/; what others need is in the precompiled headers
  target_compile_definitions(${target} PRIVATE CGAL_AHR_WITH_SHARED_INSTANTIATIONS CGAL_AHR_WITH_OTHER_TYPES)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE -fsyntax-only)
  endif()
endfunction()

# check_syntax_of(PART PROGRAM...): as parts of the target syntax_check_PART, each with its own macros, folders and libraries
function(check_syntax_of part)
  add_custom_target(syntax_check_${part})
  add_dependencies(syntax_check syntax_check_${part})
  foreach(program IN LISTS ARGN)
    get_target_property(sources ${program} SOURCES)
    add_syntax_check(syntax_of_${program} ${sources})
    foreach(property IN ITEMS INCLUDE_DIRECTORIES COMPILE_DEFINITIONS LINK_LIBRARIES)
      get_target_property(values ${program} ${property})
      # nothing is linked
      list(FILTER values EXCLUDE REGEX "_instantiations$")
      if(values)
        set_property(TARGET syntax_of_${program} APPEND PROPERTY ${property} ${values})
      endif()
    endforeach()
    # not the examples, which show whether they include what they use, of the CGAL that includes least by itself
    if(NOT part STREQUAL examples OR CGAL_VERSION VERSION_LESS 6.2)
      target_precompile_headers(syntax_of_${program} REUSE_FROM syntax_check_headers)
    endif()
    add_dependencies(syntax_check_${part} syntax_of_${program})
  endforeach()
endfunction()

# what these have in common, which is compiled
file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/syntax_check_headers.cpp" CONTENT "// nothing but the precompiled headers\n")
add_library(syntax_check_headers OBJECT EXCLUDE_FROM_ALL "${PROJECT_BINARY_DIR}/syntax_check_headers.cpp")
target_link_libraries(syntax_check_headers PRIVATE Anisotropic_hde_remeshing::Anisotropic_hde_remeshing)
target_compile_definitions(syntax_check_headers PRIVATE CGAL_AHR_WITH_SHARED_INSTANTIATIONS CGAL_AHR_WITH_OTHER_TYPES)
target_precompile_headers(syntax_check_headers PRIVATE ${precompiled_headers} <CGAL/anisotropic_hde_remeshing.h>)

add_syntax_check(syntax_check_instantiations ${parallel_instantiations} ${sequential_instantiations})
target_precompile_headers(syntax_check_instantiations REUSE_FROM syntax_check_headers)
add_dependencies(syntax_check syntax_check_instantiations)
