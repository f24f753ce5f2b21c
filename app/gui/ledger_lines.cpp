#include <fmt/format.h>

#include <algorithm>

#include "app/gui/ledger_parts.h"
#include "app/gui/theme.h"
#include "core/study/palette.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr int kOpenLevels = 3; // of rays that are sent on, at first
constexpr float kWide = 46;    // in heights of a letter: from here on numbers have a column of their own

/// Lines broken at spaces alone: ImGui's own wrapping also breaks a number at its point.
std::string wrapped(const std::string& text, float width) {
    std::string result, line;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t space = std::min(text.find(' ', at), text.size());
        const std::string longer = (line.empty() ? "" : line + " ") + text.substr(at, space - at);
        if (!line.empty() && ImGui::CalcTextSize(longer.c_str()).x > width) {
            result += line + "\n";
            line = text.substr(at, space - at);
        } else {
            line = longer;
        }
        at = space + 1;
    }
    return result + line;
}

/// The ray that a term is about, for the other views to mark.
int rayOf(const LedgerNode& node, const SampleRecord& record) {
    if (node.lamp < 0) return node.ray;
    const int shadowRay = record.lamps[static_cast<std::size_t>(node.lamp)].shadowRay;
    return shadowRay >= 0 ? shadowRay : node.ray;
}

/// What stands beside a term.
struct Remark {
    std::string text;
    ImVec4 color;
};

class Lines {
public:
    Lines(const Widgets& ui, bool wide)
        : ui_(ui), wide_(wide), study_(ui.viewer.study()), record_(ui.viewer.picked()->trace),
          scene_(ui.viewer.document().scene),
          text_{study_.ledger(), record_, *scene_, study_.settings().notation} {}

    void draw() {
        results();
        below(0, 0);
        mean();
    }

private:
    /// What it all adds up to, and what it would.
    void results() {
        const Color sum = evaluate(study_.ledger());
        result(fmt::format("sample {}", ui_.viewer.picked()->sample), sum,
               sum == ui_.viewer.picked()->trace.radiance
                   ? Remark{"the sum is the film's value, bit for bit", doneColor(ui_.dark)}
                   : Remark{"the sum is not the film's value", errorColor(ui_.dark)},
               "ledger total");
        // always there, so that nothing moves under the pointer that strikes out
        const bool whole = study_.strikes().empty();
        result("with what is struck out", evaluate(study_.ledger(), study_.strikes()),
               {whole ? "nothing yet: untick a term" : "", ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]},
               "ledger struck");
        if (whole) return;
        ImGui::TableSetColumnIndex(wide_ ? 1 : 0);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0});
        ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
        ui_.button("Bring all back", "strike", "undoes what was struck out");
        flow(10 * ImGui::GetFontSize());
        ui_.button("In the whole picture", "strike-picture", "takes it out of every pixel; Ctrl+Z undoes it");
        ImGui::PopStyleVar(2);
    }

    void mean() {
        const int samples = study_.mean().samples(), passes = study_.film().samples;
        if (samples == 0) return;
        Remark remark;
        if (samples == passes)
            remark = study_.mean().value() == study_.film().mean
                         ? Remark{"the film's pixel, bit for bit", doneColor(ui_.dark)}
                         : Remark{"not the film's pixel", errorColor(ui_.dark)};
        result(fmt::format("mean of {} of {} sample{}", samples, passes, passes == 1 ? "" : "s"),
               study_.mean().value(), remark, "ledger mean");
    }

    void result(const std::string& what, const Color& value, const Remark& remark, const char* name) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(what.c_str());
        beside(remark);
        ImGui::TableNextColumn();
        colorCell(value);
        ui_.mark(name);
    }

    /// In the column for numbers, or below the term where there is none.
    void beside(const Remark& remark) const {
        if (wide_) ImGui::TableNextColumn();
        if (remark.text.empty()) return;
        ImGui::PushStyleColor(ImGuiCol_Text, remark.color);
        ImGui::TextUnformatted(wrapped(remark.text, ImGui::GetContentRegionAvail().x).c_str());
        ImGui::PopStyleColor();
    }

    void colorCell(const Color& value) const {
        swatch(ui_, value);
        ImGui::SameLine();
        ImGui::TextUnformatted(colorText(value).c_str());
    }

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
        check(line.node, struck);
        const bool open = term(line, level, struck);
        if (node.operation == LedgerNode::Operation::Product)
            beside({text_.numbers(line.node), ImGui::GetStyle().Colors[ImGuiCol_Text]});
        ImGui::TableSetColumnIndex(wide_ ? 2 : 1);
        colorCell(valueOf(study_.ledger(), line.node, study_.strikes()));
        return open;
    }

    bool marked(const LedgerNode& node) const {
        return (node.term == Term::Sent || node.term == Term::Lamp) &&
               rayOf(node, record_) == ui_.viewer.selectedRay();
    }

    void check(int node, bool struck) {
        bool counts = !struck;
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
        ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
        const bool changed = ImGui::Checkbox("##counts", &counts);
        ImGui::PopStyleVar(2);
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
        if (node.term == Term::Sent && level < kOpenLevels) flags |= ImGuiTreeNodeFlags_DefaultOpen;
        const char* const sign = line.factor ? "· " : "+ ";
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
        if (node.term != Term::Sent) return ImGui::GetStyle().Colors[ImGuiCol_Text];
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
    const bool wide_;
    const PixelStudy& study_;
    const SampleRecord& record_;
    const std::shared_ptr<const Scene> scene_; // kept while a line changes it
    const LedgerText text_;
};

}

void swatch(const Widgets& ui, const Color& radiance) {
    const DisplaySettings display = shownDisplay(ui.viewer.document().render);
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
    const bool wide = ImGui::GetContentRegionAvail().x > kWide * ImGui::GetFontSize();
    if (!ImGui::BeginTable(wide ? "ledger" : "narrow ledger", wide ? 3 : 2, kFlags)) return;
    ImGui::TableSetupColumn("term", 0, 6);
    if (wide) ImGui::TableSetupColumn("in numbers", 0, 5);
    ImGui::TableSetupColumn("gives", ImGuiTableColumnFlags_WidthFixed, 14 * ImGui::GetFontSize());
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableHeadersRow();
    Lines(ui, wide).draw();
    ImGui::EndTable();
}

}
