#pragma once
// The letters of the UI, drawn at the size in which they are shown.

#include "app/gl/texture.h"

namespace eyeray {

/// Fills the font atlas of the current ImGui context with DejaVu Sans: Latin, Greek, Cyrillic and the signs
/// of mathematics.
class Fonts {
public:
    explicit Fonts(const Gl& gl);

    /// Draws all letters anew, `pixels` high from the highest ascent to the lowest descent. Call it between
    /// frames.
    void build(float pixels);

private:
    GlTexture texture_;
};

}
