# The program as a reader runs it.
foreach(scene strip spin)
  add_program_test(ch30 30_elastic_bodies "runs scene ${scene}" --headless --scene ${scene} --steps 20
                   --method corotational,neo_hookean,linear,midpoint,modal --csv -)
endforeach()
foreach(scene ball jelly gripper bridge)
  add_program_test(ch30 30_elastic_bodies "runs scene ${scene}" --headless --scene ${scene} --steps 40
                   --method corotational,neo_hookean,linear --csv -)
endforeach()
foreach(scene ball_in_space jelly_in_space fingers mattress)
  add_program_test(ch30 30_elastic_bodies "runs scene ${scene}" --headless --scene ${scene} --steps 10
                   --method corotational,neo_hookean --csv -)
endforeach()
add_program_test(ch30 30_elastic_bodies "writes the sound of a bar" --wav ${CMAKE_CURRENT_BINARY_DIR}/bar.wav)
add_program_test(ch30 30_elastic_bodies "says that a sound cannot be written" --wav /no/such/folder/bar.wav)
set_tests_properties("ch30: 30_elastic_bodies says that a sound cannot be written" PROPERTIES WILL_FAIL ON)
add_program_test(ch30 30_elastic_bodies "runs scene bar" --headless --scene bar --steps 40
                 --method modal,midpoint,corotational --csv -)
add_program_test(ch30 30_elastic_bodies "refuses a modulus of zero" --headless --scene strip --set young=0 --steps 1)
set_tests_properties("ch30: 30_elastic_bodies refuses a modulus of zero" PROPERTIES WILL_FAIL ON)
