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

void PictureView::draw(const Widgets& ui, bool other) {
    const ImVec2 available = ImGui::GetContentRegionAvail();
    const double aspect = ui.viewer.hasScene() ? ui.viewer.document().aspect : 0;
    const Fit fitting = fit(available, aspect);
    ui.viewer.setPictureSize(fitting.width, fitting.height);
    refresh(ui);

    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 size{static_cast<float>(fitting.width), static_cast<float>(fitting.height)};
    const ImVec2 corner{std::floor(start.x + (available.x - size.x) / 2),
                        std::floor(start.y + (available.y - size.y) / 2)};
    image(ui, corner, size, other);
    if (ui.viewer.hasScene() && ui.viewer.document().comparison.on && !playsGrid_)
        CompareView::handle(ui, corner, size);
    ImGui::SetCursorScreenPos(corner);
    ImGui::InvisibleButton("picture", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ui.mark("picture");
    if (!ui.viewer.hasScene()) return;
    mouse(ui, corner);
    tellHovered(ui, corner, {corner.x + size.x / 2, corner.y + size.y / 2});
    if (playsGrid_) return;
    pickedMark(ui, corner);
    if (rasterised_) raster_.note(ui, corner);
}

void PictureView::setRasterised(bool on) {
    rasterised_ = on;
    ++switches_;
}

const GlTexture& PictureView::texture() const {
    if (playsGrid_) return grid_.texture();
    if (photons_.showing()) return photons_.texture();
    return rasterised_ ? raster_.texture() : film_.texture();
}

void PictureView::refresh(const Widgets& ui) {
    if (!ui.viewer.hasScene()) return;
    const bool playsGrid = ui.viewer.gridPlayer().on();
    if (playsGrid != playsGrid_) ++switches_;
    playsGrid_ = playsGrid;
    if (playsGrid_) grid_.refresh(ui.viewer, ui.dark);
    photons_.refresh(ui.viewer);
    const Comparison& comparison = ui.viewer.document().comparison;
    film_.refresh(ui.viewer.session(), shownDisplay(ui.viewer.document().render));
    layer_.refresh(ui.viewer);
    const bool comparesRaster = comparison.on && comparison.isRasterised();
    if (rasterised_ || comparesRaster) raster_.refresh(ui.viewer);
    ui.viewer.compareWith(comparesRaster ? raster_.radiance() : nullptr);
    if (comparison.on) compare_.refresh(ui.viewer);
}

void PictureView::image(const Widgets& ui, ImVec2 corner, ImVec2 size, bool other) const {
    if (playsGrid_) return grid_.draw(ui, corner, size);
    if (photons_.showing() && !other) return photonImage(ui, corner, size);
    const ImVec2 opposite{corner.x + size.x, corner.y + size.y};
    const LegendPlace place{{corner.x, opposite.y}, size.x, size.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool compares = ui.viewer.hasScene() && ui.viewer.document().comparison.on;
    const bool layered = layer_.showing() && !compares && !other && !rasterised_;
    const GlTexture& own = rasterised_ ? raster_.texture() : film_.texture();
    const GlTexture& whole = layered ? layer_.texture() : own;
    if (whole.width() > 0) list.AddImage(textureId(whole), corner, opposite);
    if (layered) layer_.legend(ui, place);
    if (!compares) return;
    compare_.draw(ui, raster_.texture(), corner, size, other);
    compare_.legend(ui, place);
}

void PictureView::photonImage(const Widgets& ui, ImVec2 corner, ImVec2 size) const {
    const ImVec2 opposite{corner.x + size.x, corner.y + size.y};
    ImGui::GetWindowDrawList()->AddImage(textureId(photons_.texture()), corner, opposite);
    photons_.legend(ui, {{corner.x, opposite.y}, size.x, size.y});
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
        const double metres = metresPerPixel(camera, camera.distance(), shown().height());
        ui.execute({"pan", {{"right", toText(-metres * right)}, {"up", toText(metres * down)}}}, gesture);
    } else if (ImGui::GetIO().KeyShift && document.selectedObject >= 0) {
        const Object& object = document.scene->objects[static_cast<std::size_t>(document.selectedObject)];
        const CameraAxes axes = axesOf(camera);
        const double distance = glm::dot(camera.eye - DVec3(object.transform[3]), axes.backward);
        const double metres =
            metresPerPixel(camera, std::max(distance, 0.1 * camera.distance()), shown().height());
        const DVec3 by = metres * (axes.right * right - axes.up * down);
        ui.execute({"move", {{"object", fmt::format("{}", document.selectedObject)}, {"by", toText(by)}}},
                   gesture);
    } else if (!ImGui::GetIO().KeyShift) {
        ui.execute({"orbit", {{"yaw", toText(-kOrbitSpeed * right)}, {"pitch", toText(kOrbitSpeed * down)}}},
                   gesture);
    }
}

/// Of the picture itself alone: beside or in place of it other things stand under the pointer.
void PictureView::tellHovered(const Widgets& ui, ImVec2 corner, ImVec2 middle) {
    const bool asked = hovers_ && ImGui::IsItemHovered() && !ImGui::IsAnyMouseDown();
    const bool itself =
        !playsGrid_ && !rasterised_ && !photons_.showing() && !ui.viewer.document().comparison.on;
    const auto pixel = pixelAt(ImGui::GetIO().MousePos, corner);
    if (!asked || !itself || !pixel) return hover_.leave();
    hover_.over(ui.viewer, *pixel, film_.version());
    const double across = (pixel->x + 0.5) / shown().width(), down = (pixel->y + 0.5) / shown().height();
    hover_.draw(ui, middle, shown().at(pixel->x, pixel->y),
                layer_.showing() ? layer_.textAt(across, down) : "");
}

/// The pixel of the picture at a position in the window.
std::optional<PixelPosition> PictureView::pixelAt(ImVec2 position, ImVec2 corner) const {
    const float x = position.x - corner.x, y = position.y - corner.y; // far out where there is no pointer
    const auto within = [](float value, int size) { return value >= 0 && value < static_cast<float>(size); };
    if (!within(x, shown().width()) || !within(y, shown().height())) return std::nullopt;
    return PixelPosition{static_cast<int>(x), static_cast<int>(y)};
}

void PictureView::pick(const Widgets& ui, ImVec2 position, ImVec2 corner) {
    const auto pixel = pixelAt(position, corner);
    if (pixel)
        ui.execute({"pick", {{"x", fmt::format("{}", pixel->x)}, {"y", fmt::format("{}", pixel->y)}}}, {});
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
