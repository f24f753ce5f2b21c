#include "app/gui/index_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/study/ray_traversal.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr std::array kLabels = {"no boxes", "box levels", "ray's boxes"};
constexpr float kSliderWidth = 5; // letters' heights

float listWidth() {
    return ImGui::CalcTextSize(kLabels[1]).x + ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().FramePadding.x;
}
float sliderWidth() { return kSliderWidth * ImGui::GetFontSize(); }

}

float IndexChoice::controlsWidth() const {
    const float slider = slides() ? sliderWidth() + ImGui::GetStyle().ItemSpacing.x : 0;
    return listWidth() + ImGui::GetStyle().ItemSpacing.x + slider;
}

void IndexChoice::controls(const Widgets& ui) const {
    const auto now = static_cast<std::size_t>(shown_);
    const float width = listWidth();
    flow(width);
    ImGui::SetNextItemWidth(width);
    const bool open = ImGui::BeginCombo("##shown boxes", kLabels[now]);
    ui.mark("shown boxes");
    if (!open) ui.tooltip("the index over the scene, level by level, or as the selected ray goes through it");
    if (open) {
        for (std::size_t i = 0; i < kLabels.size(); ++i) {
            if (ImGui::Selectable(kLabels[i], i == now))
                ui.execute({"rayview", {{"boxes", std::string(kShownBoxesNames[i])}}}, {});
            ui.mark(fmt::format("shown boxes={}", kShownBoxesNames[i]));
        }
        ImGui::EndCombo();
    }
    if (!slides()) return;
    flow(sliderWidth());
    ImGui::SetNextItemWidth(sliderWidth());
    int level = std::min(level_, levels_ - 1);
    const bool changed =
        ImGui::SliderInt("##level", &level, 0, levels_ - 1, "level %d", ImGuiSliderFlags_AlwaysClamp);
    ui.mark("box level");
    ui.tooltip("level 0 is the box around all; each box of the next level lies in one of this");
    if (changed) ui.execute({"rayview", {{"level", fmt::format("{}", level)}}}, {});
}

const IndexPicture* IndexChoice::picture(const Viewer& viewer) {
    refresh(viewer);
    return made_.shown == ShownBoxes::None ? nullptr : &picture_;
}

void IndexChoice::refresh(const Viewer& viewer) {
    Made wanted{.world = viewer.shownWorld(),
                .shown = shown_,
                .level = level_,
                .picked = false,
                .kind = RayKind::Eye,
                .origin = Vec3(0),
                .direction = Vec3(0),
                .t = 0,
                .settings = viewer.document().render.trace};
    const auto& picked = viewer.picked();
    const int ray = viewer.selectedRay();
    if (picked && !picked->trace.rays.empty()) {
        const RayRecord& record = picked->trace.rays[static_cast<std::size_t>(ray)];
        wanted.picked = true;
        wanted.kind = record.kind;
        wanted.origin = record.origin;
        wanted.direction = record.direction;
        wanted.t = record.t;
    }
    if (wanted == made_) return;
    made_ = std::move(wanted);
    picture_ = {};
    counts_ = {};
    if (shown_ == ShownBoxes::Level) {
        levels_ = levelsOf(*made_.world);
        picture_ = boxesOfLevel(*made_.world, std::min(level_, levels_ - 1));
    }
    if (shown_ != ShownBoxes::Ray || !made_.picked) return;
    TraversalLog log;
    logTraversal(*made_.world, made_.settings, picked->trace, ray, log);
    counts_ = log.counts;
    picture_ = pictureOf(*made_.world, log);
}

std::string IndexChoice::text() const {
    if (made_.shown == ShownBoxes::None) return {};
    const World& world = *made_.world;
    if (made_.shown == ShownBoxes::Ray)
        return made_.picked ? traversalText(counts_, world)
                            : "click a pixel: then the boxes that its ray is tested against are shown";
    if (levels_ == 0)
        return fmt::format("no index over {} primitives: every ray is tested against all",
                           countText(world.primitives));
    const std::size_t boxes = picture_.boxes.size() + picture_.leftOut;
    std::string text = fmt::format("level {} of {}: {} {}", std::min(level_, levels_ - 1), levels_ - 1,
                                   countText(boxes), boxes == 1 ? "box" : "boxes");
    if (picture_.leftOut > 0) text += fmt::format(", the {} largest drawn", picture_.boxes.size());
    return text;
}

}
