# measure_beside(TARGET PEER…): gives a benchmark the programs that it measures beside the book, where they are
# installed: odeint bullet siconos ode simbody mujoco box2d chipmunk. The code asks for RIGID_HAS_ODEINT and so on.
if(NOT benchmark_FOUND)
  return()
endif()

# rigid_peer_NAME: what a target needs that uses it. Its headers are not ours to warn about: SYSTEM.
macro(add_peer name title)
  if(${ARGN})
    add_library(rigid_peer_${name} INTERFACE)
    string(TOUPPER ${name} upper)
    target_compile_definitions(rigid_peer_${name} INTERFACE RIGID_HAS_${upper})
  else()
    message(STATUS "${title} not found: the benchmarks run without it")
  endif()
endmacro()

find_package(Boost 1.67 QUIET)
add_peer(odeint "Boost.odeint (libboost-dev)" Boost_FOUND)
if(TARGET rigid_peer_odeint)
  target_include_directories(rigid_peer_odeint SYSTEM INTERFACE ${Boost_INCLUDE_DIRS})
endif()

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(BULLET64 QUIET IMPORTED_TARGET bullet-float64)
  pkg_check_modules(ODE QUIET IMPORTED_TARGET ode)
endif()

add_peer(bullet "Bullet in doubles (libbullet-dev: bullet-float64)" TARGET PkgConfig::BULLET64)
if(TARGET rigid_peer_bullet)
  target_include_directories(rigid_peer_bullet SYSTEM INTERFACE ${BULLET64_INCLUDE_DIRS})
  target_link_libraries(rigid_peer_bullet INTERFACE PkgConfig::BULLET64)
  target_compile_definitions(rigid_peer_bullet INTERFACE BT_USE_DOUBLE_PRECISION)
endif()

