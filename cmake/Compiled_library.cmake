# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# The remesher and the solver in their usual types, compiled once and installed, for programs that are to compile quickly:
# Anisotropic_hde_remeshing::compiled, a shared library, and Anisotropic_hde_remeshing::compiled_static. To be included after the target
# of the headers is there.

add_library(compiled_objects OBJECT
  "${CMAKE_CURRENT_LIST_DIR}/shared_instantiations/parallel.cpp" "${CMAKE_CURRENT_LIST_DIR}/shared_instantiations/sequential.cpp")
target_link_libraries(compiled_objects PUBLIC Anisotropic_hde_remeshing::Anisotropic_hde_remeshing)
target_compile_definitions(compiled_objects PRIVATE CGAL_AHR_WITH_SHARED_INSTANTIATIONS)
set_target_properties(compiled_objects PROPERTIES POSITION_INDEPENDENT_CODE ON)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  # nobody replaces single functions of this library, so that they may call each other directly
  target_compile_options(compiled_objects PRIVATE -fno-semantic-interposition)
endif()

# add_compiled_library(NAME KIND): Anisotropic_hde_remeshing::NAME, STATIC or SHARED
function(add_compiled_library name kind)
  set(target "anisotropic_hde_remeshing_${name}")
  add_library(${target} ${kind} $<TARGET_OBJECTS:compiled_objects>)
  add_library(Anisotropic_hde_remeshing::${name} ALIAS ${target})
  # the target of the headers is not exported: the config file defines it and links to it
  target_link_libraries(${target} PUBLIC $<BUILD_INTERFACE:Anisotropic_hde_remeshing::Anisotropic_hde_remeshing>)
  target_compile_definitions(${target} PUBLIC CGAL_AHR_WITH_SHARED_INSTANTIATIONS)
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    LINKER_LANGUAGE CXX
    OUTPUT_NAME CGAL_anisotropic_hde_remeshing
    WINDOWS_EXPORT_ALL_SYMBOLS ON
    VERSION ${Anisotropic_hde_remeshing_VERSION}
    SOVERSION ${Anisotropic_hde_remeshing_VERSION_MAJOR}.${Anisotropic_hde_remeshing_VERSION_MINOR})
endfunction()

add_compiled_library(compiled SHARED)
add_compiled_library(compiled_static STATIC)
if(WIN32)
  # where a shared library has a .lib, too
  set_target_properties(anisotropic_hde_remeshing_compiled_static PROPERTIES OUTPUT_NAME CGAL_anisotropic_hde_remeshing_static)
endif()

if(CGAL_AHR_INSTALL)
  set(CGAL_AHR_INSTALL_LIBRARY_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/Anisotropic_hde_remeshing_compiled")
  install(TARGETS anisotropic_hde_remeshing_compiled anisotropic_hde_remeshing_compiled_static EXPORT compiled_library
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT library)
  install(EXPORT compiled_library NAMESPACE Anisotropic_hde_remeshing:: FILE Anisotropic_hde_remeshing_compiledTargets.cmake
    DESTINATION "${CGAL_AHR_INSTALL_LIBRARY_CMAKE_DIR}" COMPONENT library)

  set(CGAL_AHR_COMPILED_WITH_TBB OFF)
  if(CGAL_AHR_WITH_TBB AND TARGET CGAL::TBB_support)
    set(CGAL_AHR_COMPILED_WITH_TBB ON)
  endif()
  configure_file("${CMAKE_CURRENT_LIST_DIR}/Anisotropic_hde_remeshing_compiledConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/cmake/Anisotropic_hde_remeshing_compiledConfig.cmake" @ONLY)
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/cmake/Anisotropic_hde_remeshing_compiledConfigVersion.cmake"
    VERSION ${Anisotropic_hde_remeshing_VERSION} COMPATIBILITY ExactVersion)
  install(
    FILES
      "${PROJECT_BINARY_DIR}/cmake/Anisotropic_hde_remeshing_compiledConfig.cmake"
      "${PROJECT_BINARY_DIR}/cmake/Anisotropic_hde_remeshing_compiledConfigVersion.cmake"
    DESTINATION "${CGAL_AHR_INSTALL_LIBRARY_CMAKE_DIR}" COMPONENT library)
endif()
