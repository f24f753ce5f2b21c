#include "app/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "core/base/errors.h"

namespace eyeray {

Progress::Progress(std::size_t steps, bool wanted)
    : steps_(steps), shown_(wanted && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::step(const std::string& what) {
    ++done_;
    if (!shown_) return;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    const double left = spent.count() / static_cast<double>(done_) * static_cast<double>(steps_ - done_);
    fmt::print(stderr, "\r{}: {:.0f} %, {:.0f} s left\033[K", what,
               100.0 * static_cast<double>(done_) / static_cast<double>(steps_), left);
    std::fflush(stderr);
}

void printWhole(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw Failure("standard output", "cannot be written", "see that there is room");
}

}
