#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/inspected.h"
#include "app/document/command.h"
#include "core/study/notation.h"
#include "core/study/path_sum.h"
#include "core/study/ray_facts.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

using Json = nlohmann::ordered_json;

/// A double that is written with the shortest digits of the float.
Json number(float value) {
    const auto shortest = toNumber(fmt::format("{}", value));
    return shortest ? Json(*shortest) : Json(nullptr);
}
Json triple(const Vec3& v) { return {number(v.x), number(v.y), number(v.z)}; }
Json place(const DVec3& v) { return {v.x, v.y, v.z}; }

Json hitOf(const Inspected& inspected, const RayRecord& ray) {
    const HitRecord& hit = ray.hit;
    const Scene& scene = *inspected.world->scene;
    Json json = {{"object", hit.object},
                 {"name", objectName(scene, hit.object)},
                 {"material", hit.material},
                 {"primitive", hit.primitive},
                 {"position", place(inspected.inScene(hit.position))},
                 {"normal", triple(hit.normal)},
                 {"geometric_normal", triple(hit.geometricNormal)},
                 {"front", hit.front},
                 {"incidence_deg", number(incidenceDegrees(ray))}};
    const auto material = static_cast<std::size_t>(hit.material);
    if (hit.material >= 0 && material < scene.materials.size())
        json["material_name"] = scene.materials[material].name;
    return json;
}

Json rayOf(const Inspected& inspected, std::size_t index) {
    const RayRecord& ray = inspected.trace.rays[index];
    Json json = {{"ray", index},
                 {"parent", ray.parent},
                 {"kind", name(ray.kind)},
                 {"depth", ray.depth},
                 {"origin", place(inspected.inScene(ray.origin))},
                 {"direction", triple(ray.direction)},
                 {"t", number(ray.t)},
                 {"end", name(ray.end)},
                 {"medium", ray.medium},
                 {"share", triple(ray.share)},
                 {"weight", triple(ray.weight)},
                 {"transmitted", triple(ray.transmitted)},
                 {"radiance", triple(ray.radiance)},
                 {"contribution", triple(contribution(ray))},
                 {"nodes", inspected.traversal[index].nodes},
                 {"boxes", inspected.traversal[index].boxes},
                 {"tests", inspected.traversal[index].primitives}};
    if (ray.kind == RayKind::Shadow) json["light"] = ray.light;
    if (ray.kind == RayKind::Refraction) json["eta"] = number(ray.eta);
    if (ray.kind == RayKind::Reflection) json["total_reflection"] = ray.totalReflection;
    if (ray.end == RayEnd::Hit) json["hit"] = hitOf(inspected, ray);
    return json;
}

Json lampOf(const Inspected& inspected, const LampTerm& lamp) {
    constexpr std::array<std::string_view, 3> kStates = {"lit", "faces away", "out of reach"};
    return {{"ray", lamp.ray},
            {"light", lamp.light},
            {"name", lampName(*inspected.world->scene, lamp.light)},
            {"state", kStates[static_cast<std::size_t>(lamp.state)]},
            {"shadow_ray", lamp.shadowRay},
            {"wi", triple(lamp.wi)},
            {"diffuse", triple(lamp.diffuse)},
            {"specular", triple(lamp.specular)},
            {"irradiance", triple(lamp.irradiance)},
            {"visibility", triple(lamp.visibility)},
            {"radiance", triple(lamp.radiance)}};
}

Json termOf(const PathTerm& term) {
    constexpr std::array<std::string_view, 4> kSources = {"diffuse light", "specular light", "emission",
                                                          "background"};
    return {{"source", kSources[static_cast<std::size_t>(term.source)]},
            {"ray", term.ray},
            {"lamp", term.lamp},
            {"throughput", triple(term.throughput)},
            {"f_cos", triple(term.scattered)},
            {"pdf", number(term.pdfW)},
            {"mis", number(term.mis)},
            {"radiance", triple(term.radiance)},
            {"visibility", triple(term.visibility)},
            {"value", triple(term.value)}};
}

Json untracedOf(const UntracedRay& ray) {
    return {{"parent", ray.parent},
            {"kind", name(ray.kind)},
            {"reason", reasonText(ray.reason)},
            {"direction", triple(ray.direction)},
            {"share", triple(ray.share)},
            {"weight", triple(ray.weight)}};
}

Json ledgerOf(const LedgerText& text, int node) {
    constexpr std::array<std::string_view, 3> kOperations = {"value", "sum", "product"};
    const LedgerNode& n = text.ledger.at(node);
    Json json = {{"operation", kOperations[static_cast<std::size_t>(n.operation)]},
                 {"term", name(n.term)},
                 {"ray", n.ray}};
    if (n.lamp >= 0) json["lamp"] = n.lamp;
    if (n.operation == LedgerNode::Operation::Value) json["symbol"] = text.symbol(node);
    json["value"] = triple(n.value);
    for (const int operand : text.ledger.operandsOf(node))
        json["operands"].push_back(ledgerOf(text, operand));
    return json;
}

}

std::string jsonOf(const Inspected& inspected) {
    const Scene& scene = *inspected.world->scene;
    const RenderSettings& settings = inspected.settings;
    Json json = {{"scene", inspected.reference},
                 {"width", settings.width},
                 {"height", settings.height},
                 {"method", kMethodNames[static_cast<std::size_t>(settings.trace.method)]},
                 {"max_depth", settings.trace.maxDepth},
                 {"x", inspected.pixel.x},
                 {"y", inspected.pixel.y},
                 {"sample", inspected.sample},
                 {"pixel", triple(inspected.film)},
                 {"total", triple(evaluate(inspected.ledger))},
                 {"accelerator",
                  {{"kind", kAccelNames[static_cast<std::size_t>(inspected.world->accelKind)]},
                   {"primitives", inspected.world->primitives},
                   {"nodes", inspected.world->nodes}}}};
    for (const char* list : {"rays", "lamps", "untraced", "path_sum"}) json[list] = Json::array();
    for (std::size_t i = 0; i < inspected.trace.rays.size(); ++i) json["rays"].push_back(rayOf(inspected, i));
    for (const LampTerm& lamp : inspected.trace.lamps) json["lamps"].push_back(lampOf(inspected, lamp));
    for (const UntracedRay& ray : inspected.trace.untraced) json["untraced"].push_back(untracedOf(ray));
    for (const PathTerm& term : pathTermsOf(inspected.trace)) json["path_sum"].push_back(termOf(term));
    json["ledger"] = nullptr;
    if (!inspected.ledger.nodes.empty())
        json["ledger"] = ledgerOf({inspected.ledger, inspected.trace, scene}, 0);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}
