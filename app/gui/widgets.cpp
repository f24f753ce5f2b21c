#include "app/gui/widgets.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/document/settings.h"

namespace eyeray {
namespace {

constexpr float kLabelShare = 0.42F; // of a panel's width

ImGuiSliderFlags sliderFlags(bool logarithmic) {
    return ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
}

std::string hidden(const std::string& name) { return "##" + name; }

}

void Widgets::mark(const std::string& name) const {
    const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    rectangles[name] = {lo.x, lo.y, hi.x, hi.y};
}

void Widgets::tooltip(std::string_view text) const {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || text.empty()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void Widgets::run(const Command& command, const std::string& gesture) const { execute(command, gesture); }

bool Widgets::button(const char* label, const char* command, const char* help) const {
    const bool pressed = ImGui::Button(label);
    mark(command);
    tooltip(help);
    if (pressed) run(Command::parse(command), {});
    return pressed;
}

void Widgets::flag(const char* label, const char* key) const {
    const Setting& setting = settingNamed(key);
    bool on = setting.get(viewer.document()) == "on";
    const bool changed = ImGui::Checkbox(label, &on);
    mark(key);
    tooltip(setting.help);
    if (changed) run({"set", {{key, toText(on)}}}, {});
}

void Widgets::integer(const char* label, const char* key, int lowest, int highest, bool logarithmic) const {
    const Setting& setting = settingNamed(key);
    int value = static_cast<int>(toNumber(setting.get(viewer.document())).value_or(lowest));
    labelled(label);
    const bool changed =
        ImGui::SliderInt(hidden(key).c_str(), &value, lowest, highest, "%d", sliderFlags(logarithmic));
    mark(key);
    tooltip(setting.help);
    if (changed) run({"set", {{key, fmt::format("{}", value)}}}, key);
    if (ImGui::IsItemDeactivated()) viewer.endGesture();
}

void Widgets::number(const char* label, const char* key, float lowest, float highest, const char* format,
                     bool logarithmic) const {
    const Setting& setting = settingNamed(key);
    auto value = static_cast<float>(toNumber(setting.get(viewer.document())).value_or(lowest));
    labelled(label);
    const bool changed =
        ImGui::SliderFloat(hidden(key).c_str(), &value, lowest, highest, format, sliderFlags(logarithmic));
    mark(key);
    tooltip(setting.help);
    if (changed) run({"set", {{key, fmt::format("{}", value)}}}, key);
    if (ImGui::IsItemDeactivated()) viewer.endGesture();
}

void Widgets::choice(const char* label, const char* key, std::span<const std::string_view> names,
                     std::span<const std::string_view> labels) const {
    const Setting& setting = settingNamed(key);
    const std::string value = setting.get(viewer.document());
    const auto current =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), value) - names.begin());
    labelled(label);
    const std::string preview(current < labels.size() ? labels[current] : std::string_view(value));
    const bool open = ImGui::BeginCombo(hidden(key).c_str(), preview.c_str());
    mark(key);
    if (!open) return tooltip(setting.help);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (ImGui::Selectable(std::string(labels[i]).c_str(), i == current))
            run({"set", {{key, std::string(names[i])}}}, {});
        mark(fmt::format("{}={}", key, names[i]));
    }
    ImGui::EndCombo();
}

void Widgets::part(const Command& command, const char* key, const std::string& value, bool dragged) const {
    auto arguments = command.arguments();
    const std::string gesture = dragged ? command.text() + key : "";
    arguments.emplace_back(key, value);
    run({command.name(), std::move(arguments)}, gesture);
}

void Widgets::partColor(const Command& command, const char* label, const char* key,
                        const Color& value) const {
    Color edited = value;
    labelled(label);
    ImGui::PushID(key);
    const bool changed = ImGui::ColorEdit3("##color", &edited.x,
                                           ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR |
                                               ImGuiColorEditFlags_NoOptions);
    mark(command.name() + " " + key);
    if (changed) part(command, key, toText(glm::max(edited, Color(0))), true);
    if (ImGui::IsItemDeactivated()) viewer.endGesture();
    ImGui::PopID();
}

void Widgets::partNumber(const Command& command, const char* label, const char* key, double value,
                         double lowest, double highest, const char* format, bool logarithmic) const {
    auto edited = static_cast<float>(value);
    labelled(label);
    const bool changed = ImGui::SliderFloat(hidden(key).c_str(), &edited, static_cast<float>(lowest),
                                            static_cast<float>(highest), format, sliderFlags(logarithmic));
    mark(command.name() + " " + key);
    if (changed) part(command, key, fmt::format("{}", edited), true);
    if (ImGui::IsItemDeactivated()) viewer.endGesture();
}

void Widgets::partFlag(const Command& command, const char* label, const char* key, bool value) const {
    bool edited = value;
    const bool changed = ImGui::Checkbox(label, &edited);
    mark(command.name() + " " + key);
    if (changed) part(command, key, toText(edited), false);
}

void Widgets::partPosition(const Command& command, const char* label, const char* key,
                           const DVec3& value) const {
    Vec3 edited(value);
    const auto speed = static_cast<float>(boundsOf(*viewer.document().scene).radius() * 0.005);
    labelled(label);
    const bool changed = ImGui::DragFloat3(hidden(key).c_str(), &edited.x, speed, 0, 0, "%.2f");
    mark(command.name() + " " + key);
    tooltip("drag, or double-click to type; metres");
    if (changed) part(command, key, toText(DVec3(edited)), true);
    if (ImGui::IsItemDeactivated()) viewer.endGesture();
}

void labelled(const char* label) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(
        std::max(width * kLabelShare, ImGui::CalcTextSize(label).x + ImGui::GetStyle().ItemSpacing.x) +
        ImGui::GetStyle().WindowPadding.x);
    ImGui::SetNextItemWidth(-1);
}

bool panelHeading(const Widgets& ui, const char* label, bool openAtFirst) {
    const bool open = ImGui::CollapsingHeader(label, openAtFirst ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    ui.mark(std::string("panel ") + label);
    return open;
}

void flow(float width) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    if (ImGui::GetItemRectMax().x + gap + width < right) ImGui::SameLine();
}

void dimmedText(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

}
