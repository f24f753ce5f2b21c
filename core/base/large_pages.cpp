#include "core/base/large_pages.h"

#include <cstdlib>

#include <sys/mman.h>

namespace eyeray {
namespace {
constexpr std::size_t kLargePage = std::size_t{2} << 20U;
}

void* allocateLarge(std::size_t bytes) {
    const bool large = bytes >= kLargePage;
    void* memory = large ? std::aligned_alloc(kLargePage, (bytes + kLargePage - 1) / kLargePage * kLargePage)
                         : std::malloc(bytes);
    if (memory == nullptr && bytes > 0) throw std::bad_alloc();
    if (large) ::madvise(memory, bytes, MADV_HUGEPAGE); // where it is refused, small pages do
    return memory;
}

void freeLarge(void* memory) { std::free(memory); }

}
