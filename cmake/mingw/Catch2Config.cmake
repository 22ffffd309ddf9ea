# Catch2's headers for MinGW: see cmake/mingw.cmake. Version 2 is a header and nothing else.
add_library(Catch2::Catch2 INTERFACE IMPORTED)
set_target_properties(Catch2::Catch2 PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_BINARY_DIR}/host)
list(APPEND CMAKE_MODULE_PATH /usr/lib/cmake/Catch2)   # catch_discover_tests()
