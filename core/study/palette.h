#pragma once
// Colours and dashes of the kinds of rays, the same in the window and in files. Told apart by people with any
// common colour blindness: Okabe, Ito 2008, "Color Universal Design"; the dashes tell them apart in print.

#include <cstdint>
#include <span>

#include "core/base/ray_kind.h"
#include "core/render/display.h"
#include "core/study/index_picture.h"

namespace eyeray {

/// 0xrrggbb as displayed, on a dark or a light ground.
std::uint32_t colorOfKind(RayKind, bool dark);

/// Of boxes of the index, likewise.
std::uint32_t colorOfBox(SpaceBox::Role, bool dark);

/// Of the lines of a chart, likewise: so many that are told apart, then again from the first.
inline constexpr std::size_t kSeriesColors = 6;
std::uint32_t colorOfSeries(int number, bool dark);

/// Radiance as displayed: 0xrrggbb.
std::uint32_t shownColor(const Color& radiance, const DisplaySettings&);

/// Lengths of dash, gap, dash, … in heights of a letter; none for a full line.
std::span<const float> dashesOf(RayKind);

/// Surfaces and letters of a theme: 0xrrggbb.
struct Ground {
    std::uint32_t paper, panel, text, dimmed, border;
};
const Ground& groundOf(bool dark);

}
