# The program of docs/use_it.md, built outside the tree as its reader would: with an installed copy, and with the book's
# folder as a part of the project.
string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
foreach(way "an installed copy" "a subdirectory")
  set(name "use it: a program of another project builds and runs with ${way}")
  add_test(NAME ${name}
           COMMAND ${CMAKE_COMMAND} "-DWAY=${way}" -DSOURCE=${PROJECT_SOURCE_DIR} -DBUILD=${CMAKE_BINARY_DIR}
                   -DCOMPILER=${CMAKE_CXX_COMPILER} -DLAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER} -DPROCESSOR=${CMAKE_SYSTEM_PROCESSOR} -DCONFIG=$<CONFIG>
                   "-DFLAGS=${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}" -DSANITIZE=${RIGID_SANITIZE} "-DEIGEN=${Eigen3_DIR}" -DGENERATOR=${CMAKE_GENERATOR}
                   -P ${PROJECT_SOURCE_DIR}/tests/use_it_run.cmake)
  set_tests_properties(${name} PROPERTIES LABELS use_it TIMEOUT 900 COST 1000)   # the longest: begun first
endforeach()
