#include "tests/fuzz/lines.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    eyeray::fuzz::lines(std::as_bytes(std::span(data, size)));
    return 0;
}
