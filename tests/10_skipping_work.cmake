# The program as a reader runs it.
foreach(method skipping no_sleep one_island)
  add_program_test(ch10 10_skipping_work "runs the rain by ${method}" --headless --scene rain --set discs=300
                   --method ${method} --steps 600 --csv -)
endforeach()
foreach(scene columns field net)
  add_program_test(ch10 10_skipping_work "runs scene ${scene}" --headless --scene ${scene} --steps 300 --csv -)
endforeach()
add_program_test(ch10 10_skipping_work "lets all of the rain fall asleep" --headless --scene rain --set discs=200
                 --steps 3000 --csv -)
set_tests_properties("ch10: 10_skipping_work lets all of the rain fall asleep" PROPERTIES
  PASS_REGULAR_EXPRESSION "\n[^\n]*3000,[^,]*,0,0,0,0,0,0,0,0,0,0,0,0")
