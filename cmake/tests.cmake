# add_catch_tests(NAME LABEL FILES …): one Catch2 executable bin/test_NAME, its test cases under
# the one label. (catch_discover_tests keeps only the first of several labels.)
# Where Catch2 is missing, this file defines nothing and the book is built without tests.
find_package(Catch2 CONFIG QUIET)
if(NOT Catch2_FOUND)
  message(STATUS "Catch2 not found: the tests are not built")
  return()
endif()
include(Catch)

# Test code is not what is measured: -O1 compiles faster and gives the same bits. Programs, benchmarks and the counted
# work of docs/results are compiled as the preset says.
add_library(rigid_test_options INTERFACE)
if(NOT MSVC)
  target_compile_options(rigid_test_options INTERFACE $<$<CONFIG:Release>:-O1>)
endif()

add_library(rigid_test_main STATIC tests/test_main.cpp tests/eigenvalues.cpp)
target_link_libraries(rigid_test_main PUBLIC Catch2::Catch2 rigid_common rigid_test_options)
target_compile_definitions(rigid_test_main PUBLIC RIGID_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
set_source_files_properties(tests/test_main.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)   # it makes Catch2's own code
# Some tests look at the scenes of a program.
target_sources(rigid_test_main PRIVATE common/program/program.cpp)
if(TARGET rigid_precompiled)
  target_sources(rigid_test_main PRIVATE cmake/precompiled/precompiled.cpp)
  target_precompile_headers(rigid_test_main PRIVATE common/eigen_instances.hpp cmake/precompiled/standard.hpp tests/catch.hpp)
endif()

function(add_catch_tests name label)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "FILES")
  add_executable(test_${name} ${arg_FILES})
  compile_together(test_${name})
  # of a chapter: its library and those before it; what is about all of them: all; else those of the plane
  if(name MATCHES "^(0[1-9]|1[0-8]|2[0-46-9]|30)_")
    target_link_libraries(test_${name} PRIVATE ${rigid_chapter_up_to_${CMAKE_MATCH_1}} rigid_test_main)
  elseif(name MATCHES "^25_|^small$")
    target_link_libraries(test_${name} PRIVATE ${rigid_chapter_libraries} rigid_chapter_19 rigid_test_main)
  else()
    target_link_libraries(test_${name} PRIVATE rigid_chapter_19 rigid_test_main)
  endif()
  if(TARGET rigid_precompiled)
    target_precompile_headers(test_${name} REUSE_FROM rigid_test_main)
  endif()
  catch_discover_tests(test_${name} TEST_PREFIX "${label}: " PROPERTIES LABELS ${label} TIMEOUT 300)
endfunction()

# add_program_test(LABEL CHAPTER NAME ARGUMENTS …): runs a chapter's program and wants exit code 0.
function(add_program_test label chapter name)
  add_test(NAME "${label}: ${chapter} ${name}" COMMAND ${chapter} ${ARGN})
  set_tests_properties("${label}: ${chapter} ${name}" PROPERTIES LABELS ${label} TIMEOUT 300)
endfunction()
