#pragma once
// A ray in one row of a table: everything that is known of it.

#include <array>
#include <string>
#include <string_view>

#include "core/scene/scene.h"
#include "core/study/family.h"

namespace eyeray {

inline constexpr std::array<std::string_view, 16> kRayHeadings = {
    "ray", "depth",  "meets", "material", "t",      "incidence",    "kr there", "kt there",
    "η",   "medium", "T",     "weight",   "brings", "contribution", "origin",   "direction"};
using RayRow = std::array<std::string, kRayHeadings.size()>;

/// Texts in the order of kRayHeadings; empty where there is nothing to say. `worldOrigin` is that of the
/// World that was traced.
RayRow rayRow(const SampleRecord&, const Family&, const Scene&, const DVec3& worldOrigin, int ray);

}
