# The program as a reader runs it.
foreach(scene struck mixed poured heavy pyramid net)
  add_program_test(ch18 18_islands "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method by_island,exact,sweeps --set prices=1 --csv -)
endforeach()
add_program_test(ch18 18_islands "refuses a net of one disc" --headless --scene net --set side=1 --steps 1)
set_tests_properties("ch18: 18_islands refuses a net of one disc" PROPERTIES WILL_FAIL ON)
