#include <fmt/format.h>

#include <algorithm>

#include "core/study/picture_model.h"

namespace eyeray {
namespace {

bool hasArea(const Light& light) {
    return std::holds_alternative<RectangleLamp>(light.shape) ||
           std::holds_alternative<SphereLamp>(light.shape);
}

bool mirrors(const Scene& scene, const Object& object) {
    return needsOf(scene.materials[static_cast<std::size_t>(object.material)].model).reflects;
}

/// Whether no ray that leaves the shape's outside can come upon it again.
struct Convex {
    DVec3 eye; // in object space
    bool operator()(const Plane&) const { return true; }
    bool operator()(const Sphere& sphere) const {
        return glm::length(eye) > static_cast<double>(sphere.radius) * (1 + kMargin);
    }
    bool operator()(const Box& box) const {
        const DVec3 beyond = glm::abs(eye) - DVec3(box.size) * (0.5 * (1 + kMargin));
        return std::max({beyond.x, beyond.y, beyond.z}) > 0;
    }
    bool operator()(const Cylinder& c) const {
        const double radius = std::max(c.radiusTop, c.radiusBottom);
        return std::fabs(eye.y) > 0.5 * static_cast<double>(c.height) * (1 + kMargin) ||
               std::hypot(eye.x, eye.z) > radius * (1 + kMargin);
    }
    static constexpr double kMargin = 1e-3; // of its size
};

/// Whether all that mirrors is one convex shape with the eye outside: then no mirror is seen in a mirror.
bool oneConvexMirror(const PictureModel& model) {
    const Scene& scene = *model.scene;
    const Object* only = nullptr;
    for (const Object& object : scene.objects) {
        if (!object.visible || !mirrors(scene, object)) continue;
        if (only != nullptr) return false;
        only = &object;
    }
    if (only == nullptr) return false;
    const auto* const shape = std::get_if<ShapeId>(&only->geometry);
    if (shape == nullptr || glm::determinant(DMat3(only->transform)) == 0) return false;
    const DVec3 eye = transformPoint(glm::inverse(only->transform), model.camera.eye);
    return std::visit(Convex{eye}, scene.shapes[static_cast<std::size_t>(shape->index)]);
}

class Prover {
public:
    explicit Prover(const PictureModel& model)
        : model_(model), needs_(analyseNeeds(*model.scene)), method_(model.trace.method),
          physical_(isPhysical(method_)), recurses_(physical_ || method_ == Method::Whitted) {}

    std::vector<ProvedNeed> prove() {
        const PhysicalNeeds& p = needs_.physical;
        const bool shadows = physical_ ? p.shadows : needs_.shadows;
        const bool reflections = physical_ ? p.reflections : needs_.reflections;
        const bool diffuse = method_ == Method::Path && p.diffuse;
        rays("shadow rays", &TraceSettings::shadows, method_ == Method::Local || shadows,
             "no lamp shines on anything", [](SceneNeeds& n) { n.shadows = n.physical.shadows = true; });
        rays("reflection rays", &TraceSettings::reflections, !recurses_ || reflections,
             physical_ ? "every material is matte" : "no material is a mirror or a dielectric",
             [](SceneNeeds& n) { n.reflections = n.physical.reflections = true; });
        rays("refraction rays", &TraceSettings::refractions, !recurses_ || needs_.refractions,
             "no material transmits light", [](SceneNeeds& n) { n.refractions = true; });
        rays("diffuse rays", &TraceSettings::diffuse, method_ != Method::Path || diffuse,
             "no material is matte", [](SceneNeeds& n) { n.physical.diffuse = true; });
        const bool asProved = model_.trace.faults.empty(); // a mistaken ray may meet anything
        if (asProved && recurses_ && !reflections && !needs_.refractions && !diffuse)
            depth(0, "nothing sends a ray on");
        else if (asProved && method_ == Method::Whitted && !needs_.refractions && oneConvexMirror(model_))
            depth(1, "the only mirror is convex: it never sees itself");
        leftOut("texture reads", "read", !needs_.textures, "no material has a texture",
                [](SceneNeeds& n) { n.textures = true; });
        if (physical_) {
            const auto& lights = model_.scene->lights;
            const bool soft =
                !model_.scene->environment.black() || std::any_of(lights.begin(), lights.end(), hasArea);
            leftOut("soft shadows", "sampled", !soft && needs_.shadows,
                    "no lamp has an area, and no sky shines", {});
            leftOut("lens samples", "sampled", model_.camera.lensRadius == 0, "the camera is a pinhole", {});
        }
        return std::move(proved_);
    }

private:
    using Force = std::function<void(SceneNeeds&)>;

    void rays(const char* what, bool TraceSettings::* on, bool needed, const char* reason, Force force) {
        if (needed || !(model_.trace.*on)) return;
        add(what, "on", "off", reason, [on](PictureModel& m) { m.trace.*on = false; }, std::move(force));
    }

    void depth(int bound, const char* reason) {
        if (model_.trace.maxDepth <= bound) return;
        add("max depth", fmt::format("{}", model_.trace.maxDepth), fmt::format("{}", bound), reason,
            [bound](PictureModel& m) { m.trace.maxDepth = bound; }, {});
    }

    void add(const char* what, std::string from, std::string to, const char* reason,
             std::function<void(PictureModel&)> climb, Force force) {
        proved_.push_back({{.what = what,
                            .from = std::move(from),
                            .rungs = {{to, std::move(climb)}},
                            .leftOut = what,
                            .evenIfFree = true},
                           to,
                           reason,
                           std::move(force)});
    }

    /// By the renderer, with nothing to set.
    void leftOut(const char* what, const char* from, bool isSo, const char* reason, Force force) {
        if (isSo) proved_.push_back({{what, from, {}, what}, "left out", reason, std::move(force)});
    }

    const PictureModel& model_;
    const SceneNeeds needs_;
    const Method method_;
    const bool physical_, recurses_;
    std::vector<ProvedNeed> proved_;
};

}

std::vector<ProvedNeed> provedNeeds(const PictureModel& model) { return Prover(model).prove(); }

}
