# The program as a reader runs it.
foreach(scene two_contacts tableau box_stack ten_discs heavy_top)
  add_program_test(ch05 05_lemke "runs scene ${scene}" --headless --scene ${scene} --steps 300 --csv -)
endforeach()
add_program_test(ch05 05_lemke "walks by each tie rule" --headless --scene tableau --method first_row --steps 20
                 --set family=4 rows=3)
foreach(problem spd_s5 nonsym_pd_s6 column_rest_s3 mass1000_rest_s5 pyramid_impact_s3 disc_chain_s2 fric_boxed_s4
        fric_st_s2 blcp_spd_s10 murty_exp_s6 murty_q1_s16 circulant_ties_12)
  add_program_test(ch05 05_lemke "solves ${problem} from a file" --headless --problem
                   ${PROJECT_SOURCE_DIR}/tests/problems/${problem}.mlcp --method lemke)
  set_tests_properties("ch05: 05_lemke solves ${problem} from a file" PROPERTIES
    PASS_REGULAR_EXPRESSION "status solved")
endforeach()
add_program_test(ch05 05_lemke "says that a problem has no answer" --headless --problem
                 ${PROJECT_SOURCE_DIR}/tests/problems/infeasible_psd2.mlcp --method lemke)
set_tests_properties("ch05: 05_lemke says that a problem has no answer" PROPERTIES
  PASS_REGULAR_EXPRESSION "status infeasible")
