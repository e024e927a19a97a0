# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Tests under tools that find what checks do not, a ctest label each: `address` (AddressSanitizer and UBSan), `thread`
# (ThreadSanitizer), `fuzz` (libFuzzer, with both of the first), `memcheck` (valgrind), and `elsewhere` (other compilers and versions
# of CGAL). They take minutes to compile. The fuzzers run a thousand inputs, the same each time, or CGAL_AHR_FUZZING_SECONDS on
# other ones each time. With CGAL_AHR_WITH_LONG_TESTS there are larger ones, labelled `long`, too.

set(CGAL_AHR_FUZZING_SECONDS 0 CACHE STRING "how long each fuzzer runs, in seconds; 0: on the same inputs each time")

# not what CGAL and Boost do on purpose: references to elements that are not there, casts within hierarchies of traits
set(undefined_behaviour
  bounds,integer-divide-by-zero,float-cast-overflow,shift,signed-integer-overflow,return,bool,enum,unreachable)

# add_instrumented_test(NAME LABEL SOURCE FLAG...)
function(add_instrumented_test name label source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE Anisotropic_hde_remeshing::Anisotropic_hde_remeshing)
  target_compile_options(${name} PRIVATE -O1 -g1 ${ARGN})
  target_link_options(${name} PRIVATE ${ARGN})
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${label}" TIMEOUT 1800)
endfunction()

# with all assertions, CGAL's and Eigen's, too
set(address_flags -UNDEBUG -fsanitize=address,${undefined_behaviour} -fno-sanitize-recover=all)
add_instrumented_test(address_test_addresses address addresses/test_addresses.cpp ${address_flags})
if(CGAL_AHR_WITH_LONG_TESTS)
  add_instrumented_test(address_test_promises "address;long" test_promises.cpp ${address_flags})
  add_instrumented_test(address_test_constraints "address;long" test_remeshing_constraints.cpp ${address_flags})
endif()

if(CGAL_AHR_WITH_TBB AND TARGET CGAL::TBB_support)
  add_instrumented_test(thread_test_threads thread threads/test_threads.cpp -fsanitize=thread)
  target_include_directories(thread_test_threads BEFORE PRIVATE threads)
  set(thread_tests thread_test_threads)
  if(CGAL_AHR_WITH_LONG_TESTS)
    add_test(NAME long_thread_test_threads COMMAND thread_test_threads all)
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

# What users of Debian 13 and of the next Debian have: all programs compile with other versions of CGAL, Boost and Eigen, with
# another compiler, and without TBB, and with the first hde_remesh and a test run. scripts/build_elsewhere.sh builds all in all
# combinations. add_test_elsewhere(NAME CONFIGURATION TARGETS TESTS)
function(add_test_elsewhere name configuration targets tests)
  add_test(NAME ${name} COMMAND "${PROJECT_SOURCE_DIR}/scripts/build_elsewhere.sh" ${configuration})
  set_tests_properties(${name} PROPERTIES LABELS elsewhere TIMEOUT 1800 SKIP_RETURN_CODE 77 ENVIRONMENT
    "BUILD_DIR=${CMAKE_CURRENT_BINARY_DIR}/elsewhere;SHARED=ON;TARGETS=${targets};TESTS=${tests}")
endfunction()

if(UNIX)
  add_test_elsewhere(elsewhere_gcc_trixie g++,17,trixie,ON "hde_remesh test_transfer_vertex_property"
    "^(hde_remesh_runs|test_transfer_vertex_property)$")
  add_test_elsewhere(elsewhere_clang_trixie clang++,17,trixie,ON "syntax_check_examples syntax_check_tests" "")
  add_test_elsewhere(elsewhere_clang_forky clang++,20,forky,OFF "syntax_check public_headers" "")
endif()

# libFuzzer is Clang's, whichever compiler builds the rest. Without TBB: one thread is enough.
find_program(CGAL_AHR_CLANG clang++)
if(NOT CGAL_AHR_CLANG)
  message(STATUS "There are no fuzzers, as clang++ was not found")
  return()
endif()

get_target_property(eigen_folders CGAL::Eigen3_support INTERFACE_INCLUDE_DIRECTORIES)
set(fuzzer_folders "${PROJECT_SOURCE_DIR}/include" "${CMAKE_CURRENT_SOURCE_DIR}" ${CGAL_INCLUDE_DIRS} ${eigen_folders})
list(FILTER fuzzer_folders EXCLUDE REGEX "^(/usr/include|.*[$]<.*)$")
list(TRANSFORM fuzzer_folders PREPEND -I)
set(fuzzer_flags -std=c++17 -O1 -g1 -DCGAL_EIGEN3_ENABLED ${fuzzer_folders} -fno-sanitize-recover=all
  -fsanitize=fuzzer,address,${undefined_behaviour}
  "-fsanitize-ignorelist=${CMAKE_CURRENT_SOURCE_DIR}/fuzzing/ignored_by_ubsan.txt")

# add_fuzzer(NAME LARGEST_SIZE SOURCE...): runs on what was found before, in fuzzing/NAME, and on new input from there
function(add_fuzzer name largest_size)
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
      COMMAND "${CGAL_AHR_CLANG}" ${fuzzer_flags} -MD -MF "${object}.d" -c "${source}" -o "${object}"
      DEPENDS "${source}" ${dependencies}
      COMMENT "Compiling ${name} for libFuzzer" VERBATIM)
    list(APPEND objects "${object}")
  endforeach()
  add_custom_command(OUTPUT ${name}
    COMMAND "${CGAL_AHR_CLANG}" ${fuzzer_flags} ${objects} -o ${name} -lgmp -lmpfr
    DEPENDS ${objects} VERBATIM)
  add_custom_target(${name}_fuzzer ALL DEPENDS ${name})
  set(new_inputs "${CMAKE_CURRENT_BINARY_DIR}/${name}_corpus")
  file(MAKE_DIRECTORY "${new_inputs}")
  set(duration -max_total_time=${CGAL_AHR_FUZZING_SECONDS})
  if(CGAL_AHR_FUZZING_SECONDS EQUAL 0)
    # with those that were found before
    set(number_of_runs 1000)
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
add_fuzzer(fuzz_files 4000 fuzzing/fuzz_files.cpp ${program}/mesh_file.cpp ${program}/Mesh.cpp ${program}/Format.cpp ${program}/vtp_file.cpp
  ${program}/unreadable.cpp ${program}/ply_header.cpp ${program}/repair.cpp)
