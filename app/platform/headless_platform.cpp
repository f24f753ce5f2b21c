#include "app/platform/headless_platform.h"

#include <array>

#include <GL/osmesa.h>
#include <dlfcn.h>

#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr float kFrameSeconds = 1.0F / 60.0F;
constexpr const char* kRemedy = "install libosmesa6 22.3 or later";

/// Loaded when first asked for: it brings a whole compiler with it, LLVM, whose 3,000 pages of addresses to
/// fill in would take half of every start of the program.
class OsMesa {
public:
    static const OsMesa& loaded() {
        static const OsMesa library;
        return library;
    }

    decltype(&OSMesaCreateContextAttribs) createContext;
    decltype(&OSMesaMakeCurrent) makeCurrent;
    decltype(&OSMesaDestroyContext) destroyContext;
    decltype(&OSMesaGetProcAddress) getProcAddress;

private:
    OsMesa() {
        void* library = ::dlopen("libOSMesa.so.8", RTLD_NOW);
        if (!library) throw Failure{"OSMesa", "cannot be loaded", kRemedy};
        find(library, "OSMesaCreateContextAttribs", createContext);
        find(library, "OSMesaMakeCurrent", makeCurrent);
        find(library, "OSMesaDestroyContext", destroyContext);
        find(library, "OSMesaGetProcAddress", getProcAddress);
    }
    template <class Function>
    static void find(void* library, const char* name, Function& function) {
        function = reinterpret_cast<Function>(::dlsym(library, name));
        if (!function) throw Failure{"OSMesa", std::string("has no function ") + name, kRemedy};
    }
};

void* getProc(const char* name) { return reinterpret_cast<void*>(OsMesa::loaded().getProcAddress(name)); }

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
    const OsMesa& mesa = OsMesa::loaded();
    context_ = mesa.createContext(kAttributes.data(), nullptr);
    if (context_ && mesa.makeCurrent(context_, &pixel_, GL_UNSIGNED_BYTE, 1, 1)) return;
    if (context_) mesa.destroyContext(context_);
    throw Failure{"OSMesa", "gives no OpenGL 3.3 core", kRemedy};
}

HeadlessPlatform::Context::~Context() { OsMesa::loaded().destroyContext(context_); }

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
