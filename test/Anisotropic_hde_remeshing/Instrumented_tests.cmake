# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Tests under tools that find what checks do not, a ctest label each: `address` (AddressSanitizer and UBSan), `thread`
# (ThreadSanitizer), `fuzz` (libFuzzer, with both of the first), `memcheck` (valgrind), and `elsewhere` (other compilers and
# versions of CGAL). They take minutes to compile. The fuzzers run some thousand inputs, the same each time, or
# CGAL_AHR_FUZZING_SECONDS on other ones each time. With CGAL_AHR_WITH_LONG_TESTS there are larger ones, labelled `long`, too.

set(CGAL_AHR_FUZZING_SECONDS 0 CACHE STRING "how long each fuzzer runs, in seconds; 0: on the same inputs each time")

# not what CGAL and Boost do on purpose: references to elements that are not there, casts within hierarchies of traits
set(undefined_behaviour
  bounds,integer-divide-by-zero,float-cast-overflow,shift,signed-integer-overflow,return,bool,enum,unreachable)

# Clang's programs under sanitizers take less time than GCC's, to compile, too: it makes them, whichever compiler makes the rest.
find_program(CGAL_AHR_CLANG clang++)
get_target_property(eigen_folders CGAL::Eigen3_support INTERFACE_INCLUDE_DIRECTORIES)
set(clang_folders "${PROJECT_SOURCE_DIR}/include" "${CMAKE_CURRENT_SOURCE_DIR}" ${CGAL_INCLUDE_DIRS} ${eigen_folders})
list(FILTER clang_folders EXCLUDE REGEX "^(/usr/include|.*[$]<.*)$")
list(TRANSFORM clang_folders PREPEND -I)
set(clang_flags -std=c++17 -DCGAL_EIGEN3_ENABLED "-DCGAL_DATA_DIR=\"${CGAL_DATA_DIR}\"" ${clang_folders}
  -fno-sanitize-recover=all "-fsanitize-ignorelist=${CMAKE_CURRENT_SOURCE_DIR}/fuzzing/ignored_by_ubsan.txt")

# add_clang_program(NAME FLAGS LIBRARIES SOURCE...): lists of flags and libraries
function(add_clang_program name flags libraries)
  set(objects "")
  foreach(source IN LISTS ARGN)
    get_filename_component(object "${source}" NAME_WE)
    set(object "${CMAKE_CURRENT_BINARY_DIR}/${name}_${object}.o")
    get_filename_component(source "${source}" ABSOLUTE)
    set(dependencies "")
    if(CMAKE_VERSION VERSION_GREATER_EQUAL 3.20)
      set(dependencies DEPFILE "${object}.d")
    endif()
    add_custom_command(OUTPUT "${object}"
      COMMAND "${CGAL_AHR_CLANG}" ${flags} -MD -MF "${object}.d" -c "${source}" -o "${object}"
      DEPENDS "${source}" ${dependencies}
      COMMENT "Compiling ${name} by Clang" VERBATIM)
    list(APPEND objects "${object}")
  endforeach()
  add_custom_command(OUTPUT ${name}
    COMMAND "${CGAL_AHR_CLANG}" ${flags} ${objects} -o ${name} ${libraries} -lgmp -lmpfr
    DEPENDS ${objects} VERBATIM)
  add_custom_target(${name}_program ALL DEPENDS ${name})
endfunction()

# add_instrumented_test(NAME LABELS SOURCE FLAG...)
function(add_instrumented_test name labels source)
  if(CGAL_AHR_CLANG)
    set(libraries "")
    if(CGAL_AHR_WITH_TBB AND TARGET CGAL::TBB_support)
      set(libraries -ltbb)
      list(APPEND ARGN -DCGAL_LINKED_WITH_TBB)
    endif()
    add_clang_program(${name} "-O1;-g1;${ARGN};${clang_flags}" "${libraries}" ${source})
    set(program "${CMAKE_CURRENT_BINARY_DIR}/${name}")
  else()
    add_executable(${name} ${source})
    target_link_libraries(${name} PRIVATE Anisotropic_hde_remeshing::Anisotropic_hde_remeshing)
    target_compile_options(${name} BEFORE PRIVATE -O1 -g1 ${ARGN} -fno-sanitize-recover=all)
    target_link_options(${name} PRIVATE ${ARGN})
    set(program ${name})
  endif()
  add_test(NAME ${name} COMMAND ${program})
  set_tests_properties(${name} PROPERTIES LABELS "${labels}" TIMEOUT 1800)
endfunction()

# with all assertions, CGAL's and Eigen's, too
set(address_flags -UNDEBUG -fsanitize=address,${undefined_behaviour})
# it is small: -O0 saves more time in compiling than it takes in running
add_instrumented_test(address_test_addresses address addresses/test_addresses.cpp ${address_flags} -O0)
if(CGAL_AHR_WITH_LONG_TESTS)
  add_instrumented_test(address_test_promises "address;long" test_promises.cpp ${address_flags})
  add_instrumented_test(address_test_constraints "address;long" test_remeshing_constraints.cpp ${address_flags})
endif()

