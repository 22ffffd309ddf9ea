# The program as a reader runs it.
foreach(scene column ten_discs removed hanging_chain loop swinging_chain triangle)
  foreach(method cold yesterday best_multiple)
    add_program_test(ch08 08_warm_starting "runs scene ${scene} from ${method}" --headless --scene ${scene}
                     --method ${method} --steps 150 --csv -)
  endforeach()
endforeach()
add_program_test(ch08 08_warm_starting "runs two starts side by side in every order" --headless --scene triangle
                 --method cold,best_multiple --set order=3 repaid_by=4 substeps=4 keep=2 --steps 60 --csv -)
add_program_test(ch08 08_warm_starting "refuses a share above one" --headless --set share=1.5 --steps 2)
set_tests_properties("ch08: 08_warm_starting refuses a share above one" PROPERTIES WILL_FAIL ON)

# The same bits without and with optimisation. Every source is compiled anew: nothing optimised is linked in.
if(NOT MSVC)
  foreach(level 0 2)
    add_executable(08_warm_starting_trace_O${level} tests/08_warm_starting_trace.cpp common/contact.cpp
                                                    common/measure.cpp common/scenes.cpp)
    target_link_libraries(08_warm_starting_trace_O${level} PRIVATE rigid_options)
    target_compile_options(08_warm_starting_trace_O${level} PRIVATE -O${level})
  endforeach()
  add_test(NAME "ch08: 300 warm steps of two scenes are the same bits without and with optimisation"
           COMMAND ${CMAKE_COMMAND} -DFIRST=$<TARGET_FILE:08_warm_starting_trace_O0>
                   -DSECOND=$<TARGET_FILE:08_warm_starting_trace_O2>
                   -P ${PROJECT_SOURCE_DIR}/tests/04_pgs_same_output.cmake)
  set_tests_properties("ch08: 300 warm steps of two scenes are the same bits without and with optimisation"
                       PROPERTIES LABELS ch08 TIMEOUT 300)
endif()
