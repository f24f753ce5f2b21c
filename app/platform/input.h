#pragma once
// What a person does with mouse and keyboard, in order, on its way to ImGui.

#include <cstddef>
#include <deque>
#include <limits>
#include <string>
#include <variant>

#include <imgui.h>

#include "app/platform/keys.h"

namespace eyeray {

struct MouseMoved {
    float x, y; // pixels of the framebuffer from its top left
};
struct MouseLeft {}; // the pointer is no more over the window
struct MouseButton {
    int button; // 0 left, 1 right, 2 middle
    bool down;
};
struct WheelTurned {
    float x, y; // notches; y > 0 away from the person
};
struct KeyChanged {
    int key;
    bool down;
};
struct TextTyped {
    std::string text; // UTF-8
};
using InputEvent = std::variant<MouseMoved, MouseLeft, MouseButton, WheelTurned, KeyChanged, TextTyped>;

/// ImGui sees the state of mouse and keys once a frame. The queue spreads events that came between two frames
/// over as many frames as it takes for each to be seen, in order: no press is lost, however short.
class InputQueue {
public:
    void push(const InputEvent& event);
    bool empty() const { return events_.empty(); }

    /// Brings the events of the next frame, `most` at most, into the state that ImGui::NewFrame reads.
    void feed(ImGuiIO& io, std::size_t most = std::numeric_limits<std::size_t>::max());

private:
    std::deque<InputEvent> events_;
};

/// Tells ImGui which of our keys are its own: arrows, Enter, Ctrl+C and so on.
void nameKeys(ImGuiIO& io);

/// Whether this chord's key went down in this frame, or repeats while held if `repeat`, with exactly its
/// modifiers.
bool pressed(const KeyChord& chord, bool repeat = false);

}
