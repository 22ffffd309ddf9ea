# The program as a reader runs it.
foreach(scene pyramid house heavy column chain bridge grid dolls poured tumbler piles dominoes bricks wrecker
              seesaw arch rubble cart gates furniture bullets)
  add_program_test(ch19 19_engine "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method by_island,exact,sweeps --set thrown=2 --csv -)
endforeach()
add_program_test(ch19 19_engine "refuses a pyramid without boxes" --headless --scene pyramid --set base=0 --steps 1)
set_tests_properties("ch19: 19_engine refuses a pyramid without boxes" PROPERTIES WILL_FAIL ON)