if(CGAL_AHR_WITH_TBB AND TARGET CGAL::TBB_support)
  add_instrumented_test(thread_test_threads thread threads/test_threads.cpp
    -DNDEBUG -fsanitize=thread "-I${CMAKE_CURRENT_SOURCE_DIR}/threads")
  if(TARGET thread_test_threads) # not made by Clang
    target_include_directories(thread_test_threads BEFORE PRIVATE threads)
  endif()
  set(thread_tests thread_test_threads)
  if(CGAL_AHR_WITH_LONG_TESTS)
    add_test(NAME long_thread_test_threads COMMAND "${CMAKE_CURRENT_BINARY_DIR}/thread_test_threads" all)
    set_tests_properties(long_thread_test_threads PROPERTIES LABELS "thread;long" TIMEOUT 1800)
    list(APPEND thread_tests long_thread_test_threads)
  endif()
  set_tests_properties(${thread_tests} PROPERTIES ENVIRONMENT "TSAN_OPTIONS=halt_on_error=1")
endif()

# what TBB's threads keep to the end may be reached
find_program(CGAL_AHR_VALGRIND valgrind)
if(CGAL_AHR_VALGRIND)
  add_test(NAME memcheck_test_simultaneous_moves
    COMMAND "${CGAL_AHR_VALGRIND}" --quiet --leak-check=full --show-leak-kinds=definite
      --errors-for-leak-kinds=definite --error-exitcode=1 $<TARGET_FILE:test_simultaneous_moves>)
  set_tests_properties(memcheck_test_simultaneous_moves PROPERTIES LABELS memcheck TIMEOUT 300)
endif()

# What users of Debian 13 and of the next Debian have: programs compile with other versions of CGAL, Boost and Eigen, with
# another compiler, and without TBB, and with the first hde_remesh runs. Tests compile with the second.
# scripts/build_elsewhere.sh builds all in all combinations. add_test_elsewhere(NAME CONFIGURATION TARGETS TESTS)
function(add_test_elsewhere name configuration targets tests)
  add_test(NAME ${name} COMMAND "${PROJECT_SOURCE_DIR}/scripts/build_elsewhere.sh" ${configuration})
  set_tests_properties(${name} PROPERTIES LABELS elsewhere TIMEOUT 1800 SKIP_RETURN_CODE 77 ENVIRONMENT
    "BUILD_DIR=${CMAKE_CURRENT_BINARY_DIR}/elsewhere;SHARED=ON;TARGETS=${targets};TESTS=${tests}")
endfunction()

if(UNIX)
  add_test_elsewhere(elsewhere_gcc_trixie g++,17,trixie,ON "hde_remesh" "^hde_remesh_runs$")
  add_test_elsewhere(elsewhere_clang_trixie clang++,17,trixie,ON "syntax_check_examples syntax_check_tests" "")
  add_test_elsewhere(elsewhere_clang_forky clang++,20,forky,OFF
    "syntax_check_examples syntax_check_hde_remesh syntax_check_instantiations public_headers" "")
endif()

# libFuzzer is Clang's, whichever compiler builds the rest
if(NOT CGAL_AHR_CLANG)
  message(STATUS "There are no fuzzers, as clang++ was not found")
  return()
endif()

# without TBB: one thread is enough
set(fuzzer_flags -O1 -g1 ${clang_flags} -fsanitize=fuzzer,address,${undefined_behaviour})

# add_fuzzer(NAME LARGEST_SIZE SOURCE...): runs on what was found before, in fuzzing/NAME, and on new input from there
function(add_fuzzer name largest_size)
  add_clang_program(${name} "${fuzzer_flags}" "" ${ARGN})
  set(new_inputs "${CMAKE_CURRENT_BINARY_DIR}/${name}_corpus")
  file(MAKE_DIRECTORY "${new_inputs}")
  set(duration -max_total_time=${CGAL_AHR_FUZZING_SECONDS})
  if(CGAL_AHR_FUZZING_SECONDS EQUAL 0)
    # with those that were found before
    set(number_of_runs 2500)
    if(CGAL_AHR_WITH_LONG_TESTS)
      set(number_of_runs 10000)
    endif()
    set(duration -seed=1 -runs=${number_of_runs} -reload=0)
  endif()
  add_test(NAME ${name}
    COMMAND "${CMAKE_CURRENT_BINARY_DIR}/${name}" ${duration} -max_len=${largest_size} -rss_limit_mb=4096 -timeout=60
      -print_final_stats=1 ${new_inputs} "${CMAKE_CURRENT_SOURCE_DIR}/fuzzing/${name}")
  math(EXPR limit "${CGAL_AHR_FUZZING_SECONDS} + 1800")
  set_tests_properties(${name} PROPERTIES LABELS fuzz TIMEOUT ${limit})
endfunction()

add_fuzzer(fuzz_operations 400 fuzzing/fuzz_operations.cpp)
set(program "${PROJECT_SOURCE_DIR}/examples/Anisotropic_hde_remeshing/hde_remesh")
add_fuzzer(fuzz_files 4000 fuzzing/fuzz_files.cpp ${program}/mesh_file.cpp ${program}/foreign_file.cpp ${program}/Mesh.cpp
  ${program}/Format.cpp ${program}/vtp_file.cpp ${program}/repair.cpp ${program}/cracks.cpp ${program}/walls.cpp ${program}/solids.cpp
  ${program}/flat_faces.cpp ${readers})
