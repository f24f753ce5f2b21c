#pragma once
// Every action that a person can take, as one line of text: `name key=value …`.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/math.h"

namespace eyeray {

/// A command and its arguments, in the order given. A value with spaces is written in double quotes; in them
/// a backslash stands before a quote and a backslash, and \n is a new line.
class Command {
public:
    using Argument = std::pair<std::string, std::string>;

    Command(std::string name, std::vector<Argument> arguments = {})
        : name_(std::move(name)), arguments_(std::move(arguments)) {}

    /// Throws InputError if the line is empty or no `name key=value …`, or has a key twice.
    static Command parse(std::string_view line);
    std::string text() const;

    const std::string& name() const { return name_; }
    const std::vector<Argument>& arguments() const { return arguments_; }

    /// Value of a key, or nothing. The typed ones throw InputError, naming command, key and range, for
    /// another value.
    std::optional<std::string> find(std::string_view key) const;
    std::optional<double> number(std::string_view key, double lowest, double highest) const;
    std::optional<int> integer(std::string_view key, int lowest, int highest) const;
    std::optional<bool> flag(std::string_view key) const;    // on off
    std::optional<DVec3> triple(std::string_view key) const; // x,y,z, each within ±1e9
    std::optional<Color> color(std::string_view key) const;  // r,g,b, each 0 to 1e9, or one number for all
    std::optional<int> choice(std::string_view key,
                              std::span<const std::string_view> names) const; // its index

    /// Throws InputError if the key is not there.
    std::string required(std::string_view key) const;

    /// Throws InputError if there is an argument whose key is none of these.
    void allowOnly(std::initializer_list<std::string_view> keys) const;

    friend bool operator==(const Command&, const Command&) = default;

private:
    std::string name_;
    std::vector<Argument> arguments_;
};

/// Commands of a text: one a line, blank lines and lines that begin with # skipped. Throws InputError with
/// the line number.
std::vector<Command> parseCommands(std::string_view text, const std::string& where);

/// Values as commands write them: shortest digits that read back the same; "on" or "off"; "x,y,z".
std::string toText(double value);
std::string toText(bool value);
std::string toText(const DVec3& value);
std::string toText(const Color& value);

/// An angle in degrees that radians() turns into the same bits, if any does.
std::string degreesText(double radians);

/// A finite number that takes up the whole text, or nothing.
std::optional<double> toNumber(std::string_view text);

}
