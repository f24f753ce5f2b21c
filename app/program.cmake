# The program `eyeray`: everything but main in a library that the tests link too.
file(GLOB_RECURSE EYERAY_APP_SOURCES CONFIGURE_DEPENDS app/*.cpp app/*.S)
list(REMOVE_ITEM EYERAY_APP_SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/app/main.cpp)
add_library(eyeray_app STATIC ${EYERAY_APP_SOURCES})
target_include_directories(eyeray_app PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(eyeray_app
  PUBLIC eyeray_core PkgConfig::imgui
  PRIVATE glfw CLI11::CLI11 nlohmann_json::nlohmann_json ${CMAKE_DL_LIBS})
set_source_files_properties(app/gl/font.S PROPERTIES
  COMPILE_DEFINITIONS EYERAY_FONT="${EYERAY_FONT}" OBJECT_DEPENDS ${EYERAY_FONT})
target_include_directories(eyeray_app SYSTEM PRIVATE ${osmesa_INCLUDE_DIRS})
eyeray_compile_options(eyeray_app)

add_executable(eyeray app/main.cpp)
target_link_libraries(eyeray PRIVATE eyeray_app)
file(RELATIVE_PATH EYERAY_ASSETS_FROM_BIN ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/eyeray)
set_property(SOURCE app/document/scene_files.cpp APPEND PROPERTY COMPILE_DEFINITIONS
  EYERAY_BUILD_ASSETS="${CMAKE_CURRENT_SOURCE_DIR}/assets" EYERAY_INSTALLED_ASSETS="${EYERAY_ASSETS_FROM_BIN}")
set_property(SOURCE app/document/picture_file.cpp app/cli/options.cpp APPEND PROPERTY COMPILE_DEFINITIONS
  EYERAY_VERSION="${PROJECT_VERSION}")
eyeray_compile_options(eyeray)
install(TARGETS eyeray)
