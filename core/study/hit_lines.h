#pragma once
// Rays as lines of text, and what they hit: the renderer's own intersection, for other programs to ask.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/world.h"

namespace eyeray {

/// What is asked of each ray. Closest: `t id nx ny nz`, or `miss`. Any: `1` or `0`. Spawned: for the mirrored
/// and the refracted ray (η 1.5) that the renderer sends on from the hit, `1` if it meets the same face again
/// at once, nearer than 1e-4 of the primitive's bounding radius, else `0`; `-` where there is no such ray.
enum class HitQuestion : std::uint8_t { Closest, Any, Spawned };

/// A ray in the scene's own coordinates; the direction has any length, and t is in units of it.
struct RayLine {
    DVec3 origin{0}, direction{0};
    double tMin = 0, tMax = std::numeric_limits<double>::infinity();
};

/// Reads `ox oy oz dx dy dz [tmin tmax]`; nothing for a blank line or one that begins with #. Throws
/// InputError, which names the line by `number`.
std::optional<RayLine> parseRayLine(std::string_view line, std::int64_t number);

/// Answers the same question about many rays. Ids count from 0 over the objects in the order of the scene, a
/// shape as one primitive, a mesh as its triangles in the order of its file; the surfaces of lamps come last.
class HitLines {
public:
    HitLines(std::shared_ptr<const World>, HitQuestion);

    /// Appends one line for each ray among `lines`, of which the first has this number in the whole. Throws
    /// InputError for a line that is no ray: then those before it have been answered. Thread-safe; to be
    /// called in the FloatEnvironment of rendering.
    void answer(std::string_view lines, std::int64_t firstNumber, std::string& answers) const;

private:
    struct Numbers { // of the primitives of an instance
        std::uint64_t first = 0;
        bool mesh = false; // else a shape, one primitive whatever its face
    };

    template <class Index>
    void answer(const IndexedGeometry<Index>&, const RayLine&, std::string& answers) const;

    std::shared_ptr<const World> world_;
    HitQuestion question_;
    std::vector<Numbers> numbers_;
};

}
