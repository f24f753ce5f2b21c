#include "app/gui/sketch_view.h"

#include "app/gl/framebuffer.h"
#include "app/gl/imgui_renderer.h"
#include "app/gui/label_places.h"
#include "core/image/encode.h"
#include "core/study/svg.h"

namespace eyeray {
namespace {

constexpr float kPlateAlpha = 0.62F;
constexpr float kPlateRounding = 0.27F; // letters' heights
constexpr float kBaseLine = 0.82F;      // of the font, below the top of a line, in its heights

ImU32 packed(const Ink& ink) { return ImGui::ColorConvertFloat4ToU32({ink.r, ink.g, ink.b, ink.a}); }

std::uint32_t rgb(const Ink& ink) {
    const auto channel = [](float value) {
        return static_cast<std::uint32_t>(std::lround(255 * std::fmin(std::fmax(value, 0.0F), 1.0F)));
    };
    return channel(ink.r) << 16U | channel(ink.g) << 8U | channel(ink.b);
}

void drawPath(ImDrawList& list, const SketchPath& path, ImVec2 corner) {
    ImVector<ImVec2> points;
    points.reserve(static_cast<int>(path.points.size()));
    for (const Vec2& p : path.points) points.push_back({corner.x + p.x, corner.y + p.y});
    if (path.width > 0)
        list.AddPolyline(points.Data, points.Size, packed(path.ink), 0, path.width);
    else
        list.AddConvexPolyFilled(points.Data, points.Size, packed(path.ink));
}

void drawLabel(ImDrawList& list, const PlacedLabel& placed, ImVec2 corner, const Ink& ground) {
    const auto at = [&](const Vec2& p) { return ImVec2(corner.x + p.x, corner.y + p.y); };
    list.AddRectFilled(at(placed.corner), at(placed.corner + placed.extent),
                       packed(Ink(Vec3(ground), kPlateAlpha)), kPlateRounding * placed.height);
    list.AddText(ImGui::GetFont(), placed.height, at(placed.text), packed(placed.label->ink),
                 placed.label->text.c_str());
}

}

void draw(ImDrawList& list, const SketchedPicture& sketched, const GlTexture& picture, ImVec2 corner) {
    const ImVec2 opposite{corner.x + sketched.size.x, corner.y + sketched.size.y};
    list.AddImage(textureId(picture), corner, opposite, {0, 1}, {1, 0});
    list.PushClipRect(corner, opposite, true);
    for (const SketchPath& path : sketched.sketch.paths) drawPath(list, path, corner);
    for (const PlacedLabel& placed : placeLabels(sketched.sketch, sketched.size, sketched.letter))
        drawLabel(list, placed, corner, sketched.ground);
    list.PopClipRect();
}

ByteImage imageOf(const Gl& gl, const SketchedPicture& sketched, const GlTexture& picture) {
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    list.PushClipRect({0, 0}, {sketched.size.x, sketched.size.y});
    draw(list, sketched, picture, {0, 0});
    ImDrawList* lists = &list;
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = &lists;
    data.CmdListsCount = 1;
    data.TotalVtxCount = list.VtxBuffer.Size;
    data.TotalIdxCount = list.IdxBuffer.Size;
    data.DisplaySize = {sketched.size.x, sketched.size.y};
    data.FramebufferScale = {1, 1};
    const Framebuffer framebuffer(gl, static_cast<int>(sketched.size.x), static_cast<int>(sketched.size.y));
    framebuffer.bind();
    ImGuiRenderer(gl).draw(data);
    ByteImage image = framebuffer.read();
    gl.bindFramebuffer(GL_FRAMEBUFFER, 0);
    return image;
}

std::string svgOf(const SketchedPicture& sketched, const ByteImage& picture) {
    Svg svg(sketched.size.x, sketched.size.y, rgb(sketched.ground));
    svg.image({0, 0}, sketched.size, encodeDisplayed(picture, ImageFormat::Png, {}));
    for (const SketchPath& path : sketched.sketch.paths) {
        if (path.width > 0)
            svg.line(path.points,
                     {.color = rgb(path.ink), .width = path.width, .dashes = {}, .opacity = path.ink.a});
        else
            svg.polygon(path.points, rgb(path.ink), path.ink.a);
    }
    for (const PlacedLabel& placed : placeLabels(sketched.sketch, sketched.size, sketched.letter)) {
        const Vec2 lo = placed.corner, hi = placed.corner + placed.extent;
        const std::array plate = {lo, Vec2(hi.x, lo.y), hi, Vec2(lo.x, hi.y)};
        svg.polygon(plate, rgb(sketched.ground), kPlateAlpha);
        svg.text(placed.text + Vec2(0, kBaseLine * placed.height), placed.label->text,
                 {.size = 0.86F * placed.height, .color = rgb(placed.label->ink)});
    }
    return svg.file();
}

}
