// labels: unit robustness
// What is told on load of geometry that no tracer can show right (stability F17, F18).

#include <filesystem>

#include <gtest/gtest.h>

#include "core/scene/geometry_notes.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

std::vector<std::string> doubts(const Scene& scene) {
    ImportReport report;
    GltfNotes notes(report);
    noteGeometry(scene, notes, {});
    std::vector<std::string> texts;
    for (const auto& line : report.lines)
        if (line.kind == ImportReport::Kind::Doubtful) texts.push_back(line.text);
    return texts;
}

const TaughtMaterial kRed = matte(Color(1, 0, 0)), kBlue = matte(Color(0, 0, 1));
const DMat4 kTurned = glm::rotate(DMat4(1), 0.7, glm::normalize(DVec3(1, 2, 3)));

TEST(SharedPlaces, OfTwoSheetsAreTold) {
    for (const DMat4& turn : {DMat4(1), kTurned}) {
        Scene scene = underSky(Color(1));
        add(scene, Plane{2, 2}, kRed, turn);
        add(scene, Plane{1, 3}, kBlue, turn);
        scene.objects[0].name = "red sheet";
        scene.objects[1].name = "blue sheet";
        const auto texts = doubts(scene);
        ASSERT_EQ(texts.size(), 1U);
        EXPECT_NE(texts[0].find("red sheet and blue sheet"), std::string::npos) << texts[0];
    }
}

TEST(SharedPlaces, OfBlocksWhoseSidesAreFlushAreTold) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{1, 1, 1}}, kRed, kTurned);
    add(scene, Box{{0.5F, 1, 0.5F}}, kBlue, kTurned);
    EXPECT_EQ(doubts(scene).size(), 1U);
}

TEST(SharedPlaces, ThatNobodySeesAreNotTold) {
    Scene scene = underSky(Color(1));
    add(scene, Plane{9, 9}, kRed);
    add(scene, Box{{1, 1, 1}}, kBlue, at({0, 0.5, 0}));           // stands on it
    add(scene, Box{{1, 1, 1}}, matte(Color(1)), at({1, 0.5, 0})); // beside the other
    add(scene, Sphere{0.5}, kBlue, at({-2, 0.5, 0}));
    EXPECT_TRUE(doubts(scene).empty());
}

TEST(SharedPlaces, OfMeshesAreToldAndAGapEndsIt) {
    for (const double gap : {0.0, 1e-4}) {
        Scene scene = underSky(Color(1));
        add(scene, cases::closedMesh(12, 16, 1), kRed);
        add(scene, cases::closedMesh(12, 16, 1), kBlue, glm::scale(DMat4(1), DVec3(1 + gap)));
        EXPECT_EQ(doubts(scene).size(), gap > 0 ? 0U : 1U) << gap;
    }
}

TEST(OpenGlass, IsToldWithTheNumberOfItsEdges) {
    Scene scene = underSky(Color(1));
    TriangleMesh mesh = cases::closedMesh(8, 12, 1);
    add(scene, mesh, glass(1.5F));
    EXPECT_TRUE(doubts(scene).empty()) << "closed";
    mesh.triangles.pop_back();
    add(scene, mesh, glass(1.5F), at({5, 0, 0}));
    add(scene, mesh, kRed, at({9, 0, 0}));
    const auto texts = doubts(scene);
    ASSERT_EQ(texts.size(), 1U) << "of what is not transparent it does not matter";
    EXPECT_NE(texts[0].find(" 3 of its edges"), std::string::npos) << texts[0];
}

// A vertex amid a neighbour's edge: the two halves of that edge and the whole.
TEST(OpenGlass, HasAGapWhereAVertexLiesOnAnEdge) {
    TriangleMesh mesh = cases::closedMesh(8, 12, 1);
    const auto [a, b, c] = mesh.triangles.back();
    mesh.positions.push_back(0.5F * (mesh.positions[a] + mesh.positions[b]));
    const auto middle = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    mesh.triangles.back() = {a, middle, c};
    mesh.triangles.push_back({middle, b, c});
    Scene scene = underSky(Color(1));
    add(scene, mesh, glass(1.5F));
    const auto texts = doubts(scene);
    ASSERT_EQ(texts.size(), 1U);
    EXPECT_NE(texts[0].find(" 3 of its edges"), std::string::npos) << texts[0];
}

// Vertices that a file parts at a seam are one place.
TEST(OpenGlass, IsNotWhatHasItsVerticesTwice) {
    const TriangleMesh mesh = cases::closedMesh(8, 12, 1);
    TriangleMesh parted;
    for (const auto& triangle : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(parted.positions.size());
        for (const std::uint32_t vertex : triangle) parted.positions.push_back(mesh.positions[vertex]);
        parted.triangles.push_back({first, first + 1, first + 2});
    }
    Scene scene = underSky(Color(1));
    add(scene, parted, glass(1.5F));
    EXPECT_TRUE(doubts(scene).empty());
}

TEST(BuiltInScenes, LeaveNoDoubt) {
    for (const auto& file : std::filesystem::directory_iterator(EYERAY_SOURCE_DIR "/assets/scenes")) {
        ImportReport report;
        importGltf(file.path(), report);
        for (const auto& line : report.lines)
            EXPECT_NE(line.kind, ImportReport::Kind::Doubtful) << file.path() << ": " << line.text;
    }
}

}
}
