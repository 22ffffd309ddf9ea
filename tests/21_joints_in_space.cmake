# The program as a reader runs it.
foreach(scene top chain door gyroscope plates)
  add_program_test(ch21 21_joints_in_space "runs scene ${scene}" --headless --scene ${scene} --steps 300
                   --method exact,islands --csv -)
endforeach()
add_program_test(ch21 21_joints_in_space "refuses a top that is too slow" --headless --scene top --set spin=40 --set tilt=1 --steps 1)
set_tests_properties("ch21: 21_joints_in_space refuses a top that is too slow" PROPERTIES WILL_FAIL ON)
