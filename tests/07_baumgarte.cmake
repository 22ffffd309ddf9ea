# The program as a reader runs it.
foreach(scene ten_discs bead rail overlap crowd hanging_chain swinging_chain column triangle towed_discs)
  add_program_test(ch07 07_baumgarte "runs scene ${scene}" --headless --scene ${scene} --steps 120
                   --method baumgarte,none,relaxation,split_impulse,projection --csv -)
endforeach()
add_program_test(ch07 07_baumgarte "refuses a negative beta" --headless --scene column --set beta=-1)
set_tests_properties("ch07: 07_baumgarte refuses a negative beta" PROPERTIES WILL_FAIL ON)
add_program_test(ch07 07_baumgarte "gives up where beta makes the error grow forever" --headless --scene rail
                 --method baumgarte --set beta=2.5 --steps 3000)
set_tests_properties("ch07: 07_baumgarte gives up where beta makes the error grow forever" PROPERTIES WILL_FAIL ON)

# A column of one disc and a chain of one link: the theory of the scene looks at the second body only where there is one.
foreach(scene_and_count column:discs hanging_chain:links)
  string(REPLACE ":" ";" pair ${scene_and_count})
  list(GET pair 0 scene)
  list(GET pair 1 count)
  add_program_test(ch07 07_baumgarte "runs a ${scene} of one" --headless --scene ${scene} --set ${count}=1 --steps 30
                   --csv -)
endforeach()
# What is read past the end of the scene does no harm on most days: valgrind sees it on all.
find_program(VALGRIND_PROGRAM valgrind)
if(VALGRIND_PROGRAM AND NOT RIGID_SANITIZE AND NOT RIGID_NATIVE)
  add_test(NAME "ch07: 07_baumgarte reads nothing beside a column of one disc"
           COMMAND ${VALGRIND_PROGRAM} -q --error-exitcode=9 $<TARGET_FILE:07_baumgarte> --headless --scene column
                   --set discs=1 --steps 2 --csv -)
  set_tests_properties("ch07: 07_baumgarte reads nothing beside a column of one disc" PROPERTIES LABELS ch07 TIMEOUT 300)
endif()
