#include "app/gui/ray_pane.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/document/picture_file.h"
#include "app/gui/sketch_view.h"
#include "app/gui/theme.h"
#include "app/rayview/photon_arrows.h"
#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/image/encode.h"
#include "core/study/palette.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr double kOrbitSpeed = 0.4; // degrees per pixel
constexpr double kWheelStep = 0.9;
constexpr float kClickSlop = 4;     // pixels: a press that moves less is a click
constexpr float kLeastPane = 8;     // pixels; smaller ones show nothing
constexpr float kPlainHeight = 600; // pixels; letters and lines of higher files grow with them
constexpr double kLeastFileHeight = 900;
constexpr float kNearArrow = 8;     // pixels at scale 1: a click hits an arrow so near
constexpr float kLegendHeight = 17; // of the least pane with a legend, in letters' heights

Ink ink(std::uint32_t rgb) {
    return Ink(static_cast<float>((rgb >> 16U) & 255U), static_cast<float>((rgb >> 8U) & 255U),
               static_cast<float>(rgb & 255U), 255) /
           255.0F;
}
Ink ink(const ImVec4& c) { return {c.x, c.y, c.z, c.w}; }

RayStyle rayStyle(bool dark, float scale, float letter) {
    RayStyle style;
    for (int i = 0; i < kRayKinds; ++i)
        style.kinds[static_cast<std::size_t>(i)] = ink(colorOfKind(static_cast<RayKind>(i), dark));
    for (std::size_t i = 0; i < style.boxes.size(); ++i)
        style.boxes[i] = ink(colorOfBox(static_cast<SpaceBox::Role>(i), dark));
    style.blocked = ink(errorColor(dark));
    style.unlit = dark ? Ink(0.02F, 0.02F, 0.03F, 0.9F) : Ink(0.15F, 0.16F, 0.18F, 0.9F);
    style.highlight = dark ? Ink(1) : ink(0x15181e);
    style.text = ink(groundOf(dark).text);
    style.ground = ink(groundOf(dark).paper);
    style.scale = scale;
    style.letter = letter;
    return style;
}

Backdrop backdropOf(bool dark) {
    return dark ? Backdrop{Color(ink(0x3c4454)), Color(ink(0x1b1e25)), 0.6F}
                : Backdrop{Color(ink(0xdfe6f0)), Color(ink(0xf7f8fa)), 0.86F};
}

/// As the pane, but fine enough for a projector.
PictureSize sizeForFile(PictureSize pane) {
    const double larger = std::max(1.0, kLeastFileHeight / pane.height);
    return {static_cast<int>(std::lround(larger * pane.width)),
            static_cast<int>(std::lround(larger * pane.height))};
}

bool drawable(const Widgets& ui, const PictureView& picture) {
    return ui.viewer.hasScene() && ui.viewer.shownWorld() && !picture.shown().empty();
}

struct Stand {
    const char *label, *command, *help;
};
constexpr std::array kStands = {Stand{"Frame", "rayview view=frame", "eye and scene from the side"},
                                Stand{"Follow", "rayview view=follow", "behind the eye, wherever it goes"},
                                Stand{"Top", "rayview view=top", "from above"},
                                Stand{"Side", "rayview view=side", "from the right of the eye"},
                                Stand{"Front", "rayview view=front", "from the scene towards the eye"}};
constexpr std::array kShownRaysLabels = {"one pixel", "row", "column", "grid"};

float comboWidth(const char* longest) {
    return ImGui::CalcTextSize(longest).x + ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().FramePadding.x;
}

/// One button for each stand or, where they do not fit beside the next widget, a list.
void standButtons(const Widgets& ui, float besides) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = besides;
    for (const Stand& stand : kStands)
        width += ImGui::CalcTextSize(stand.label).x + 2 * style.FramePadding.x + style.ItemSpacing.x;
    if (width <= ImGui::GetContentRegionAvail().x) {
        for (const Stand& stand : kStands) {
            if (ImGui::SmallButton(stand.label)) ui.execute(Command::parse(stand.command), {});
            ui.mark(stand.command);
            ui.tooltip(stand.help);
            ImGui::SameLine();
        }
        return;
    }
    ImGui::SetNextItemWidth(comboWidth("View"));
    const bool open = ImGui::BeginCombo("##stand", "View");
    ui.mark("stand");
    if (open) {
        for (const Stand& stand : kStands) {
            if (ImGui::Selectable(stand.label)) ui.execute(Command::parse(stand.command), {});
            ui.mark(stand.command);
            ui.tooltip(stand.help);
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
}

}

