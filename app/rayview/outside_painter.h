#pragma once
// The scene as it is shown to people from outside: clear forms, no lamps of its own, plain light.

#include "app/gl/render_target.h"
#include "app/rayview/item_program.h"

namespace eyeray {

/// Colours from the top to the foot of the picture behind the scene, sRGB-coded, 0 to 1; and how bright a
/// white thing is before it.
struct Backdrop {
    Color top{0}, foot{0};
    float light = 1;
    friend bool operator==(const Backdrop&, const Backdrop&) = default;
};

class OutsidePainter {
public:
    explicit OutsidePainter(const Gl&);

    /// Draws all items into the bound target, of the projection's size. Infinite planes fade out far from
    /// the scene. Glass hides nothing and leaves no depth.
    void draw(const SceneMeshes&, const Projection&, const Backdrop&);

private:
    void drawBackdrop(const Backdrop&);
    void drawItem(const SceneItem&, float fade);

    const Gl& gl_;
    ItemProgram program_;
    Program backdrop_;
    Handle noVertices_;
};

}
