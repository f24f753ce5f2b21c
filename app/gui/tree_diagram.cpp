#include <fmt/format.h>

#include <algorithm>

#include "app/gui/theme.h"
#include "app/gui/tree_parts.h"
#include "core/study/palette.h"

namespace eyeray {
namespace {

constexpr float kSmallest = 0.8F, kLargest = 1.15F; // letters of the diagram against those of the window
constexpr float kMargin = 0.8F;                     // in letters, as all lengths below
constexpr float kBar = 0.4F, kSwatch = 1.1F, kPadding = 0.4F, kKnob = 0.55F;
constexpr int kCurveSteps = 24;

ImVec2 operator+(ImVec2 a, ImVec2 b) { return {a.x + b.x, a.y + b.y}; }

class Canvas {
public:
    Canvas(const Widgets& ui, float letter)
        : ui_(ui), diagram_(ui.viewer.study().diagram()), letter_(letter),
          corner_(ImGui::GetCursorScreenPos() + ImVec2{kMargin * letter, kMargin * letter}),
          list_(ImGui::GetWindowDrawList()), hasChildren_(diagram_.nodes.size(), false),
          onPath_(diagram_.nodes.size(), false) {
        for (const DiagramNode& node : diagram_.nodes)
            if (node.parent >= 0) hasChildren_[static_cast<std::size_t>(node.parent)] = true;
        const int selected = selectedNode();
        for (int i = selected; i >= 0; i = at(i).parent) onPath_[static_cast<std::size_t>(i)] = true;
    }

    void draw() {
        for (int i = 0; i < count(); ++i)
            if (at(i).parent >= 0) edge(i);
        for (int i = 0; i < count(); ++i) box(i);
    }

    int nodeAt(ImVec2 position) const {
        for (int i = 0; i < count(); ++i) {
            const auto [lo, hi] = corners(at(i));
            if (position.x >= lo.x && position.y >= lo.y && position.x < hi.x && position.y < hi.y) return i;
        }
        return -1;
    }

    /// The node whose knob for folding is there.
    int knobAt(ImVec2 position) const {
        for (int i = 0; i < count(); ++i) {
            if (!hasKnob(i)) continue;
            const ImVec2 knob = knobOf(at(i));
            const float dx = position.x - knob.x, dy = position.y - knob.y, r = 1.4F * kKnob * letter_;
            if (dx * dx + dy * dy < r * r) return i;
        }
        return -1;
    }

    const DiagramNode& at(int node) const { return diagram_.nodes[static_cast<std::size_t>(node)]; }
    int selectedNode() const {
        for (int i = 0; i < count(); ++i)
            if (at(i).traced && at(i).ray == ui_.viewer.selectedRay()) return i;
        return -1;
    }

private:
    int count() const { return static_cast<int>(diagram_.nodes.size()); }
    ImVec2 placed(const Vec2& p) const { return corner_ + ImVec2{p.x * letter_, p.y * letter_}; }
    std::pair<ImVec2, ImVec2> corners(const DiagramNode& node) const {
        return {placed({node.x, node.y}), placed({node.x + node.width, node.y + node.height})};
    }
    ImVec2 knobOf(const DiagramNode& node) const {
        return placed({node.x + node.width, node.y + node.height / 2});
    }
    bool hasKnob(int node) const {
        return at(node).traced && (hasChildren_[static_cast<std::size_t>(node)] || at(node).hidden > 0);
    }
    ImU32 color(RayKind kind, float alpha = 1) const {
        ImVec4 result = colorOf(kind, ui_.dark);
        result.w = alpha;
        return ImGui::GetColorU32(result);
    }

    void text(ImVec2 at, float size, ImU32 color, const std::string& words) {
        list_->AddText(ImGui::GetFont(), size * letter_, at, color, words.c_str());
    }