void RayPane::execute(const Command& command) {
    command.allowOnly(
        {"view", "yaw", "pitch", "right", "up", "dolly", "show", "step", "labels", "boxes", "level"});
    const auto stand = command.choice("view", kOutsideStandNames);
    const auto show = command.choice("show", kShownRaysNames);
    const auto step = command.integer("step", 1, kMaxPictureSide);
    const auto labels = command.flag("labels");
    const auto boxes = command.choice("boxes", kShownBoxesNames);
    const auto level = command.integer("level", 0, kMostLevels);
    const auto yaw = command.number("yaw", -36000, 36000), pitch = command.number("pitch", -36000, 36000);
    const auto right = command.number("right", -1e9, 1e9), up = command.number("up", -1e9, 1e9);
    const auto dolly = command.number("dolly", 0.01, 100);
    OutsideView& outside = view_.outside();
    if (stand) outside.go(static_cast<OutsideStand>(*stand));
    if (yaw || pitch) outside.orbit(radians(yaw.value_or(0)), radians(pitch.value_or(0)));
    if (right || up) outside.pan(right.value_or(0), up.value_or(0));
    if (dolly) outside.dolly(*dolly);
    if (show || step) step_ = step.value_or(0);
    if (show) show_ = static_cast<ShownRays>(*show);
    labels_ = labels.value_or(labels_);
    if (boxes) index_.show(static_cast<ShownBoxes>(*boxes));
    if (level) index_.setLevel(*level);
}

void RayPane::noticeScene(const Viewer& viewer) {
    if (!viewer.hasScene() || scene_ == viewer.opened().reference) return;
    scene_ = viewer.opened().reference;
    view_.outside().go(OutsideStand::Frame);
}

void RayPane::draw(const Widgets& ui, const PictureView& picture) {
    if (!drawable(ui, picture)) return;
    toolbar(ui);
    const ImVec2 available = ImGui::GetContentRegionAvail(), corner = ImGui::GetCursorScreenPos();
    if (available.x < kLeastPane || available.y < kLeastPane) return;
    size_ = {static_cast<int>(available.x), static_cast<int>(available.y)};
    const Vec2 size(size_.width, size_.height);
    const RayStyle style = rayStyle(ui.dark, ui.scale, ImGui::GetFontSize());
    const Sketch sketch = compose(ui, picture, size_, style);
    eyeray::draw(*ImGui::GetWindowDrawList(), {sketch, size, style.letter, style.ground}, view_.picture(),
                 corner);
    ImGui::InvisibleButton("rays in space", {size.x, size.y},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ui.mark("rays in space");
    mouse(ui, corner);
}

void RayPane::save(const Widgets& ui, const PictureView& picture, const std::filesystem::path& file,
                   std::optional<PictureSize> wanted) {
    if (!drawable(ui, picture)) throw InputError(file.string(), "there is no picture yet", "wait a moment");
    const PictureSize size = wanted.value_or(sizeForFile(size_));
    const float larger = std::max(1.0F, static_cast<float>(size.height) / kPlainHeight);
    const RayStyle style = rayStyle(ui.dark, larger * ui.scale, larger * ImGui::GetFontSize());
    const Sketch sketch = compose(ui, picture, size, style);
    const SketchedPicture sketched{sketch, Vec2(size.width, size.height), style.letter, style.ground};
    if (file.extension() == ".svg") {
        const std::string text = svgOf(sketched, view_.readPicture());
        writeFileAtomically(file, std::as_bytes(std::span(text)));
    } else if (formatOf(file) == ImageFormat::Png) {
        const Metadata metadata = toMetadata(ui.viewer.pictureState(), file.parent_path());
        writeFileAtomically(
            file, encodeDisplayed(imageOf(gl_, sketched, view_.picture()), ImageFormat::Png, metadata));
    } else {
        throw InputError(file.string(), "rays in space are saved as PNG or SVG",
                         "end the name in one of them");
    }
}

/// Draws the view and gives what is to be laid over it.
Sketch RayPane::compose(const Widgets& ui, const PictureView& picture, PictureSize size,
                        const RayStyle& style) {
    many_.update(ui.viewer, show_, step_);
    view_.draw(content(ui, picture), size.width, size.height, style, backdropOf(ui.dark));
    Sketch sketch = view_.sketch();
    caption(ui, sketch, style, size);
    return sketch;
}

void RayPane::toolbar(const Widgets& ui) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0});
    standButtons(ui, comboWidth("one pixel") + index_.controlsWidth());
    shownRaysChoice(ui);
    index_.controls(ui);
    ImGui::PopStyleVar();
}

