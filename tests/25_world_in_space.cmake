# The program as a reader runs it.
add_program_test(ch25 25_world_in_space "runs scene heavy_end" --headless --scene heavy_end --steps 300
                 --method exact_cone,cone --csv -)
add_program_test(ch25 25_world_in_space "runs scene cradle" --headless --scene cradle --steps 600 --method cone,exact_cone --csv -)
foreach(scene wall cards dolls car pour)
  add_program_test(ch25 25_world_in_space "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method cone,box,exact_cone --csv -)
endforeach()
add_program_test(ch25 25_world_in_space "runs scene hills" --headless --scene hills --steps 60
                 --method cone,one_by_one,box,exact_cone --csv -)
add_program_test(ch25 25_world_in_space "refuses to pour none" --headless --scene pour --set bodies=0 --steps 1)
set_tests_properties("ch25: 25_world_in_space refuses to pour none" PROPERTIES WILL_FAIL ON)
