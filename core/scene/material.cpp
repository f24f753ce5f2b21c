#include "core/scene/material.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/exponential.hpp>

namespace eyeray {

namespace {

float dielectricF0(float ior) {
    const float r = (ior - 1) / (ior + 1);
    return r * r;
}

Color attenuationPerMetre(const GltfMaterial& m) {
    constexpr float kDarkest = 1e-6F; // else one black channel would make σ infinite
    if (!(m.attenuationDistance < kInfinity)) return Color(0);
    return -glm::log(glm::max(m.attenuationColor, Color(kDarkest))) / m.attenuationDistance;
}

/// The Blinn-Phong exponent of the same highlight: a Phong lobe is as wide as one of four times its exponent.
/// Fisher, Woo 1994, "R.E versus N.H Specular Highlights", Graphics Gems IV.
float blinnPhongExponent(const TaughtMaterial& m) {
    return m.specularModel == SpecularModel::Phong ? 4 * m.shininess : m.shininess;
}

}

Vec2 TextureRef::transformed(const Vec2& uv) const {
    // v points down, so a counter-clockwise turn takes (1, 0) towards (0, −1). The listing in the extension's
    // text turns the other way; its test model and all known viewers do this.
    const float c = std::cos(rotation), s = std::sin(rotation);
    const Vec2 scaled = scale * uv;
    return {offset.x + c * scaled.x + s * scaled.y, offset.y - s * scaled.x + c * scaled.y};
}

TaughtMaterial asTaught(const GltfMaterial& m) {
    const Color dielectric = glm::min(dielectricF0(m.ior) * m.specular * m.specularColor, Color(1));
    const Color f0 = glm::mix(dielectric, m.baseColor, m.metallic);
    const Color body = m.baseColor * (1 - m.metallic);
    const float alpha = m.roughness * m.roughness;
    const float exponent = std::min(2 / std::max(alpha * alpha, 1e-6F) - 2, kMaxShininess);
    const float sharpness = (1 - m.roughness) * (1 - m.roughness);

    TaughtMaterial taught;
    taught.diffuse = body * (1 - m.transmission);
    taught.ambient = taught.diffuse;
    taught.specular = f0 * ((exponent + 8) / 8);
    taught.shininess = exponent;
    taught.specularModel = SpecularModel::BlinnPhong;
    taught.reflectivity = f0 * sharpness * (1 - (1 - m.metallic) * m.transmission);
    taught.transmission = body * m.transmission;
    taught.ior = m.ior;
    taught.attenuation = attenuationPerMetre(m);
    taught.emission = m.emissive * m.emissiveStrength;
    return taught;
}

GltfMaterial asPhysical(const TaughtMaterial& m) {
    const bool transmits = !isBlack(m.transmission), mirrors = !isBlack(m.reflectivity);
    const float exponent = blinnPhongExponent(m);

    GltfMaterial physical;
    physical.metallic = 0;
    physical.roughness = transmits || mirrors ? 0 : std::pow(2 / (exponent + 2), 0.25F);
    if (transmits) {
        physical.baseColor = glm::min(m.diffuse + m.transmission, Color(1));
        const float through = maxComponent(m.transmission);
        physical.transmission = through / (through + maxComponent(m.diffuse));
        physical.ior = m.ior;
        physical.thickness = 1;
        if (!isBlack(m.attenuation)) {
            physical.attenuationDistance = 1;
            physical.attenuationColor = glm::exp(-m.attenuation);
        }
    } else if (mirrors && isBlack(m.diffuse)) {
        physical.baseColor = m.reflectivity;
        physical.metallic = 1;
    } else {
        const Color f0 = mirrors ? m.reflectivity : m.specular * (8 / (exponent + 8));
        physical.baseColor = m.diffuse;
        physical.specularColor = glm::min(f0, Color(1)) / dielectricF0(physical.ior);
    }
    physical.emissiveStrength = std::max(1.0F, maxComponent(m.emission));
    physical.emissive = m.emission / physical.emissiveStrength;
    return physical;
}

}
