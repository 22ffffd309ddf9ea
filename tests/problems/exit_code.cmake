# Runs PROGRAM with the arguments in ARGUMENTS (separated by |) and wants the exit code CODE and, somewhere in
# what it prints, the words WORDS.
string(REPLACE "|" ";" arguments "${ARGUMENTS}")
execute_process(COMMAND ${PROGRAM} ${arguments} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL "${CODE}")
  message(FATAL_ERROR "exit code ${code}, wanted ${CODE}\n${out}${err}")
endif()
string(FIND "${out}${err}" "${WORDS}" found)
if(found EQUAL -1)
  message(FATAL_ERROR "\"${WORDS}\" is not in:\n${out}${err}")
endif()
