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
  target_link_libraries(${name} PRIVATE eyeray_core GTest::gtest_main OpenEXR::OpenEXR)
  if(needs_app)
    target_link_libraries(${name} PRIVATE eyeray_app)
    add_dependencies(${name} eyeray)
  endif()
  file(STRINGS ${source} needs_folders REGEX "EYERAY_(SOURCE|BINARY)_DIR" LIMIT_COUNT 1)
  if(needs_folders) # the others compile to the same in every checkout, so ccache knows them
    target_compile_definitions(${name} PRIVATE
      EYERAY_SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}" EYERAY_BINARY_DIR="${CMAKE_CURRENT_BINARY_DIR}")
  endif()
  eyeray_compile_options(${name})
  file(STRINGS ${source} has_lanes REGEX "foreach_target" LIMIT_COUNT 1)
  if(NOT has_lanes) # what is tested is optimised, in core and app: to optimise a test takes longer than to run it
    target_compile_options(${name} PRIVATE -O1)
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
  # Read by ctest after discovery, for gtest_discover_tests itself keeps only the first label of a list.
  file(APPEND ${EYERAY_TEST_LABELS}
    "if(${name}_TESTS)\n  set_tests_properties(\${${name}_TESTS} PROPERTIES LABELS \"${labels}\")\nendif()\n")
  foreach(label IN LISTS labels)
    set_property(GLOBAL APPEND PROPERTY EYERAY_TESTS_${label} ${name})
  endforeach()
endfunction()

set(EYERAY_TEST_LABELS ${CMAKE_CURRENT_BINARY_DIR}/test_labels.cmake)
file(WRITE ${EYERAY_TEST_LABELS} "")
file(GLOB EYERAY_TESTS CONFIGURE_DEPENDS tests/*_test.cpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${EYERAY_TESTS})
foreach(source IN LISTS EYERAY_TESTS)
  eyeray_test(${source})
endforeach()
set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${EYERAY_TEST_LABELS})

if(EYERAY_BUILD_APP)
  file(GLOB EYERAY_BENCHMARKS CONFIGURE_DEPENDS tests/bench/*.cpp)
  add_executable(eyeray_bench ${EYERAY_BENCHMARKS})
  target_link_libraries(eyeray_bench PRIVATE eyeray_app)
  eyeray_compile_options(eyeray_bench)

  add_executable(eyeray_leaks_bench EXCLUDE_FROM_ALL tests/bench/leaks/main.cpp)
  target_link_libraries(eyeray_leaks_bench PRIVATE eyeray_core)
  eyeray_compile_options(eyeray_leaks_bench)

  add_executable(eyeray_instructions_bench EXCLUDE_FROM_ALL tests/bench/instructions/main.cpp)
  target_link_libraries(eyeray_instructions_bench PRIVATE eyeray_app)
  eyeray_compile_options(eyeray_instructions_bench)

  add_executable(eyeray_pov_mesh EXCLUDE_FROM_ALL tests/bench/povray/mesh.cpp)
  target_link_libraries(eyeray_pov_mesh PRIVATE eyeray_core)
  eyeray_compile_options(eyeray_pov_mesh)

  find_package(embree 3 REQUIRED) # only a peer to measure against
  file(GLOB EYERAY_RAYS_BENCHMARK CONFIGURE_DEPENDS tests/bench/rays/*.cpp)
  add_executable(eyeray_rays_bench EXCLUDE_FROM_ALL ${EYERAY_RAYS_BENCHMARK})
  target_link_libraries(eyeray_rays_bench PRIVATE eyeray_core embree)
  eyeray_compile_options(eyeray_rays_bench)

  add_test(NAME install_works
    COMMAND ${CMAKE_COMMAND} -DBUILD=${CMAKE_CURRENT_BINARY_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/tests/install_test.cmake)
  set_tests_properties(install_works PROPERTIES LABELS e2e TIMEOUT 300)
  set_property(GLOBAL APPEND PROPERTY EYERAY_TESTS_e2e eyeray)
endif()

# `cmake --build --target tests-threads` builds only what `ctest -L threads` runs.
foreach(label unit image ui e2e robustness threads)
  get_property(targets GLOBAL PROPERTY EYERAY_TESTS_${label})
  add_custom_target(tests-${label})
  if(targets)
    add_dependencies(tests-${label} ${targets})
  endif()
endforeach()
