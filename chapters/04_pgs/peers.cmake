# Bullet's solver of the same name, in doubles, where the library is installed.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(BULLET64 QUIET IMPORTED_TARGET bullet-float64)
endif()
if(TARGET PkgConfig::BULLET64)
  # Its own copy of the include folder as a SYSTEM one: its headers are not ours to warn about.
  target_include_directories(04_pgs_benchmark SYSTEM PRIVATE ${BULLET64_INCLUDE_DIRS})
  target_link_libraries(04_pgs_benchmark PRIVATE PkgConfig::BULLET64)
  target_compile_definitions(04_pgs_benchmark PRIVATE RIGID_HAS_BULLET BT_USE_DOUBLE_PRECISION)
else()
  message(STATUS "Bullet (bullet-float64) not found: chapter 4's benchmark runs without it")
endif()
