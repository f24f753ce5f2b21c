#include "app/gui/file_dialog.h"

#include <imgui_stdlib.h>

#include <algorithm>

namespace eyeray {

namespace fs = std::filesystem;

void FileDialog::begin(Purpose purpose, const fs::path& folder, std::vector<std::string> endings,
                       std::string name) {
    purpose_ = purpose;
    endings_ = std::move(endings);
    name_ = std::move(name);
    std::error_code error;
    enter(fs::is_directory(folder, error) ? folder : fs::current_path(error));
}

void FileDialog::enter(const fs::path& folder) {
    std::error_code error;
    std::vector<Entry> entries;
    for (const auto& entry :
         fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, error)) {
        const std::string name = entry.path().filename().string();
        if (name.empty() || name[0] == '.') continue;
        std::error_code unreadable;
        const bool isFolder = entry.is_directory(unreadable);
        const bool wanted = std::any_of(endings_.begin(), endings_.end(), [&](const std::string& ending) {
            return entry.path().extension() == ending;
        });
        if (isFolder || wanted) entries.push_back({name, isFolder});
    }
    if (error) {
        problem_ = "cannot read this folder: " + error.message();
        return;
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
    problem_.clear();
    folder_ = fs::absolute(folder, error).lexically_normal();
    entries_ = std::move(entries);
}

std::optional<fs::path> FileDialog::draw(const Widgets& ui) {
    std::optional<fs::path> chosen;
    ImGui::TextWrapped("%s", folder_.string().c_str());
    if (ImGui::Button("folder above")) enter(folder_.parent_path());
    ui.mark("folder above");
    if (!problem_.empty()) ImGui::TextWrapped("%s", problem_.c_str());
    const float below = 2 * ImGui::GetFrameHeightWithSpacing();
    ImGui::BeginChild("entries", {0, -below}, true);
    const std::vector<Entry> entries = entries_;
    for (const Entry& entry : entries) {
        const std::string label = entry.folder ? entry.name + "/" : entry.name;
        const bool clicked =
            ImGui::Selectable(label.c_str(), entry.name == name_, ImGuiSelectableFlags_AllowDoubleClick);
        ui.mark("file " + entry.name);
        if (!clicked) continue;
        if (entry.folder)
            enter(folder_ / entry.name);
        else if (name_ = entry.name; ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
            chosen = folder_ / name_;
    }
    ImGui::EndChild();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue)) chosen = folder_ / name_;
    ui.mark("file name");
    if (ImGui::Button(purpose_ == Purpose::Open ? "Open" : "Save") && !name_.empty())
        chosen = folder_ / name_;
    ui.mark("file choose");
    std::error_code error;
    if (chosen && fs::is_directory(*chosen, error)) {
        enter(*chosen);
        name_.clear();
        return std::nullopt;
    }
    return chosen;
}

}
