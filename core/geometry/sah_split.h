#pragma once
// How a set of boxes is cut in two for a tree: by the surface area heuristic in 16 bins along each axis.
// I. Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE Symposium on
// Interactive Ray Tracing.

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>

#include "core/geometry/bounds.h"

namespace eyeray {

/// A box in registers of four floats; what the fourth holds does not matter.
struct alignas(16) Box4 {
    std::array<float, 4> lo{kInfinity, kInfinity, kInfinity, kInfinity};
    std::array<float, 4> hi{-kInfinity, -kInfinity, -kInfinity, -kInfinity};
};

/// A box to be put into a tree, with its number in place of the fourth float.
class BoxItem {
public:
    BoxItem(const Bounds& box, std::uint32_t entry)
        : box_{{box.lo.x, box.lo.y, box.lo.z, std::bit_cast<float>(entry)},
               {box.hi.x, box.hi.y, box.hi.z, 0}} {}

    const Box4& box() const { return box_; }
    std::uint32_t entry() const { return std::bit_cast<std::uint32_t>(box_.lo[3]); }
    Vec3 center() const {
        return {0.5F * box_.lo[0] + 0.5F * box_.hi[0], 0.5F * box_.lo[1] + 0.5F * box_.hi[1],
                0.5F * box_.lo[2] + 0.5F * box_.hi[2]};
    }

private:
    Box4 box_;
};

/// What a set of boxes spans, and what their centres span.
struct BoxSpan {
    Box4 boxes, centers;
};

BoxSpan spanOf(std::span<const BoxItem>);

struct SahSplit {
    std::size_t left; // how many of the items, which are reordered, go left: at least 1, and not all
    BoxSpan leftSpan, rightSpan;
};

/// How many entries a leaf may hold, and how many of them one test takes.
struct LeafSizes {
    int most = 1, atOnce = 1;
};

/// Cuts the items, whose span is given, in two; none if they had better be a leaf. Where no cut by area is
/// found, or `bySize` asks for it, the larger half of the centres goes right.
std::optional<SahSplit> splitBySah(std::span<BoxItem>, const BoxSpan&, const LeafSizes&, bool bySize);

}
