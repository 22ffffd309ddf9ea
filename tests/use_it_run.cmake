# Builds docs/use_it in a folder of its own outside SOURCE, by WAY, and runs it.
function(run what)   # ends the test unless the command ends with 0
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    file(REMOVE_RECURSE ${folder})
    message(FATAL_ERROR "${what} ended with ${code}:\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

unset(ENV{MALLOC_PERTURB_})   # the compiler's memory is not what is tested
string(RANDOM LENGTH 8 unique)
set(temporary $ENV{TMPDIR})
if(NOT temporary)
  set(temporary /tmp)
endif()
set(folder ${temporary}/rigid_use_it_${unique})
file(COPY ${SOURCE}/docs/use_it/ DESTINATION ${folder}/program)
set(configure ${CMAKE_COMMAND} -G ${GENERATOR} -S ${folder}/program -B ${folder}/build -DCMAKE_CXX_COMPILER=${COMPILER}
    -DEigen3_DIR=${EIGEN})
if(SANITIZE)
  list(APPEND configure "-DCMAKE_CXX_FLAGS=-fsanitize=address,undefined")
endif()
if(WAY STREQUAL "a subdirectory")
  list(APPEND configure -DRIGID_SOURCE=${SOURCE})
else()
  run("cmake --install" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/installed --config ${CONFIG})
  list(APPEND configure -DCMAKE_PREFIX_PATH=${folder}/installed)
endif()

run("configuring the program" ${configure})
file(STRINGS ${folder}/build/CMakeCache.txt asked REGEX "^(Catch2_DIR|CLI11_DIR|benchmark_DIR|glfw3_DIR|ODE_|BOX2D)")
file(STRINGS ${folder}/build/CMakeCache.txt build_type REGEX "^CMAKE_BUILD_TYPE:[A-Z]*=.")
run("building the program" ${CMAKE_COMMAND} --build ${folder}/build --verbose)
string(FIND "${said}" "-Wconversion" warns)
if(WAY STREQUAL "an installed copy" AND NOT warns EQUAL -1)
  list(APPEND asked "-Wconversion for the program")
endif()
run("the program" ${folder}/build/my_program)
run("the program with a stack" ${folder}/build/my_stack)
run("the program with a world" ${folder}/build/my_world)
run("the program with a lift" ${folder}/build/my_lift)

# An instruction set for the program alone would make Eigen free what it did not allocate: refused with a sentence.
if(PROCESSOR MATCHES "^(x86_64|AMD64)$")
  # not optimised: whether it builds is all that is asked
  execute_process(COMMAND ${configure} "-DCMAKE_CXX_FLAGS=-mavx" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=
                          -B ${folder}/avx OUTPUT_QUIET ERROR_QUIET)
  set(what)
  if(WAY STREQUAL "a subdirectory" AND GENERATOR STREQUAL Ninja)   # the program's objects: the physics has been compiled
    set(what --target CMakeFiles/my_program.dir/main.cpp.o CMakeFiles/my_world.dir/world.cpp.o rigid_base)
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder}/avx ${what} RESULT_VARIABLE code OUTPUT_VARIABLE refusal
                  ERROR_VARIABLE refusal)
  if(WAY STREQUAL "an installed copy")
    string(REGEX MATCH "compile both for the same instruction set" sentence "${refusal}")
    if(code EQUAL 0 OR NOT sentence)
      list(APPEND asked "a program with -mavx is not refused (${code}): ${refusal}")
    endif()
  elseif(NOT code EQUAL 0)   # here the flags are those of both
    list(APPEND asked "with -mavx for both it does not build: ${refusal}")
  endif()
endif()

file(REMOVE_RECURSE ${folder})
if(asked)
  message(FATAL_ERROR "a program that only wants the physics was given: ${asked}")
endif()
if(build_type)
  message(FATAL_ERROR "the program chose no build type and got ${build_type}")
endif()
