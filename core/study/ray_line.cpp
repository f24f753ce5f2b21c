#include <fmt/format.h>

#include <array>
#include <charconv>

#include "core/base/errors.h"
#include "core/study/hit_lines.h"

namespace eyeray {
namespace {

constexpr double kFarthest = 1e15; // as of points in files
constexpr std::string_view kSpace = " \t\r\v\f";

std::string_view nextWord(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kSpace), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(kSpace));
    rest.remove_prefix(word.size());
    return word;
}

[[noreturn]] void refuse(std::int64_t number, const std::string& what, const char* remedy) {
    throw InputError(fmt::format("rays: line {}", number), what, remedy);
}

double numberFrom(std::string_view word, std::int64_t number) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || std::isnan(value))
        refuse(number, fmt::format("\"{}\" is not a number", printable(word, 40)),
               "write ox oy oz dx dy dz [tmin tmax]");
    return value;
}

}

std::optional<RayLine> parseRayLine(std::string_view line, std::int64_t number) {
    std::array<double, 8> values{};
    std::size_t count = 0;
    for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line)) {
        if (count == 0 && word.front() == '#') return {};
        if (count == values.size())
            refuse(number, "more than eight numbers", "write one ray a line: ox oy oz dx dy dz [tmin tmax]");
        values[count++] = numberFrom(word, number);
    }
    if (count == 0) return {};
    if (count != 6 && count != 8)
        refuse(number, fmt::format("{} numbers in place of six or eight", count),
               "write ox oy oz dx dy dz [tmin tmax]");
    RayLine ray{{values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
    if (count == 8) {
        ray.tMin = values[6];
        ray.tMax = values[7];
    }
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::fabs(ray.origin[axis]) <= kFarthest))
            refuse(number, fmt::format("an origin at {:g}", ray.origin[axis]), "stay within 1e15 of 0");
    if (!isFinite(ray.direction) || ray.direction == DVec3(0))
        refuse(number, "a direction that is zero or infinite", "give one of any finite length");
    if (!(ray.tMin >= 0) || std::isinf(ray.tMin))
        refuse(number, fmt::format("tmin {:g}", ray.tMin), "give a finite one, 0 or more");
    return ray;
}

}
