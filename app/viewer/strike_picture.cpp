#include "app/viewer/strike_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/errors.h"

namespace eyeray {
namespace {

/// A weight of the taught material at a ray's hit, or of the medium that it runs in.
Command withoutWeight(const Scene& scene, int material, const char* key) {
    const auto index = static_cast<std::size_t>(material);
    const bool taught = material >= 0 && index < scene.materials.size() &&
                        std::holds_alternative<TaughtMaterial>(scene.materials[index].model);
    if (!taught)
        throw InputError("strike-picture", fmt::format("this material has no weight {} of its own", key),
                         "bring the term back; strike out its lamp or its ray instead");
    return {"material", {{"material", fmt::format("{}", material)}, {key, "0"}}};
}

int materialOf(const Scene& scene, int object) {
    const auto index = static_cast<std::size_t>(object);
    return object >= 0 && index < scene.objects.size() ? scene.objects[index].material : -1;
}

Command without(const LedgerNode& node, const SampleRecord& record, const Scene& scene) {
    const RayRecord& ray = record.rays[static_cast<std::size_t>(node.ray)];
    const auto lampOff = [&] {
        const int light = record.lamps[static_cast<std::size_t>(node.lamp)].light;
        return Command("light", {{"light", fmt::format("{}", light)}, {"enabled", "off"}});
    };
    switch (node.term) {
    case Term::Lamp:
    case Term::Local:
    case Term::Irradiance:
        return lampOff();
    case Term::Visibility:
        return node.value == Color(1) ? lampOff() : Command("set", {{"shadows", "off"}});
    case Term::Diffuse:
        return withoutWeight(scene, ray.hit.material, "diffuse");
    case Term::Specular:
        return withoutWeight(scene, ray.hit.material, "specular");
    case Term::Emission:
        return withoutWeight(scene, ray.hit.material, "emission");
    case Term::Transmittance:
        return withoutWeight(scene, materialOf(scene, ray.medium), "attenuation");
    case Term::Ambient:
        return {"ambient", {{"color", "0"}}};
    case Term::Background:
        return {"environment", {{"zenith", "0"}, {"horizon", "0"}, {"nadir", "0"}}};
    case Term::Sent:
    case Term::Share:
        return {"set", {{ray.kind == RayKind::Refraction ? "refractions" : "reflections", "off"}}};
    case Term::Radiance:
    case Term::Arriving:
    case Term::Onward:
        break;
    }
    throw InputError("strike-picture", "this is the sum itself", "strike out one of its terms");
}

}

std::vector<Command> strikesEverywhere(const PixelStudy& study, const SampleRecord& record,
                                       const Scene& scene) {
    std::vector<Command> commands;
    for (const Strike& strike : study.strikes()) {
        Command command = without(study.ledger().at(strike.node), record, scene);
        if (std::find(commands.begin(), commands.end(), command) == commands.end())
            commands.push_back(std::move(command));
    }
    return commands;
}

}
