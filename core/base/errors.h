#pragma once
// The three ways a job can fail: the user's input, the machine, or a mistake of ours.

#include <stdexcept>
#include <string>

namespace eyeray {

/// What every error says in one line: where it is, what is wrong, what to do.
class Error : public std::runtime_error {
public:
    Error(std::string where, const std::string& what, const std::string& remedy);

    const std::string& where() const { return where_; }

private:
    std::string where_;
};

/// The user's file or argument is wrong (exit code 2).
class InputError : public Error {
    using Error::Error;
};

/// The machine could not do it: disk, memory, display (exit code 1).
class Failure : public Error {
    using Error::Error;
};

/// A mistake of ours, found by ENSURE.
class InternalError : public std::logic_error {
    using std::logic_error::logic_error;
};

/// One printable line: control characters are escaped, text over `limit` bytes is cut with an ellipsis.
std::string printable(std::string_view text, std::size_t limit = 200);

namespace detail {
[[noreturn]] void ensureFailed(const char* condition, const char* file, int line);
}

}

#define ENSURE(condition)                                                                                    \
    ((condition) ? static_cast<void>(0) : ::eyeray::detail::ensureFailed(#condition, __FILE__, __LINE__))
