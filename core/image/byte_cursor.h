#pragma once
// Walks through the bytes of a file that nobody vouches for.

#include <cstddef>
#include <span>
#include <string>

#include "core/base/errors.h"

namespace eyeray {

class ByteCursor {
public:
    ByteCursor(std::span<const std::byte> bytes, std::string where)
        : rest_(bytes), where_(std::move(where)) {}

    /// Throws InputError where so many are not left.
    std::span<const std::byte> take(std::size_t count) {
        if (count > rest_.size()) refuse("is cut short");
        const auto taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }
    unsigned byte() { return std::to_integer<unsigned>(take(1)[0]); }

    /// Up to the next of these bytes, which is taken, too. Throws InputError for more than 1000.
    std::string until(const char* ends) {
        constexpr std::size_t kLongest = 1000;
        std::string text;
        for (char c = static_cast<char>(byte()); std::string_view(ends).find(c) == std::string_view::npos;
             c = static_cast<char>(byte())) {
            if (text.size() == kLongest) refuse("has a line without end");
            text += c;
        }
        return text;
    }

    const std::string& where() const { return where_; }
    [[noreturn]] void refuse(const std::string& what) const {
        throw InputError{where_, what, "write it again"};
    }

private:
    std::span<const std::byte> rest_;
    std::string where_;
};

}