void RayPane::shownRaysChoice(const Widgets& ui) const {
    ImGui::SetNextItemWidth(comboWidth("one pixel"));
    const bool open = ImGui::BeginCombo("##shown rays", kShownRaysLabels[static_cast<std::size_t>(show_)]);
    ui.mark("shown rays");
    if (!open) return ui.tooltip("whose rays are drawn; row, column and grid go through the picked pixel");
    for (std::size_t i = 0; i < kShownRaysLabels.size(); ++i) {
        if (ImGui::Selectable(kShownRaysLabels[i], static_cast<std::size_t>(show_) == i))
            ui.execute({"rayview", {{"show", std::string(kShownRaysNames[i])}}}, {});
        ui.mark(fmt::format("shown rays={}", kShownRaysNames[i]));
    }
    ImGui::EndCombo();
}

RayViewContent RayPane::content(const Widgets& ui, const PictureView& picture) {
    const Viewer& viewer = ui.viewer;
    RayViewContent content{.world = viewer.shownWorld(),
                           .camera = viewer.document().camera,
                           .picture = &picture.texture(),
                           .pictureVersion = picture.version(),
                           .pictureWidth = picture.shown().width(),
                           .pictureHeight = picture.shown().height(),
                           .aspect = static_cast<double>(picture.shown().width()) / picture.shown().height(),
                           .pixel = {},
                           .samples = {},
                           .selectedRay = -1,
                           .index = index_.picture(viewer),
                           .photons = {},
                           .lens = {},
                           .hurried = ImGui::IsAnyMouseDown(),
                           .labels = labels_};
    if (const auto& picked = viewer.picked()) {
        content.pixel = DVec2(picked->pixel.x, picked->pixel.y);
        const int shown = viewer.player().shown(picked->trace);
        const bool playing = shown < static_cast<int>(picked->trace.rays.size());
        if (playing) played_ = firstRays(picked->trace, shown);
        content.samples.push_back(playing ? &played_ : &picked->trace);
        content.selectedRay = viewer.selectedRay();
    }
    if (const auto& photons = viewer.photons().picture(); photons && !viewer.gridPlayer().on()) {
        content.samples.clear();
        content.selectedRay = -1;
        content.photons = arrowsOf(photons->paths, content.world->radius);
        content.lens = photons->lens;
        return content;
    }
    if (const GridPlayer& player = viewer.gridPlayer(); player.on()) {
        const PixelGrid& grid = player.grid();
        content.pictureWidth = grid.columns;
        content.pictureHeight = grid.rows;
        if (const auto cell = player.current()) content.pixel = DVec2(grid.column(*cell), grid.row(*cell));
    }
    for (const Retrace& trace : many_.samples()) content.samples.push_back(&trace);
    const auto& hovered = picture.hover().pixel();
    if (hovered && hovered->pixel != viewer.document().pixel) {
        content.hovered = &hovered->trace;
        content.hoveredPixel = DVec2(hovered->pixel.x, hovered->pixel.y);
    }
    return content;
}

