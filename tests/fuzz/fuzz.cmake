# One executable per tests/fuzz/*_fuzzer.cpp, for clang: see tests/fuzz/README.md.
file(GLOB EYERAY_FUZZERS CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*_fuzzer.cpp)
foreach(source IN LISTS EYERAY_FUZZERS)
  get_filename_component(name ${source} NAME_WE)
  add_executable(eyeray_${name} ${source} app/document/command.cpp)
  target_link_libraries(eyeray_${name} PRIVATE eyeray_core)
  eyeray_compile_options(eyeray_${name})
  target_link_options(eyeray_${name} PRIVATE -fsanitize=fuzzer)
endforeach()
# Its tables are computed by the compiler, of which clang allows less.
set_property(SOURCE core/image/srgb.cpp APPEND PROPERTY COMPILE_OPTIONS -fconstexpr-steps=100000000)