# ODE exports its solver but has no header for it: does it link, and with doubles?
if(TARGET PkgConfig::ODE)
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_LIBRARIES PkgConfig::ODE)
  check_cxx_source_compiles("
    #include <cstddef>
    class dxWorldProcessMemArena;
    struct dxWorldProcessMemoryManager;
    struct dxWorldProcessMemoryReserveInfo;
    size_t dxEstimateSolveLCPMemoryReq(unsigned, bool);
    dxWorldProcessMemArena* dxAllocateTemporaryWorldProcessMemArena(
        size_t, const dxWorldProcessMemoryManager*, const dxWorldProcessMemoryReserveInfo*);
    void dxFreeTemporaryWorldProcessMemArena(dxWorldProcessMemArena*);
    void dxSolveLCP(dxWorldProcessMemArena*, unsigned, double*, double*, double*, unsigned, double*, int*);
    int main()
    {
        dxSolveLCP(dxAllocateTemporaryWorldProcessMemArena(dxEstimateSolveLCPMemoryReq(1, false), nullptr, nullptr),
                   0, nullptr, nullptr, nullptr, 0, nullptr, nullptr);
        dxFreeTemporaryWorldProcessMemArena(nullptr);
    }" RIGID_ODE_HAS_DANTZIG)
  unset(CMAKE_REQUIRED_LIBRARIES)
endif()
add_peer(ode "ODE (libode-dev)" RIGID_ODE_HAS_DANTZIG)
if(TARGET rigid_peer_ode)
  target_link_libraries(rigid_peer_ode INTERFACE PkgConfig::ODE)
endif()

# Simbody 3.7's headers are none of C++20: one source alone sees them.
find_package(Simbody CONFIG QUIET)
if(Simbody_FOUND)
  add_library(rigid_peer_simbody STATIC EXCLUDE_FROM_ALL tests/peers/simbody_world.cpp)
  set_target_properties(rigid_peer_simbody PROPERTIES CXX_STANDARD 17)
  target_include_directories(rigid_peer_simbody PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_include_directories(rigid_peer_simbody SYSTEM PRIVATE ${Simbody_INCLUDE_DIR})
  target_link_libraries(rigid_peer_simbody PRIVATE ${Simbody_LIBRARIES})
  target_compile_definitions(rigid_peer_simbody INTERFACE RIGID_HAS_SIMBODY)
else()
  message(STATUS "Simbody (libsimbody-dev) not found: the benchmarks run without it")
endif()

find_package(mujoco CONFIG QUIET)
add_peer(mujoco "MuJoCo (libmujoco-dev)" TARGET mujoco::mujoco)
if(TARGET rigid_peer_mujoco)
  target_link_libraries(rigid_peer_mujoco INTERFACE mujoco::mujoco)
endif()

find_path(SICONOS_INCLUDE_DIR LinearComplementarityProblem.h PATH_SUFFIXES siconos/numerics)
find_path(SICONOS_TOOLS_INCLUDE_DIR SiconosConfig.h PATH_SUFFIXES siconos siconos/externals)
find_library(SICONOS_NUMERICS siconos_numerics)
add_peer(siconos "Siconos (libsiconos-numerics-dev)"
         SICONOS_INCLUDE_DIR AND SICONOS_TOOLS_INCLUDE_DIR AND SICONOS_NUMERICS)
if(TARGET rigid_peer_siconos)
  target_include_directories(rigid_peer_siconos SYSTEM INTERFACE
    ${SICONOS_INCLUDE_DIR} ${SICONOS_TOOLS_INCLUDE_DIR} ${SICONOS_INCLUDE_DIR}/../externals ${SICONOS_INCLUDE_DIR}/..)
  target_link_libraries(rigid_peer_siconos INTERFACE ${SICONOS_NUMERICS} ${CMAKE_DL_LIBS})
endif()

find_path(BOX2D_INCLUDE_DIR box2d/box2d.h)
find_library(BOX2D_LIBRARY box2d)
add_peer(box2d "Box2D (libbox2d-dev)" BOX2D_INCLUDE_DIR AND BOX2D_LIBRARY)
if(TARGET rigid_peer_box2d)
  target_include_directories(rigid_peer_box2d SYSTEM INTERFACE ${BOX2D_INCLUDE_DIR})
  target_link_libraries(rigid_peer_box2d INTERFACE ${BOX2D_LIBRARY})
endif()

find_path(CHIPMUNK_INCLUDE_DIR chipmunk/chipmunk.h)
find_library(CHIPMUNK_LIBRARY chipmunk)
add_peer(chipmunk "Chipmunk (libchipmunk-dev)" CHIPMUNK_INCLUDE_DIR AND CHIPMUNK_LIBRARY)
if(TARGET rigid_peer_chipmunk)
  target_include_directories(rigid_peer_chipmunk SYSTEM INTERFACE ${CHIPMUNK_INCLUDE_DIR})
  target_link_libraries(rigid_peer_chipmunk INTERFACE ${CHIPMUNK_LIBRARY})
endif()

function(measure_beside target)
  foreach(peer IN LISTS ARGN)
    if(TARGET rigid_peer_${peer})
      target_link_libraries(${target} PRIVATE rigid_peer_${peer})
    endif()
  endforeach()
endfunction()

# measure_beside_box2d3(TARGET SOURCE): and Box2D 3, where it is installed (or -Dbox2d_DIR=…). Its headers have the names of
# Box2D 2.4's, so one source alone sees them: a library apart. A macro, because a language is enabled for a whole file.
macro(measure_beside_box2d3 target source)
  find_package(box2d 3 CONFIG QUIET)
  if(TARGET box2d::box2d)
    enable_language(C)   # its C library may want -lm and threads of it
    add_library(${target}_box2d3 STATIC EXCLUDE_FROM_ALL ${source})
    target_link_libraries(${target}_box2d3 PRIVATE rigid_common rigid_physics box2d::box2d)
    target_link_libraries(${target} PRIVATE ${target}_box2d3)
    target_compile_definitions(${target} PRIVATE RIGID_HAS_BOX2D3)
  endif()
endmacro()
