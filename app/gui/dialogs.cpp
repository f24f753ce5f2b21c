#include "app/gui/dialogs.h"

#include <fmt/format.h>

#include <array>

#include "app/document/document_commands.h"
#include "app/gui/actions.h"
#include "app/gui/gui_commands.h"
#include "app/gui/theme.h"
#include "app/viewer/viewer_commands.h"

namespace eyeray {
namespace {

void row(std::string_view left, std::string_view right) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(left.data(), left.data() + left.size());
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(right.data(), right.data() + right.size());
    ImGui::PopTextWrapPos();
}

bool beginRows(const char* heading, float leftShare) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", heading);
    if (!ImGui::BeginTable(heading, 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
        return false;
    ImGui::TableSetupColumn("left", 0, leftShare);
    ImGui::TableSetupColumn("right", 0, 1 - leftShare);
    return true;
}

template <class Commands>
void commandRows(const Commands& commands) {
    for (const auto& command : commands)
        row(command.name, fmt::format("{} {}", command.help,
                                      command.usage.empty() ? "" : fmt::format("({})", command.usage)));
}

}

void helpPage(const Widgets&) {
    if (beginRows("Mouse", 0.3F)) {
        for (const Gesture& gesture : gestures()) row(gesture.what, gesture.does);
        ImGui::EndTable();
    }
    if (beginRows("Keys", 0.3F)) {
        for (const Action& action : actions())
            if (!action.chord.empty()) row(action.chord, action.label);
        ImGui::EndTable();
    }
    if (beginRows("Commands, for recordings: one a line, name key=value …", 0.3F)) {
        commandRows(documentCommands());
        commandRows(viewerCommands());
        commandRows(guiCommands());
        ImGui::EndTable();
    }
}

void importReport(const Widgets& ui) {
    const OpenedScene& opened = ui.viewer.opened();
    ImGui::TextWrapped("%s", opened.reference.c_str());
    if (opened.report.lines.empty()) ImGui::TextUnformatted("Everything in the file is shown as it says.");
    struct Group {
        ImportReport::Kind kind;
        const char* heading;
    };
    for (const Group& group : {Group{ImportReport::Kind::Added, "Added, since the file has none"},
                               Group{ImportReport::Kind::Doubtful, "May look wrong"},
                               Group{ImportReport::Kind::Repaired, "Mended"},
                               Group{ImportReport::Kind::Ignored, "Read, but not shown"}}) {
        bool first = true;
        for (const ImportReport::Line& line : opened.report.lines) {
            if (line.kind != group.kind) continue;
            if (first) {
                ImGui::Spacing();
                ImGui::TextDisabled("%s", group.heading);
            }
            first = false;
            ImGui::Bullet();
            ImGui::TextWrapped("%s", line.text.c_str());
        }
    }
}

}
