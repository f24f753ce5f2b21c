# One executable per tests/*_test.cpp. Its line `// labels: …` names its CTest labels; a file that
# includes from app/ is built only with the program.
find_package(GTest REQUIRED)
include(GoogleTest)

function(eyeray_test source)
  get_filename_component(name ${source} NAME_WE)
  file(STRINGS ${source} labels REGEX "^// labels: " LIMIT_COUNT 1)
  string(REPLACE "// labels: " "" labels "${labels}")
  string(REPLACE " " ";" labels "${labels}")
  if(NOT labels)
    message(FATAL_ERROR "${source} has no line `// labels: …`")
  endif()
  file(STRINGS ${source} needs_app REGEX "^#include \"(app/|tests/app_)" LIMIT_COUNT 1)
  if(needs_app AND NOT EYERAY_BUILD_APP)
    return()
  endif()
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE eyeray_core GTest::gtest_main)
  if(needs_app)
    target_link_libraries(${name} PRIVATE eyeray_app)
    add_dependencies(${name} eyeray)
  endif()
  target_compile_definitions(${name} PRIVATE
    EYERAY_SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}" EYERAY_BINARY_DIR="${CMAKE_CURRENT_BINARY_DIR}")
  eyeray_compile_options(${name})
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS "${labels}" TIMEOUT 300)
  foreach(label IN LISTS labels)
    set_property(GLOBAL APPEND PROPERTY EYERAY_TESTS_${label} ${name})
  endforeach()
endfunction()

file(GLOB EYERAY_TESTS CONFIGURE_DEPENDS tests/*_test.cpp)
foreach(source IN LISTS EYERAY_TESTS)
  eyeray_test(${source})
endforeach()

# `cmake --build --target tests-threads` builds only what `ctest -L threads` runs.
foreach(label unit image ui e2e robustness threads)
  get_property(targets GLOBAL PROPERTY EYERAY_TESTS_${label})
  add_custom_target(tests-${label} DEPENDS ${targets})
endforeach()
