#include "app/gui/picture_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/gl/imgui_renderer.h"

namespace eyeray {
namespace {

constexpr float kClickSlop = 4;                        // pixels: a press that moves less is a click
constexpr double kOrbitSpeed = 0.4, kTurnSpeed = 0.15; // degrees per pixel
constexpr double kWheelStep = 0.9;

struct Fit {
    int width, height;
};

/// Largest whole size in `available` of the given aspect; all of it for aspect 0.
Fit fit(ImVec2 available, double aspect) {
    const double width = std::max(1.0F, std::floor(available.x)),
                 height = std::max(1.0F, std::floor(available.y));
    if (aspect <= 0) return {static_cast<int>(width), static_cast<int>(height)};
    const double w = std::min(width, height * aspect);
    return {std::max(1, static_cast<int>(std::lround(w))),
            std::max(1, static_cast<int>(std::lround(w / aspect)))};
}

/// Metres per pixel in the plane at `distance` before the eye.
double metresPerPixel(const Camera& camera, double distance, int height) {
    return 2 * distance * std::tan(camera.verticalFov / 2) / std::max(1, height);
}

}

void PictureView::draw(const Widgets& ui) {
    const ImVec2 available = ImGui::GetContentRegionAvail();
    const double aspect = ui.viewer.hasScene() ? ui.viewer.document().aspect : 0;
    const Fit size = fit(available, aspect);
    ui.viewer.setPictureSize(size.width, size.height);
    refresh(ui);

    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 corner{std::floor(start.x + (available.x - static_cast<float>(size.width)) / 2),
                        std::floor(start.y + (available.y - static_cast<float>(size.height)) / 2)};
    const ImVec2 opposite{corner.x + static_cast<float>(size.width),
                          corner.y + static_cast<float>(size.height)};
    if (texture_.width() > 0) ImGui::GetWindowDrawList()->AddImage(textureId(texture_), corner, opposite);
    ImGui::SetCursorScreenPos(corner);
    ImGui::InvisibleButton("picture", {static_cast<float>(size.width), static_cast<float>(size.height)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ui.mark("picture");
    if (!ui.viewer.hasScene()) return;
    mouse(ui, corner);
    pickedMark(ui, corner);
    if (rasterised_) rasterisedNote(ui, corner);
}

void PictureView::setRasterised(bool on) {
    rasterised_ = on;
    rasterisedFor_.reset();
    display_.reset(); // what is traced is to be shown anew
}

void PictureView::rasterise(const Widgets& ui) {
    const Document& document = ui.viewer.document();
    const RasterisedFor now{ui.viewer.world(), document.camera, ui.viewer.pictureSize(),
                            document.render.display};
    if (!now.world || now == rasterisedFor_) return;
    if (!rasteriser_) rasteriser_.emplace(gl_);
    shown_ = display(rasteriser_->draw(now.world, now.camera, now.size.width, now.size.height).radiance,
                     now.display);
    texture_.upload(shown_);
    ++version_;
    rasterisedFor_ = now;
}

/// Says in the picture that it is none of the tracer's.
void PictureView::rasterisedNote(const Widgets& ui, ImVec2 corner) const {
    constexpr const char* kText = "rasterised by OpenGL: local illumination, z-buffer (G)";
    const float pad = 5 * ui.scale, wrap = std::max(1.0F, static_cast<float>(shown_.width()) - 4 * pad);
    const ImVec2 size = ImGui::CalcTextSize(kText, nullptr, false, wrap);
    const ImVec2 at{corner.x + 2 * pad, corner.y + 2 * pad};
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled({at.x - pad, at.y - pad}, {at.x + size.x + pad, at.y + size.y + pad},
                        IM_COL32(0, 0, 0, 170), pad);
    list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, IM_COL32_WHITE, kText, nullptr, wrap);
}

void PictureView::refresh(const Widgets& ui) {
    if (!ui.viewer.hasScene()) return;
    if (rasterised_) return rasterise(ui);
    std::vector<Tile> changed = ui.viewer.session().read(picture_);
    const DisplaySettings& display = ui.viewer.document().render.display;
    if (picture_.radiance.empty()) return;
    const int width = picture_.radiance.width(), height = picture_.radiance.height();
    if (display_ != display || shown_.width() != width || shown_.height() != height) {
        shown_ = ByteImage(width, height);
        changed = {{0, 0, width, height}};
        display_ = display;
    }
    if (!changed.empty()) show(changed, display);
}

void PictureView::show(const std::vector<Tile>& tiles, const DisplaySettings& settings) {
    ++version_;
    std::size_t pixels = 0;
    for (const Tile& tile : tiles) {
        const auto columns = static_cast<std::size_t>(tile.x1 - tile.x0);
        for (int y = tile.y0; y < tile.y1; ++y)
            display({&picture_.radiance.at(tile.x0, y), columns}, settings,
                    {&shown_.at(tile.x0, y), columns});
        pixels += columns * static_cast<std::size_t>(tile.y1 - tile.y0);
    }
    const bool sameSize = texture_.width() == shown_.width() && texture_.height() == shown_.height();
    if (!sameSize || pixels * 2 > shown_.values().size()) return texture_.upload(shown_);
    for (const Tile& tile : tiles)
        texture_.upload(shown_, {tile.x0, tile.y0, tile.x1 - tile.x0, tile.y1 - tile.y0});
}

void PictureView::mouse(const Widgets& ui, ImVec2 corner) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemHovered()) {
        if (io.MouseWheel != 0)
            ui.execute(
                {"dolly", {{"factor", toText(std::pow(kWheelStep, static_cast<double>(io.MouseWheel)))}}},
                "wheel");
        ui.viewer.session().setFocus(DVec2(io.MousePos.x - corner.x, io.MousePos.y - corner.y));
    } else {
        ui.viewer.session().clearFocus();
    }
    for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Middle, ImGuiMouseButton_Right}) {
        if (ImGui::IsItemActive() && ImGui::IsMouseDragging(button, kClickSlop)) {
            if (!dragging_) {
                ++drags_;
                // Shift-drag takes the object under the press, unless one is selected
                if (button == ImGuiMouseButton_Left && io.KeyShift && ui.viewer.document().selectedObject < 0)
                    pick(ui, io.MouseClickedPos[button], corner);
            }
            const ImVec2 whole = ImGui::GetMouseDragDelta(button, kClickSlop);
            drag(ui, button, dragging_ ? io.MouseDelta : whole);
            dragging_ = true;
        }
    }
    if (ImGui::IsItemDeactivated()) {
        if (!dragging_ && ImGui::IsMouseReleased(ImGuiMouseButton_Left))
            pick(ui, io.MouseClickedPos[ImGuiMouseButton_Left], corner);
        dragging_ = false;
        ui.viewer.endGesture();
    }
}

