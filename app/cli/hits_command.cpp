#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "app/cli/run.h"
#include "core/base/errors.h"
#include "core/base/thread_pool.h"

namespace eyeray {
namespace {

constexpr std::size_t kBatchBytes = std::size_t{8} << 20;  // read before any of it is traced
constexpr std::size_t kBlockBytes = std::size_t{32} << 10; // traced by one thread
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

/// Standard input in pieces of whole lines, the last of which may lack its line break: as much as is there,
/// so that a program may ask for one ray, read the answer and ask for the next.
class Input {
public:
    /// Empty at the end. Valid until the next call.
    std::string_view next() {
        text_.erase(0, given_);
        std::size_t end = std::string::npos;
        while (end == std::string::npos && !ended_) {
            do read();
            while (!ended_ && text_.size() < kBatchBytes && moreIsThere());
            end = text_.rfind('\n');
            if (end == std::string::npos && text_.size() > kLongestLine)
                throw InputError("rays", "a line of more than a million characters", "write one ray a line");
        }
        given_ = end == std::string::npos ? text_.size() : end + 1;
        return std::string_view(text_).substr(0, given_);
    }

private:
    void read() {
        const std::size_t old = text_.size();
        text_.resize(old + kBlockBytes);
        ssize_t count = 0;
        do count = ::read(STDIN_FILENO, text_.data() + old, kBlockBytes);
        while (count < 0 && errno == EINTR);
        if (count < 0)
            throw Failure("standard input", std::generic_category().message(errno), "give rays, one a line");
        text_.resize(old + static_cast<std::size_t>(count));
        ended_ = count == 0;
    }

    static bool moreIsThere() {
        pollfd input{STDIN_FILENO, POLLIN, 0};
        return poll(&input, 1, 0) > 0;
    }

    std::string text_;
    std::size_t given_ = 0;
    bool ended_ = false;
};

/// Some lines, to be answered by one thread.
struct Block {
    std::string_view lines;
    std::int64_t firstNumber;
    std::string answers;
    std::optional<InputError> fault;
};

std::vector<Block> blocksOf(std::string_view lines, std::int64_t firstNumber) {
    std::vector<Block> blocks;
    while (!lines.empty()) {
        const std::size_t end = std::min(lines.find('\n', std::min(kBlockBytes, lines.size())), lines.size());
        blocks.push_back({lines.substr(0, std::min(end + 1, lines.size())), firstNumber, {}, {}});
        firstNumber += std::ranges::count(blocks.back().lines, '\n');
        lines.remove_prefix(blocks.back().lines.size());
    }
    return blocks;
}

void answer(const HitLines& hits, Block& block) {
    const FloatEnvironment environment;
    try {
        hits.answer(block.lines, block.firstNumber, block.answers);
    } catch (const InputError& error) {
        block.fault = error;
    }
}

void print(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        throw Failure("standard output", "cannot be written", "see that there is room");
}

}

int run(const HitsOptions& options) {
    const Document document = openFor(options.picture).document;
    const HitLines hits(buildWorld(document.scene, {.accel = document.accel, .byStreams = false}),
                        options.question);
    ThreadPool pool(document.threads);
    if (isatty(STDIN_FILENO) != 0)
        fmt::print(stderr, "eyeray: standard input: one ray a line: ox oy oz dx dy dz [tmin tmax]\n");
    Input input;
    std::int64_t number = 1;
    for (std::string_view lines = input.next(); !lines.empty(); lines = input.next()) {
        std::vector<Block> blocks = blocksOf(lines, number);
        pool.forEach(static_cast<int>(blocks.size()), {},
                     [&](int i) { answer(hits, blocks[static_cast<std::size_t>(i)]); });
        for (const Block& block : blocks) { // in order: whatever comes before a wrong line is answered
            print(block.answers);
            if (block.fault) throw InputError(*block.fault);
        }
        if (std::fflush(stdout) != 0)
            throw Failure("standard output", "cannot be written", "see that there is room");
        number += std::ranges::count(lines, '\n');
    }
    return 0;
}

}
