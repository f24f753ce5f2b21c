// labels: unit
// The words and letters that a sample is told in.

#include <algorithm>

#include <gtest/gtest.h>

#include "core/study/notation.h"
#include "core/study/ray_facts.h"
#include "core/study/ray_row.h"
#include "core/study/wording.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

/// A mirror under a lamp, seen at 60° from its normal, with a sky to mirror.
Scene tiltedMirror() {
    Scene scene = underSky(Color(0.5F));
    scene.ambient = Color(1);
    TaughtMaterial material = matte(Color(0.25F), Color(0.125F));
    material.reflectivity = Color(0.5F);
    material.specular = Color(0.25F);
    add(scene, Plane{}, material);
    scene.objects[0].name = "floor";
    scene.materials[0].name = "silver";
    scene.lights = {taughtLampAt({0, 5, 0}, Color(0.5F, 0.25F, 0.125F))};
    scene.lights[0].name = "key";
    look(scene, {0, 2, 2 * std::sqrt(3.0)}, {0, 0, 0});
    return scene;
}

struct Told {
    explicit Told(Scene told, const TraceSettings& settings = toDepth(2))
        : scene(std::move(told)), trace(Tracing(scene, settings).retrace()), ledger(ledgerOf(trace)) {}

    LedgerText in(Notation notation) const { return {ledger, trace, scene, notation}; }
    int nodeOf(Term term) const {
        return static_cast<int>(std::find_if(ledger.nodes.begin(), ledger.nodes.end(),
                                             [&](const LedgerNode& node) { return node.term == term; }) -
                                ledger.nodes.begin());
    }

    Scene scene;
    Retrace trace;
    Ledger ledger;
};

TEST(Notation, WritesTheSameSumInTheLettersOfEachDeck) {
    const Told told(tiltedMirror());
    EXPECT_EQ(told.in(Notation::DeckA).formula(0), "ka Ia + (kd (l·n) + ks (r·v)^sh) · I₁ · S₁ + kr · […]");
    EXPECT_EQ(told.in(Notation::DeckB).formula(0),
              "ambient + (diffuse + specular) · light 1 · shadow ray 1 + reflectivity · […]");
    EXPECT_EQ(told.in(Notation::Glm).formula(0),
              "ka * Ia + (kd * dot(n, l) + ks * pow(dot(reflect(-l, n), v), sh)) * light[0] * visible[0] + "
              "kr * […]");
}

TEST(Notation, KnowsBlinnsHighlightFromPhongs) {
    Scene scene = tiltedMirror();
    std::get<TaughtMaterial>(scene.materials[0].model).specularModel = SpecularModel::BlinnPhong;
    const Told told(std::move(scene));
    EXPECT_EQ(told.in(Notation::DeckA).symbol(told.nodeOf(Term::Specular)), "ks (n·h)^sh");
    EXPECT_EQ(told.in(Notation::Glm).symbol(told.nodeOf(Term::Specular)), "ks * pow(dot(n, h), sh)");
}

TEST(Notation, FillsTheNumbersIn) {
    const Told told(tiltedMirror());
    const LedgerText text = told.in(Notation::DeckA);
    EXPECT_EQ(text.numbers(told.nodeOf(Term::Ambient)), "0.125");
    EXPECT_EQ(text.numbers(told.nodeOf(Term::Irradiance)), "(0.5 0.25 0.125)");
    EXPECT_EQ(text.numbers(told.nodeOf(Term::Sent)), "0.5 · 0.5");
}

TEST(Notation, SaysWhoseATermIsAndLeavesOutWhatSaysNothing) {
    const Told told(tiltedMirror());
    const LedgerText text = told.in(Notation::DeckA);
    EXPECT_EQ(text.whose(told.nodeOf(Term::Lamp)), "key");
    EXPECT_EQ(text.whose(told.nodeOf(Term::Sent)), "reflection ray: nothing hit");
    EXPECT_TRUE(text.saysNothing(told.nodeOf(Term::Emission)));
    EXPECT_TRUE(text.saysNothing(told.nodeOf(Term::Share)));
    EXPECT_FALSE(text.saysNothing(told.nodeOf(Term::Ambient)));
    Scene blocked = tiltedMirror();
    add(blocked, Sphere{1}, matte(Color(1)), at({0, 3, 0}));
    EXPECT_EQ(Told(blocked).in(Notation::DeckA).whose(told.nodeOf(Term::Lamp)), "key, blocked");
}

