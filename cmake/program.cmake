# rigid_program: what a chapter's main.cpp stands on. The command line is always there; the
# window needs GLFW, GLEW, OpenGL and Dear ImGui, and is left out where one of them is missing.
find_package(CLI11 CONFIG REQUIRED)

add_library(rigid_program STATIC
  common/svg_canvas.cpp
  common/program/command_line.cpp
  common/program/headless.cpp
  common/program/outputs.cpp
  common/program/panel_rows.cpp
  common/program/panes.cpp
  common/program/part_watch.cpp
  common/program/playback.cpp
  common/program/program.cpp
  common/program/progress.cpp
  common/program/run_program.cpp
  common/program/show.cpp
  common/program/table.cpp)
get_target_property(cli11_include CLI11::CLI11 INTERFACE_INCLUDE_DIRECTORIES)
if(cli11_include)
  target_include_directories(rigid_program SYSTEM PRIVATE ${cli11_include})
endif()
target_link_libraries(rigid_program PUBLIC rigid_common PRIVATE CLI11::CLI11)
precompile(rigid_program)

set(RIGID_HAS_WINDOW OFF)
if(RIGID_WINDOW)
  find_package(OpenGL QUIET COMPONENTS OpenGL OPTIONAL_COMPONENTS EGL)
  find_package(GLEW QUIET)
  find_package(glfw3 3.3 QUIET)
  find_package(imgui CONFIG QUIET)               # vcpkg
  if(NOT TARGET imgui::imgui)
    find_package(PkgConfig QUIET)                # Debian
    if(PkgConfig_FOUND)
      pkg_check_modules(IMGUI QUIET IMPORTED_TARGET imgui)
    endif()
  endif()
  find_path(STB_INCLUDE_DIR NAMES stb/stb_image_write.h stb_image_write.h)
  if(TARGET OpenGL::GL AND TARGET GLEW::GLEW AND TARGET glfw AND (TARGET imgui::imgui OR TARGET PkgConfig::IMGUI)
     AND STB_INCLUDE_DIR)
    set(RIGID_HAS_WINDOW ON)
  endif()
endif()

if(RIGID_HAS_WINDOW)
  target_sources(rigid_program PRIVATE common/gl_canvas.cpp common/program/panel.cpp common/program/window.cpp)
  target_compile_definitions(rigid_program PRIVATE RIGID_HAS_WINDOW)
  target_include_directories(rigid_program SYSTEM PRIVATE ${STB_INCLUDE_DIR})
  if(TARGET imgui::imgui)
    set(imgui_target imgui::imgui)
    target_compile_definitions(rigid_program PRIVATE RIGID_IMGUI_FLAT)   # backends stand beside imgui.h
  else()
    set(imgui_target PkgConfig::IMGUI)
  endif()
  foreach(library ${imgui_target} GLEW::GLEW glfw)   # not ours to warn about
    get_target_property(include ${library} INTERFACE_INCLUDE_DIRECTORIES)
    if(include)
      target_include_directories(rigid_program SYSTEM PRIVATE ${include})
    endif()
  endforeach()
  target_link_libraries(rigid_program PRIVATE ${imgui_target} glfw GLEW::GLEW OpenGL::GL ${CMAKE_DL_LIBS})
else()
  message(STATUS "GLFW, GLEW, OpenGL, Dear ImGui or stb not found: the programs are built without a window")
endif()

# Pictures by OpenGL without a window.
if(RIGID_HAS_WINDOW AND TARGET OpenGL::EGL)
  target_sources(rigid_program PRIVATE common/program/offscreen.cpp)
  target_link_libraries(rigid_program PRIVATE OpenGL::EGL)
else()
  target_sources(rigid_program PRIVATE common/program/no_offscreen.cpp)
endif()

# CLI11; and what the tests have a copy of (rigid_test_main)
set_source_files_properties(common/program/command_line.cpp common/program/program.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
compile_together(rigid_program)
