#pragma once
// Materials as taught and as glTF says; a file keeps its own kind.

#include <string>
#include <variant>

#include "core/base/math.h"

namespace eyeray {

/// Which texture, read where: uv' = translation · rotation · scale · uv as in KHR_texture_transform.
struct TextureRef {
    int texture = -1; // none
    int uvSet = 0;
    Vec2 offset{0}, scale{1};
    float rotation = 0; // radians, counter-clockwise

    bool used() const { return texture >= 0; }
    Vec2 transformed(const Vec2& uv) const;
};

enum class SpecularModel : std::uint8_t { Phong, BlinnPhong };

/// The lectures' material. With kt > 0 it is a dielectric: with constant weights kr reflects and kt refracts,
/// as on the slides; exact Fresnel divides kr + kt anew at each angle.
struct TaughtMaterial {
    Color ambient{0.2F};       // ka, times the scene's ambient light
    Color diffuse{0.8F};       // kd
    TextureRef diffuseTexture; // multiplies ka and kd
    Color specular{0};         // ks
    float shininess = 32;      // exponent
    SpecularModel specularModel = SpecularModel::Phong;
    Color reflectivity{0}; // kr
    Color transmission{0}; // kt
    float ior = 1.5F;      // η
    Color attenuation{0};  // σ per metre in the medium: T = e^(−σd)
    Color emission{0};     // radiance
};

/// Metallic-roughness with its extensions. Colours are linear.
struct GltfMaterial {
    Color baseColor{1};
    TextureRef baseColorTexture; // sRGB
    float metallic = 1, roughness = 1;
    TextureRef metallicRoughnessTexture; // B metallic, G roughness
    Color emissive{0};                   // times emissiveStrength: radiance
    float emissiveStrength = 1;          // KHR_materials_emissive_strength
    TextureRef emissiveTexture;          // sRGB
    float transmission = 0;              // KHR_materials_transmission
    TextureRef transmissionTexture;      // R
    float ior = 1.5F;                    // KHR_materials_ior
    float specular = 1;                  // KHR_materials_specular
    Color specularColor{1};
    float thickness = 0; // KHR_materials_volume; solids are traced, so it only says "not thin"
    float attenuationDistance = kInfinity;
    Color attenuationColor{1};
};

using MaterialModel = std::variant<TaughtMaterial, GltfMaterial>;

struct Material {
    std::string name;
    MaterialModel model;
};

/// A taught material that looks like a glTF one (textures are left to the caller):
/// F0 = mix(dielectric F0 of ior and specular, baseColor, metallic); kd = baseColor·(1 − metallic)·(1 −
/// transmission); kt = baseColor·(1 − metallic)·transmission; σ = −ln(attenuationColor)/attenuationDistance.
/// A rough surface has no mirror image, so kr = F0·(1 − roughness)²·(1 − (1 − metallic)·transmission) (the
/// transmitted share has a Fresnel reflection of its own), and its highlight is the normalised Blinn-Phong
/// lobe with exponent n = 2/α² − 2, α = roughness², at most kMaxShininess (a point lamp has no width). B.
/// Walter et al. 2007, "Microfacet Models for Refraction", section 5.2, for Blinn-Phong against roughness;
/// Akenine-Möller et al. 2018, "Real-Time Rendering" 4th ed., section 9.8, for the factor (n + 8)/8.
TaughtMaterial asTaught(const GltfMaterial&);

/// A glTF material that looks like a taught one (textures are left to the caller): base colour kd, or kr with
/// metallic 1 for a mirror without diffuse part, or kd + kt for glass. Roughness comes from the shininess by
/// the inverse of the above; it is 0 where light is mirrored or transmitted, for that is always sharp in the
/// lectures. What a diffuse material mirrors, kr or the highlight's ks·8/(n + 8), becomes its specular
/// colour.
GltfMaterial asPhysical(const TaughtMaterial&);

inline constexpr float kMaxShininess = 1024;

}
