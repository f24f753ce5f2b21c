#pragma once
// Where the labels of points stand, so that each can be read.

#include <optional>
#include <span>
#include <vector>

#include "core/base/math.h"

namespace eyeray {

/// A point to be labelled; lengths in the drawing's unit, y down.
struct LabelledPoint {
    Vec2 at{0};
    Vec2 extent{0}; // of its label; none for a point that only takes room
};

/// Top left corner of each label: in the area, on no point and no earlier label, as near to its point as is
/// free within a few of its heights. Nothing where there is none, or no label. `mark` is the radius that a
/// point takes.
std::vector<std::optional<Vec2>> layOutLabels(std::span<const LabelledPoint>, const Vec2& areaCorner,
                                              const Vec2& areaSize, float mark);

}
