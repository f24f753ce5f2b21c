// labels: unit
// The built-in scenes keep what assets/README.md and the lectures promise of them.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "core/scene/gltf.h"

namespace eyeray {
namespace {

const std::filesystem::path kAssets = std::filesystem::path(EYERAY_SOURCE_DIR) / "assets";

std::vector<std::filesystem::path> sceneFiles() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(kAssets / "scenes"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string textOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Scene sceneNamed(const std::string& name) {
    ImportReport report;
    return importGltf(kAssets / "scenes" / (name + ".gltf"), report);
}

const TaughtMaterial& taughtMaterial(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                    [&](const Material& m) { return m.name == name; });
    return std::get<TaughtMaterial>(found->model);
}

class BuiltInScene : public testing::TestWithParam<std::filesystem::path> {
protected:
    ImportReport report;
    const Scene scene = importGltf(GetParam(), report);
};

TEST_P(BuiltInScene, ImportsWithNothingIgnoredRepairedOrAdded) {
    for (const auto& line : report.lines) ADD_FAILURE() << line.text;
}

TEST_P(BuiltInScene, IsNamedAfterItsFile) { EXPECT_EQ(scene.name, GetParam().stem().string()); }

TEST_P(BuiltInScene, SaysInOneShortLineWhatToLookAt) {
    EXPECT_FALSE(scene.whatToLookAt.empty());
    EXPECT_LE(scene.whatToLookAt.size(), 120U);
    EXPECT_EQ(scene.whatToLookAt.find('\n'), std::string::npos);
}

TEST_P(BuiltInScene, StatesItsMethodDepthAndExposure) {
    ASSERT_EQ(scene.settings.size(), 1U);
    for (const auto* part : {"set method=", " max-depth=", " cutoff=", " exposure=", " tonemap=", " aspect="})
        EXPECT_NE(scene.settings[0].find(part), std::string::npos) << part;
    EXPECT_TRUE(scene.statesExposure);
}

TEST_P(BuiltInScene, GivesEveryCameraLampObjectAndMaterialAName) {
    const auto named = [](const auto& things) {
        return !things.empty() && std::all_of(things.begin(), things.end(),
                                              [](const auto& thing) { return !thing.name.empty(); });
    };
    EXPECT_TRUE(named(scene.cameras));
    EXPECT_TRUE(named(scene.lights));
    EXPECT_TRUE(named(scene.objects));
    EXPECT_TRUE(named(scene.materials));
}

TEST_P(BuiltInScene, GivesNoTwoCamerasLampsOrMaterialsTheSameName) {
    const auto distinct = [](const auto& things) {
        std::set<std::string> names;
        for (const auto& thing : things) names.insert(thing.name);
        return names.size() == things.size();
    };
    EXPECT_TRUE(distinct(scene.cameras));
    EXPECT_TRUE(distinct(scene.lights));
    EXPECT_TRUE(distinct(scene.materials));
}

TEST_P(BuiltInScene, IsSmallEnoughToRead) { EXPECT_LT(std::filesystem::file_size(GetParam()), 20'000U); }

TEST_P(BuiltInScene, StandsInTheReadmeWithItsLine) {
    const std::string row =
        "| [`" + scene.name + "`](scenes/" + scene.name + ".gltf) | " + scene.whatToLookAt + " |";
    EXPECT_NE(textOf(kAssets / "README.md").find(row), std::string::npos) << row;
}

INSTANTIATE_TEST_SUITE_P(Each, BuiltInScene, testing::ValuesIn(sceneFiles()),
                         [](const auto& file) { return file.param.stem().string(); });

TEST(BuiltInScenes, AreAtLeastSixteen) { EXPECT_GE(sceneFiles().size(), 16U); }

TEST(BuiltInScenes, HoldTwoMeshesOfMoreThanAHundredThousandTriangles) {
    for (const auto* name : {"terrain", "knot"}) {
        const Scene scene = sceneNamed(name);
        ASSERT_EQ(scene.meshes.size(), 1U);
        EXPECT_GE(scene.meshes[0].triangles->triangles.size(), 100'000U) << name;
    }
}

TEST(BuiltInScenes, HoldThousandsOfBalls) {
    EXPECT_GE(sceneNamed("many").objects.size(), 5000U);
    EXPECT_GE(sceneNamed("flake").objects.size(), 7381U); // 1 + 9 + 81 + 729 + 6561
}

TEST(BuiltInScenes, UseTheIndicesOfRefractionOfTheLecture) {
    const Scene scene = sceneNamed("indices");
    const std::vector<std::pair<std::string, float>> indices = {{"vacuum", 1.0F},       {"air", 1.000277F},
                                                                {"water", 1.33F},       {"glass", 1.49F},
                                                                {"crown glass", 1.52F}, {"diamond", 2.42F}};
    for (const auto& [name, index] : indices) EXPECT_EQ(taughtMaterial(scene, name).ior, index) << name;
}

TEST(BuiltInScenes, HaveAPrismWhoseSidesMeetAtSixtyDegrees) {
    const Scene scene = sceneNamed("prism");
    const TriangleMesh& prism = *scene.meshes.at(0).triangles;
    std::vector<Vec3> sides; // outward normals of the upright triangles
    for (const auto& [a, b, c] : prism.triangles) {
        const Vec3 corner = prism.positions[a];
        const Vec3 normal =
            glm::normalize(glm::cross(prism.positions[b] - corner, prism.positions[c] - corner));
        if (std::fabs(normal.y) < 0.5F) sides.push_back(normal);
    }
    ASSERT_EQ(sides.size(), 6U);
    for (const Vec3& a : sides)
        for (const Vec3& b : sides) {
            const double between =
                degrees(std::acos(std::clamp(static_cast<double>(glm::dot(a, b)), -1.0, 1.0)));
            EXPECT_TRUE(between < 0.1 || std::fabs(between - 120) < 0.01) << between; // 180° − 60°
        }
}

TEST(BuiltInScenes, LeaveNoDiffuseSurfaceBrighterThanWhiteUnderTheLecturesLamps) {
    for (const auto& file : sceneFiles()) {
        ImportReport report;
        const Scene scene = importGltf(file, report);
        Color lamps = scene.ambient; // all straight above the surface: more than any scene has
        for (const Light& light : scene.lights)
            if (light.enabled && !light.falloff) lamps += light.color * static_cast<float>(light.intensity);
        for (const Material& material : scene.materials) {
            const auto* taught = std::get_if<TaughtMaterial>(&material.model);
            if (taught == nullptr) continue;
            EXPECT_LE(maxComponent(taught->diffuse * lamps), 1.05F) << file << ": " << material.name;
        }
    }
}

}
}
