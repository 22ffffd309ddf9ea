# The program as a reader runs it.
foreach(scene spring stack suspension soft_body bridge cloth)
  add_program_test(ch16 16_soft_constraints "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method soft,preloaded,hard,xpbd,bodies,exact --csv -)
endforeach()
add_program_test(ch16 16_soft_constraints "refuses a frequency of zero" --headless --scene stack --set frequency=0 --steps 1)
set_tests_properties("ch16: 16_soft_constraints refuses a frequency of zero" PROPERTIES WILL_FAIL ON)
