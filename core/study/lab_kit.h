#pragma once
// Parts that the scenes of the failure lab are put together from.

#include <glm/gtc/matrix_transform.hpp>

#include "core/scene/scene.h"

namespace eyeray::lab {

inline Scene underSky(const Color& zenith, const Color& horizon) {
    Scene scene;
    scene.environment = {zenith, horizon, horizon};
    scene.cameras.emplace_back();
    scene.cameras.back().name = "front";
    scene.statesExposure = true;
    return scene;
}

inline Scene underDaySky() { return underSky({0.20F, 0.36F, 0.62F}, {0.62F, 0.70F, 0.78F}); }

inline DMat4 at(const DVec3& place) { return glm::translate(DMat4(1), place); }

/// The plane y = 0 of object space facing +z.
inline DMat4 upright() { return glm::rotate(DMat4(1), kPiD / 2, DVec3(1, 0, 0)); }

inline int addMaterial(Scene& scene, const MaterialModel& material) {
    scene.materials.push_back({"", material});
    return static_cast<int>(scene.materials.size()) - 1;
}

inline void add(Scene& scene, std::string name, const Shape& shape, const MaterialModel& material,
                const DMat4& transform = DMat4(1)) {
    scene.shapes.push_back(shape);
    const ShapeId id{static_cast<int>(scene.shapes.size()) - 1};
    scene.objects.push_back({std::move(name), id, addMaterial(scene, material), transform});
}

inline void add(Scene& scene, std::string name, TriangleMesh mesh, const MaterialModel& material,
                const DMat4& transform = DMat4(1)) {
    scene.meshes.push_back({name, std::make_shared<const TriangleMesh>(std::move(mesh))});
    const MeshId id{static_cast<int>(scene.meshes.size()) - 1};
    scene.objects.push_back({std::move(name), id, addMaterial(scene, material), transform});
}

/// ka = kd, so that ambient light shows the same colour.
inline TaughtMaterial matte(const Color& color) {
    TaughtMaterial material;
    material.ambient = material.diffuse = color;
    return material;
}

inline TaughtMaterial mirror(const Color& kr) {
    TaughtMaterial material = matte(Color(0));
    material.reflectivity = kr;
    return material;
}

inline TaughtMaterial glass() {
    TaughtMaterial material = matte(Color(0));
    material.transmission = Color(1);
    return material;
}

inline TaughtMaterial glowing(const Color& radiance) {
    TaughtMaterial material = matte(Color(0));
    material.emission = radiance;
    return material;
}

inline TaughtMaterial checkered(Scene& scene, const Color& even, const Color& odd) {
    scene.textures.push_back({"checker", CheckerTexture{even, odd}});
    TaughtMaterial material = matte(Color(1));
    material.diffuseTexture.texture = static_cast<int>(scene.textures.size()) - 1;
    return material;
}

/// A unit ball of `rows` by 2·rows quads with the normals of a sphere.
TriangleMesh ballMesh(int rows);

/// The lectures' lamp: as bright at any distance.
inline void addLamp(Scene& scene, const DVec3& place, const Color& color = Color(1)) {
    Light lamp;
    lamp.name = "lamp";
    lamp.color = color;
    lamp.falloff = false;
    lamp.transform = at(place);
    scene.lights.push_back(lamp);
}

inline void look(Scene& scene, const DVec3& eye, const DVec3& target, double fovDegrees = 40) {
    Camera& camera = scene.cameras.front();
    camera.eye = eye;
    camera.target = target;
    camera.verticalFov = radians(fovDegrees);
}

/// The whole scene under a map, the camera and lamps with it.
inline void mapAll(Scene& scene, const DMat4& map) {
    for (Object& object : scene.objects) object.transform = map * object.transform;
    for (Light& light : scene.lights) light.transform = map * light.transform;
    for (Camera& camera : scene.cameras) {
        camera.eye = transformPoint(map, camera.eye);
        camera.target = transformPoint(map, camera.target);
    }
}

}
