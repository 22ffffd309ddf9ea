# docs/stability.md and its figures, made again from the committed tables, are the committed ones.
set(tool ${SOURCE}/docs/stability)
file(MAKE_DIRECTORY ${FOLDER})
foreach(command IN ITEMS "draw.py;${tool}/matrix.csv;${FOLDER}"
                         "make_page.py;${tool}/matrix.csv;${tool}/mark.csv;${FOLDER}/stability.md")
  list(POP_FRONT command script)
  execute_process(COMMAND ${PYTHON} -B ${tool}/${script} ${command} RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${script} ended with ${code}")
  endif()
endforeach()
foreach(pair IN ITEMS "stability.md;${SOURCE}/docs/stability.md"
                      "stability_in_depth.md;${SOURCE}/docs/stability_in_depth.md"
                      "stability_overview.svg;${tool}/figures/stability_overview.svg"
                      "stability_matrix.svg;${tool}/figures/stability_matrix.svg"
                      "stability_turning.svg;${tool}/figures/stability_turning.svg"
                      "stability_joints.svg;${tool}/figures/stability_joints.svg"
                      "stability_space.svg;${tool}/figures/stability_space.svg")
  list(GET pair 0 made)
  list(GET pair 1 kept)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${FOLDER}/${made} ${kept} RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(SEND_ERROR "${kept} is not what docs/stability makes of its tables; ./book stress --publish, or make_page.py alone, writes it")
  endif()
endforeach()
