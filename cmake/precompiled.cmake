# precompile(TARGET): compiles a target of the book's own with the shared precompiled header: the standard library and
# Eigen are parsed once (Eigen's factorisations are compiled once, in rigid_factors). It saves about a third of a build. A
# build without it (-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON, .ci/run alone) gives the same bits and shows a header that
# relies on it. The library that is used (release) is compiled without it: a program that uses it has none. Where clang++ only looks
# at the library (presets clang and asan: RIGID_LIBRARY_PRECOMPILED), it is with it.
option(RIGID_LIBRARY_PRECOMPILED "Compile the physics with the precompiled header, too (clang++ only)" OFF)
if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS AND NOT MSVC)
  function(add_precompiled name)
    add_library(${name} STATIC cmake/precompiled/precompiled.cpp)
    target_link_libraries(${name} PRIVATE rigid_options)
    target_compile_options(${name} PRIVATE ${ARGN})
    target_precompile_headers(${name} PRIVATE common/eigen_instances.hpp cmake/precompiled/standard.hpp)
  endfunction()
  add_precompiled(rigid_precompiled)
  if(RIGID_LIBRARY_PRECOMPILED AND CMAKE_CXX_COMPILER_ID MATCHES Clang)
    # what it declares is made there
    set_source_files_properties(common/eigen_instances.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    if(RIGID_RESULTS_OPTIONS)
      add_precompiled(rigid_precompiled_for_results ${RIGID_RESULTS_OPTIONS})
    endif()
    foreach(part ${rigid_parts})
      get_target_property(options ${part} COMPILE_OPTIONS)
      if(RIGID_RESULTS_OPTIONS AND "${RIGID_RESULTS_OPTIONS}" IN_LIST options)
        target_precompile_headers(${part} REUSE_FROM rigid_precompiled_for_results)
      elseif(NOT "-fsanitize=fuzzer-no-link" IN_LIST options)   # else the header would have to be compiled so, too
        target_precompile_headers(${part} REUSE_FROM rigid_precompiled)
      endif()
    endforeach()
    set_target_properties(${rigid_parts} PROPERTIES POSITION_INDEPENDENT_CODE OFF)   # as the header is compiled
  endif()
endif()

# compile_together(TARGET): its sources are compiled some at a time, one after the other in one go, so what they share is
# compiled once for all of them: about half of the time. An author who edits one of them builds with -DRIGID_TOGETHER=OFF.
# Each source must stand alone all the same (.ci/run alone).
function(compile_together target)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources number)
  if(RIGID_TOGETHER AND number GREATER 1)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 5)
    # g++ takes the anonymous namespace of an included source for that of a header.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

function(precompile target)
  if(TARGET rigid_precompiled)
    target_precompile_headers(${target} REUSE_FROM rigid_precompiled)
    target_link_libraries(${target} PRIVATE rigid_precompiled)
  endif()
endfunction()
