#pragma once
// Axes of charts: where they are marked, and how numbers on them read. For files and for the window alike.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace eyeray {

enum class Scale : std::uint8_t { Linear, Log };

/// A range of finite values, low < high; those of Log are above 0.
struct Axis {
    Scale scale = Scale::Linear;
    double low = 0, high = 1;

    /// How far along the axis a value lies: 0 at low, 1 at high. Not finite for what Log cannot show.
    double share(double value) const;
    /// The value that lies there.
    double valueAt(double share) const;
};

/// An axis that shows all of these values that it can, with a margin: finite ones, of Log those above 0.
/// About 1 if there is none.
Axis axisAround(Scale, std::span<const double> values);

struct Tick {
    double value = 0;
    std::string label; // none at a minor one
};

/// Marks at round numbers (1, 2 or 5 times a power of ten) by ascending value, at most `most` of them
/// labelled (at least 2). Where all is within a small factor, a log axis is marked like a linear one.
std::vector<Tick> ticksOf(const Axis&, int most);

/// Rounded to so many digits: "0", "0.00123", "12.3", "12300", "4.56·10⁻⁷", "∞", "?" for no number.
std::string shortNumber(double value, int digits = 3);

}
