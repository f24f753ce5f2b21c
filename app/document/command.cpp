#include "app/document/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr std::string_view kSpace = " \t\r";
constexpr double kLargest = 1e9; // of positions in metres and of colours: floats hold it, and its square

std::string quotedIfNeeded(const std::string& value) {
    if (!value.empty() && value.find_first_of(" \t\r\n\"") == std::string::npos) return value;
    std::string result = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\' || c == '\n') result += '\\';
        result += c == '\n' ? 'n' : c;
    }
    return result + '"';
}

/// Takes one word off the front of `line`; quotes may stand anywhere in it.
std::string takeWord(std::string_view& line) {
    std::string word;
    bool quoted = false;
    std::size_t i = 0;
    for (; i < line.size() && (quoted || kSpace.find(line[i]) == std::string_view::npos); ++i) {
        if (line[i] == '"')
            quoted = !quoted;
        else if (quoted && line[i] == '\\' && i + 1 < line.size())
            word += line[++i] == 'n' ? '\n' : line[i];
        else
            word += line[i];
    }
    if (quoted) throw InputError(std::string(line), "a quote is not closed", "end the value with \"");
    line.remove_prefix(i);
    line.remove_prefix(std::min(line.find_first_not_of(kSpace), line.size()));
    return word;
}

[[noreturn]] void refuse(const Command& command, std::string_view key, const std::string& value,
                         const std::string& expected) {
    throw InputError(fmt::format("{} {}={}", command.name(), key, value),
                     "not a value of " + std::string(key), "give " + expected);
}

template <std::size_t N>
std::optional<std::array<double, N>> numbers(std::string_view text) {
    std::array<double, N> values{};
    for (std::size_t i = 0; i < N; ++i) {
        const std::size_t comma = i + 1 < N ? text.find(',') : text.size();
        if (comma == std::string_view::npos) return std::nullopt;
        const auto value = toNumber(text.substr(0, comma));
        if (!value) return std::nullopt;
        values[i] = *value;
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return values;
}

/// Names of commands and keys need no quotes and take none.
bool isName(std::string_view word) {
    return !word.empty() && std::ranges::all_of(word, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
}

}

Command Command::parse(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(kSpace), line.size()));
    if (line.empty())
        throw InputError("command", "the line is empty", "write a command such as: set max-depth=5");
    Command command(takeWord(line));
    if (!isName(command.name_))
        throw InputError(command.name_, "not the name of a command",
                         "write a command such as: set max-depth=5");
    while (!line.empty()) {
        const std::string word = takeWord(line);
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError(fmt::format("{} {}", command.name_, word),
                             "an argument without =", "write key=value");
        const std::string key = word.substr(0, equals);
        if (!isName(key))
            throw InputError(fmt::format("{} {}", command.name_, word), "a key is letters, digits and -",
                             "write key=value");
        if (command.find(key))
            throw InputError(fmt::format("{} {}", command.name_, word), fmt::format("{} is given twice", key),
                             "give it once");
        command.arguments_.emplace_back(key, word.substr(equals + 1));
    }
    return command;
}

std::string Command::text() const {
    std::string result = name_;
    for (const auto& [key, value] : arguments_) result += " " + key + "=" + quotedIfNeeded(value);
    return result;
}

std::optional<std::string> Command::find(std::string_view key) const {
    const auto argument = std::find_if(arguments_.begin(), arguments_.end(),
                                       [&](const auto& pair) { return pair.first == key; });
    return argument == arguments_.end() ? std::nullopt : std::optional(argument->second);
}

std::optional<double> Command::number(std::string_view key, double lowest, double highest) const {
    const auto text = find(key);
    if (!text) return std::nullopt;
    const auto value = toNumber(*text);
    if (!value || *value < lowest || *value > highest)
        refuse(*this, key, *text, fmt::format("a number from {:g} to {:g}", lowest, highest));
    return value;
}

std::optional<int> Command::integer(std::string_view key, int lowest, int highest) const {
    const auto text = find(key);
    if (!text) return std::nullopt;
    const auto value = toNumber(*text);
    if (!value || *value < lowest || *value > highest || *value != std::floor(*value))
        refuse(*this, key, *text, fmt::format("a whole number from {} to {}", lowest, highest));
    return static_cast<int>(*value);
}

std::optional<bool> Command::flag(std::string_view key) const {
    const auto text = find(key);
    if (!text) return std::nullopt;
    if (*text == "on") return true;
    if (*text == "off") return false;
    refuse(*this, key, *text, "on or off");
}

std::optional<DVec3> Command::triple(std::string_view key) const {
    const auto text = find(key);
    if (!text) return std::nullopt;
    const auto values = numbers<3>(*text);
    if (!values ||
        std::any_of(values->begin(), values->end(), [](double v) { return std::abs(v) > kLargest; }))
        refuse(*this, key, *text, "three numbers x,y,z from -1e9 to 1e9");
    return DVec3((*values)[0], (*values)[1], (*values)[2]);
}

std::optional<Color> Command::color(std::string_view key) const {
    const auto text = find(key);
    if (!text) return std::nullopt;
    const auto wrong = [](double v) { return v < 0 || v > kLargest; };
    if (const auto grey = toNumber(*text); grey && !wrong(*grey)) return Color(static_cast<float>(*grey));
    const auto values = numbers<3>(*text);
    if (!values || std::any_of(values->begin(), values->end(), wrong))
        refuse(*this, key, *text, "three numbers r,g,b from 0 to 1e9, or one for all");
    return Color((*values)[0], (*values)[1], (*values)[2]);
}

std::optional<int> Command::choice(std::string_view key, std::span<const std::string_view> names) const {
    const auto text = find(key);
    if (!text) return std::nullopt;
    const auto name = std::find(names.begin(), names.end(), *text);
    if (name == names.end()) refuse(*this, key, *text, fmt::format("one of {}", fmt::join(names, " ")));
    return static_cast<int>(name - names.begin());
}

std::string Command::required(std::string_view key) const {
    const auto value = find(key);
    if (!value) throw InputError(text(), fmt::format("{} is missing", key), fmt::format("add {}=…", key));
    return *value;
}

void Command::allowOnly(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, value] : arguments_)
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            throw InputError(text(), fmt::format("{} has no argument {}", name_, key),
                             fmt::format("use {}", fmt::join(keys, " ")));
}

std::vector<Command> parseCommands(std::string_view text, const std::string& where) {
    std::vector<Command> commands;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t first = line.find_first_not_of(kSpace);
        if (first == std::string_view::npos || line[first] == '#') continue;
        try {
            commands.push_back(Command::parse(line));
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}:{}", where, number), error.what(), "correct this line");
        }
    }
    return commands;
}

std::string toText(double value) { return fmt::format("{}", value == 0 ? 0.0 : value); }
std::string toText(bool value) { return value ? "on" : "off"; }
std::string degreesText(double radiansValue) {
    const double exact = degrees(radiansValue);
    const double round = *toNumber(fmt::format("{:.12g}", exact));
    for (const double value : {round, exact, std::nextafter(exact, 0.0), std::nextafter(exact, kInfinity)})
        if (radians(value) == radiansValue) return toText(value);
    return toText(exact);
}
std::string toText(const DVec3& v) { return fmt::format("{},{},{}", toText(v.x), toText(v.y), toText(v.z)); }
std::string toText(const Color& c) { return fmt::format("{},{},{}", c.r, c.g, c.b); }

std::optional<double> toNumber(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

}
