# Warnings and sanitizers of our own targets; nothing of it reaches a user of the library.
function(eyeray_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  if(EYERAY_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(EYERAY_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${EYERAY_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${EYERAY_SANITIZE})
    # Code for four lanes differs from that for eight in their number alone, and takes minutes more to build.
    target_compile_definitions(${target} PRIVATE "HWY_DISABLED_TARGETS=(HWY_SSE4|HWY_SSSE3)")
  endif()
endfunction()
