# The tests of ./book mine itself; whether the emptied headers fail and the book's own pass takes longer: .ci/run mine.
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_FOUND)
  add_test(NAME "common: the headers to write yourself are those of the lists and mine.py does what it says"
           COMMAND Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/tests/mine/test_mine.py)
  set_tests_properties("common: the headers to write yourself are those of the lists and mine.py does what it says"
                       PROPERTIES LABELS common TIMEOUT 60)
endif()
