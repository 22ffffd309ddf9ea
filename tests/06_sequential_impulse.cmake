# The program as a reader runs it.
foreach(scene groove bounce cradle lift belt rope one_sweep triangle column hanging_chain ten_discs)
  add_program_test(ch06 06_sequential_impulse "runs scene ${scene}" --headless --scene ${scene} --steps 200 --csv -)
endforeach()
foreach(method alternating shuffled coloured blocks correction)
  add_program_test(ch06 06_sequential_impulse "runs method ${method}" --headless --scene triangle --method ${method}
                   --steps 100 --csv -)
endforeach()
add_program_test(ch06 06_sequential_impulse "refuses a restitution above one" --headless --scene triangle
                 --set restitution=1.5 --steps 1)
set_tests_properties("ch06: 06_sequential_impulse refuses a restitution above one" PROPERTIES WILL_FAIL ON)

# The same bits without and with optimisation. Every source is compiled anew: nothing optimised is linked in.
if(NOT MSVC)
  foreach(level 0 2)
    add_executable(06_sequential_impulse_trace_O${level} tests/06_sequential_impulse_trace.cpp common/contact.cpp
                                                         common/scenes.cpp)
    target_link_libraries(06_sequential_impulse_trace_O${level} PRIVATE rigid_options)
    target_compile_options(06_sequential_impulse_trace_O${level} PRIVATE -O${level})
  endforeach()
  add_test(NAME "ch06: runs in every order are the same bits without and with optimisation"
           COMMAND ${CMAKE_COMMAND} -DFIRST=$<TARGET_FILE:06_sequential_impulse_trace_O0>
                   -DSECOND=$<TARGET_FILE:06_sequential_impulse_trace_O2>
                   -P ${PROJECT_SOURCE_DIR}/tests/04_pgs_same_output.cmake)
  set_tests_properties("ch06: runs in every order are the same bits without and with optimisation"
                       PROPERTIES LABELS ch06 TIMEOUT 300)
endif()
