# The program as a reader runs it.
foreach(scene column ten_discs removed hanging_chain loop swinging_chain triangle)
  foreach(method cold previous best_multiple)
    add_program_test(ch08 08_warm_starting "runs scene ${scene} from ${method}" --headless --scene ${scene}
                     --method ${method} --steps 150 --csv -)
  endforeach()
endforeach()
add_program_test(ch08 08_warm_starting "runs two starts side by side in every order" --headless --scene triangle
                 --method cold,best_multiple --set order=3 repaid_by=4 substeps=4 keep=2 --steps 60 --csv -)
add_program_test(ch08 08_warm_starting "refuses a warm start factor above one" --headless --set factor=1.5 --steps 2)
set_tests_properties("ch08: 08_warm_starting refuses a warm start factor above one" PROPERTIES WILL_FAIL ON)
