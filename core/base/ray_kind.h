#pragma once
// The kinds of rays that the lectures name; everything that is counted, coloured or switched is per kind.

#include <array>
#include <cstdint>
#include <string_view>

namespace eyeray {

enum class RayKind : std::uint8_t { Eye, Shadow, Reflection, Refraction, Diffuse };

inline constexpr int kRayKinds = 5;
inline constexpr std::array<std::string_view, kRayKinds> kRayKindNames = {"eye", "shadow", "reflection",
                                                                          "refraction", "diffuse"};

constexpr std::string_view name(RayKind kind) { return kRayKindNames[static_cast<std::size_t>(kind)]; }

}
