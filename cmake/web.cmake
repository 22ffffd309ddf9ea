# The programs for a page (preset web, ./book web): the same main.cpp and the same physics by Emscripten, with
# common/program/web_program.cpp in place of the command line and the window. demos/NN_name.js is what a page loads.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# Nothing is loaded by address at run time: position-independent code would look every constant up in a table.
set_target_properties(${rigid_parts} PROPERTIES POSITION_INDEPENDENT_CODE OFF)

add_library(rigid_web STATIC
  common/draw_list.cpp
  common/program/panel_rows.cpp
  common/program/panes.cpp
  common/program/playback.cpp
  common/program/program.cpp
  common/program/show.cpp
  common/program/web_description.cpp
  common/program/web_show.cpp)
target_link_libraries(rigid_web PUBLIC rigid_common rigid_physics)
# What a frame needs once may be small; the steps are in the programs. (Emscripten 3.1's -Os inlines nothing: it is 20 times
# slower and no smaller.)
set(small -O2 "SHELL:-mllvm -inline-threshold=50")
target_compile_options(rigid_web PRIVATE ${small})

add_library(rigid_web_program OBJECT common/program/web_program.cpp)
target_link_libraries(rigid_web_program PRIVATE rigid_web)
target_compile_options(rigid_web_program PRIVATE ${small})

# The preset compiles everything with -msimd128 -msse2: Eigen then adds by the two numbers at once that it has on a PC, in
# the same order (cmake/physics.cmake). Only Eigen does: loops that the compiler pairs or unrolls by itself are written twice
# or four times over, with their remainders. Chapter 19 was 25 kB heavier in gzip, and no faster.
# The preset leaves pairs of single numbers (-vectorize-slp=false) to Eigen as well, and makes its own way of writing one number
# into both halves of a pair (cmake/web/splat.hpp): Emscripten 3.1.6 reads such a number too late.
# What is as long as 50 instructions is called and not copied to where it is called; 225 is usual, and chapter 19 above 200 kB then.
set(fast -fno-vectorize "SHELL:-mllvm -unroll-allow-partial=0" "SHELL:-mllvm -unroll-runtime=0")
foreach(part ${rigid_parts})
  target_compile_options(${part} PRIVATE ${fast} "SHELL:-mllvm -inline-threshold=50")
endforeach()

file(GLOB mains CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/[0-9][0-9]_*/program/main.cpp)
foreach(main ${mains})
  cmake_path(GET main PARENT_PATH folder)
  cmake_path(GET folder PARENT_PATH folder)
  cmake_path(GET folder FILENAME chapter)
  add_executable(${chapter} ${main} $<TARGET_OBJECTS:rigid_web_program>)
  set_source_files_properties(${main} PROPERTIES COMPILE_DEFINITIONS main=chapter_main)
  if(chapter MATCHES "^(14|15|18|19|25|26|29|30)_")   # they have the most methods, and would weigh more than 200 kB
    target_compile_options(${chapter} PRIVATE ${small})
    target_link_options(${chapter} PRIVATE -Oz)
  else()
    target_compile_options(${chapter} PRIVATE -O3)
    target_link_options(${chapter} PRIVATE -O3)   # 3 % faster than -O2, and a little smaller
  endif()
  if(chapter MATCHES "^(11|20)_")   # a step of one body is 0.3 or 0.5 µs: calls count; 5 to 7 % faster, 10 to 15 kB heavier
    target_compile_options(${chapter} PRIVATE "SHELL:-mllvm -inline-threshold=800" "SHELL:-mllvm -inlinehint-threshold=800")
  endif()
  if(chapter MATCHES "^19_")   # the whole engine: a smaller malloc(), which its steps hardly call
    target_link_options(${chapter} PRIVATE -sMALLOC=emmalloc)
  endif()
  target_compile_options(${chapter} PRIVATE ${fast})   # after -O3, which would turn some of it on again
  target_include_directories(${chapter} BEFORE PRIVATE cmake/web)   # headers in place of those that need files
  target_link_libraries(${chapter} PRIVATE rigid_web)
  # A bare .wasm that knows nothing of a browser: docs/web/machine.js gives it a clock.
  target_link_options(${chapter} PRIVATE --no-entry -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH=1)
  set_target_properties(${chapter} PROPERTIES SUFFIX .wasm)
  set(script ${CMAKE_BINARY_DIR}/demos/${chapter}.js)
  add_custom_command(OUTPUT ${script} DEPENDS ${chapter} docs/web/pack.py
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/docs/web/pack.py $<TARGET_FILE:${chapter}> ${script})
  list(APPEND scripts ${script})
endforeach()

# The race (docs/race.md): no program of a chapter, and on a page of its own. For node alone, and faster: race_plane and
# race_space (docs/race/beside.mjs), by `./book race`.
function(add_race name source)
  add_executable(${name} ${source})
  target_compile_options(${name} PRIVATE ${ARGN} ${fast})
  target_link_libraries(${name} PRIVATE rigid_web)
  target_link_options(${name} PRIVATE ${ARGN} --no-entry -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH=1)
  set_target_properties(${name} PROPERTIES SUFFIX .wasm)
endfunction()
add_race(race docs/race/race.cpp)
add_race(race_plane docs/race/beside_plane.cpp -O3)
add_race(race_space docs/race/beside_space.cpp -O3)
target_include_directories(race_space BEFORE PRIVATE cmake/web)   # benchmark/benchmark.h
set_target_properties(race_plane race_space PROPERTIES EXCLUDE_FROM_ALL ON)
set(script ${CMAKE_BINARY_DIR}/race/race.js)
add_custom_command(OUTPUT ${script} DEPENDS race docs/web/pack.py
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/docs/web/pack.py $<TARGET_FILE:race> ${script})
list(APPEND scripts ${script})

add_custom_target(web ALL DEPENDS ${scripts})
