#include "app/platform/headless_platform.h"

#include <array>

#include <GL/osmesa.h>

#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr float kFrameSeconds = 1.0F / 60.0F;

void* getProc(const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }

}

HeadlessPlatform::Context::Context() {
    constexpr std::array kAttributes = {OSMESA_FORMAT,
                                        OSMESA_RGBA,
                                        OSMESA_PROFILE,
                                        OSMESA_CORE_PROFILE,
                                        OSMESA_CONTEXT_MAJOR_VERSION,
                                        3,
                                        OSMESA_CONTEXT_MINOR_VERSION,
                                        3,
                                        0};
    context_ = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
    if (context_ && OSMesaMakeCurrent(context_, &pixel_, GL_UNSIGNED_BYTE, 1, 1)) return;
    if (context_) OSMesaDestroyContext(context_);
    throw Failure{"OSMesa", "gives no OpenGL 3.3 core", "install libosmesa6 22.3 or later"};
}

HeadlessPlatform::Context::~Context() { OSMesaDestroyContext(context_); }

HeadlessPlatform::HeadlessPlatform(int width, int height, float contentScale)
    : size_{width, height}, contentScale_(contentScale), gl_(getProc), ui_(gl_) {}

void HeadlessPlatform::chord(const KeyChord& chord) {
    const auto modifiers = [&](bool down) {
        if (chord.ctrl) key(kKeyLeftCtrl, down);
        if (chord.shift) key(kKeyLeftShift, down);
        if (chord.alt) key(kKeyLeftAlt, down);
    };
    modifiers(true);
    key(chord.key, true);
    key(chord.key, false);
    modifiers(false);
}

void HeadlessPlatform::beginFrame() {
    input_.feed(ImGui::GetIO(), 1);
    ui_.beginFrame(size_.width, size_.height, scale(), kFrameSeconds);
}

}
