#pragma once
// Watching a sample being traced. Rendering uses NoRecorder, which costs nothing.

#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/base/ray_kind.h"

namespace eyeray {

/// How a ray ended.
enum class RayEnd : std::uint8_t { Hit, Background, Unblocked, Blocked };

/// One ray of a sample's tree, in scene order of tracing: a parent comes before its children.
struct RayRecord {
    int parent = -1;
    RayKind kind = RayKind::Eye;
    int depth = 0;                // a shadow ray has the depth of the ray whose hit cast it
    Vec3 origin{0}, direction{0}; // relative to the World's origin; the direction is unit
    float t = kInfinity;          // of the hit, or to the lamp
    int object = -1;              // hit: id in Scene::objects, −1 for none or the surface of a lamp
    int light = -1;               // of a shadow ray: id in Scene::lights
    Color weight{1};              // share of this ray's radiance that reaches the pixel; of a shadow ray: 1
    Color radiance{0};            // what it brings: of a shadow ray its lamp's unblocked share
    RayEnd end = RayEnd::Background;
    bool totalReflection = false; // a reflection ray that carries all the light
};

struct NoRecorder {
    static constexpr bool kOn = false;
    static int begin(const RayRecord&) { return -1; }
    template <class Change>
    static void update(int, Change&&) {}
};

struct TreeRecorder {
    static constexpr bool kOn = true;
    std::vector<RayRecord> rays;

    int begin(const RayRecord& ray) {
        rays.push_back(ray);
        return static_cast<int>(rays.size()) - 1;
    }
    template <class Change>
    void update(int ray, Change&& change) {
        change(rays[static_cast<std::size_t>(ray)]);
    }
};

}
