#include "core/study/wording.h"

#include <fmt/format.h>

#include <array>

namespace eyeray {
namespace {

template <class Items>
std::string nameOf(const Items& items, int index, std::string_view noun) {
    const auto i = static_cast<std::size_t>(index);
    return i < items.size() && !items[i].name.empty() ? items[i].name : fmt::format("{} {}", noun, index);
}

}

std::string objectName(const Scene& scene, int object) {
    return object < 0 ? "the surface of a lamp" : nameOf(scene.objects, object, "object");
}

std::string lampName(const Scene& scene, int light) {
    if (light == kGlowingObjects) return "what glows";
    return light == kSkyLight ? "the sky" : nameOf(scene.lights, light, "lamp");
}

std::string meeting(const Scene& scene, const RayRecord& ray) {
    switch (ray.end) {
    case RayEnd::Hit:
        return objectName(scene, ray.object);
    case RayEnd::Background:
        return "nothing hit";
    case RayEnd::Unblocked:
        return "reaches " + lampName(scene, ray.light);
    case RayEnd::Blocked:
        return "blocked before " + lampName(scene, ray.light);
    }
    return {};
}

std::string_view name(RayEnd end) {
    constexpr std::array<std::string_view, 4> kNames = {"hit", "background", "unblocked", "blocked"};
    return kNames[static_cast<std::size_t>(end)];
}

std::string_view reasonText(UntracedRay::Reason reason) {
    switch (reason) {
    case UntracedRay::Reason::SwitchedOff:
        return "switched off";
    case UntracedRay::Reason::DepthLimit:
        return "depth limit";
    case UntracedRay::Reason::Cutoff:
        return "below the cutoff";
    case UntracedRay::Reason::TreeLimit:
        return "tree too large";
    case UntracedRay::Reason::Roulette:
        return "ended by roulette";
    }
    return {};
}

std::string weightText(const Color& weight) {
    const float w = maxComponent(weight);
    return w == 0 || w >= 0.095F ? fmt::format("{:.2f}", w) : fmt::format("{:.2g}", w);
}

std::string metresText(float t) { return std::isfinite(t) ? fmt::format("{:.4g} m", t) : "∞"; }

std::string colorText(const Color& c) { return fmt::format("{:.4f} {:.4f} {:.4f}", c.r, c.g, c.b); }

std::string amountText(const Color& c) {
    if (c.r == c.g && c.g == c.b) return fmt::format("{:.3g}", c.r);
    return fmt::format("({:.3g} {:.3g} {:.3g})", c.r, c.g, c.b);
}

std::string countText(std::uint64_t count) {
    std::string digits = fmt::format("{}", count);
    for (auto i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
        digits.insert(static_cast<std::size_t>(i), 1, ' ');
    return digits;
}

}
