# The program as a reader runs it.
foreach(scene pendulum bead double_pendulum slider_crank chain doll)
  add_program_test(ch26 26_four_ways "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method end_spring,acceleration,impulses,positions,coordinates --csv -)
endforeach()
foreach(scene slope ball stack cradle)
  add_program_test(ch26 26_four_ways "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method end_spring,acceleration,single,impulses,positions,coordinates --csv -)
endforeach()
foreach(scene controlled)
  add_program_test(ch26 26_four_ways "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method spring,impulses --csv -)
endforeach()
foreach(scene rod)
  add_program_test(ch26 26_four_ways "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method end_spring,single,impulses,positions,coordinates --csv -)
endforeach()
# Painleve's rod has no finite force: the program says so and ends
add_program_test(ch26 26_four_ways "says where no force obeys the law" --headless --scene rod --method acceleration --steps 1)
set_tests_properties("ch26: 26_four_ways says where no force obeys the law" PROPERTIES WILL_FAIL ON)
