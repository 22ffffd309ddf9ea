# The program as a reader runs it.
foreach(scene book spin handle)
  add_program_test(ch20 20_turning_in_space "runs scene ${scene}" --headless --scene ${scene} --steps 300
                   --method middle,explicit,implicit,momentum --csv -)
endforeach()
