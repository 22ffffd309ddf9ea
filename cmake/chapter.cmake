# add_chapter(NN_name): the program, the benchmark and the tests of one chapter.
# Executables: bin/NN_name, bin/NN_name_benchmark; tests: label chNN. No test needs the benchmarks of the chapters: they
# are built by name (./book bench, ./book figures) or all together as the target `benchmarks`.
if(RIGID_BENCHMARKS)
  find_package(benchmark QUIET)
  if(NOT benchmark_FOUND)
    message(STATUS "Google Benchmark not found: the benchmarks are not built")
  endif()
endif()
add_custom_target(benchmarks)
add_custom_target(steps_alone)   # every program's steps, for a comparison of times with those of the pages
include(cmake/peers.cmake)   # measure_beside(): programs to compare with, where they are installed

function(add_chapter chapter)
  string(SUBSTRING ${chapter} 0 2 number)
  set(folder ${PROJECT_SOURCE_DIR}/chapters/${chapter})
  if(EXISTS ${folder}/program/main.cpp)
    add_executable(${chapter} ${folder}/program/main.cpp)
    set(physics ${rigid_chapter_up_to_${number}})
    if(number EQUAL 4)
      set(physics rigid_chapter_04)   # no exact solver
    endif()
    target_link_libraries(${chapter} PRIVATE rigid_program ${physics} rigid_common)
    precompile(${chapter})
    # The same objects for the time of a step alone (docs/web/test/step_times.mjs).
    add_executable(${chapter}_steps EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/docs/web/test/steps_alone.cpp $<TARGET_OBJECTS:${chapter}>)
    target_link_libraries(${chapter}_steps PRIVATE $<TARGET_PROPERTY:${chapter},LINK_LIBRARIES>)
    add_dependencies(steps_alone ${chapter}_steps)
  endif()

  if(benchmark_FOUND AND EXISTS ${folder}/benchmark/benchmark.cpp)
    add_executable(${chapter}_benchmark EXCLUDE_FROM_ALL ${folder}/benchmark/benchmark.cpp)
    target_link_libraries(${chapter}_benchmark PRIVATE rigid_program ${rigid_chapter_up_to_${number}} rigid_common
                          benchmark::benchmark)
    precompile(${chapter}_benchmark)
    add_dependencies(benchmarks ${chapter}_benchmark)
    if(EXISTS ${folder}/benchmark/peers.cmake)   # the programs that it measures beside the book
      include(${folder}/benchmark/peers.cmake)
    endif()
  endif()

  if(COMMAND add_catch_tests AND EXISTS ${PROJECT_SOURCE_DIR}/tests/${chapter}.cpp)
    file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${number}_*.cpp)   # one executable a chapter
    add_catch_tests(${chapter} ch${number} FILES ${tests})
    if(EXISTS ${PROJECT_SOURCE_DIR}/tests/${chapter}.cmake)   # tests that run the program
      include(${PROJECT_SOURCE_DIR}/tests/${chapter}.cmake)
    endif()
  endif()
endfunction()