void PictureView::drag(const Widgets& ui, int button, ImVec2 delta) {
    if (delta.x == 0 && delta.y == 0) return;
    const Document& document = ui.viewer.document();
    const Camera& camera = document.camera;
    const std::string gesture = fmt::format("drag {}", drags_);
    const double right = delta.x, down = delta.y;
    if (button == ImGuiMouseButton_Right) {
        ui.execute({"turn", {{"yaw", toText(-kTurnSpeed * right)}, {"pitch", toText(-kTurnSpeed * down)}}},
                   gesture);
    } else if (button == ImGuiMouseButton_Middle) {
        const double metres = metresPerPixel(camera, camera.distance(), shown_.height());
        ui.execute({"pan", {{"right", toText(-metres * right)}, {"up", toText(metres * down)}}}, gesture);
    } else if (ImGui::GetIO().KeyShift && document.selectedObject >= 0) {
        const Object& object = document.scene->objects[static_cast<std::size_t>(document.selectedObject)];
        const CameraAxes axes = axesOf(camera);
        const double distance = glm::dot(camera.eye - DVec3(object.transform[3]), axes.backward);
        const double metres =
            metresPerPixel(camera, std::max(distance, 0.1 * camera.distance()), shown_.height());
        const DVec3 by = metres * (axes.right * right - axes.up * down);
        ui.execute({"move", {{"object", fmt::format("{}", document.selectedObject)}, {"by", toText(by)}}},
                   gesture);
    } else if (!ImGui::GetIO().KeyShift) {
        ui.execute({"orbit", {{"yaw", toText(-kOrbitSpeed * right)}, {"pitch", toText(kOrbitSpeed * down)}}},
                   gesture);
    }
}

void PictureView::pick(const Widgets& ui, ImVec2 position, ImVec2 corner) {
    const int x = static_cast<int>(position.x - corner.x), y = static_cast<int>(position.y - corner.y);
    if (x < 0 || y < 0 || x >= shown_.width() || y >= shown_.height()) return;
    ui.execute({"pick", {{"x", fmt::format("{}", x)}, {"y", fmt::format("{}", y)}}}, {});
}

/// A square around the picked pixel that is seen on any ground.
void PictureView::pickedMark(const Widgets& ui, ImVec2 corner) const {
    const auto& pixel = ui.viewer.document().pixel;
    if (!pixel) return;
    const float arm = 6 * ui.scale;
    const ImVec2 lo{corner.x + static_cast<float>(pixel->x) - arm,
                    corner.y + static_cast<float>(pixel->y) - arm};
    const ImVec2 hi{lo.x + 2 * arm + 1, lo.y + 2 * arm + 1};
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRect({lo.x - 1, lo.y - 1}, {hi.x + 1, hi.y + 1}, IM_COL32(0, 0, 0, 255), 0, 0, 3 * ui.scale);
    list->AddRect(lo, hi, IM_COL32(255, 255, 255, 255), 0, 0, 1.5F * ui.scale);
}

}
