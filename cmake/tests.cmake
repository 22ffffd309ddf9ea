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

add_library(rigid_test_main STATIC tests/test_main.cpp)
target_link_libraries(rigid_test_main PUBLIC Catch2::Catch2 rigid_common rigid_test_options)
target_compile_definitions(rigid_test_main PUBLIC RIGID_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
set_source_files_properties(tests/test_main.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)   # it makes Catch2's own code
# In the tests Eigen counts what it allocates: its instances and the chapters' own sources are others, too. Some tests look at
# the scenes of a program.
target_sources(rigid_test_main PRIVATE cmake/precompiled/tests_eigen_instances.cpp common/program/program.cpp ${rigid_chapters})
if(RIGID_TOGETHER)
  set_target_properties(rigid_test_main PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endif()
if(NOT TARGET rigid_precompiled)
  target_compile_options(rigid_test_main PRIVATE "SHELL:$<IF:$<CXX_COMPILER_ID:MSVC>,/FI,-include> \"${PROJECT_SOURCE_DIR}/tests/counted_eigen.hpp\"")
else()
  target_sources(rigid_test_main PRIVATE cmake/precompiled/precompiled.cpp)
  target_precompile_headers(rigid_test_main PRIVATE tests/counted_eigen.hpp common/eigen_instances.hpp
                                                    cmake/precompiled/standard.hpp tests/catch.hpp)
endif()

function(add_catch_tests name label)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "FILES")
  add_executable(test_${name} ${arg_FILES})
  compile_together(test_${name})
  target_link_libraries(test_${name} PRIVATE rigid_test_main)
  if(TARGET rigid_precompiled)
    target_precompile_headers(test_${name} REUSE_FROM rigid_test_main)
  else()
    # compiled together, the first source may have included Eigen before the second counts what it allocates
    set_target_properties(test_${name} PROPERTIES UNITY_BUILD_CODE_BEFORE_INCLUDE "#include \"tests/counted_eigen.hpp\"")
  endif()
  catch_discover_tests(test_${name} TEST_PREFIX "${label}: " PROPERTIES LABELS ${label} TIMEOUT 300)
endfunction()

# add_program_test(LABEL CHAPTER NAME ARGUMENTS …): runs a chapter's program and wants exit code 0.
function(add_program_test label chapter name)
  add_test(NAME "${label}: ${chapter} ${name}" COMMAND ${chapter} ${ARGN})
  set_tests_properties("${label}: ${chapter} ${name}" PROPERTIES LABELS ${label} TIMEOUT 300)
endfunction()

# add_same_bits_test(LABEL CHAPTER NAME): tests/CHAPTER_trace.cpp prints the same without and with optimisation. The one
# is compiled without any (the library, too: nothing optimised is linked in), the other as the release build compiles.
function(add_same_bits_test label chapter name)
  if(MSVC)
    return()
  endif()
  if(NOT TARGET rigid_traced_plain)
    add_traced_library(plain -O0)
    add_traced_library(optimised -O2)
  endif()
  foreach(level plain optimised)
    add_executable(${chapter}_trace_${level} tests/${chapter}_trace.cpp)
    if(level STREQUAL optimised AND CMAKE_BUILD_TYPE STREQUAL "Release")
      target_link_libraries(${chapter}_trace_${level} PRIVATE rigid_common)
      precompile(${chapter}_trace_${level})
    else()
      target_link_libraries(${chapter}_trace_${level} PRIVATE rigid_traced_${level})
      target_precompile_headers(${chapter}_trace_${level} REUSE_FROM rigid_traced_${level})
    endif()
    add_dependencies(test_${chapter} ${chapter}_trace_${level})   # ./book test N builds test_NN
  endforeach()
  add_test(NAME "${label}: ${name}"
           COMMAND ${CMAKE_COMMAND} -DFIRST=$<TARGET_FILE:${chapter}_trace_plain>
                   -DSECOND=$<TARGET_FILE:${chapter}_trace_optimised>
                   -P ${PROJECT_SOURCE_DIR}/tests/04_pgs_same_output.cmake)
  set_tests_properties("${label}: ${name}" PROPERTIES LABELS ${label} TIMEOUT 300)
endfunction()

# What the traces of all chapters share at one level: the objects of the physics below the engine and a precompiled header.
# rigid_common gives the flags; of its archive nothing is needed where the objects stand before it.
function(add_traced_library level option)
  add_library(rigid_traced_${level} OBJECT EXCLUDE_FROM_ALL common/contact.cpp common/eigen_instances.cpp
              common/elementary.cpp common/measure.cpp common/scenes.cpp ${rigid_chapters})
  if(RIGID_TOGETHER)
    set_target_properties(rigid_traced_${level} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  endif()
  target_link_libraries(rigid_traced_${level} PUBLIC rigid_common)
  target_compile_options(rigid_traced_${level} PUBLIC ${option})
  target_precompile_headers(rigid_traced_${level} PRIVATE cmake/precompiled/standard.hpp <Eigen/Dense> <Eigen/Sparse>)
endfunction()
