# The program as a reader runs it.
foreach(scene groove bounce cradle lift belt rope one_sweep triangle column hanging_chain ten_discs)
  add_program_test(ch06 06_sequential_impulse "runs scene ${scene}" --headless --scene ${scene} --steps 200 --csv -)
endforeach()
foreach(method alternating shuffled coloured blocks correction)
  add_program_test(ch06 06_sequential_impulse "runs method ${method}" --headless --scene triangle --method ${method}
                   --steps 100 --csv -)
endforeach()
add_program_test(ch06 06_sequential_impulse "refuses a restitution above one" --headless --scene triangle
                 --set restitution=1.5 --steps 1)
set_tests_properties("ch06: 06_sequential_impulse refuses a restitution above one" PROPERTIES WILL_FAIL ON)
