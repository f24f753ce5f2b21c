#include "app/gui/theme.h"

#include "core/study/palette.h"

namespace eyeray {
namespace {

struct Palette {
    const Ground& ground;
    std::uint32_t field, fieldHover, fieldActive, accent;
};
const Palette kDark{groundOf(true), 0x2a2e38, 0x363b48, 0x414758, 0x4c9be8};
const Palette kLight{groundOf(false), 0xe4e7ed, 0xd6dbe5, 0xc5ccda, 0x1d6fc4};

void setColors(ImVec4* colors, const Palette& p) {
    for (const int window : {ImGuiCol_WindowBg, ImGuiCol_ChildBg}) colors[window] = fromHex(p.ground.panel);
    colors[ImGuiCol_PopupBg] = fromHex(p.ground.panel, 0.98F);
    colors[ImGuiCol_MenuBarBg] = fromHex(p.ground.paper);
    colors[ImGuiCol_Text] = fromHex(p.ground.text);
    colors[ImGuiCol_TextDisabled] = fromHex(p.ground.dimmed);
    colors[ImGuiCol_Border] = colors[ImGuiCol_Separator] = fromHex(p.ground.border);
    colors[ImGuiCol_FrameBg] = colors[ImGuiCol_Button] = fromHex(p.field);
    colors[ImGuiCol_FrameBgHovered] = colors[ImGuiCol_ButtonHovered] = fromHex(p.fieldHover);
    colors[ImGuiCol_FrameBgActive] = colors[ImGuiCol_ButtonActive] = fromHex(p.fieldActive);
    colors[ImGuiCol_Header] = fromHex(p.field);
    colors[ImGuiCol_HeaderHovered] = fromHex(p.fieldHover);
    colors[ImGuiCol_HeaderActive] = fromHex(p.fieldActive);
    colors[ImGuiCol_CheckMark] = colors[ImGuiCol_SliderGrab] = colors[ImGuiCol_SliderGrabActive] =
        fromHex(p.accent);
    colors[ImGuiCol_PlotHistogram] = colors[ImGuiCol_NavHighlight] = fromHex(p.accent);
    colors[ImGuiCol_TextSelectedBg] = fromHex(p.accent, 0.35F);
    colors[ImGuiCol_ScrollbarBg] = fromHex(p.ground.panel);
    colors[ImGuiCol_ScrollbarGrab] = fromHex(p.field);
    colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = fromHex(p.ground.paper);
    colors[ImGuiCol_TableHeaderBg] = fromHex(p.ground.paper);
    colors[ImGuiCol_TableBorderStrong] = colors[ImGuiCol_TableBorderLight] = fromHex(p.ground.border);
    colors[ImGuiCol_Tab] = fromHex(p.field);
    colors[ImGuiCol_TabHovered] = fromHex(p.fieldHover);
    colors[ImGuiCol_TabActive] = fromHex(p.fieldActive);
    colors[ImGuiCol_ModalWindowDimBg] = fromHex(0x000000, 0.4F);
}

}

ImVec4 fromHex(std::uint32_t hex, float alpha) {
    return {static_cast<float>((hex >> 16) & 255) / 255, static_cast<float>((hex >> 8) & 255) / 255,
            static_cast<float>(hex & 255) / 255, alpha};
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

ImVec4 colorOf(RayKind kind, bool dark) { return fromHex(colorOfKind(kind, dark)); }

ImVec4 errorColor(bool dark) { return fromHex(dark ? 0xff8a5c : 0xb83a00); }
ImVec4 doneColor(bool dark) { return fromHex(dark ? 0x7ccf9a : 0x1b7a45); }

}
