# The program without a window: every scene runs, writes its table and its picture, and refuses bad input.
foreach(scene springs projectile kepler pendulum)
  add_program_test(ch01 01_euler_integration "runs ${scene} for 300 steps"
                   --headless --scene ${scene} --steps 300 --csv ${CMAKE_CURRENT_BINARY_DIR}/ch01_${scene}.csv
                   --svg ${CMAKE_CURRENT_BINARY_DIR}/ch01_${scene}.svg)
endforeach()
add_program_test(ch01 01_euler_integration "shows six methods of kepler side by side"
                 --headless --scene kepler --steps 100 --csv ${CMAKE_CURRENT_BINARY_DIR}/ch01_six.csv
                 --method symplectic_euler,explicit_euler,verlet,yoshida4,rk4,dormand_prince)

# Exit code 2 and one sentence for what makes no sense.
foreach(case "a step of zero|--h;0" "an unknown scene|--scene;moon" "an unknown method|--scene;kepler;--method;magic"
             "a value out of range|--scene;kepler;--set;eccentricity=2")
  string(REPLACE "|" ";" parts "${case}")
  list(POP_FRONT parts name)
  add_test(NAME "ch01: 01_euler_integration refuses ${name}"
           COMMAND ${CMAKE_COMMAND} "-Dprogram=$<TARGET_FILE:01_euler_integration>" "-Darguments=--headless;${parts}"
                   -P ${PROJECT_SOURCE_DIR}/tests/01_euler_integration_refuses.cmake)
  set_tests_properties("ch01: 01_euler_integration refuses ${name}" PROPERTIES LABELS ch01 TIMEOUT 60)
endforeach()
