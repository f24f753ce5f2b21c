#pragma once
// What long work of several steps says while it goes on.

#include <chrono>
#include <cstddef>
#include <string>

namespace eyeray {

/// A line on standard error, if that is a terminal and `wanted`: what was done last, how much of all, and the
/// time left.
class Progress {
public:
    explicit Progress(std::size_t steps, bool wanted = true);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    void step(const std::string& what);

private:
    std::size_t steps_, done_ = 0;
    bool shown_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// All of the text on standard output, or Failure.
void printWhole(const std::string& text);

}
