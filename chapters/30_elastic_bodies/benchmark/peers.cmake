measure_beside(30_elastic_bodies_benchmark bullet)
# CHOLMOD's supernodal factor beside the book's, where SuiteSparse is installed.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
if(CHOLMOD_INCLUDE_DIR AND CHOLMOD_LIBRARY)
  target_include_directories(30_elastic_bodies_benchmark SYSTEM PRIVATE ${CHOLMOD_INCLUDE_DIR})
  target_link_libraries(30_elastic_bodies_benchmark PRIVATE ${CHOLMOD_LIBRARY})
  target_compile_definitions(30_elastic_bodies_benchmark PRIVATE RIGID_CHOLMOD)
endif()
# CalculiX's statics beside the book's, where it is installed.
find_program(CALCULIX_PROGRAM ccx)
if(CALCULIX_PROGRAM)
  target_compile_definitions(30_elastic_bodies_benchmark PRIVATE RIGID_CALCULIX="${CALCULIX_PROGRAM}")
endif()
