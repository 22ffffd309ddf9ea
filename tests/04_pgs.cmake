# The program as a reader runs it.
add_program_test(ch04 04_pgs "runs scene ten_discs" --headless --steps 300 --csv -)
foreach(scene column hanging_chain mass_ratio sweeps zigzag)
  add_program_test(ch04 04_pgs "runs scene ${scene}" --headless --scene ${scene} --steps 300 --csv -)
endforeach()
add_program_test(ch04 04_pgs "solves a problem from a file" --headless --problem
                 ${PROJECT_SOURCE_DIR}/tests/problems/spd_s5.mlcp --method pgs)
add_program_test(ch04 04_pgs "gives up on infeasible rows" --headless --problem
                 ${PROJECT_SOURCE_DIR}/tests/problems/infeasible_psd2.mlcp --method pgs)
set_tests_properties("ch04: 04_pgs gives up on infeasible rows" PROPERTIES WILL_FAIL ON)
add_program_test(ch04 04_pgs "refuses a bounded problem for conjugate gradients" --headless --problem
                 ${PROJECT_SOURCE_DIR}/tests/problems/spd_s5.mlcp --method cg)
set_tests_properties("ch04: 04_pgs refuses a bounded problem for conjugate gradients" PROPERTIES WILL_FAIL ON)

# Without --method a problem with contacts is solved too: the default is the chapter's own method.
add_program_test(ch04 04_pgs "solves a problem with bounds without being told how" --headless --problem
                 ${PROJECT_SOURCE_DIR}/tests/problems/fric_boxed_s4.mlcp)
