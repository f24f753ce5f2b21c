// How the events of a GLFW window become ours.
#include <cctype>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/platform/glfw_platform.h"

namespace eyeray {
namespace {

static_assert(kKeyUp == GLFW_KEY_UP && kKeyEnd == GLFW_KEY_END && kKeyPause == GLFW_KEY_PAUSE);
static_assert(kKeyF25 == GLFW_KEY_F25 && kKeyPadEnter == GLFW_KEY_KP_ENTER && kKeyMenu == GLFW_KEY_MENU);

/// GLFW names a key by its place on a US keyboard; a person means the letter printed on it, so that Ctrl+Z is
/// where a German keyboard has its Z.
int printedKey(int key, int scancode) {
    const char* const name = glfwGetKeyName(key, scancode);
    if (!name || name[0] == '\0' || name[1] != '\0') return key;
    const auto letter = std::toupper(static_cast<unsigned char>(name[0]));
    return letter >= 'A' && letter <= 'Z' ? letter : key;
}

std::string utf8(unsigned int character) {
    const auto byte = [](unsigned int bits) { return static_cast<char>(bits); };
    const auto next = [&](int shift) { return byte(0x80 | ((character >> shift) & 0x3f)); };
    if (character < 0x80) return {byte(character)};
    if (character < 0x800) return {byte(0xc0 | (character >> 6)), next(0)};
    if (character < 0x10000) return {byte(0xe0 | (character >> 12)), next(6), next(0)};
    return {byte(0xf0 | (character >> 18)), next(12), next(6), next(0)};
}

GlfwPlatform& platform(GLFWwindow* window) {
    return *static_cast<GlfwPlatform*>(glfwGetWindowUserPointer(window));
}

}

void GlfwPlatform::listen() {
    GLFWwindow* const w = window_.get();
    glfwSetWindowUserPointer(w, this);
    glfwSetCursorPosCallback(w, [](GLFWwindow* window, double x, double y) {
        int width = 1; // in the desktop's units, which are not pixels everywhere
        glfwGetWindowSize(window, &width, nullptr);
        GlfwPlatform& self = platform(window);
        const double pixels = static_cast<double>(self.framebufferSize().width) / std::max(width, 1);
        self.input_.push(MouseMoved{static_cast<float>(x * pixels), static_cast<float>(y * pixels)});
    });
    glfwSetCursorEnterCallback(w, [](GLFWwindow* window, int entered) {
        if (!entered) platform(window).input_.push(MouseLeft{});
    });
    glfwSetMouseButtonCallback(w, [](GLFWwindow* window, int button, int action, int) {
        if (button < ImGuiMouseButton_COUNT)
            platform(window).input_.push(MouseButton{button, action == GLFW_PRESS});
    });
    glfwSetScrollCallback(w, [](GLFWwindow* window, double x, double y) {
        platform(window).input_.push(WheelTurned{static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetKeyCallback(w, [](GLFWwindow* window, int key, int scancode, int action, int) {
        if (key != GLFW_KEY_UNKNOWN && action != GLFW_REPEAT) // ImGui repeats keys itself
            platform(window).input_.push(KeyChanged{printedKey(key, scancode), action == GLFW_PRESS});
    });
    glfwSetCharCallback(w, [](GLFWwindow* window, unsigned int character) {
        platform(window).input_.push(TextTyped{utf8(character)});
    });
    glfwSetWindowFocusCallback(
        w, [](GLFWwindow*, int focused) { ImGui::GetIO().AddFocusEvent(focused == GLFW_TRUE); });
    glfwSetWindowSizeCallback(w, [](GLFWwindow* window, int width, int height) {
        if (!glfwGetWindowAttrib(window, GLFW_MAXIMIZED) && !platform(window).fullscreen())
            platform(window).restored_ = {width, height, false};
    });
    glfwSetDropCallback(w, [](GLFWwindow* window, int count, const char** paths) {
        platform(window).dropped_.insert(platform(window).dropped_.end(), paths, paths + count);
    });
}

}
