# The program as a reader runs it.
foreach(scene rod percussion pendulum double ladder seesaw gears crank)
  add_program_test(ch11 11_rotation "runs scene ${scene}" --headless --scene ${scene} --steps 300
                   --method exact,rattle,sweeps,baumgarte --csv -)
endforeach()
add_program_test(ch11 11_rotation "refuses a restitution above one" --headless --scene rod --set restitution=1.5 --steps 1)
set_tests_properties("ch11: 11_rotation refuses a restitution above one" PROPERTIES WILL_FAIL ON)
