// labels: unit
#include "core/scene/scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace eyeray {
namespace {

void expectNear(const DVec3& a, const DVec3& b, double tolerance = 1e-6) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

/// A valid scene with one object of the given shape.
Scene withShape(const Shape& shape, const DMat4& transform = DMat4(1)) {
    Scene scene;
    scene.shapes = {shape};
    scene.materials = {{"m", TaughtMaterial{}}};
    scene.cameras = {Camera{}};
    scene.objects = {{"o", ShapeId{0}, 0, transform, true}};
    return scene;
}

DMat4 turnedBy(double angle) { return glm::rotate(DMat4(1), angle, DVec3(0, 0, 1)); }

TEST(SceneBounds, OfATurnedBoxHoldItsCorners) {
    const SceneBounds bounds = boundsOf(withShape(Box{Vec3(2)}, turnedBy(kPiD / 4)));
    expectNear(bounds.hi, {std::sqrt(2.0), std::sqrt(2.0), 1});
    expectNear(bounds.lo, -bounds.hi);
}

TEST(SceneBounds, OfAStretchedAndTurnedSphereAreThoseOfTheEllipsoid) {
    const DMat4 m = turnedBy(kPiD / 6) * glm::scale(DMat4(1), DVec3(3, 1, 1));
    const SceneBounds bounds = boundsOf(withShape(Sphere{2}, m));
    // Support function of an ellipsoid with half axes 6 and 2: √(36 cos² + 4 sin²).
    expectNear(bounds.hi, {std::sqrt(36 * 0.75 + 4 * 0.25), std::sqrt(36 * 0.25 + 4 * 0.75), 2});
}

TEST(SceneBounds, LeaveOutInfinitePlanes) {
    Scene scene = withShape(Plane{});
    EXPECT_TRUE(boundsOf(scene).empty());
    EXPECT_EQ(boundsOf(scene).radius(), 1);
    scene.shapes.push_back(Sphere{1});
    scene.objects.push_back({"ball", ShapeId{1}, 0, glm::translate(DMat4(1), DVec3(5, 6, 7)), true});
    expectNear(boundsOf(scene).center(), {5, 6, 7});
    EXPECT_NEAR(boundsOf(scene).radius(), std::sqrt(3.0), 1e-6);
}

TEST(SceneBounds, HoldAllInstancesOfAMesh) {
    Scene scene = withShape(Plane{});
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
    mesh.triangles = {{0, 1, 2}};
    scene.meshes = {{"mesh", std::make_shared<const TriangleMesh>(mesh)}};
    for (const double x : {0.0, 10.0})
        scene.objects.push_back({"instance", MeshId{0}, 0, glm::translate(DMat4(1), DVec3(x, 0, 0)), true});
    expectNear(boundsOf(scene).lo, {0, 0, 0});
    expectNear(boundsOf(scene).hi, {11, 2, 0});
}

TEST(FramingCamera, SeesTheWholeSceneFromTheFrontAndAbove) {
    for (const double scale : {1e-3, 1.0, 1e4}) {
        const DMat4 m = glm::scale(glm::translate(DMat4(1), DVec3(3, 4, 5) * scale), DVec3(scale));
        const Camera camera = framingCamera(withShape(Box{Vec3(1, 2, 3)}, m), "framed");
        EXPECT_EQ(camera.name, "framed");
        EXPECT_GT(camera.eye.y, camera.target.y);
        EXPECT_GT(camera.eye.z, camera.target.z);
        const CameraAxes axes = axesOf(camera);
        const double half = std::tan(camera.verticalFov / 2);
        for (int corner = 0; corner < 8; ++corner) {
            const DVec3 local((corner & 1) - 0.5, 2 * ((corner >> 1 & 1) - 0.5), 3 * ((corner >> 2) - 0.5));
            const DVec3 d = transformPoint(m, local) - camera.eye;
            const double depth = -glm::dot(d, axes.backward);
            ASSERT_GT(depth, 0);
            EXPECT_LT(std::fabs(glm::dot(d, axes.right)), half * depth);
            EXPECT_LT(std::fabs(glm::dot(d, axes.up)), half * depth);
        }
    }
}

TEST(Environment, IsHorizonAtEyeLevelAndZenithAndNadirAtThePoles) {
    const Environment sky{Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1)};
    EXPECT_EQ(sky.radiance({1, 0, 0}), Color(0, 1, 0));
    EXPECT_EQ(sky.radiance({0, 1, 0}), Color(1, 0, 0));
    EXPECT_EQ(sky.radiance({0, -1, 0}), Color(0, 0, 1));
    EXPECT_EQ(sky.radiance({0, 0.25F, std::sqrt(1 - 0.0625F)}), Color(0.5F, 0.5F, 0));
}

TEST(Validate, AcceptsAWholeSceneAndNoBrokenOne) {
    const Scene good = withShape(Sphere{1});
    EXPECT_NO_THROW(validate(good));
    const auto broken = [&](auto&& change) {
        Scene scene = good;
        change(scene);
        EXPECT_THROW(validate(scene), InternalError);
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    broken([](Scene& s) { s.objects[0].material = 1; });
    broken([](Scene& s) { s.objects[0].geometry = ShapeId{1}; });
    broken([](Scene& s) { s.objects[0].geometry = MeshId{0}; });
    broken([&](Scene& s) { s.objects[0].transform[3][0] = static_cast<double>(nan); });
    broken([](Scene& s) { s.objects[0].transform[0][3] = 1; });
    broken([](Scene& s) { s.cameras.clear(); });
    broken([](Scene& s) { s.materials.clear(); });
    broken([&](Scene& s) { std::get<TaughtMaterial>(s.materials[0].model).diffuse.x = nan; });
    broken([](Scene& s) { std::get<TaughtMaterial>(s.materials[0].model).diffuseTexture.texture = 0; });
    broken([&](Scene& s) { s.ambient.x = nan; });
    broken([](Scene& s) { s.shapes[0] = Sphere{0}; });
    broken([](Scene& s) { s.textures = {{"t", ImageTexture{}}}; });
    broken([](Scene& s) {
        TriangleMesh mesh;
        mesh.positions.resize(3);
        mesh.triangles = {{0, 1, 3}};
        s.meshes = {{"mesh", std::make_shared<const TriangleMesh>(mesh)}};
    });
    broken([](Scene& s) {
        Light light;
        light.shape = SpotLamp{1, 0.5};
        s.lights = {light};
    });
}

}
}
