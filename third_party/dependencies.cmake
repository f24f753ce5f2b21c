# Every dependency comes from the system; third_party/packages.txt names the Debian packages.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE) # Debian's Imath would report that its Python binding is not installed
find_package(OpenEXR REQUIRED)
unset(CMAKE_MESSAGE_LOG_LEVEL)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(hwy REQUIRED)

if(EYERAY_BUILD_APP)
  find_package(glfw3 REQUIRED)
  find_package(CLI11 REQUIRED)
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
  pkg_check_modules(osmesa REQUIRED osmesa) # its header: the program loads the library when it needs it
  find_file(EYERAY_FONT DejaVuSans.ttf REQUIRED PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/TTF)
endif()
