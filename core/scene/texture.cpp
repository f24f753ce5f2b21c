#include "core/scene/texture.h"

#include <algorithm>

#include "core/image/srgb.h"

namespace eyeray {
namespace {

int wrapped(float coordinate, int size, Wrap wrap) {
    // |coordinate| beyond this has no fraction left and would overflow the integer
    constexpr float kLimit = 1.0e9F;
    if (!(std::fabs(coordinate) < kLimit)) return 0;
    const auto i = static_cast<int>(std::floor(coordinate));
    switch (wrap) {
    case Wrap::Clamp:
        return std::clamp(i, 0, size - 1);
    case Wrap::Repeat:
        return ((i % size) + size) % size;
    case Wrap::Mirror: {
        const int period = ((i % (2 * size)) + 2 * size) % (2 * size);
        return period < size ? period : 2 * size - 1 - period;
    }
    }
    return 0;
}

Color decoded(const Rgba8& texel, TextureCoding coding) {
    if (coding == TextureCoding::Srgb)
        return {decodeSrgb8(texel.r), decodeSrgb8(texel.g), decodeSrgb8(texel.b)};
    return Color(texel.r, texel.g, texel.b) / 255.0F;
}

Color value(const Scene& scene, const ImageTexture& texture, const Vec2& uv, TextureCoding coding) {
    const ByteImage& pixels = *scene.images[static_cast<std::size_t>(texture.image)].pixels;
    if (pixels.empty()) return Color(1);
    const auto texel = [&](float x, float y) {
        return decoded(
            pixels.at(wrapped(x, pixels.width(), texture.wrapU), wrapped(y, pixels.height(), texture.wrapV)),
            coding);
    };
    const float x = uv.x * static_cast<float>(pixels.width());
    const float y = uv.y * static_cast<float>(pixels.height());
    if (texture.nearest) return texel(x, y);
    const float left = std::floor(x - 0.5F), top = std::floor(y - 0.5F);
    const float fx = x - 0.5F - left, fy = y - 0.5F - top;
    if (!(fx >= 0 && fx <= 1 && fy >= 0 && fy <= 1)) return texel(x, y);
    return (texel(left, top) * (1 - fx) + texel(left + 1, top) * fx) * (1 - fy) +
           (texel(left, top + 1) * (1 - fx) + texel(left + 1, top + 1) * fx) * fy;
}

Color value(const Scene&, const CheckerTexture& checker, const Vec2& uv, TextureCoding) {
    const float parity = std::floor(uv.x) + std::floor(uv.y);
    return parity - 2 * std::floor(parity * 0.5F) == 0 ? checker.even : checker.odd;
}

}

Color textureValue(const Scene& scene, const Texture& texture, const Vec2& uv, TextureCoding coding) {
    return std::visit([&](const auto& source) { return value(scene, source, uv, coding); }, texture.source);
}

}
