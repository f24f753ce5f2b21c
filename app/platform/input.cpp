#include "app/platform/input.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <utility>
#include <vector>

#include "core/base/errors.h"

namespace eyeray {
namespace {

/// Whether `next` must wait for a frame of its own when the frame already has `earlier`.
struct Conflict {
    // Only the last position of a frame counts; but a release must not hide where its drag went.
    bool operator()(const MouseMoved&, const MouseButton& next) const { return !next.down; }
    template <class Next>
    bool operator()(const MouseMoved&, const Next&) const {
        return false;
    }
    bool operator()(const MouseButton& earlier, const MouseButton& next) const {
        return earlier.button == next.button;
    }
    // Ctrl pressed after Z is no Ctrl+Z.
    bool operator()(const KeyChanged& earlier, const KeyChanged& next) const {
        return earlier.key == next.key || (isModifier(next.key) && !isModifier(earlier.key));
    }
    bool operator()(const WheelTurned&, const WheelTurned&) const { return false; }
    bool operator()(const TextTyped&, const TextTyped&) const { return false; }
    // Between different kinds the order matters: a click and then a move, a letter and then Enter.
    template <class Earlier, class Next>
    bool operator()(const Earlier&, const Next&) const {
        return true;
    }
};

bool mustWait(const InputEvent& earlier, const InputEvent& next) {
    return std::visit(Conflict{}, earlier, next);
}

struct Apply {
    ImGuiIO& io;

    void operator()(const MouseMoved& e) const { io.MousePos = {e.x, e.y}; }
    void operator()(const MouseLeft&) const { io.MousePos = {-FLT_MAX, -FLT_MAX}; }
    void operator()(const MouseButton& e) const {
        ENSURE(e.button >= 0 && e.button < IM_ARRAYSIZE(io.MouseDown));
        io.MouseDown[e.button] = e.down;
    }
    void operator()(const WheelTurned& e) const {
        io.MouseWheelH += e.x;
        io.MouseWheel += e.y;
    }
    void operator()(const KeyChanged& e) const {
        ENSURE(e.key >= 0 && e.key < IM_ARRAYSIZE(io.KeysDown));
        io.KeysDown[e.key] = e.down;
        io.KeyCtrl = io.KeysDown[kKeyLeftCtrl] || io.KeysDown[kKeyRightCtrl];
        io.KeyShift = io.KeysDown[kKeyLeftShift] || io.KeysDown[kKeyRightShift];
        io.KeyAlt = io.KeysDown[kKeyLeftAlt] || io.KeysDown[kKeyRightAlt];
        io.KeySuper = io.KeysDown[kKeyLeftSuper] || io.KeysDown[kKeyRightSuper];
    }
    void operator()(const TextTyped& e) const { io.AddInputCharactersUTF8(e.text.c_str()); }
};

}

void InputQueue::push(const InputEvent& event) { events_.push_back(event); }

void InputQueue::feed(ImGuiIO& io, std::size_t most) {
    std::vector<InputEvent> frame;
    while (!events_.empty() && frame.size() < most) {
        const InputEvent& next = events_.front();
        if (std::ranges::any_of(frame, [&](const InputEvent& earlier) { return mustWait(earlier, next); }))
            break;
        std::visit(Apply{io}, next);
        frame.push_back(std::move(events_.front()));
        events_.pop_front();
    }
}

void nameKeys(ImGuiIO& io) {
    constexpr std::array<std::pair<ImGuiKey, int>, ImGuiKey_COUNT> kMap = {{
        {ImGuiKey_Tab, kKeyTab},
        {ImGuiKey_LeftArrow, kKeyLeft},
        {ImGuiKey_RightArrow, kKeyRight},
        {ImGuiKey_UpArrow, kKeyUp},
        {ImGuiKey_DownArrow, kKeyDown},
        {ImGuiKey_PageUp, kKeyPageUp},
        {ImGuiKey_PageDown, kKeyPageDown},
        {ImGuiKey_Home, kKeyHome},
        {ImGuiKey_End, kKeyEnd},
        {ImGuiKey_Insert, kKeyInsert},
        {ImGuiKey_Delete, kKeyDelete},
        {ImGuiKey_Backspace, kKeyBackspace},
        {ImGuiKey_Space, kKeySpace},
        {ImGuiKey_Enter, kKeyEnter},
        {ImGuiKey_Escape, kKeyEscape},
        {ImGuiKey_KeyPadEnter, kKeyPadEnter},
        {ImGuiKey_A, 'A'},
        {ImGuiKey_C, 'C'},
        {ImGuiKey_V, 'V'},
        {ImGuiKey_X, 'X'},
        {ImGuiKey_Y, 'Y'},
        {ImGuiKey_Z, 'Z'},
    }};
    for (const auto& [theirs, ours] : kMap) io.KeyMap[theirs] = ours;
}

bool pressed(const KeyChord& chord, bool repeat) {
    const ImGuiIO& io = ImGui::GetIO();
    return io.KeyCtrl == chord.ctrl && io.KeyShift == chord.shift && io.KeyAlt == chord.alt &&
           ImGui::IsKeyPressed(chord.key, repeat);
}

}
