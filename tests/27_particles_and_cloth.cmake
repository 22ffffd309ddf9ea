# The program as a reader runs it.
foreach(scene sheet flag curtain banner tear)
  add_program_test(ch27 27_particles_and_cloth "runs scene ${scene}" --headless --scene ${scene} --steps 20
                   --method threads,xpbd,pbd,particles,augmented,projective,implicit --csv -)
endforeach()
add_program_test(ch27 27_particles_and_cloth "runs scene masses" --headless --scene masses --steps 60
                 --method threads,xpbd,pbd,forgotten,particles,augmented,projective,implicit,newton,midpoint,exact,explicit --csv -)
add_program_test(ch27 27_particles_and_cloth "runs scene strip" --headless --scene strip --steps 5
                 --method newton,exact,xpbd --csv -)
add_program_test(ch27 27_particles_and_cloth "runs scene net" --headless --scene net --steps 10
                 --method exact,threads,xpbd,pbd,augmented --csv -)
add_program_test(ch27 27_particles_and_cloth "refuses a sheet of no stiffness" --headless --scene sheet
                 --set stiffness=0 --steps 1)
set_tests_properties("ch27: 27_particles_and_cloth refuses a sheet of no stiffness" PROPERTIES WILL_FAIL ON)