    void edge(int index) {
        const DiagramNode& node = at(index);
        const auto curve = edgeCurve(diagram_, node);
        const ImVec2 from = placed(curve[0]), to = placed(curve[3]);
        const float above = 1.2F * letter_;
        if (!ImGui::IsRectVisible({from.x, std::min(from.y, to.y) - above},
                                  {to.x, std::max(from.y, to.y) + above}))
            return;
        const bool marked = onPath_[static_cast<std::size_t>(index)];
        stroke(curve, node.kind, (node.traced ? 0.12F : 0.06F) * (marked ? 2.2F : 1.0F));
        if (node.edge.empty()) return;
        const ImVec2 end = placed(edgeLabel(diagram_, node));
        const float size = 0.85F,
                    width = ImGui::CalcTextSize(node.edge.c_str()).x * size * letter_ / ImGui::GetFontSize();
        text({end.x - width, end.y - size * letter_}, size, ImGui::GetColorU32(ImGuiCol_Text), node.edge);
    }

    /// A curve in the dashes of its kind.
    void stroke(const std::array<Vec2, 4>& curve, RayKind kind, float width) {
        const auto dashes = dashesOf(kind);
        const float thickness = std::max(1.0F, width * letter_);
        if (dashes.empty()) {
            list_->AddBezierCubic(placed(curve[0]), placed(curve[1]), placed(curve[2]), placed(curve[3]),
                                  color(kind), thickness);
            return;
        }
        std::size_t part = 0;
        float left = dashes[0];
        Vec2 from = curve[0];
        for (int i = 1; i <= kCurveSteps; ++i) {
            const Vec2 to = pointOf(curve, static_cast<float>(i) / kCurveSteps);
            for (float rest = glm::length(to - from); rest > 0;) {
                const float step = std::min(rest, left);
                const Vec2 next = from + (to - from) * (step / rest);
                if (part % 2 == 0) list_->AddLine(placed(from), placed(next), color(kind), thickness);
                from = next;
                rest -= step;
                left -= step;
                if (left <= 0) left = dashes[++part % dashes.size()];
            }
        }
    }

    void box(int index) {
        const DiagramNode& node = at(index);
        const auto [lo, hi] = corners(node);
        if (node.traced) ui_.rectangles[fmt::format("ray {}", node.ray)] = {lo.x, lo.y, hi.x, hi.y};
        if (!ImGui::IsRectVisible(lo, {hi.x + 3 * letter_, hi.y})) return;
        const bool selected = node.traced && node.ray == ui_.viewer.selectedRay();
        const float rounding = 0.3F * letter_;
        list_->AddRectFilled(lo, hi, ImGui::GetColorU32(selected ? ImGuiCol_FrameBgActive : ImGuiCol_FrameBg),
                             rounding);
        list_->AddRect(lo, hi,
                       node.faint && !selected ? ImGui::GetColorU32(ImGuiCol_Border) : color(node.kind),
                       rounding, 0, (selected ? 0.22F : 0.08F) * letter_);
        if (node.traced) {
            list_->AddRectFilled(lo, {lo.x + kBar * letter_, hi.y}, color(node.kind), rounding,
                                 ImDrawFlags_RoundCornersLeft);
            swatch(node, hi);
        }
        const ImU32 plain = ImGui::GetColorU32(node.faint ? ImGuiCol_TextDisabled : ImGuiCol_Text);
        const float x = lo.x + (kBar + kPadding) * letter_;
        text({x, lo.y + 0.25F * letter_}, 0.95F, plain, node.title);
        text({x, lo.y + 1.55F * letter_}, 0.85F, ImGui::GetColorU32(ImGuiCol_TextDisabled), node.detail);
        if (hasKnob(index)) knob(node);
    }

    void swatch(const DiagramNode& node, ImVec2 hi) {
        const float side = kSwatch * letter_, y = hi.y - (node.height * letter_ + side) / 2;
        const ImVec2 corner{hi.x - side - 1.3F * kPadding * letter_, y},
            opposite = corner + ImVec2{side, side};
        const DisplaySettings display = shownDisplay(ui_.viewer.document().render);
        list_->AddRectFilled(corner, opposite,
                             ImGui::GetColorU32(fromHex(shownColor(node.radiance, display))),
                             0.15F * letter_);
        list_->AddRect(corner, opposite, ImGui::GetColorU32(ImGuiCol_Border), 0.15F * letter_);
    }

