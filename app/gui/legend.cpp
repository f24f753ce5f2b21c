#include "app/gui/legend.h"

namespace eyeray {

void legendPane(const Widgets& ui, const char* name, const LegendPlace& place,
                const std::function<void()>& content) {
    const float margin = 8 * ui.scale;
    ImGui::SetNextWindowPos({place.corner.x + margin, place.corner.y - margin}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowBgAlpha(0.86F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {margin, 0.75F * margin});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushTextWrapPos(place.width - 4 * margin);
    content();
    ImGui::PopTextWrapPos();
    ImGui::End();
    ImGui::PopStyleVar();
}

void swatch(const Rgba8& color, const std::string& text) {
    const float side = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side},
                                              IM_COL32(color.r, color.g, color.b, 255), side * 0.2F);
    ImGui::Dummy({side, side});
    ImGui::SameLine();
    ImGui::TextUnformatted(text.c_str());
}

}
