# Runs `program` with `arguments` and wants exit code 2 and something on stderr.
execute_process(COMMAND ${program} ${arguments} RESULT_VARIABLE code ERROR_VARIABLE said OUTPUT_VARIABLE ignored)
if(NOT code EQUAL 2)
  message(FATAL_ERROR "exit code ${code} instead of 2; it said: ${said}")
endif()
if(said STREQUAL "")
  message(FATAL_ERROR "it ended with code 2 and said nothing")
endif()
