#include "app/platform/fonts.h"

#include <cstring>

#include <imgui.h>

#include "app/gl/font.h"
#include "app/gl/imgui_renderer.h"

namespace eyeray {
namespace {

// First and last character of each range, for ImGui ended by 0. Characters that the font lacks cost nothing.
constexpr ImWchar kCharacters[] = {
    0x0020, 0x017f, // Latin, as in names of files too
    0x0370, 0x03ff, // Greek
    0x0400, 0x045f, // Cyrillic
    0x2010, 0x203a, // dashes, quotation marks, bullet, ellipsis
    0x2070, 0x209c, // superscripts and subscripts
    0x2190, 0x22ff, // arrows, operators
    0x25a0, 0x25ff, // geometric shapes
    0x26a0, 0x26a0, // warning sign
    0x2713, 0x2717, // check mark, cross
    0,
};

// Above this height two samples a pixel across are no better to look at, and cost twice the texture.
constexpr float kOversampledBelow = 28;

}

Fonts::Fonts(const Gl& gl) : texture_(gl, Magnify::Smooth) {}

void Fonts::build(float pixels) {
    const std::span<const std::byte> file = fontBytes();
    ImFontConfig config;
    config.FontData = const_cast<std::byte*>(file.data()); // only read: it is not the atlas's own
    config.FontDataSize = static_cast<int>(file.size());
    config.FontDataOwnedByAtlas = false;
    config.SizePixels = pixels;
    config.OversampleH = pixels < kOversampledBelow ? 2 : 1;
    config.GlyphRanges = kCharacters;
    std::strcpy(config.Name, "DejaVu Sans");

    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.AddFont(&config);
    unsigned char* bytes = nullptr;
    int width = 0;
    int height = 0;
    atlas.GetTexDataAsRGBA32(&bytes, &width, &height);
    ByteImage image(width, height);
    std::memcpy(image.values().data(), bytes, image.values().size() * sizeof(Rgba8));
    texture_.upload(image);
    atlas.SetTexID(textureId(texture_));
    atlas.ClearTexData();
}

}
