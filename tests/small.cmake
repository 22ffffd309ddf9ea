# The small programs (./book small N): each compiled alone as a reader does, without a warning, and held to the library.
add_catch_tests(small small FILES tests/small/bodies.cpp tests/small/matrix.cpp tests/small/sweeps.cpp
                             tests/small/skipping.cpp tests/small/turning.cpp tests/small/jointed.cpp
                             tests/small/soft_and_wide.cpp tests/small/islands_and_engine.cpp tests/small/turning_in_space.cpp tests/small/world_in_space.cpp
                             tests/small/solids_in_space.cpp
                             tests/small/ways.cpp
                             tests/small/cloth.cpp tests/small/touching.cpp tests/small/waves.cpp tests/small/elastic.cpp tests/small/sentences.cpp)
set_target_properties(test_small PROPERTIES UNITY_BUILD OFF)   # each has names of its own

if(NOT MSVC AND NOT CMAKE_CROSSCOMPILING)
  get_target_property(folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  list(TRANSFORM folders PREPEND -isystem)
  file(GLOB programs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/*/small.cpp)
  foreach(program ${programs})
    cmake_path(GET program PARENT_PATH chapter)
    cmake_path(GET chapter FILENAME chapter)
    # in a folder from which no header of the book is found
    set(place ${CMAKE_CURRENT_BINARY_DIR}/small/${chapter})
    file(MAKE_DIRECTORY ${place})
    add_test(NAME "small: ${chapter} compiles alone without a warning"
             COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -O2 -Wall -Wextra -Werror ${folders} ${program} -o small
             WORKING_DIRECTORY ${place})
    add_test(NAME "small: ${chapter} draws its picture" COMMAND ${place}/small picture.svg WORKING_DIRECTORY ${place})
    set_tests_properties("small: ${chapter} compiles alone without a warning"
                         PROPERTIES LABELS small TIMEOUT 300 COST 100 FIXTURES_SETUP "small_${chapter}")
    set_tests_properties("small: ${chapter} draws its picture"
                         PROPERTIES LABELS small TIMEOUT 60 FIXTURES_REQUIRED "small_${chapter}")
  endforeach()
endif()

# ./book small N --holes. Compiled as it is handed out, so with this compiler and the same options as by hand.
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_FOUND)
  if(NOT MSVC AND NOT CMAKE_CROSSCOMPILING)
    set(compiled_by ${CMAKE_CXX_COMPILER} ${folders})
  endif()
  add_test(NAME "small: the hand-outs compile and the small programs fit their holes"
           COMMAND Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/tests/small/test_holes.py ${compiled_by})
  set_tests_properties("small: the hand-outs compile and the small programs fit their holes" PROPERTIES LABELS small TIMEOUT 300 COST 500)   # a long one is begun early
endif()

# The reader's guide says how many lines each has and how many of them are new.
if(Python3_FOUND)
  add_test(NAME "small: the guide and the texts count the lines of the small programs"
           COMMAND Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/tests/small/programs.py)
  set_tests_properties("small: the guide and the texts count the lines of the small programs" PROPERTIES LABELS small TIMEOUT 60)
endif()

# What the library buys: the table of the reader's guide.
add_executable(small_table EXCLUDE_FROM_ALL tests/small/table.cpp)
target_link_libraries(small_table PRIVATE rigid_physics)
