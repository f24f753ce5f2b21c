// Materials: F31 to F33, F35, F36.

#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"
#include "core/transport/bsdf.h"
#include "core/transport/direct_light.h"
#include "core/transport/next_rays.h"
#include "core/transport/textbook_optics.h"

namespace eyeray {
namespace {

constexpr float kGlass = 1.5F, kWater = 1.33F;
const Vec3 kUp(0, 1, 0);

Vec3 leaning(double angle, double around) {
    return Vec3(
        DVec3(std::sin(angle) * std::cos(around), std::cos(angle), std::sin(angle) * std::sin(around)));
}

/// By Snell's law; NaN on total reflection.
DVec3 trulyRefracted(const Vec3& wo, Real eta) {
    const Real x = wo.x, y = wo.y, z = wo.z, length = std::sqrt(x * x + y * y + z * z), k = -eta / length;
    return DVec3(k * x, -std::sqrt(1 - k * k * (x * x + z * z)), k * z);
}

Verdict directionError(const DVec3& direction, const DVec3& truth) {
    const double error = glm::length(direction - truth);
    return {error, error > 1e-3};
}

// Into glass, from a direction of another length than 1.
MeasuredForms scaledDirection(double length, const StabilityEffort& effort) {
    struct Input {
        Vec3 wo;
        DVec3 truth;
    };
    const auto inputs = inputsOf(effort.trials, 31, [&](TrialNumbers& numbers) {
        const Vec3 wo = leaning(numbers.uniform(0.1, 1.4), numbers.uniform(0, 2 * kPiD));
        return Input{static_cast<float>(length) * wo, trulyRefracted(wo, 1 / static_cast<Real>(kGlass))};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> DVec3 {
            using T = decltype(type);
            using V = textbook::Vector<T>;
            return textbook::refracted<T>(V(in.wo), V(kUp), 1 / T(kGlass));
        },
        [](const Input& in) -> DVec3 {
            const auto bent = refracted(glm::normalize(in.wo), kUp, 1 / kGlass);
            return bent ? *bent : Vec3(NAN);
        },
        [](const Input& in, const DVec3& bent) { return directionError(bent, in.truth); });
}

// What a surface that reflects all in a highlight gives back of a light straight above.
MeasuredForms highlightEnergy(double shininess, const StabilityEffort& effort) {
    struct Input {
        Vec2 u;
    };
    const auto inputs = inputsOf(effort.trials, 32, [&](TrialNumbers& numbers) {
        const double x = numbers.uniform(0, 1);
        return Input{Vec2(x, numbers.uniform(0, 1))};
    });
    const auto judge = [](double albedo) -> Verdict {
        return {std::max(0.0, albedo - 1), albedo > 1 + 5e-4};
    };
    const auto mean = [](const Input&, double weight) { return weight; };
    const auto naive = [&](auto type) {
        using T = decltype(type);
        using V = textbook::Vector<T>;
        const auto weight = [=](const Input& in) -> double { // of a uniform direction
            const T y = in.u.x, ring = std::sqrt(1 - y * y), around = T(2 * kPiD) * in.u.y;
            const V wi(ring * std::cos(around), y, ring * std::sin(around));
            return T(2 * kPiD) * y * textbook::highlight(V(kUp), V(kUp), wi, static_cast<T>(shininess));
        };
        return averaged(inputs, effort, weight, mean, judge);
    };
    TaughtMaterial white;
    white.ambient = white.diffuse = Color(0);
    white.specular = Color(1);
    white.shininess = static_cast<float>(shininess);
    const Bsdf bsdf(physicalOf(white), {.wo = kUp, .normal = kUp, .geometricNormal = kUp});
    const auto robust = [&](const Input& in) -> double {
        const auto sample = bsdf.sample(RayKind::Reflection, in.u);
        return sample ? sample->weight.x : 0;
    };
    return {naive(float()), naive(double()), averaged(inputs, effort, robust, mean, judge)};
}

MeasuredForms unlitSide(double angle, const StabilityEffort& effort) {
    constexpr float kShininess = 10.5F;
    struct Input {
        Vec3 wi;
        ShadingPoint point;
        double truth;
    };
    Surface surface;
    surface.specular = Color(1);
    surface.shininess = kShininess;
    const auto inputs = inputsOf(effort.trials, 33, [&](TrialNumbers& numbers) {
        const double around = numbers.uniform(0, 2 * kPiD);
        const Vec3 wi = leaning(radians(angle), around);
        ShadingPoint point{};
        point.wo = leaning(numbers.uniform(0, 1.5), numbers.uniform(0, 2 * kPiD));
        point.normal = point.geometricNormal = kUp;
        point.surface = &surface;
        const DVec3 mirrored(-DVec3(wi).x, wi.y, -DVec3(wi).z);
        const double along = wi.y > 0 ? std::max(0.0, glm::dot(mirrored, DVec3(point.wo))) : 0;
        return Input{wi, point, std::pow(along, kShininess)};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> double {
            using T = decltype(type);
            using V = textbook::Vector<T>;
            return textbook::highlight(V(in.point.wo), V(kUp), V(in.wi), T(kShininess));
        },
        [](const Input& in) -> double { return localModel(in.point, in.wi, NoFaults()).specular.x; },
        [](const Input& in, double value) -> Verdict {
            const double error = std::fabs(value - in.truth);
            return {error, error > 1e-3};
        });
}

// A mirror whose normal is bent by so much in any direction.
MeasuredForms bentMirror(double tilt, const StabilityEffort& effort) {
    struct Input {
        ShadingPoint point;
    };
    Surface mirror;
    mirror.normalReflectivity = mirror.grazingReflectivity = Color(1);
    const auto inputs = inputsOf(effort.trials, 35, [&](TrialNumbers& numbers) {
        ShadingPoint point{};
        do {
            point.wo = leaning(numbers.uniform(0, 1.57), numbers.uniform(0, 2 * kPiD));
            point.normal = leaning(radians(tilt), numbers.uniform(0, 2 * kPiD));
        } while (!(glm::dot(point.normal, point.wo) > 0));
        point.geometricNormal = kUp;
        point.surface = &mirror;
        return Input{point};
    });
    const World world;
    const auto share = [](const Input&, const DVec3& direction) -> bool { return !(direction.y > 0); };
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> DVec3 {
            using V = textbook::Vector<decltype(type)>;
            return textbook::mirroredAbout(V(in.point.normal), V(in.point.wo));
        },
        [&](const Input& in) -> DVec3 { return nextRays(world, {}, in.point, {}).reflection; }, share);
}

// From glass into the water in it.
MeasuredForms waterInGlass(double angle, const StabilityEffort& effort) {
    struct Input {
        Vec3 wo;
        DVec3 truth;
    };
    World world;
    for (const float ior : {kGlass, kWater}) {
        WorldMaterial material;
        material.surface.ior = ior;
        world.objects.push_back(
            {.material = static_cast<std::uint32_t>(world.materials.size()), .solid = true});
        world.materials.push_back(material);
    }
    const MediumStack inGlass = MediumStack().entered(0, 0);
    const auto inputs = inputsOf(effort.trials, 36, [&](TrialNumbers& numbers) {
        const double lean = radians(std::clamp(angle + numbers.uniform(-1, 1), 0.0, 90.0));
        const Vec3 wo = leaning(lean, numbers.uniform(0, 2 * kPiD));
        return Input{wo, trulyRefracted(wo, static_cast<Real>(kGlass) / kWater)};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> DVec3 {
            using T = decltype(type);
            using V = textbook::Vector<T>;
            return textbook::refracted<T>(V(in.wo), V(kUp), 1 / T(kWater));
        },
        [&](const Input& in) -> DVec3 {
            const Side water{.instance = 1, .solid = true, .front = true, .ior = kWater};
            const auto bent = refracted(in.wo, kUp, interfaceAt(world, water, inGlass).eta);
            return bent ? *bent : Vec3(NAN);
        },
        [](const Input& in, const DVec3& bent) { return directionError(bent, in.truth); });
}

}

std::vector<StabilityCase> shadingCases() {
    return {
        {.id = "F31",
         .title = "A direction that is not of unit length",
         .why = "Snell's law takes n·d for a cosine: at |d| = 2 it is one of 1.7",
         .fix = "directions are made unit where they arise, and stay so",
         .parameter = "length of the direction",
         .error = "length of the refracted direction's error",
         .failure = "off by more than 10⁻³",
         .sweep = {0.25, 0.5, 0.9, 1, 1.1, 2, 4},
         .mark = {1e-5, 0},
         .measure = scaledDirection},
        {.id = "F32",
         .title = "Highlights that bring more light than they take",
         .why = "cosⁿ as it is brings 2π/(n + 2): twice the light for a wide highlight",
         .fix = "microfacets that no angle gives more than 1 (Walter et al. 2007), for physical methods",
         .parameter = "shininess n",
         .error = "albedo above 1",
         .failure = "above 1.0005",
         .sweep = {1, 2, 4, 10, 30, 100, 300, 1000},
         .mark = {5e-4, 0},
         .measure = highlightEnergy},
        {.id = "F33",
         .title = "A highlight on the unlit side",
         .why = "r·v knows nothing of a lamp behind the surface; and powers of negative numbers are NaN",
         .fix = "black unless n·l > 0, and max(0, r·v)",
         .parameter = "angle of the lamp from the normal, degrees",
         .error = "error of the highlight",
         .failure = "not a number, or off by more than 10⁻³",
         .sweep = steps(0, 180, 15),
         .logarithmic = false,
         .showsFailures = true,
         .mark = {1e-4, 0},
         .measure = unlitSide},
        {.id = "F35",
         .title = "Mirrored rays under the surface",
         .why = "about a bent normal a flat ray is mirrored into the object",
         .fix = "about the surface's own normal where that happens",
         .parameter = "tilt of the shading normal, degrees",
         .error = "share of rays that go inside",
         .failure = "rays that go inside",
         .sweep = {0, 2, 5, 10, 15, 20, 30, 45},
         .logarithmic = false,
         .mark = {0, 0},
         .measure = bentMirror},
        {.id = "F36",
         .title = "Water in a glass by way of air",
         .why = "each surface takes air for what is outside: 30° in glass become 22° and not 34°",
         .fix = "η of what the ray is in: the smallest solid there (after Schmidt, Budge, JGT 7(2) 2002)",
         .parameter = "angle in glass, degrees",
         .error = "length of the direction's error",
         .failure = "off by more than 10⁻³, or not a number",
         .sweep = steps(5, 60, 5),
         .logarithmic = false,
         .mark = {1e-4, 0},
         .measure = waterInGlass},
    };
}

}
