#include "tests/fuzz/scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    eyeray::fuzz::scene(std::as_bytes(std::span(data, size)));
    return 0;
}
