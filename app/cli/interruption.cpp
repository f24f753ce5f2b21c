#include "app/cli/interruption.h"

#include <csignal>

namespace eyeray {
namespace {
volatile std::sig_atomic_t interruption = 0;
}

void heedInterrupts() {
    std::signal(SIGINT, [](int) { interruption = 1; });
    std::signal(SIGTERM, [](int) { interruption = 1; });
}

bool interrupted() { return interruption != 0; }

}
