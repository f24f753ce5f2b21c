#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/scene/generate.h"
#include "core/scene/gltf_import.h"

namespace eyeray {

namespace {

constexpr int kMostTriangles = static_cast<int>(limits::kTriangles);
constexpr int kMostSeed = std::numeric_limits<int>::max();

void reserve(GltfImport& context, std::int64_t triangles, const std::string& where) {
    constexpr std::size_t kBytes =
        sizeof(Vec3) + (2 * sizeof(Vec3) + sizeof(Vec2)) / 2; // two triangles a vertex
    const auto count = static_cast<std::size_t>(triangles);
    context.reserve(count, count * kBytes, where);
}

void addMesh(GltfImport& context, TriangleMesh mesh, Object object) {
    object.geometry = MeshId{static_cast<int>(context.scene.meshes.size())};
    context.scene.meshes.push_back({object.name, std::make_shared<const TriangleMesh>(std::move(mesh))});
    context.add(std::move(object));
}

/// One sphere shape serves all balls.
void addBalls(GltfImport& context, const std::vector<Ball>& balls, const std::vector<int>& materials,
              const Object& prototype) {
    const ShapeId sphere{static_cast<int>(context.scene.shapes.size())};
    context.scene.shapes.push_back(Sphere{1});
    for (const Ball& ball : balls) {
        Object object = prototype;
        object.name = fmt::format("{} {}", prototype.name, &ball - balls.data());
        object.geometry = sphere;
        object.transform = glm::scale(glm::translate(prototype.transform, ball.center), DVec3(ball.radius));
        if (!materials.empty())
            object.material = materials[static_cast<std::size_t>(ball.turn) % materials.size()];
        context.add(std::move(object));
    }
}

TerrainRule readTerrain(GltfFields& fields) {
    TerrainRule rule;
    rule.size = fields.number("size", rule.size, kPositive);
    rule.height = fields.number("height", rule.height, kNotNegative);
    rule.triangles = fields.whole("triangles", static_cast<int>(rule.triangles), 1, kMostTriangles);
    rule.seed = static_cast<std::uint32_t>(fields.whole("seed", static_cast<int>(rule.seed), 0, kMostSeed));
    return rule;
}

KnotRule readKnot(GltfFields& fields) {
    constexpr int kMostWindings = 100;
    KnotRule rule;
    rule.p = fields.whole("p", rule.p, 1, kMostWindings);
    rule.q = fields.whole("q", rule.q, 1, kMostWindings);
    if (std::gcd(rule.p, rule.q) != 1) fields.refuse("p and q have a common divisor, which makes no knot");
    rule.radius = fields.number("radius", rule.radius, kPositive);
    rule.tube = fields.number("tube", rule.tube, kPositive);
    rule.triangles = fields.whole("triangles", static_cast<int>(rule.triangles), 1, kMostTriangles);
    return rule;
}

SpiralRule readSpiral(GltfFields& fields) {
    SpiralRule rule;
    rule.count = fields.whole("count", rule.count, 1, static_cast<int>(limits::kObjects));
    rule.radius = fields.number("radius", rule.radius, kPositive);
    rule.spread = fields.number("spread", rule.spread, kPositive);
    rule.seed = static_cast<std::uint32_t>(fields.whole("seed", static_cast<int>(rule.seed), 0, kMostSeed));
    return rule;
}

FlakeRule readFlake(GltfFields& fields) {
    constexpr int kMostLevels = 6; // 597,871 balls
    FlakeRule rule;
    rule.radius = fields.number("radius", rule.radius, kPositive);
    rule.levels = fields.whole("levels", rule.levels, 0, kMostLevels);
    return rule;
}

}

void importGenerated(GltfImport& context, GltfFields& rule, const Object& prototype) {
    const std::string type = rule.text("type", "");
    if (type == "terrain") {
        const TerrainRule terrain = readTerrain(rule);
        reserve(context, terrain.triangles, rule.where());
        addMesh(context, makeTerrain(terrain), prototype);
    } else if (type == "knot") {
        const KnotRule knot = readKnot(rule);
        reserve(context, knot.triangles, rule.where());
        addMesh(context, makeKnot(knot), prototype);
    } else if (type == "spheres") {
        const auto materials = rule.indices("materials", context.scene.materials.size());
        addBalls(context, makeSpiral(readSpiral(rule)), materials, prototype);
    } else if (type == "flake") {
        addBalls(context, makeFlake(readFlake(rule)), {}, prototype);
    } else {
        rule.refuse("type is none of terrain, knot, spheres and flake");
    }
    rule.reportUnread();
}

}
