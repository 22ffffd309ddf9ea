# The program as a reader runs it.
foreach(scene ten_discs bead rail overlap crowd hanging_chain swinging_chain column triangle towed_discs)
  add_program_test(ch07 07_baumgarte "runs scene ${scene}" --headless --scene ${scene} --steps 120
                   --method baumgarte,none,relaxation,split_impulse,projection --csv -)
endforeach()
add_program_test(ch07 07_baumgarte "refuses a negative beta" --headless --scene column --set beta=-1)
set_tests_properties("ch07: 07_baumgarte refuses a negative beta" PROPERTIES WILL_FAIL ON)
add_program_test(ch07 07_baumgarte "gives up where beta makes the error grow for ever" --headless --scene rail
                 --method baumgarte --set beta=2.5 --steps 3000)
set_tests_properties("ch07: 07_baumgarte gives up where beta makes the error grow for ever" PROPERTIES WILL_FAIL ON)

add_same_bits_test(ch07 07_baumgarte "five ways to repay give the same bits without and with optimisation")
