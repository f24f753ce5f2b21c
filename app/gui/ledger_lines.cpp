#include <fmt/format.h>

#include <algorithm>

#include "app/gui/ledger_parts.h"
#include "app/gui/theme.h"
#include "core/study/palette.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr int kOpenLevels = 3; // of rays that are sent on, at first

/// The ray that a term is about, for the other views to mark.
int rayOf(const LedgerNode& node, const SampleRecord& record) {
    if (node.lamp < 0) return node.ray;
    const int shadowRay = record.lamps[static_cast<std::size_t>(node.lamp)].shadowRay;
    return shadowRay >= 0 ? shadowRay : node.ray;
}

class Lines {
public:
    explicit Lines(const Widgets& ui)
        : ui_(ui), study_(ui.viewer.study()), record_(ui.viewer.picked()->trace),
          text_{study_.ledger(), record_, *ui.viewer.document().scene, study_.settings().notation} {}

    void draw() {
        line({0, false}, 0);
        below(0, 1);
    }

private:
    void below(int node, int level) {
        for (const LedgerLine& next : linesBelow(study_.ledger(), node)) {
            if (text_.saysNothing(next.node)) continue;
            ImGui::PushID(next.node);
            const bool open = line(next, level);
            ImGui::PopID();
            if (open) below(next.node, level + 1);
        }
    }

    /// True if what is below it is to be drawn.
    bool line(const LedgerLine& line, int level) {
        const LedgerNode& node = study_.ledger().at(line.node);
        const bool struck = study_.isStruck(line.node);
        ImGui::TableNextRow();
        if (marked(node))
            ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, ImGui::GetColorU32(ImGuiCol_FrameBgActive));
        ImGui::TableNextColumn();
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                             1.2F * ImGui::GetFontSize() * static_cast<float>(level));
        if (line.node > 0) check(line.node, struck);
        const bool open = term(line, level, struck);
        ImGui::TableNextColumn();
        if (node.operation == LedgerNode::Operation::Product)
            ImGui::TextWrapped("%s", text_.numbers(line.node).c_str());
        ImGui::TableNextColumn();
        const Color value = valueOf(study_.ledger(), line.node, study_.strikes());
        swatch(ui_, value);
        ImGui::SameLine();
        ImGui::TextUnformatted(colorText(value).c_str());
        return open;
    }

    bool marked(const LedgerNode& node) const {
        const bool whole = node.term == Term::Radiance || node.term == Term::Sent || node.term == Term::Lamp;
        return whole && rayOf(node, record_) == ui_.viewer.selectedRay();
    }

    void check(int node, bool struck) {
        bool counts = !struck;
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
        const bool changed = ImGui::Checkbox("##counts", &counts);
        ImGui::PopStyleVar();
        ui_.mark(fmt::format("strike {}", node));
        const Term term = study_.ledger().at(node).term;
        ui_.tooltip(term == Term::Visibility ? "what if it were the other way: blocked, or not blocked?"
                                             : "what if this were not there?");
        if (changed)
            ui_.execute({"strike", {{"term", fmt::format("{}", node)}, {"on", toText(!counts)}}}, {});
        ImGui::SameLine();
    }

    bool term(const LedgerLine& line, int level, bool struck) {
        const LedgerNode& node = study_.ledger().at(line.node);
        const bool opens = node.term == Term::Sent || node.term == Term::Lamp;
        ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_NoTreePushOnOpen;
        if (!opens) flags |= ImGuiTreeNodeFlags_Leaf;
        if (node.term == Term::Sent && level <= kOpenLevels) flags |= ImGuiTreeNodeFlags_DefaultOpen;
        const char* const sign = line.node == 0 ? "" : (line.factor ? "· " : "+ ");
        ImGui::PushStyleColor(ImGuiCol_Text,
                              struck ? ImGui::GetStyle().Colors[ImGuiCol_TextDisabled] : colorOfTerm(node));
        const bool open = ImGui::TreeNodeEx("term", flags, "%s%s", sign, text_.formula(line.node).c_str());
        ImGui::PopStyleColor();
        ui_.mark(fmt::format("term {}", line.node));
        if (struck) strikeThrough();
        if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen())
            ui_.execute({"select-ray", {{"index", fmt::format("{}", rayOf(node, record_))}}}, {});
        if (const std::string whose = text_.whose(line.node); opens && !whose.empty()) {
            ImGui::SameLine();
            ImGui::TextDisabled("%s", whose.c_str());
        }
        return opens && open;
    }

    ImVec4 colorOfTerm(const LedgerNode& node) const {
        if (node.term == Term::Lamp) return colorOf(RayKind::Shadow, ui_.dark);
        if (node.term != Term::Sent && node.term != Term::Radiance)
            return ImGui::GetStyle().Colors[ImGuiCol_Text];
        return colorOf(record_.rays[static_cast<std::size_t>(node.ray)].kind, ui_.dark);
    }

    static void strikeThrough() {
        const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
        const float y = (lo.y + hi.y) / 2;
        ImGui::GetWindowDrawList()->AddLine({lo.x + ImGui::GetTreeNodeToLabelSpacing(), y}, {hi.x, y},
                                            ImGui::GetColorU32(ImGuiCol_TextDisabled),
                                            std::max(1.0F, 0.1F * ImGui::GetFontSize()));
    }

    const Widgets& ui_;
    const PixelStudy& study_;
    const SampleRecord& record_;
    const LedgerText text_;
};

}

void swatch(const Widgets& ui, const Color& radiance) {
    const DisplaySettings& display = ui.viewer.document().render.display;
    const float side = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos(), opposite{corner.x + side, corner.y + side};
    ImGui::Dummy({side, side});
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(corner, opposite, ImGui::GetColorU32(fromHex(shownColor(radiance, display))), 3);
    list->AddRect(corner, opposite, ImGui::GetColorU32(ImGuiCol_Border), 3);
}

void ledgerLines(const Widgets& ui) {
    constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                            ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_Resizable;
    if (!ImGui::BeginTable("ledger", 3, kFlags)) return;
    ImGui::TableSetupColumn("term", 0, 6);
    ImGui::TableSetupColumn("in numbers", 0, 4);
    ImGui::TableSetupColumn("gives", ImGuiTableColumnFlags_WidthFixed, 15 * ImGui::GetFontSize());
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableHeadersRow();
    Lines(ui).draw();
    ImGui::EndTable();
}

}
