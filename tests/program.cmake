# Tests of the canvas and the programs' shell.
add_catch_tests(program program FILES tests/program.cpp)
target_link_libraries(test_program PRIVATE rigid_program)

# What a page gets of them, without a browser (docs/web/test has the pages).
add_catch_tests(web program FILES tests/web.cpp common/draw_list.cpp common/program/web_description.cpp
                                  common/program/web_show.cpp)
target_link_libraries(test_web PRIVATE rigid_program)

# add_picture_test(LABEL NAME PROGRAM ARGUMENTS …): one frame by OpenGL without a window must not be
# blank. Skipped where there is no OpenGL.
function(add_picture_test label name program)
  if(NOT TARGET picture_check)
    return()
  endif()
  string(MAKE_C_IDENTIFIER "${program} ${name}" file)
  set(picture ${CMAKE_CURRENT_BINARY_DIR}/${file}.png)
  add_test(NAME "${label}: ${name}" COMMAND ${CMAKE_COMMAND} -DPICTURE=${picture} -DCHECK=$<TARGET_FILE:picture_check>
    -P ${PROJECT_SOURCE_DIR}/tests/check_picture.cmake -- $<TARGET_FILE:${program}> ${ARGN} --png ${picture})
  set_tests_properties("${label}: ${name}" PROPERTIES LABELS ${label} TIMEOUT 300
    SKIP_REGULAR_EXPRESSION "needs OpenGL without a window")
endfunction()

add_executable(program_toy tests/program_toy.cpp)
target_link_libraries(program_toy PRIVATE rigid_program)
precompile(program_toy)
add_picture_test(program "a picture without a window is not blank" program_toy --headless --steps 2)
add_picture_test(program "panes side by side without a window are not blank" program_toy
  --headless --steps 2 --method symplectic,explicit)

# The script `book` with a small book in place of this one.
find_program(SH_PROGRAM sh)
if(SH_PROGRAM AND UNIX)
  add_test(NAME "program: the script finds its book by a link and leaves files where the reader stands"
           COMMAND ${SH_PROGRAM} ${PROJECT_SOURCE_DIR}/tests/book_script.sh ${PROJECT_SOURCE_DIR}/book)
  set_tests_properties("program: the script finds its book by a link and leaves files where the reader stands"
                       PROPERTIES LABELS program TIMEOUT 60)
endif()

# The window itself, where an X server without a screen is at hand.
find_program(XVFB_RUN xvfb-run)
if(XVFB_RUN AND TARGET picture_check)
  set(picture ${CMAKE_CURRENT_BINARY_DIR}/program_window.png)
  add_test(NAME "program: the window with its panel is not blank" COMMAND ${CMAKE_COMMAND} -DPICTURE=${picture}
    -DCHECK=$<TARGET_FILE:picture_check> -P ${PROJECT_SOURCE_DIR}/tests/check_picture.cmake --
    ${XVFB_RUN} -a $<TARGET_FILE:program_toy> --h 0.05 --steps 10 --method symplectic,explicit --png ${picture})
  set_tests_properties("program: the window with its panel is not blank" PROPERTIES LABELS program TIMEOUT 300
    ENVIRONMENT "LSAN_OPTIONS=detect_leaks=0")  # Mesa keeps 112 bytes of its own
endif()
