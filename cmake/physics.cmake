# rigid::engine and rigid::physics: the book's physics for any program, without window or command line. It asks for C++20
# and Eigen and forces no warning on anybody.
find_package(Eigen3 REQUIRED NO_MODULE)
if(Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Eigen ${Eigen3_VERSION} is too old: 3.4 or newer is needed")
endif()

# ---- how the book compiles its own sources --------------------------------------------------------
add_library(rigid_flags INTERFACE)
if(MSVC)
  target_compile_options(rigid_flags INTERFACE /W4 /permissive- /utf-8 /bigobj)
  target_compile_definitions(rigid_flags INTERFACE NOMINMAX)
else()
  target_compile_options(rigid_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
  # g++ looks for its own garbage less often: an eighth of the time, for a fifth more memory (at most 2.5 GB a source).
  target_compile_options(rigid_flags INTERFACE
                         "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param=ggc-min-expand=300 --param=ggc-min-heapsize=600000>")
endif()
if(RIGID_WERROR)
  target_compile_options(rigid_flags INTERFACE $<IF:$<CXX_COMPILER_ID:MSVC>,/WX,-Werror>)
endif()
if(RIGID_SANITIZE)
  # What is at address 0 or beyond an object AddressSanitizer finds by itself; to ask at each access is a quarter of the time.
  target_compile_options(rigid_flags INTERFACE -fsanitize=address,undefined -fno-sanitize=null,object-size,vptr
                                                 -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(rigid_flags INTERFACE -fsanitize=address,undefined)
endif()
if(RIGID_NATIVE)
  target_compile_options(rigid_flags INTERFACE -march=native)
  # g++ 12 takes the "undefined" registers of its own AVX-512 headers for uninitialised variables.
  target_compile_options(rigid_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # g++ 12.2 loses a component of `if (length > 0) n = d / length;` when it packs straight-line code for AVX-512:
  # normals came out wrong (chapter 2's Direction). Eigen packs by itself, so little is lost without that pass.
  target_compile_options(rigid_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
endif()

# rigid_options: these flags and the book's headers, for sources that need nothing of the library but its headers.
add_library(rigid_options INTERFACE)
target_include_directories(rigid_options INTERFACE ${PROJECT_SOURCE_DIR})
target_link_libraries(rigid_options INTERFACE rigid_flags Eigen3::Eigen)
# A product and a sum are rounded apart: the same bits with every compiler and optimisation level.
set(rigid_rounding $<IF:$<CXX_COMPILER_ID:MSVC>,/fp:precise,-ffp-contract=off>)
target_compile_options(rigid_options INTERFACE ${rigid_rounding})
# A root of a negative number is no call that sets errno, so the roots of several lanes are one instruction.
target_compile_options(rigid_options INTERFACE $<$<NOT:$<CXX_COMPILER_ID:MSVC>>:-fno-math-errno>)
# In large products Eigen adds up block by block, and would choose the blocks by the caches of the machine at hand: now it
# takes the same everywhere (a first cache of 32 kB). In a page it also has to be told what else it would know of x86-64.
set(rigid_sums EIGEN_NO_CPUID)
if(EMSCRIPTEN)   # what Eigen takes by itself where it sees x86-64
  list(APPEND rigid_sums EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS=16 EIGEN_MAX_STATIC_ALIGN_BYTES=16
       EIGEN_DEFAULT_L1_CACHE_SIZE=32768 EIGEN_DEFAULT_L2_CACHE_SIZE=262144 EIGEN_DEFAULT_L3_CACHE_SIZE=2097152)
endif()
target_compile_definitions(rigid_options INTERFACE ${rigid_sums})

# ---- the library, chapter by chapter ------------------------------------------------------------------
# A program that defines eigen_assert in its own way, as the tests do, brings its own copies of inline functions, and the
# linker may choose them. g++ must not count on the registers that the library's copies leave alone: under Windows, where
# code is not independent of its position, it did.
set(rigid_replaceable $<$<CXX_COMPILER_ID:GNU>:-fno-ipa-ra>)

set(rigid_base_sources common/contact.cpp common/elementary.cpp common/measure.cpp common/scenes.cpp)
add_library(rigid_base STATIC ${rigid_base_sources})
target_link_libraries(rigid_base PUBLIC rigid_options)
# all pairs of discs: the counted work of a build without optimisation would wait for them
target_compile_options(rigid_base PRIVATE ${RIGID_RESULTS_OPTIONS})
if(RIGID_TOGETHER)
  set_target_properties(rigid_base PROPERTIES UNITY_BUILD ON)
endif()
# Eigen's factors: they take longer to compile than the whole program of chapter 1
add_library(rigid_factors STATIC common/eigen_instances.cpp)
target_link_libraries(rigid_factors PUBLIC rigid_options)

# add_chapter_libraries(PREFIX BASE): PREFIX_NN has the sources of chapter NN and stands on those of the chapters before, the
# first of them on BASE. RESULT_NN is the library that has all that chapter NN may use. What a chapter does is so compiled
# once, and for chapter 4 nothing of chapter 5 is. The sources of a chapter are compiled in one go: they share their headers.
# PREFIX_NN_exact are the exact solvers of chapters 2 and 3, which factor dense matrices: half of what chapters 1 to 4 take to
# compile. The program of chapter 4, the first that a reader sees, calls none and stands on PREFIX_04 alone.
# The engine (19) is no chapter that a later one uses; it is only in the library's own, because it is in no test's memory.
set(exact_02 solve_rows)
set(exact_03 answers|case_conditions|cases|direct|family|schur)
function(add_chapter_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;ON")
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC ${arg_ON})
  set_source_files_properties(${arg_SOURCES} PROPERTIES UNITY_GROUP chapter)
  # the counted work of a build without optimisation would wait for them
  target_compile_options(${name} PRIVATE ${RIGID_RESULTS_OPTIONS})
  if(RIGID_TOGETHER)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  endif()
endfunction()
function(add_chapter_libraries prefix base)
  set(last ${base})   # of chapter 1, which has no sources
  set(exact)
  foreach(number RANGE 1 30)
    if(number LESS 10)
      set(number 0${number})
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/${number}_*/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/(small|team)\\.cpp$")
    if(sources AND NOT number EQUAL 19)
      set(exact_sources)
      if(exact_${number})
        set(exact_sources ${sources})
        list(FILTER exact_sources INCLUDE REGEX "/(${exact_${number}})\\.cpp$")
        list(REMOVE_ITEM sources ${exact_sources})
      endif()
      if(number GREATER 4)
        list(APPEND last ${exact})
      endif()
      add_chapter_library(${prefix}_${number} SOURCES ${sources} ON ${last})
      set(last ${prefix}_${number})
      list(APPEND libraries ${last})
      if(exact_sources)
        add_chapter_library(${last}_exact SOURCES ${exact_sources} ON ${last} ${exact} rigid_factors)
        set(exact ${last}_exact)
        list(APPEND libraries ${exact})
      endif()
    endif()
    set(${prefix}_up_to_${number} ${last} ${exact} PARENT_SCOPE)
  endforeach()
  set(${prefix}_libraries ${libraries} PARENT_SCOPE)
endfunction()
add_chapter_libraries(rigid_chapter rigid_base)

# Each part of the world reads the whole engine, so they are compiled together: 94 s of processor in place of 250.
file(GLOB world CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/19_engine/world*.cpp)
add_library(rigid_chapter_19 STATIC EXCLUDE_FROM_ALL ${world})
target_link_libraries(rigid_chapter_19 PUBLIC ${rigid_chapter_up_to_18})
set_source_files_properties(${world} PROPERTIES UNITY_GROUP world)
if(RIGID_TOGETHER)
  set_target_properties(rigid_chapter_19 PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endif()
set(rigid_chapter_up_to_19 rigid_chapter_19)

set(rigid_parts rigid_base rigid_factors ${rigid_chapter_libraries} rigid_chapter_19)
set_target_properties(${rigid_parts} PROPERTIES POSITION_INDEPENDENT_CODE ON)
if(RIGID_FUZZ AND NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
  message(FATAL_ERROR "RIGID_FUZZ needs clang++ (libFuzzer); this is ${CMAKE_CXX_COMPILER_ID}")
endif()
foreach(part ${rigid_parts})
  target_compile_options(${part} PRIVATE ${rigid_replaceable})
  if(RIGID_FUZZ AND part MATCHES "_0[3-9](_exact)?$")   # libFuzzer sees which branches of the solvers a problem has reached
    target_compile_options(${part} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(part MATCHES "_(2[0-9]|3[0-9])$")
    list(APPEND objects_in_space $<TARGET_OBJECTS:${part}>)
  else()
    list(APPEND objects_of_engine $<TARGET_OBJECTS:${part}>)
  endif()
endforeach()

# ---- the library: rigid::engine is chapters 1 to 19, rigid::physics that and the chapters after it ------------
add_library(rigid_engine STATIC ${objects_of_engine})
add_library(rigid_physics STATIC ${objects_in_space})
target_link_libraries(rigid_physics PUBLIC rigid_engine)
foreach(part engine physics)
  add_library(rigid::${part} ALIAS rigid_${part})
  set_target_properties(rigid_${part} PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME ${part})
  target_link_libraries(rigid_${part} PRIVATE $<BUILD_INTERFACE:rigid_flags>)
  if(NOT RIGID_INSTALL)   # a part of another project: what that links is compiled
    set_target_properties(rigid_${part} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
endforeach()
target_compile_features(rigid_engine PUBLIC cxx_std_20)
target_include_directories(rigid_engine PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/rigid>)
target_link_libraries(rigid_engine PUBLIC Eigen3::Eigen)
# Most of the physics is in headers: the bits are the same only if the program that includes them rounds so, too.
target_compile_options(rigid_engine PUBLIC ${rigid_rounding})
target_compile_definitions(rigid_engine PUBLIC ${rigid_sums})
if(MSVC)
  target_compile_definitions(rigid_engine PUBLIC _USE_MATH_DEFINES)
  target_compile_definitions(rigid_options INTERFACE _USE_MATH_DEFINES)
endif()

# How Eigen aligns its memory depends on the instruction set. A program that is compiled with -march=native against a
# library that is not would free what it did not allocate: common/math.hpp refuses it with a sentence.
get_directory_property(options COMPILE_OPTIONS)
set(CMAKE_REQUIRED_FLAGS "${CMAKE_CXX_FLAGS} ${options}")
list(JOIN CMAKE_REQUIRED_FLAGS " " CMAKE_REQUIRED_FLAGS)
if(RIGID_NATIVE)
  string(APPEND CMAKE_REQUIRED_FLAGS " -march=native")
endif()
get_target_property(CMAKE_REQUIRED_INCLUDES Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
string(MD5 flags "${CMAKE_CXX_COMPILER} ${CMAKE_REQUIRED_FLAGS} ${Eigen3_VERSION}")
string(SUBSTRING ${flags} 0 8 flags)
include(CheckCXXSourceCompiles)
foreach(bytes 16 32 64 0)
  check_cxx_source_compiles("#include <Eigen/Core>
    static_assert(EIGEN_MAX_ALIGN_BYTES == ${bytes});
    int main() {}" RIGID_ALIGNS_TO_${bytes}_${flags})
  if(RIGID_ALIGNS_TO_${bytes}_${flags})
    target_compile_definitions(rigid_engine PUBLIC RIGID_ALIGN_BYTES=${bytes})
    target_compile_definitions(rigid_options INTERFACE RIGID_ALIGN_BYTES=${bytes})
    break()
  endif()
endforeach()
unset(CMAKE_REQUIRED_FLAGS)
unset(CMAKE_REQUIRED_INCLUDES)

# What nearly every target of the book stands on: our flags, and what no chapter is about. A target that needs more links the
# library of a chapter, or rigid_physics.
add_library(rigid_common INTERFACE)
target_link_libraries(rigid_common INTERFACE rigid_base rigid_options)

# ---- cmake --install, find_package(rigid CONFIG) ----------------------------------------------------
if(RIGID_INSTALL)
  include(GNUInstallDirs)
  include(CMakePackageConfigHelpers)
  set(package ${CMAKE_INSTALL_LIBDIR}/cmake/rigid)
  install(TARGETS rigid_engine rigid_physics EXPORT rigid_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT rigid_targets NAMESPACE rigid:: FILE rigidTargets.cmake DESTINATION ${package})
  install(DIRECTORY common chapters DESTINATION include/rigid FILES_MATCHING PATTERN "*.hpp"
          PATTERN program EXCLUDE PATTERN benchmark EXCLUDE PATTERN figures EXCLUDE
          PATTERN "*_canvas.hpp" EXCLUDE PATTERN "draw_list.hpp" EXCLUDE)
  write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/rigidConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES cmake/rigidConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/rigidConfigVersion.cmake DESTINATION ${package})
endif()
