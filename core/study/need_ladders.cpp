#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/study/picture_model.h"

namespace eyeray {
namespace {

constexpr std::size_t kMostParts = 32; // lamps, or textured materials, that are tried one by one

using Ladders = std::vector<NeedLadder>;

template <class Names, class Value>
std::string nameIn(const Names& names, Value value) {
    return std::string(names[static_cast<std::size_t>(value)]);
}

bool recurses(Method method) { return method != Method::Local && method != Method::Cast; }

Ladders ofMethod(const PictureModel& model) {
    NeedLadder ladder{.what = "method",
                      .from = nameIn(kMethodNames, model.trace.method),
                      .rungs = {},
                      .leftOut = "rays that {} does not trace",
                      .evenIfFree = true};
    for (const Method method : {Method::Local, Method::Cast, Method::Whitted, Method::Distributed})
        if (method < model.trace.method)
            ladder.rungs.push_back(
                {nameIn(kMethodNames, method), [method](PictureModel& m) { m.trace.method = method; }});
    return {ladder};
}

Ladders ofRayKinds(const PictureModel& model) {
    struct Kind {
        const char* name;
        bool TraceSettings::* on;
        bool methodHasIt;
    };
    const Method method = model.trace.method;
    Ladders ladders;
    for (const Kind kind : {Kind{"shadow rays", &TraceSettings::shadows, method != Method::Local},
                            Kind{"reflection rays", &TraceSettings::reflections, recurses(method)},
                            Kind{"refraction rays", &TraceSettings::refractions, recurses(method)},
                            Kind{"diffuse rays", &TraceSettings::diffuse, method == Method::Path}})
        if (kind.methodHasIt && model.trace.*kind.on)
            ladders.push_back({.what = kind.name,
                               .from = "on",
                               .rungs = {{"off", [on = kind.on](PictureModel& m) { m.trace.*on = false; }}},
                               .leftOut = kind.name,
                               .evenIfFree = true});
    return ladders;
}

/// Changes a copy of the model's scene.
template <class Change>
void editScene(PictureModel& model, const Change& change) {
    auto scene = std::make_shared<Scene>(*model.scene);
    change(*scene);
    model.scene = std::move(scene);
}

Ladders ofLamps(const PictureModel& model) {
    const std::vector<Light>& lights = model.scene->lights;
    Ladders ladders;
    for (std::size_t i = 0; i < lights.size() && lights.size() <= kMostParts; ++i) {
        if (!lights[i].enabled) continue;
        const auto darken = [i](PictureModel& m) {
            editScene(m, [i](Scene& scene) { scene.lights[i].enabled = false; });
        };
        const std::string name =
            fmt::format("lamp {}", lights[i].name.empty() ? fmt::format("{}", i) : lights[i].name);
        ladders.push_back({.what = name,
                           .from = "on",
                           .rungs = {{"off", darken}},
                           .leftOut = "shadow rays and light of this lamp",
                           .evenIfFree = true});
    }
    return ladders;
}

void drop(TaughtMaterial& m) { m.diffuseTexture = {}; }
void drop(GltfMaterial& m) {
    m.baseColorTexture = m.metallicRoughnessTexture = m.emissiveTexture = m.transmissionTexture = {};
}

Ladders ofTextures(const PictureModel& model) {
    const std::vector<Material>& materials = model.scene->materials;
    Ladders ladders;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (!needsOf(materials[i].model).textured) continue;
        const auto without = [i](PictureModel& m) {
            editScene(m, [i](Scene& scene) { dropTextures(scene.materials[i].model); });
        };
        const std::string name =
            materials[i].name.empty() ? fmt::format("material {}", i) : materials[i].name;
        ladders.push_back({.what = "textures of " + name,
                           .from = "read",
                           .rungs = {{"off", without}},
                           .leftOut = "its textures",
                           .evenIfFree = true});
    }
    if (ladders.size() > kMostParts) ladders.clear();
    return ladders;
}

Ladders ofLens(const PictureModel& model) {
    if (!isPhysical(model.trace.method) || model.camera.lensRadius == 0) return {};
    return {{.what = "lens",
             .from = fmt::format("{:g} m", model.camera.lensRadius),
             .rungs = {{"pinhole", [](PictureModel& m) { m.camera.lensRadius = 0; }}},
             .leftOut = "rays beside the middle of the lens",
             .evenIfFree = true}};
}

Ladders ofDepth(const PictureModel& model) {
    if (!recurses(model.trace.method)) return {};
    NeedLadder ladder{.what = "max depth",
                      .from = fmt::format("{}", model.trace.maxDepth),
                      .rungs = {},
                      .leftOut = "rays deeper than {}",
                      .evenIfFree = true};
    for (int depth = 0; depth < model.trace.maxDepth; ++depth)
        ladder.rungs.push_back(
            {fmt::format("{}", depth), [depth](PictureModel& m) { m.trace.maxDepth = depth; }});
    return {ladder};
}

Ladders ofCutoff(const PictureModel& model) {
    constexpr std::array kCutoffs = {0.5F, 0.2F, 0.1F, 0.05F, 0.02F, 0.01F, 0.005F};
    const Method method = model.trace.method;
    if (method != Method::Whitted && method != Method::Distributed) return {};
    NeedLadder ladder{.what = "cutoff",
                      .from = fmt::format("{}", model.trace.cutoff),
                      .rungs = {},
                      .leftOut = "rays that weigh less than {}"};
    for (const float cutoff : kCutoffs)
        if (cutoff > model.trace.cutoff)
            ladder.rungs.push_back(
                {fmt::format("{}", cutoff), [cutoff](PictureModel& m) { m.trace.cutoff = cutoff; }});
    return {ladder};
}

Ladders ofGlassShadows(const PictureModel& model) {
    const Method method = model.trace.method;
    const bool asked = model.trace.shadows &&
                       (method == Method::Whitted || method == Method::Cast || method == Method::Distributed);
    if (!asked || !analyseNeeds(*model.scene).refractions) return {};
    NeedLadder ladder{.what = "glass shadows",
                      .from = nameIn(kGlassShadowNames, model.trace.glassShadows),
                      .rungs = {},
                      .leftOut = "shadow rays that pass glass",
                      .evenIfFree = true};
    for (const GlassShadows policy : {GlassShadows::AllBlock, GlassShadows::OpaqueOnly}) {
        if (policy == model.trace.glassShadows) break;
        ladder.rungs.push_back({nameIn(kGlassShadowNames, policy),
                                [policy](PictureModel& m) { m.trace.glassShadows = policy; }});
    }
    return {ladder};
}

/// Only formulas of textbooks have another precision; the renderer's own are in float.
Ladders ofPrecision(const PictureModel& model) {
    if (model.trace.faults.empty() || model.trace.precision == Precision::Float) return {};
    return {{.what = "precision",
             .from = "double",
             .rungs = {{"float", [](PictureModel& m) { m.trace.precision = Precision::Float; }}},
             .leftOut = "digits beyond those of {}",
             .evenIfFree = true}};
}

}

void dropTextures(MaterialModel& model) {
    std::visit([](auto& material) { drop(material); }, model);
}

const std::vector<NeedSubject>& needSubjects() {
    static const std::vector<NeedSubject> subjects = {
        {"method", ofMethod},     {"ray kinds", ofRayKinds}, {"lamps", ofLamps},
        {"textures", ofTextures}, {"lens", ofLens},          {"max depth", ofDepth},
        {"cutoff", ofCutoff},     {"glass", ofGlassShadows}, {"precision", ofPrecision}};
    return subjects;
}

}