TEST(Notation, LinesOfALedgerAreItsTermsWithoutTheParentheses) {
    const Told told(tiltedMirror());
    std::vector<Term> terms;
    for (const LedgerLine& line : linesBelow(told.ledger, 0)) {
        terms.push_back(told.ledger.at(line.node).term);
        EXPECT_FALSE(line.factor);
    }
    EXPECT_EQ(terms, (std::vector{Term::Emission, Term::Ambient, Term::Lamp, Term::Sent}));
    const auto lamp = linesBelow(told.ledger, told.nodeOf(Term::Lamp));
    ASSERT_EQ(lamp.size(), 4U);
    EXPECT_FALSE(lamp[0].factor) << "kd (l·n) is added to ks (r·v)^sh";
    EXPECT_TRUE(lamp[2].factor);
}

TEST(RayRow, HasTheAngleOfIncidenceTheSharesAndTheContribution) {
    const Told told(tiltedMirror());
    const Family family(told.trace);
    EXPECT_NEAR(incidenceDegrees(told.trace.rays[0]), 60, 1e-3);
    EXPECT_EQ(sharesAtHit(told.trace, family, 0).reflected, Color(0.5F));
    const RayRow eye = rayRow(told.trace, family, told.scene, DVec3(0), 0);
    const auto cell = [&](std::string_view heading) {
        const auto column = std::find(kRayHeadings.begin(), kRayHeadings.end(), heading);
        return eye[static_cast<std::size_t>(column - kRayHeadings.begin())];
    };
    EXPECT_EQ(cell("ray"), "eye #0");
    EXPECT_EQ(cell("meets"), "floor");
    EXPECT_EQ(cell("material"), "silver");
    EXPECT_EQ(cell("t"), "4 m");
    EXPECT_EQ(cell("incidence"), "60.00°");
    EXPECT_EQ(cell("kr there"), "0.5000 0.5000 0.5000");
    EXPECT_EQ(cell("kt there"), "");
    EXPECT_EQ(cell("weight"), "1.0000 1.0000 1.0000");
    const auto& mirrored = told.trace.rays.back();
    ASSERT_EQ(mirrored.kind, RayKind::Reflection);
    EXPECT_EQ(contribution(mirrored), Color(0.25F));
}

TEST(RayRow, OfARayInGlassHasEtaMediumAndTransmittance) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{4, 4, 2}}, glass(1.5F, Color(1), Color(0.5F)), at({0, 0, -5}));
    scene.objects[0].name = "slab";
    const Told told(std::move(scene));
    const Family family(told.trace);
    EXPECT_NEAR(sharesAtHit(told.trace, family, 0).reflected.r, 0.04, 1e-6) << "((n − 1)/(n + 1))²";
    EXPECT_NEAR(sharesAtHit(told.trace, family, 0).refracted.r, 0.96, 1e-6);
    const auto inside = std::find_if(told.trace.rays.begin(), told.trace.rays.end(),
                                     [](const RayRecord& ray) { return ray.medium >= 0; });
    ASSERT_NE(inside, told.trace.rays.end());
    const RayRow row =
        rayRow(told.trace, family, told.scene, DVec3(0), static_cast<int>(inside - told.trace.rays.begin()));
    EXPECT_NE(std::find(row.begin(), row.end(), "2 m in slab"), row.end());
    EXPECT_NE(std::find(row.begin(), row.end(), "0.3679 0.3679 0.3679"), row.end()) << "e^(−0.5 · 2)";
}

TEST(Wording, NamesWhatIsNotInTheSceneWithoutFailing) {
    const Scene scene = tiltedMirror();
    EXPECT_EQ(objectName(scene, 0), "floor");
    EXPECT_EQ(objectName(scene, -1), "the surface of a lamp");
    EXPECT_EQ(objectName(scene, 99), "object 99");
    EXPECT_EQ(lampName(scene, 99), "lamp 99");
    EXPECT_EQ(weightText(Color(0.27F)), "0.27");
    EXPECT_EQ(weightText(Color(0.00123F)), "0.0012");
    EXPECT_EQ(metresText(kInfinity), "∞");
}

}
}
