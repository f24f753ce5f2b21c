#pragma once
// Scalable Vector Graphics 1.1, as much as diagrams and charts need. Lengths are in the picture's own unit, y
// down.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/math.h"

namespace eyeray {

/// Colours are 0xrrggbb.
class Svg {
public:
    struct Stroke {
        std::uint32_t color = 0;
        float width = 1;
        std::span<const float> dashes; // lengths of dash, gap, …
        float opacity = 1;
    };
    enum class Anchor : std::uint8_t { Start, Middle, End };
    struct Font {
        float size = 1;
        std::uint32_t color = 0;
        Anchor anchor = Anchor::Start;
        bool bold = false;
        // NOLINTNEXTLINE(readability-redundant-member-init): GCC warns of members left out without
        std::optional<std::uint32_t> halo = {}; // around the letters, over what lies below
        bool upward = false;                    // read from below to above
    };

    Svg(float width, float height, std::uint32_t paper);

    void box(Vec2 corner, Vec2 size, float radius, std::uint32_t fill);
    void box(Vec2 corner, Vec2 size, float radius, std::uint32_t fill, const Stroke&);
    void line(std::span<const Vec2> points, const Stroke&);
    void polygon(std::span<const Vec2> points, std::uint32_t fill, float opacity);
    /// A PNG, drawn over this rectangle.
    void image(Vec2 corner, Vec2 size, std::span<const std::byte> png);
    /// Cubic Bézier curve through four control points.
    void curve(std::span<const Vec2, 4> points, const Stroke&);
    /// `at` is on the base line. Any text; what XML reserves is escaped.
    void text(Vec2 at, std::string_view text, const Font&);

    /// What `draw` adds; a browser shows `hover` while the pointer is on it.
    void described(std::string_view hover, const std::function<void()>& draw);
    /// Where a reader prefers dark screens, the second colour of a pair takes the first one's place.
    void twinColors(std::span<const std::array<std::uint32_t, 2>> lightAndDark);

    /// The whole file.
    std::string file() const { return body_ + "</svg>\n"; }

private:
    std::string body_;
};

}
