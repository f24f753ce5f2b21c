#include <fmt/format.h>

#include "app/gui/panels.h"
#include "app/gui/theme.h"

namespace eyeray {
namespace {

constexpr float kTableWidth = 46; // letters' heights

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

void mark(const Widgets& ui, const NeedItem& item) {
    if (item.proved)
        ImGui::TextColored(doneColor(ui.dark), "proved");
    else
        ImGui::TextUnformatted("measured");
    ui.tooltip(item.proved
                   ? "read from the scene: no pixel can change, and the renderer leaves it out by itself"
                   : "found by tracing parts of the picture with and without");
}

void reason(const Widgets& ui, const NeedItem& item) {
    ImGui::TextWrapped("%s", item.reason.c_str());
    if (item.takenBack.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, errorColor(ui.dark));
    ImGui::TextWrapped("taken back: %s", item.takenBack.c_str());
    ImGui::PopStyleColor();
}

void table(const Widgets& ui, const MeasuredNeeds& needs) {
    constexpr auto kFlags =
        ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("needs", 6, kFlags)) return;
    for (const char* const heading : {"", "what", "change", "saves", "error"})
        ImGui::TableSetupColumn(heading);
    ImGui::TableSetupColumn("why", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableHeadersRow();
    for (const NeedItem& item : needs.items) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        mark(ui, item);
        cell(item.what);
        cell(changeText(item));
        cell(savingText(item));
        cell(errorText(item.error));
        ImGui::TableNextColumn();
        reason(ui, item);
    }
    ImGui::EndTable();
}

/// Where a table would be too narrow for its reasons: first what has been measured, which saves most.
void list(const Widgets& ui, const MeasuredNeeds& needs) {
    for (const bool proved : {false, true})
        for (const NeedItem& item : needs.items) {
            if (item.proved != proved) continue;
            mark(ui, item);
            ImGui::SameLine();
            ImGui::TextWrapped("%s: %s", item.what.c_str(), changeText(item).c_str());
            ImGui::Indent();
            if (!proved)
                dimmedText(fmt::format("saves {}, error {}", savingText(item), errorText(item.error)));
            reason(ui, item);
            ImGui::Unindent();
        }
}

void buttons(const Widgets& ui, bool hold, bool applied) {
    if (!hold && !applied)
        ui.button("Measure", "measure-needs", "what does this picture need, and what not?");
    if (hold && !applied)
        ui.button("Use no more", "apply-needs",
                  "makes the picture with no more than it needs (U); undo brings all back");
    if (applied && !hold) ui.button("Undo", "undo", "brings back what was set");
}

}

void needsView(const Widgets& ui) {
    const NeedsMeasuring& measuring = ui.viewer.needs();
    if (measuring.running()) {
        const std::string doing = (measuring.checking() ? "the whole picture: " : "") + measuring.doing();
        ImGui::ProgressBar(static_cast<float>(measuring.done()), {ImGui::GetFontSize() * 20, 0},
                           doing.c_str());
    } else {
        buttons(ui, ui.viewer.needsHold(), ui.viewer.needsApplied());
    }
    const auto& needs = measuring.needs();
    if (!needs) {
        if (!measuring.running())
            dimmedText(
                "What could be left out of this picture and nobody would see it? By proof from the scene, "
                "and by tracing parts of it with and without.");
        return;
    }
    if (!measuring.running()) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
    }
    const bool stale = !ui.viewer.needsHold() && !ui.viewer.needsApplied();
    ImGui::TextWrapped("%s%s", stale ? "before the last change: " : "", summaryText(*needs).c_str());
    ui.mark("needs summary");
    const bool wide = ImGui::GetContentRegionAvail().x > kTableWidth * ImGui::GetFontSize();
    if (!needs->items.empty()) wide ? table(ui, *needs) : list(ui, *needs);
    dimmedText(measureText(*needs));
}

}
