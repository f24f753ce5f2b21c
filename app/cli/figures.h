#pragma once
// Figures that `render --stats` and `bench --json` share.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "core/scene/world.h"

namespace eyeray {

/// Kind, primitives, nodes and bytes.
nlohmann::json acceleratorFigures(const World&);

/// Most memory that the program has taken so far.
std::int64_t peakRssBytes();

}
