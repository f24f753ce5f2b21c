#pragma once
// The few widgets that panels are made of: each shows a value and turns a change into a command.

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include <imgui.h>

#include "app/viewer/viewer.h"

namespace eyeray {

/// Where a widget stands, in pixels of the window.
struct WidgetRect {
    float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// What a panel has at hand while it draws itself.
struct Widgets {
    Viewer& viewer;
    bool dark;
    float scale; // pixels for a length of 1
    std::function<bool(const Command&, const std::string& gesture)> execute;
    std::map<std::string, WidgetRect>& rectangles;

    /// Remembers where the last widget stands.
    void mark(const std::string& name) const;
    /// Shows a help text when the last widget is hovered.
    void tooltip(std::string_view text) const;
    /// Runs a command with no arguments from a button.
    bool button(const char* label, const char* command, const char* help) const;

    // Settings, by the key of settings(); the tooltip is the setting's help.
    void flag(const char* label, const char* key) const;
    void integer(const char* label, const char* key, int lowest, int highest, bool logarithmic = false) const;
    void number(const char* label, const char* key, float lowest, float highest, const char* format,
                bool logarithmic = false) const;
    void choice(const char* label, const char* key, std::span<const std::string_view> names,
                std::span<const std::string_view> labels) const;

    // Parts of the scene: `command` with its noun, such as {"light", {{"light", "2"}}}; the key is added with
    // its value.
    void part(const Command& command, const char* key, const std::string& value, bool dragged) const;
    void partColor(const Command&, const char* label, const char* key, const Color& value) const;
    void partNumber(const Command&, const char* label, const char* key, double value, double lowest,
                    double highest, const char* format, bool logarithmic = false) const;
    void partFlag(const Command&, const char* label, const char* key, bool value) const;
    void partPosition(const Command&, const char* label, const char* key, const DVec3& value) const;

private:
    void run(const Command&, const std::string& gesture) const;
};

/// Label on the left, the next widget to the right of it over the rest of the panel.
void labelled(const char* label);

/// A heading that opens and closes a panel; true if it is open.
bool panelHeading(const Widgets&, const char* label, bool openAtFirst = true);

/// Goes on in the line if a widget of this width still fits in it.
void flow(float width);

/// Text in the dimmed colour, wrapped.
void dimmedText(const std::string& text);

}
