# The program as a reader runs it.
foreach(scene ball tablecloth fold hills)
  add_program_test(ch28 28_cloth_that_touches "runs scene ${scene}" --headless --scene ${scene} --steps 20
                   --method threads,xpbd,pbd,particles,augmented,projective,implicit --csv -)
endforeach()
foreach(scene trampoline goal bridge pole)
  add_program_test(ch28 28_cloth_that_touches "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method threads,xpbd,pbd --csv -)
endforeach()
add_program_test(ch28 28_cloth_that_touches "runs scene drum" --headless --scene drum --steps 30
                 --method threads,xpbd --csv -)
add_program_test(ch28 28_cloth_that_touches "refuses a thickness of more than half a square" --headless --scene fold
                 --set thickness=30 --set squares=40 --steps 1)
set_tests_properties("ch28: 28_cloth_that_touches refuses a thickness of more than half a square" PROPERTIES WILL_FAIL ON)