    void knob(const DiagramNode& node) {
        const ImVec2 middle = knobOf(node);
        const float r = kKnob * letter_, arm = 0.55F * r;
        list_->AddCircleFilled(middle, r, ImGui::GetColorU32(ImGuiCol_ChildBg));
        list_->AddCircle(middle, r, color(node.kind), 0, 0.08F * letter_);
        const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
        list_->AddLine(middle + ImVec2{-arm, 0}, middle + ImVec2{arm, 0}, ink, 0.1F * letter_);
        ui_.rectangles[fmt::format("fold {}", node.ray)] = {middle.x - r, middle.y - r, middle.x + r,
                                                            middle.y + r};
        if (node.hidden == 0) return;
        list_->AddLine(middle + ImVec2{0, -arm}, middle + ImVec2{0, arm}, ink, 0.1F * letter_);
        text(middle + ImVec2{1.4F * r, -0.5F * letter_}, 0.9F, ImGui::GetColorU32(ImGuiCol_TextDisabled),
             fmt::format("{} more", node.hidden));
    }

    const Widgets& ui_;
    const TreeDiagram& diagram_;
    const float letter_;
    const ImVec2 corner_; // of the diagram, in the window
    ImDrawList* const list_;
    std::vector<bool> hasChildren_, onPath_;
};

/// Size of its letters against the window's, where the diagram would fill the width and the height with
/// letters of these sizes: what has to be scrolled at any size is shown large enough to be read.
float fittedScale(float byWidth, float byHeight) {
    const float widthScale = byWidth / ImGui::GetFontSize(), heightScale = byHeight / ImGui::GetFontSize();
    const float whole = std::min(widthScale, heightScale);
    if (whole >= kSmallest) return std::min(whole, kLargest);
    return std::clamp(heightScale, kSmallest, 1.0F);
}

/// Brings the selected node into sight when another one has been selected.
void follow(const Widgets& ui, const Canvas& canvas, float letter) {
    int* const last = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("followed"), 0);
    if (*last == ui.viewer.selectedRay()) return;
    *last = ui.viewer.selectedRay();
    const int selected = canvas.selectedNode();
    if (selected < 0) return;
    const DiagramNode& node = canvas.at(selected);
    ImGui::SetScrollX(std::max(0.0F, (node.x + node.width / 2) * letter - ImGui::GetWindowWidth() / 2));
    ImGui::SetScrollY(std::max(0.0F, (node.y + node.height / 2) * letter - ImGui::GetWindowHeight() / 2));
}

void mouse(const Widgets& ui, const Canvas& canvas) {
    const ImVec2 position = ImGui::GetIO().MousePos;
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        const ImVec2 by = ImGui::GetIO().MouseDelta;
        ImGui::SetScrollX(ImGui::GetScrollX() - by.x);
        ImGui::SetScrollY(ImGui::GetScrollY() - by.y);
    }
    if (!ImGui::IsItemDeactivated() || ImGui::GetIO().MouseDragMaxDistanceSqr[0] > 16) return;
    if (const int fold = canvas.knobAt(position); fold >= 0)
        ui.execute({"collapse", {{"ray", std::to_string(canvas.at(fold).ray)}}}, {});
    else if (const int node = canvas.nodeAt(position); node >= 0)
        selectRay(ui, canvas.at(node).ray);
}

}

void treeDiagram(const Widgets& ui) {
    const TreeDiagram& diagram = ui.viewer.study().diagram();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float wide = diagram.width + 2 * kMargin + 2, high = diagram.height + 2 * kMargin;
    const float letter = ImGui::GetFontSize() * fittedScale(room.x / wide, room.y / high);
    Canvas canvas(ui, letter);
    ImGui::InvisibleButton("canvas", {std::max(wide * letter, room.x), std::max(high * letter, room.y)});
    canvas.draw();
    follow(ui, canvas, letter);
    mouse(ui, canvas); // last, for what it does makes another diagram
}

}
