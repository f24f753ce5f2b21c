# cmake -DBUILD=<build folder> -P install_test.cmake: what is built there is installed, another project finds, links
# and runs eyeray::core from it, and the installed program finds its assets from any folder.
set(work ${BUILD}/install_test)
set(prefix ${work}/prefix)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY / OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    string(JOIN " " command ${ARGV})
    message(FATAL_ERROR "${command}\n${output}\nended with ${result}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/install_consumer -B ${work}/consumer
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${work}/consumer)
run(${work}/consumer/consumer)

# A scene that only the installed folder has shows that the program does not read the source tree's.
file(COPY_FILE ${prefix}/share/eyeray/scenes/homage.gltf ${prefix}/share/eyeray/scenes/only-installed.gltf)
run(${prefix}/bin/eyeray scenes)
if(NOT output MATCHES "only-installed")
  message(FATAL_ERROR "the installed program lists other scenes than those installed with it:\n${output}")
endif()
