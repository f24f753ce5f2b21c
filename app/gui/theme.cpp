#include "app/gui/theme.h"

#include <array>

namespace eyeray {
namespace {

ImVec4 rgb(int hex, float alpha = 1) {
    return {static_cast<float>((hex >> 16) & 255) / 255, static_cast<float>((hex >> 8) & 255) / 255,
            static_cast<float>(hex & 255) / 255, alpha};
}

struct Palette {
    int window, panel, field, fieldHover, fieldActive, accent, text, dimmed, border;
};
constexpr Palette kDark{0x16181d, 0x1d2027, 0x2a2e38, 0x363b48, 0x414758,
                        0x4c9be8, 0xe9ebf0, 0x969db0, 0x343945};
constexpr Palette kLight{0xf2f3f6, 0xffffff, 0xe4e7ed, 0xd6dbe5, 0xc5ccda,
                         0x1d6fc4, 0x15181e, 0x5d6577, 0xc3c9d4};

void setColors(ImVec4* colors, const Palette& p) {
    for (const int window : {ImGuiCol_WindowBg, ImGuiCol_ChildBg}) colors[window] = rgb(p.panel);
    colors[ImGuiCol_PopupBg] = rgb(p.panel, 0.98F);
    colors[ImGuiCol_MenuBarBg] = rgb(p.window);
    colors[ImGuiCol_Text] = rgb(p.text);
    colors[ImGuiCol_TextDisabled] = rgb(p.dimmed);
    colors[ImGuiCol_Border] = colors[ImGuiCol_Separator] = rgb(p.border);
    colors[ImGuiCol_FrameBg] = colors[ImGuiCol_Button] = rgb(p.field);
    colors[ImGuiCol_FrameBgHovered] = colors[ImGuiCol_ButtonHovered] = rgb(p.fieldHover);
    colors[ImGuiCol_FrameBgActive] = colors[ImGuiCol_ButtonActive] = rgb(p.fieldActive);
    colors[ImGuiCol_Header] = rgb(p.field);
    colors[ImGuiCol_HeaderHovered] = rgb(p.fieldHover);
    colors[ImGuiCol_HeaderActive] = rgb(p.fieldActive);
    colors[ImGuiCol_CheckMark] = colors[ImGuiCol_SliderGrab] = colors[ImGuiCol_SliderGrabActive] =
        rgb(p.accent);
    colors[ImGuiCol_PlotHistogram] = colors[ImGuiCol_NavHighlight] = rgb(p.accent);
    colors[ImGuiCol_TextSelectedBg] = rgb(p.accent, 0.35F);
    colors[ImGuiCol_ScrollbarBg] = rgb(p.panel);
    colors[ImGuiCol_ScrollbarGrab] = rgb(p.field);
    colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = rgb(p.window);
    colors[ImGuiCol_TableHeaderBg] = rgb(p.window);
    colors[ImGuiCol_TableBorderStrong] = colors[ImGuiCol_TableBorderLight] = rgb(p.border);
    colors[ImGuiCol_ModalWindowDimBg] = rgb(0x000000, 0.4F);
}

}

ImGuiStyle themeStyle(bool dark) {
    ImGuiStyle style;
    dark ? ImGui::StyleColorsDark(&style) : ImGui::StyleColorsLight(&style);
    setColors(style.Colors, dark ? kDark : kLight);
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.WindowRounding = 6;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = 4;
    style.WindowBorderSize = 0;
    style.ScrollbarSize = 12;
    style.GrabMinSize = 12;
    return style;
}

ImVec4 colorOf(RayKind kind, bool dark) {
    constexpr std::array kOnDark = {0xf0e442, 0xa9afbd, 0x56b4e9, 0x3fd0a0, 0xd98cc0};
    constexpr std::array kOnLight = {0x8a7d00, 0x5d6577, 0x0072b2, 0x007a58, 0xa8487f};
    return rgb((dark ? kOnDark : kOnLight)[static_cast<std::size_t>(kind)]);
}

ImVec4 errorColor(bool dark) { return rgb(dark ? 0xff8a5c : 0xb83a00); }
ImVec4 doneColor(bool dark) { return rgb(dark ? 0x7ccf9a : 0x1b7a45); }

}
