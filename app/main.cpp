#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <system_error>
#include <variant>

#include "app/cli/run.h"
#include "core/base/errors.h"

namespace {

constexpr int kCannot = 1, kWrongRequest = 2;

int complain(const std::exception& error, int code) {
    fmt::print(stderr, "eyeray: {}\n", error.what());
    return code;
}

}

int main(int argc, char** argv) {
    // a closed pipe or a file that grew too large is an error to be told, not an end
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        const auto parsed = eyeray::parseCommandLine(argc, argv);
        if (const int* code = std::get_if<int>(&parsed)) return *code;
        return std::visit([](const auto& options) { return eyeray::run(options); },
                          std::get<eyeray::Options>(parsed));
    } catch (const eyeray::InputError& error) {
        return complain(error, kWrongRequest);
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "eyeray: memory: there is not enough of it: choose a smaller picture or scene\n");
        return kCannot;
    } catch (const std::system_error& error) {
        if (error.code() != std::errc::resource_unavailable_try_again) return complain(error, kCannot);
        fmt::print(stderr, "eyeray: threads: the system starts no more of them: close other programs\n");
        return kCannot;
    } catch (const std::exception& error) {
        return complain(error, kCannot);
    }
}
