#pragma once
// Small scenes in code, and tracing them without a session.

#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "core/base/thread_pool.h"
#include "core/scene/world.h"
#include "core/transport/integrator.h"

namespace eyeray::scenes {

/// Nothing but a sky of one colour and a camera at the origin that looks along −z.
inline Scene underSky(const Color& sky) {
    Scene scene;
    scene.environment = {sky, sky, sky};
    scene.cameras.emplace_back();
    return scene;
}

inline DMat4 at(const DVec3& position) { return glm::translate(DMat4(1), position); }

inline void add(Scene& scene, const Shape& shape, const MaterialModel& material,
                const DMat4& transform = DMat4(1)) {
    const auto id = [](const auto& values) { return static_cast<int>(values.size()) - 1; };
    scene.shapes.push_back(shape);
    scene.materials.push_back({"", material});
    scene.objects.push_back({"", ShapeId{id(scene.shapes)}, id(scene.materials), transform});
}

inline void add(Scene& scene, TriangleMesh mesh, const MaterialModel& material,
                const DMat4& transform = DMat4(1)) {
    const auto id = [](const auto& values) { return static_cast<int>(values.size()) - 1; };
    scene.meshes.push_back({"", std::make_shared<const TriangleMesh>(std::move(mesh))});
    scene.materials.push_back({"", material});
    scene.objects.push_back({"", MeshId{id(scene.meshes)}, id(scene.materials), transform});
}

inline Light lampAt(const DVec3& position, const LampShape& shape = PointLamp{}, double intensity = 1) {
    Light light;
    light.shape = shape;
    light.intensity = intensity;
    light.transform = at(position);
    return light;
}

/// A lamp whose normal irradiance is π·color wherever it stands: the lectures' lamp.
inline Light taughtLampAt(const DVec3& position, const Color& color = Color(1)) {
    Light light = lampAt(position);
    light.color = color;
    light.falloff = false;
    return light;
}

/// Rotation that turns −z, where lamps shine and cameras look, to `direction`.
inline DMat4 facing(const DVec3& direction) {
    Camera camera;
    camera.target = direction;
    const CameraAxes axes = axesOf(camera);
    return {DVec4(axes.right, 0), DVec4(axes.up, 0), DVec4(axes.backward, 0), DVec4(0, 0, 0, 1)};
}

inline TaughtMaterial matte(const Color& kd, const Color& ka = Color(0)) {
    TaughtMaterial m;
    m.diffuse = kd;
    m.ambient = ka;
    return m;
}

inline TaughtMaterial mirror(const Color& kr) {
    TaughtMaterial m = matte(Color(0));
    m.reflectivity = kr;
    return m;
}

inline TaughtMaterial glass(float ior, const Color& kt = Color(1), const Color& attenuation = Color(0)) {
    TaughtMaterial m = matte(Color(0));
    m.transmission = kt;
    m.ior = ior;
    m.attenuation = attenuation;
    return m;
}

inline TaughtMaterial glowing(const Color& radiance) {
    TaughtMaterial m = matte(Color(0));
    m.emission = radiance;
    return m;
}

inline void look(Scene& scene, const DVec3& eye, const DVec3& target, double fovDegrees = 45) {
    Camera& camera = scene.cameras.front();
    camera.eye = eye;
    camera.target = target;
    camera.verticalFov = radians(fovDegrees);
}

/// The scene under a map, as a node above all of it would put it; lamps' transforms included.
inline Scene mapped(Scene scene, const DMat4& map) {
    for (Object& object : scene.objects) object.transform = map * object.transform;
    for (Light& light : scene.lights) light.transform = map * light.transform;
    for (Camera& camera : scene.cameras) {
        camera.eye = transformPoint(map, camera.eye);
        camera.target = transformPoint(map, camera.target);
        camera.up = transformVector(map, camera.up);
    }
    return scene;
}

/// Settings that cut nothing off but at a depth.
inline TraceSettings toDepth(int depth) {
    TraceSettings settings;
    settings.maxDepth = depth;
    settings.cutoff = 0;
    return settings;
}

inline TraceSettings casting() {
    TraceSettings settings;
    settings.method = Method::Cast;
    return settings;
}

/// A picture by the scene's first camera. One of a single pixel is the ray along the camera's axis.
class Tracing {
public:
    explicit Tracing(const Scene& scene, const TraceSettings& settings = toDepth(5), int width = 1,
                     int height = 1, AccelKind accel = AccelKind::Auto)
        : Tracing(buildWorld(std::make_shared<const Scene>(scene), {accel}), settings, width, height) {}

    Tracing(const std::shared_ptr<const World>& world, const TraceSettings& settings, int width = 1,
            int height = 1, std::stop_token stop = {})
        : context_(world, world->scene->cameras.front(), settings, width, height, 0, std::move(stop)),
          integrator_(makeIntegrator(settings.method)) {}

    /// The whole picture as one tile.
    TileResult tile(int pass = 0) const {
        const FloatEnvironment environment;
        return integrator_->renderTile(context_, {0, 0, context_.width, context_.height}, pass);
    }
    std::vector<Color> radiance(int pass = 0) const { return tile(pass).radiance; }
    Color pixel(int x = 0, int y = 0, int pass = 0) const { return retrace(x, y, pass).radiance; }

    Retrace retrace(int x = 0, int y = 0, int pass = 0) const {
        const FloatEnvironment environment;
        return integrator_->retrace(context_, x, y, pass);
    }

    const TraceContext& context() const { return context_; }
    const World& world() const { return *context_.world; }
    const Integrator& integrator() const { return *integrator_; }

private:
    TraceContext context_;
    std::unique_ptr<Integrator> integrator_;
};

inline bool isNear(const Color& a, const Color& b, float tolerance) {
    return maxComponent(glm::abs(a - b)) <= tolerance;
}

}
