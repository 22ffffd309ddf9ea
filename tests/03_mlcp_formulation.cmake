# The program as a reader runs it.
foreach(scene bounce corner ten_discs)
  add_program_test(ch03 03_mlcp_formulation "runs 300 steps of scene ${scene}" --headless --scene ${scene} --steps 300 --csv -)
endforeach()
add_program_test(ch03 03_mlcp_formulation "runs a bounce with equations in place of either or" --headless --scene bounce
                 --method equations --steps 300 --csv -)
add_program_test(ch03 03_mlcp_formulation "runs the ten discs by enumerating links and contacts alike" --headless
                 --scene ten_discs --method enumerate --steps 300 --csv -)

function(add_exit_test name code words)
  string(REPLACE ";" "|" arguments "${ARGN}")
  add_test(NAME "ch03: ${name}"
           COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:03_mlcp_formulation> -DARGUMENTS=${arguments} -DCODE=${code}
                   -DWORDS=${words} -P ${PROJECT_SOURCE_DIR}/tests/problems/exit_code.cmake)
  set_tests_properties("ch03: ${name}" PROPERTIES LABELS ch03 TIMEOUT 300)
endfunction()

set(problems ${PROJECT_SOURCE_DIR}/tests/problems)
add_exit_test("a solved problem exits with 0 and says so" 0 "status solved" --headless --problem ${problems}/disc_chain_s2.mlcp
              --method schur)
add_exit_test("enumerate tells how many answers there are" 0 "solution unique" --problem ${problems}/spd_s5.mlcp
              --method enumerate)
add_exit_test("a problem without an answer exits with 3" 3 "status infeasible" --problem ${problems}/infeasible_psd2.mlcp
              --method enumerate)
add_exit_test("a malformed problem exits with 2 and names the line" 2 "line 8: section \"q\" has 1 entries"
              --problem ${problems}/malformed/short_q.mlcp)
add_exit_test("crossed bounds exit with 2 and name the line" 2 "line 10: entry 1 has lo = 2 and hi = 1"
              --problem ${problems}/malformed/crossed_bounds.mlcp --method schur)
add_exit_test("direct refuses a problem with bounds" 2 "the direct solve needs all rows without bounds"
              --problem ${problems}/spd_s5.mlcp --method direct)
