#pragma once
// All that tracing one picture reads; const while tiles are traced.

#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/base/sampling.h"
#include "core/geometry/textbook_geometry.h"
#include "core/scene/camera.h"
#include "core/scene/world.h"
#include "core/transport/emitters.h"
#include "core/transport/medium_stack.h"
#include "core/transport/settings.h"

namespace eyeray {

/// Rays of a camera, relative to the World's origin.
class EyeRays {
public:
    EyeRays(const Camera&, const DVec3& origin, int width, int height, FaultSet = {});

    /// Ray through `inPixel` ∈ [0, 1)² of pixel (x, y); unit direction. The centre of pixel i lies at
    /// a·tan(fov/2)·(2i + 1 − w)/w, exactly antisymmetric about the middle of the picture.
    Ray through(int x, int y, const Vec2& inPixel) const;

    /// The same ray from the place on the lens that u in [0, 1)² says, uniformly over its disc: all meet at
    /// the distance that is in focus. Without a lens the ray itself. Potmesil, Chakravarty 1982, "Synthetic
    /// Image Generation with a Lens and Aperture Camera Model"; Cook et al. 1984.
    Ray fromLens(const Ray& through, const Vec2& u) const;
    bool hasLens() const { return lensRight_ != Vec3(0); }

    /// What `through` goes by in a picture whose rays are not aimed: the ray through the place (right, up) of
    /// the picture's plane, both from −1 to 1, runs along forward + right·halfRight + up·halfUp.
    struct Frame {
        Vec3 eye{0}, halfRight{0}, halfUp{0}, forward{0};
        float width = 0, height = 0; // pixels
    };
    const Frame& frame() const { return frame_; }
    bool aimed() const { return !aims_.empty(); }

    /// From now on the rays of pixels that an edge of a mesh crosses go exactly at a place on it: at its ends
    /// and between, the nearest to the eye. Random rays hardly ever meet an edge, which is why leaks go
    /// unseen.
    void aimAtEdges(const World&);

private:
    void aimAlong(const Vec3& from, const Vec3& to);
    void aimAt(const Vec3& place);
    Vec3 onScreen(const Vec3& place) const; // x and y in pixels, and the depth
    std::size_t pixelIndex(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width) +
               static_cast<std::size_t>(x);
    }

    Frame frame_;
    Vec3 lensRight_, lensUp_;
    float focusDistance_;
    std::vector<Vec3> aims_; // by pixel; NaN where there is no edge. Empty: rays go where they are told to
};

struct TraceContext {
    TraceContext(std::shared_ptr<const World>, const Camera&, const TraceSettings&, int width, int height,
                 std::uint32_t seed, std::stop_token);

    std::shared_ptr<const World> world;
    TraceSettings settings; // kinds that the scene cannot need are off
    int width, height;
    std::uint32_t seed;
    std::stop_token stop;
    EyeRays eyeRays;
    std::vector<WorldLight> lights;
    Emitters emitters;                                // of physical methods
    MediumStack eyeMedia;                             // what the eye is inside of
    std::shared_ptr<const TextbookGeometry> textbook; // traced in the place of the World's, if not null
};

}
