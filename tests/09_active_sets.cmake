# The program as a reader runs it.
target_link_libraries(test_09_active_sets PRIVATE ${rigid_chapter_up_to_10})   # 09_rattle.cpp: with bodies that sleep
foreach(scene plane cycle guess fill ten_discs long_chain linkage)
  add_program_test(ch09 09_active_sets "runs scene ${scene}" --headless --scene ${scene} --steps 300 --csv -)
endforeach()
foreach(method dantzig lemke)
  add_program_test(ch09 09_active_sets "guesses by ${method}" --headless --scene guess --method ${method} --steps 100 --csv -)
  set_tests_properties("ch09: 09_active_sets guesses by ${method}" PROPERTIES  # the last column is the status: solved
    PASS_REGULAR_EXPRESSION "\n100,[^\n]*,0\n")
endforeach()
add_program_test(ch09 09_active_sets "refuses a pyramid that is too high" --headless --scene guess --set levels=40 --steps 1)
set_tests_properties("ch09: 09_active_sets refuses a pyramid that is too high" PROPERTIES
  PASS_REGULAR_EXPRESSION "the pyramid has 40 levels")
foreach(problem spd_s5 column_rest_s3 mass1000_rest_s5 pyramid_impact_s3 disc_chain_s2 fric_boxed_s4 blcp_spd_s10)
  foreach(method active_sets dantzig)
    add_program_test(ch09 09_active_sets "solves ${problem} by ${method}" --headless --problem
                     ${PROJECT_SOURCE_DIR}/tests/problems/${problem}.mlcp --method ${method})
    set_tests_properties("ch09: 09_active_sets solves ${problem} by ${method}" PROPERTIES
      PASS_REGULAR_EXPRESSION "status solved")
  endforeach()
endforeach()
# A is not symmetric: Dantzig's method is not for these.
foreach(problem nonsym_pd_s6 fric_st_s2 murty_exp_s6 murty_q1_s16 circulant_ties_12)
  add_program_test(ch09 09_active_sets "solves ${problem} by active_sets" --headless --problem
                   ${PROJECT_SOURCE_DIR}/tests/problems/${problem}.mlcp --method active_sets)
  set_tests_properties("ch09: 09_active_sets solves ${problem} by active_sets" PROPERTIES
    PASS_REGULAR_EXPRESSION "status solved")
endforeach()
foreach(method active_sets dantzig)
  add_program_test(ch09 09_active_sets "says by ${method} that a problem has no answer" --headless --problem
                   ${PROJECT_SOURCE_DIR}/tests/problems/infeasible_psd2.mlcp --method ${method})
  set_tests_properties("ch09: 09_active_sets says by ${method} that a problem has no answer" PROPERTIES
    PASS_REGULAR_EXPRESSION "status infeasible")
endforeach()
