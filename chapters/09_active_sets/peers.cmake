# Other programs' exact solvers, where the libraries are installed: ODE's and Bullet's Dantzig, Siconos' Lemke.
find_package(PkgConfig QUIET)

# ODE exports its solver but has no header for it: does it link, and with doubles?
if(PkgConfig_FOUND)
  pkg_check_modules(ODE QUIET IMPORTED_TARGET ode)
endif()
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
if(RIGID_ODE_HAS_DANTZIG)
  target_link_libraries(09_active_sets_benchmark PRIVATE PkgConfig::ODE)
  target_compile_definitions(09_active_sets_benchmark PRIVATE RIGID_HAS_ODE)
else()
  message(STATUS "ODE (libode-dev) not found: chapter 9's benchmark runs without it")
endif()

find_path(SICONOS_INCLUDE_DIR LinearComplementarityProblem.h PATH_SUFFIXES siconos/numerics)
find_path(SICONOS_TOOLS_INCLUDE_DIR SiconosConfig.h PATH_SUFFIXES siconos siconos/externals)
find_library(SICONOS_NUMERICS siconos_numerics)
if(SICONOS_INCLUDE_DIR AND SICONOS_TOOLS_INCLUDE_DIR AND SICONOS_NUMERICS)
  target_include_directories(09_active_sets_benchmark SYSTEM PRIVATE ${SICONOS_INCLUDE_DIR} ${SICONOS_TOOLS_INCLUDE_DIR}
                             ${SICONOS_INCLUDE_DIR}/../externals ${SICONOS_INCLUDE_DIR}/..)
  target_link_libraries(09_active_sets_benchmark PRIVATE ${SICONOS_NUMERICS} ${CMAKE_DL_LIBS})
  target_compile_definitions(09_active_sets_benchmark PRIVATE RIGID_HAS_SICONOS)
else()
  message(STATUS "Siconos (libsiconos-numerics-dev) not found: chapter 9's benchmark runs without it")
endif()

if(PkgConfig_FOUND)
  pkg_check_modules(BULLET64 QUIET IMPORTED_TARGET bullet-float64)
endif()
if(TARGET PkgConfig::BULLET64)
  # Its own copy of the include folder as a SYSTEM one: its headers are not ours to warn about.
  target_include_directories(09_active_sets_benchmark SYSTEM PRIVATE ${BULLET64_INCLUDE_DIRS})
  target_link_libraries(09_active_sets_benchmark PRIVATE PkgConfig::BULLET64)
  target_compile_definitions(09_active_sets_benchmark PRIVATE RIGID_HAS_BULLET BT_USE_DOUBLE_PRECISION)
else()
  message(STATUS "Bullet (bullet-float64) not found: chapter 9's benchmark runs without it")
endif()
