#pragma once
// Reading textures.

#include "core/image/pixels.h"
#include "core/scene/scene.h"

namespace eyeray {

/// How the stored bytes are meant: sRGB-coded colours or plain numbers.
enum class TextureCoding : std::uint8_t { Srgb, Linear };

/// Linear value of a texture at uv: nearest or bilinear, wrapped as the texture says. Any finite or
/// non-finite uv is safe.
Color textureValue(const Scene&, const Texture&, const Vec2& uv, TextureCoding);

}
