# Toolchain file of the preset `mingw`: Windows programs compiled on Linux by MinGW (Debian: g++-mingw-w64-x86-64-posix), and
# run by Wine (wine64) where it is installed. Without window.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
find_program(RIGID_WINE NAMES wine wine64 PATHS /usr/lib/wine)
if(RIGID_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${RIGID_WINE})
endif()
set(CMAKE_CXX_FLAGS_INIT "-Wa,-mbig-obj")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")   # no DLL of the compiler's needs to be found
# … nor that of its threads: the library of the same name for static linking, which FindOpenMP takes second.
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libgomp.a OUTPUT_VARIABLE gomp OUTPUT_STRIP_TRAILING_WHITESPACE)
if(IS_ABSOLUTE "${gomp}")
  set(OpenMP_gomp_LIBRARY ${gomp} CACHE FILEPATH "OpenMP of MinGW, for static linking")
endif()

# Libraries of headers alone are this system's. /usr/include itself has the headers of another C library, so that they get
# a folder without those: cmake/mingw/*Config.cmake name it.
set(RIGID_HOST_HEADERS ${CMAKE_BINARY_DIR}/host)
file(MAKE_DIRECTORY ${RIGID_HOST_HEADERS})
foreach(library CLI catch2)
  if(EXISTS /usr/include/${library} AND NOT EXISTS ${RIGID_HOST_HEADERS}/${library})
    file(CREATE_LINK /usr/include/${library} ${RIGID_HOST_HEADERS}/${library} SYMBOLIC)
  endif()
endforeach()
