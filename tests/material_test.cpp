// labels: unit
#include "core/scene/material.h"

#include <gtest/gtest.h>

namespace eyeray {
namespace {

void expectNear(const Color& a, const Color& b, float tolerance = 1e-6F) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(TextureRef, ScalesThenTurnsThenMoves) {
    TextureRef ref;
    ref.offset = {0.25F, 0.5F};
    ref.scale = {2, 3};
    const Vec2 moved = ref.transformed({0.1F, 0.2F});
    EXPECT_FLOAT_EQ(moved.x, 0.45F);
    EXPECT_FLOAT_EQ(moved.y, 1.1F);
    ref.rotation = kPi / 2; // counter-clockwise where v points down: +u goes to −v
    const Vec2 turned = ref.transformed({0.1F, 0});
    EXPECT_NEAR(turned.x, 0.25F, 1e-6F);
    EXPECT_NEAR(turned.y, 0.3F, 1e-6F);
}

TEST(TextureRef, TheExampleOfTheExtensionShowsTheLowerLeftQuarter) {
    TextureRef ref; // KHR_texture_transform: offset (0, 1), rotation π/2, scale 1/2
    ref.offset = {0, 1};
    ref.scale = {0.5F, 0.5F};
    ref.rotation = kPi / 2;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
        const Vec2 uv = ref.transformed(corner);
        EXPECT_GE(uv.x, -1e-6F);
        EXPECT_LE(uv.x, 0.5F + 1e-6F);
        EXPECT_GE(uv.y, 0.5F - 1e-6F);
        EXPECT_LE(uv.y, 1 + 1e-6F);
    }
}

TEST(AsTaught, ADiffuseDielectricKeepsItsColourAndReflectsFourPercent) {
    GltfMaterial plastic;
    plastic.baseColor = {0.8F, 0.4F, 0.2F};
    plastic.metallic = 0;
    plastic.roughness = 0;
    const TaughtMaterial taught = asTaught(plastic);
    expectNear(taught.diffuse, plastic.baseColor);
    expectNear(taught.reflectivity, Color(0.04F));
    EXPECT_TRUE(isBlack(taught.transmission));
}

TEST(AsTaught, APolishedMetalMirrorsItsColourAndARoughOneDoesNot) {
    GltfMaterial gold;
    gold.baseColor = {1, 0.77F, 0.34F};
    gold.roughness = 0;
    expectNear(asTaught(gold).reflectivity, gold.baseColor);
    EXPECT_TRUE(isBlack(asTaught(gold).diffuse));
    EXPECT_FLOAT_EQ(asTaught(gold).shininess, kMaxShininess);
    gold.roughness = 1;
    EXPECT_TRUE(isBlack(asTaught(gold).reflectivity));
    EXPECT_NEAR(asTaught(gold).shininess, 0, 1e-5);
}

TEST(AsTaught, TheHighlightOfAMetalKeepsTheEnergyOfItsColour) {
    // ∫ (n + 8)/(8π) cosⁿh·cosθ dω for light along the normal: h is at θ/2. Midpoint rule over θ.
    for (const float roughness : {0.4F, 0.6F, 0.8F}) {
        GltfMaterial metal;
        metal.roughness = roughness;
        const TaughtMaterial taught = asTaught(metal);
        double energy = 0;
        constexpr int kSteps = 20'000;
        for (int i = 0; i < kSteps; ++i) {
            const double theta = (i + 0.5) / kSteps * kPiD / 2;
            const double lobe = std::pow(std::cos(theta / 2), static_cast<double>(taught.shininess));
            energy += 2 * lobe * std::cos(theta) * std::sin(theta) * (kPiD / 2 / kSteps);
        }
        EXPECT_NEAR(energy * static_cast<double>(taught.specular.x), 1, 0.1) << "roughness " << roughness;
    }
}

TEST(AsTaught, AbsorptionGivesTheColourAtItsDistance) {
    GltfMaterial glass;
    glass.metallic = 0;
    glass.transmission = 1;
    glass.attenuationDistance = 0.5F;
    glass.attenuationColor = {0.25F, 0.5F, 1};
    const TaughtMaterial taught = asTaught(glass);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(std::exp(-taught.attenuation[c] * 0.5F), glass.attenuationColor[c], 1e-6F);
    expectNear(taught.transmission, Color(1));
    expectNear(taught.reflectivity, Color(0)); // glass reflects by Fresnel, not by a constant
}

TEST(AsTaught, BlackAbsorptionStaysFinite) {
    GltfMaterial ink;
    ink.attenuationDistance = 1e-3F;
    ink.attenuationColor = Color(0);
    EXPECT_TRUE(isFinite(asTaught(ink).attenuation));
}

TEST(AsTaught, AnIndexOfOneReflectsNothing) {
    GltfMaterial air;
    air.metallic = 0;
    air.ior = 1;
    air.transmission = 1;
    EXPECT_TRUE(isBlack(asTaught(air).reflectivity));
    EXPECT_TRUE(isBlack(asTaught(air).specular));
}

TEST(AsPhysical, AMirrorWithoutDiffusePartIsASmoothMetal) {
    TaughtMaterial mirror;
    mirror.diffuse = Color(0);
    mirror.reflectivity = {0.9F, 0.8F, 0.7F};
    const GltfMaterial physical = asPhysical(mirror);
    expectNear(physical.baseColor, mirror.reflectivity);
    EXPECT_EQ(physical.metallic, 1);
    EXPECT_EQ(physical.roughness, 0);
}

TEST(AsPhysical, GlassComesBackAsTheSameGlass) {
    TaughtMaterial glass;
    glass.diffuse = Color(0);
    glass.transmission = {0.9F, 1, 0.95F};
    glass.ior = 1.49F;
    glass.attenuation = {2, 0.5F, 0.1F};
    const TaughtMaterial back = asTaught(asPhysical(glass));
    expectNear(back.transmission, glass.transmission);
    expectNear(back.attenuation, glass.attenuation, 1e-5F);
    expectNear(back.diffuse, Color(0));
    EXPECT_EQ(back.ior, glass.ior);
}

TEST(AsPhysical, AGlossySurfaceKeepsItsColourAndItsHighlight) {
    TaughtMaterial paint;
    paint.diffuse = {0.7F, 0.1F, 0.1F};
    paint.specular = Color(0.5F);
    paint.shininess = 50;
    paint.specularModel = SpecularModel::BlinnPhong;
    const TaughtMaterial back = asTaught(asPhysical(paint));
    expectNear(back.diffuse, paint.diffuse);
    expectNear(back.specular, paint.specular, 1e-4F);
    EXPECT_NEAR(back.shininess, 50, 1e-2);
    paint.specularModel = SpecularModel::Phong; // a Phong lobe is that of four times its exponent
    EXPECT_NEAR(asTaught(asPhysical(paint)).shininess, 200, 0.1);
}

TEST(AsPhysical, ADiffuseMirrorKeepsItsReflectivity) {
    TaughtMaterial floor;
    floor.diffuse = Color(0.5F);
    floor.reflectivity = {0.3F, 0.2F, 0.1F};
    const TaughtMaterial back = asTaught(asPhysical(floor));
    expectNear(back.diffuse, floor.diffuse);
    expectNear(back.reflectivity, floor.reflectivity);
}

TEST(AsPhysical, EmissionKeepsItsRadiance) {
    TaughtMaterial lamp;
    lamp.emission = {12, 8, 0.5F};
    const GltfMaterial physical = asPhysical(lamp);
    EXPECT_LE(maxComponent(physical.emissive), 1); // emissiveFactor is limited to 1 in glTF
    expectNear(physical.emissive * physical.emissiveStrength, lamp.emission);
}

}
}
