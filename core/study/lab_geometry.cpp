// Where rays and objects meet at the wrong place.

#include <fmt/format.h>

#include "core/scene/generate.h"
#include "core/study/lab_kit.h"
#include "core/study/lab_scenes.h"

namespace eyeray::lab {
namespace {

/// Two triangles side by side in the plane z = 0.
TriangleMesh quad(float width, float height) {
    const float x = width / 2, y = height / 2;
    TriangleMesh mesh;
    mesh.positions = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

void addBalls(Scene& scene) {
    add(scene, "floor", Plane{24, 24, true}, matte({0.55F, 0.53F, 0.50F}));
    add(scene, "red ball", Sphere{1}, matte({0.75F, 0.20F, 0.15F}), at({-1.3, 1, 0}));
    add(scene, "blue ball", Sphere{0.7F}, matte({0.18F, 0.34F, 0.72F}), at({0.7, 0.7, 0.9}));
    add(scene, "green ball", Sphere{0.4F}, matte({0.25F, 0.60F, 0.30F}), at({1.9, 0.4, 0.2}));
    scene.ambient = Color(0.15F);
    addLamp(scene, {4, 7, 5});
    look(scene, {0.6, 2.6, 7.5}, {0.2, 0.7, 0}, 32);
}

}

Scene distantSphere(double distance) {
    Scene scene = underDaySky();
    add(scene, "ball", Sphere{1}, matte({0.85F, 0.45F, 0.12F}));
    scene.ambient = Color(0.25F);
    addLamp(scene, {-distance, distance, distance});
    look(scene, {0, 0, distance}, {0, 0, 0}, degrees(2 * std::atan(2 / distance)));
    scene.settings = {"set method=cast shadows=off"};
    return scene;
}

Scene plateOnFloor(double /*epsilon*/) {
    Scene scene = underDaySky();
    addBalls(scene);
    // As close above the floor as a sheet of card.
    add(scene, "card", Plane{1.6F, 1.1F, true}, matte({0.85F, 0.75F, 0.3F}), at({2.4, 1e-3, 2.1}));
    scene.settings = {"set method=whitted"};
    return scene;
}

Scene scaledBalls(double scale) {
    Scene scene = underDaySky();
    addBalls(scene);
    mapAll(scene, glm::scale(DMat4(1), DVec3(scale)));
    scene.settings = {"set method=whitted"};
    return scene;
}

Scene closedBall(double rows) {
    Scene scene = underSky(Color(1), Color(1));
    TriangleMesh room = ballMesh(static_cast<int>(rows));
    room.normals.clear(); // each triangle is to be seen
    for (Vec3& position : room.positions) position *= 10.0F;
    add(scene, "room", std::move(room), matte({0.03F, 0.06F, 0.14F}),
        glm::rotate(DMat4(1), 0.9, glm::normalize(DVec3(3, 1, 2))));
    scene.ambient = Color(0.3F);
    addLamp(scene, {3, 5, 2});
    look(scene, {0.7, 1.1, 5.3}, {0, 0, 0}, 60);
    scene.settings = {"set method=cast aim=edges samples=1 error=0"};
    return scene;
}

Scene smallKnot(double size) {
    Scene scene = underDaySky();
    TriangleMesh knot = makeKnot({.radius = 1, .tube = 0.34, .triangles = 12000});
    for (Vec3& position : knot.positions) position *= static_cast<float>(size);
    knot.doubleSided = true;
    add(scene, "knot", knot, matte({0.70F, 0.55F, 0.20F}));
    scene.ambient = Color(0.2F);
    addLamp(scene, size * DVec3(4, 5, 3));
    look(scene, size * DVec3(0.3, 2.2, 3.6), {0, 0, 0}, 40);
    scene.settings = {"set method=cast"};
    return scene;
}

Scene coplanarQuads(double tilt) {
    Scene scene = underSky(Color(0.05F), Color(0.05F));
    const DMat4 lean = glm::rotate(DMat4(1), radians(tilt), glm::normalize(DVec3(1, 0.7, 0)));
    const DMat4 turned = glm::rotate(DMat4(1), radians(31), DVec3(0, 0, 1));
    add(scene, "yellow", quad(3.2F, 2.2F), glowing({0.85F, 0.65F, 0.12F}), lean);
    add(scene, "blue", quad(3.0F, 2.0F), glowing({0.10F, 0.25F, 0.70F}), lean * turned);
    look(scene, {0, 0, 5}, {0, 0, 0}, 32);
    scene.settings = {"set method=cast"};
    return scene;
}

Scene farAway(double metres) {
    Scene scene = underDaySky();
    addBalls(scene);
    mapAll(scene, at({metres, 0, 0.37 * metres}));
    scene.settings = {"set method=whitted"};
    return scene;
}

Scene pancake(double squash) {
    Scene scene = underDaySky();
    add(scene, "floor", Plane{24, 24, true}, matte({0.5F, 0.5F, 0.48F}), at({0, -1, 0}));
    TaughtMaterial shiny = matte({0.70F, 0.32F, 0.14F});
    shiny.specular = Color(0.7F);
    shiny.shininess = 40;
    add(scene, "pancake", Sphere{1.4F}, shiny,
        at({0, 0.2, 0}) * glm::rotate(DMat4(1), radians(28), DVec3(0, 0, 1)) *
            glm::scale(DMat4(1), DVec3(1, squash, 1)));
    scene.ambient = Color(0.15F);
    addLamp(scene, {-5, 4, 3});
    look(scene, {0, 1.4, 6}, {0, 0, 0}, 36);
    scene.settings = {"set method=whitted"};
    return scene;
}

}
