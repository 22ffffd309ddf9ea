# cmake -DBOOK=FOLDER -P use_it_compiler.cmake -- COMPILER OPTIONS…: the compiler of use_it_run.cmake for a subdirectory. What
# the book's own build, in FOLDER, has compiled by the same command is not compiled once more: its object is copied.
# commands.txt, in the folder that is built, has the book's commands.
cmake_minimum_required(VERSION 3.25)
set(command)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(k RANGE 5 ${last})   # cmake -DBOOK=… -P … -- are the first five
  list(APPEND command "${CMAKE_ARGV${k}}")
endforeach()
list(JOIN command " " line)
string(REPLACE "${CMAKE_CURRENT_BINARY_DIR}/rigid/" "" line "${line}")
string(REPLACE " rigid/" " " line "${line}")
set(known)
if(EXISTS commands.txt)   # not where CMake tries what the compiler can
  file(STRINGS commands.txt known)
endif()
if(line IN_LIST known)
  string(REGEX REPLACE ".* -o ([^ ]+) .*" "\\1" object "${line}")
  file(COPY_FILE ${BOOK}/${object} rigid/${object})
else()
  execute_process(COMMAND ${command} COMMAND_ERROR_IS_FATAL ANY)
endif()
