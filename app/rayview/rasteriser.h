#pragma once
// The same scene and camera as OpenGL's pipeline draws it: each object by itself, hidden by a z-buffer, lit
// by the taught local models. What it cannot know (shadows, mirrors, glass) is the lesson.

#include "app/gl/render_target.h"
#include "app/rayview/item_program.h"

namespace eyeray {

/// Lamps that are taken into account, the scene's first.
inline constexpr int kMostRasterLamps = 32;

struct RasterPicture {
    ColorImage radiance;
    Pixels<int> objects;    // id in Scene::objects; −1 for the background and the surface of a lamp
    Pixels<float> distance; // metres along the view, from the depth buffer; infinite for the background
};

/// Used by the thread of its OpenGL.
class Rasteriser {
public:
    explicit Rasteriser(const Gl& gl);

    /// One fragment for each pixel, at its centre. Shapes are drawn as fine triangles. Throws Failure for a
    /// size that the graphics card refuses.
    RasterPicture draw(const std::shared_ptr<const World>&, const Camera&, int width, int height);

private:
    void setLamps(const World&, const Camera&) const;

    const Gl& gl_;
    SceneMeshes meshes_;
    ItemProgram program_;
    std::optional<RenderTarget> target_;
};

}
