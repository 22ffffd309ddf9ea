# add_catch_tests(NAME LABEL FILES …): one Catch2 executable bin/test_NAME, its test cases under
# the one label. (catch_discover_tests keeps only the first of several labels.)
# Where Catch2 is missing, this file defines nothing and the book is built without tests.
find_package(Catch2 CONFIG QUIET)
if(NOT Catch2_FOUND)
  message(STATUS "Catch2 not found: the tests are not built")
  return()
endif()
include(Catch)

add_library(rigid_test_main STATIC tests/test_main.cpp)
target_link_libraries(rigid_test_main PUBLIC Catch2::Catch2 rigid_common)
target_compile_definitions(rigid_test_main PUBLIC RIGID_SOURCE_DIR="${PROJECT_SOURCE_DIR}")

function(add_catch_tests name label)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "FILES")
  add_executable(test_${name} ${arg_FILES})
  target_link_libraries(test_${name} PRIVATE rigid_test_main)
  catch_discover_tests(test_${name} TEST_PREFIX "${label}: " PROPERTIES LABELS ${label} TIMEOUT 300)
endfunction()

# add_program_test(LABEL CHAPTER NAME ARGUMENTS …): runs a chapter's program and wants exit code 0.
function(add_program_test label chapter name)
  add_test(NAME "${label}: ${chapter} ${name}" COMMAND ${chapter} ${ARGN})
  set_tests_properties("${label}: ${chapter} ${name}" PROPERTIES LABELS ${label} TIMEOUT 300)
endfunction()