void RayPane::mouse(const Widgets& ui, ImVec2 corner) {
    const ImGuiIO& io = ImGui::GetIO();
    const Vec2 at(io.MousePos.x - corner.x, io.MousePos.y - corner.y);
    const auto arrowHere = [&] {
        return arrowAt(*view_.projection(), view_.arrows(), at, kNearArrow * ui.scale);
    };
    const auto run = [&](std::vector<Command::Argument> arguments) {
        ui.execute({"rayview", std::move(arguments)}, {});
    };
    if (ImGui::IsItemHovered()) {
        if (io.MouseWheel != 0)
            run({{"dolly", toText(std::pow(kWheelStep, static_cast<double>(io.MouseWheel)))}});
        if (!ImGui::IsItemActive()) rayTooltip(ui, arrowHere());
    }
    for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Middle, ImGuiMouseButton_Right}) {
        if (!ImGui::IsItemActive() || !ImGui::IsMouseDragging(button, kClickSlop)) continue;
        const ImVec2 delta = dragging_ ? io.MouseDelta : ImGui::GetMouseDragDelta(button, kClickSlop);
        dragging_ = true;
        const double right = delta.x, down = delta.y;
        if (right == 0 && down == 0) continue;
        const Camera& camera = view_.outside().camera();
        const double metres = view_.projection()->metresPerPixel(camera.distance());
        if (button == ImGuiMouseButton_Left)
            run({{"yaw", toText(-kOrbitSpeed * right)}, {"pitch", toText(kOrbitSpeed * down)}});
        else
            run({{"right", toText(-metres * right)}, {"up", toText(metres * down)}});
    }
    if (!ImGui::IsItemDeactivated()) return;
    const int arrow = dragging_ || !ImGui::IsMouseReleased(ImGuiMouseButton_Left) ? -1 : arrowHere();
    dragging_ = false;
    if (arrow >= 0)
        ui.execute({"select-ray",
                    {{"index", fmt::format("{}", view_.arrows()[static_cast<std::size_t>(arrow)].ray)}}},
                   {});
}

void RayPane::rayTooltip(const Widgets& ui, int arrow) const {
    const auto& picked = ui.viewer.picked();
    if (arrow < 0 || !picked) return;
    const auto index = static_cast<std::size_t>(view_.arrows()[static_cast<std::size_t>(arrow)].ray);
    if (index >= picked->trace.rays.size()) return;
    const RayRecord& ray = picked->trace.rays[index];
    ui.tooltip(fmt::format("{} ray, depth {}, t = {}: {}; weight {}", name(ray.kind), ray.depth,
                           metresText(ray.t), meeting(*ui.viewer.document().scene, ray),
                           weightText(ray.weight)));
}

/// What is to be done, or which rays are shown, and a legend: before all other lettering.
void RayPane::caption(const Widgets& ui, Sketch& sketch, const RayStyle& style, PictureSize size) {
    const float margin = 0.7F * style.letter;
    const std::vector<SketchLabel> others = std::exchange(sketch.labels, {});
    float y = margin;
    const auto say = [&](const std::string& text) {
        sketch.labels.push_back({{margin, y}, text, style.text, {0, 0}, 0.9F});
        y += 1.35F * style.letter;
    };
    if (!ui.viewer.document().pixel && show_ == ShownRays::Pixel && !ui.viewer.gridPlayer().on() &&
        !ui.viewer.photons().picture())
        say("click a pixel of the picture to see its rays");
    else if (show_ != ShownRays::Pixel && many_.samples().size() < many_.wanted())
        say(fmt::format("{} of {} pixels: no more than {} rays are drawn", many_.samples().size(),
                        many_.wanted(), kMostArrows));
    else if (view_.raysLeftOut() > 0)
        say(fmt::format("the {} weightiest of {} rays", view_.arrows().size(),
                        view_.arrows().size() + view_.raysLeftOut()));
    if (const std::string text = index_.text(); !text.empty()) say(text);
    const Vec2 corner(size.width, size.height);
    if (corner.y > kLegendHeight * style.letter) {
        drawLegend(sketch, view_.arrows(), style, {margin, corner.y - margin},
                   ui.viewer.photons().picture() ? kPhotonKindNames : kRayKindNames);
        if (const IndexPicture* index = index_.picture(ui.viewer))
            drawIndexLegend(sketch, *index, style, corner - Vec2(margin));
    }
    sketch.labels.insert(sketch.labels.end(), others.begin(), others.end());
}

}
