# `cmake --install`: the program with its assets, and the core library for find_package(eyeray).
include(CMakePackageConfigHelpers)

install(TARGETS eyeray_core EXPORT eyerayTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/eyeray FILES_MATCHING PATTERN "*.h")
install(EXPORT eyerayTargets NAMESPACE eyeray:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/eyeray)
configure_package_config_file(third_party/eyerayConfig.cmake.in eyerayConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/eyeray)
write_basic_package_version_file(eyerayConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/eyerayConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/eyerayConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/eyeray)
install(DIRECTORY assets/ DESTINATION ${CMAKE_INSTALL_DATADIR}/eyeray PATTERN pictures EXCLUDE)
