# The tests of ./book mutants itself. The mutation run takes longer: .ci/run asks for it.
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_FOUND)
  add_test(NAME "common: each mutant has its place in the sources and run.py does what it says"
           COMMAND Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/tests/mutants/test_run.py)
  set_tests_properties("common: each mutant has its place in the sources and run.py does what it says"
                       PROPERTIES LABELS common TIMEOUT 60)
endif()
