// Mirrors and glass: F27 to F30, F37.

#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"
#include "core/transport/optics.h"
#include "core/transport/textbook_optics.h"

namespace eyeray {
namespace {

constexpr float kGlass = 1.5F;
const Vec3 kUp(0, 1, 0);

/// A direction to a surface that faces up, away from it, within half a step of the angle.
Vec3 incident(double angleDegrees, TrialNumbers& numbers) {
    const double angle = radians(std::clamp(angleDegrees + numbers.uniform(-1, 1), 0.0, 89.9));
    const double around = numbers.uniform(0, 2 * kPiD);
    return Vec3(
        DVec3(std::sin(angle) * std::cos(around), std::cos(angle), std::sin(angle) * std::sin(around)));
}

const std::vector<double> kAngles = steps(0, 88, 4);

/// Refracted, or nothing beyond the critical angle; in long double.
std::optional<DVec3> trulyRefracted(const Vec3& wo, Real eta) {
    const Real x = wo.x, y = wo.y, z = wo.z, length = std::sqrt(x * x + y * y + z * z);
    const Real sine2 = eta * eta * (x * x + z * z) / (length * length);
    if (sine2 >= 1) return {};
    const Real k = -eta / length;
    return DVec3(k * x, -std::sqrt(1 - sine2), k * z);
}

using Bent = std::optional<DVec3>;

double apart(const DVec3& a, const DVec3& b) { return glm::length(a - b); }

MeasuredForms outOfGlass(double angle, const StabilityEffort& effort) {
    struct Input {
        Vec3 wo;
        Bent truth;
    };
    const auto inputs = inputsOf(effort.trials, 27, [&](TrialNumbers& numbers) {
        const Vec3 wo = incident(angle, numbers);
        return Input{wo, trulyRefracted(wo, kGlass)};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> Bent {
            using V = textbook::Vector<decltype(type)>;
            return DVec3(textbook::refracted<decltype(type)>(V(in.wo), V(kUp), kGlass));
        },
        [](const Input& in) -> Bent {
            const auto bent = refracted(in.wo, kUp, kGlass);
            return bent ? Bent(DVec3(*bent)) : std::nullopt;
        },
        [](const Input& in, const Bent& bent) -> Verdict {
            const double sine = kGlass * std::hypot(static_cast<double>(in.wo.x), in.wo.z);
            if (std::fabs(sine - 1) < 1e-4) return {}; // on the edge of total reflection: either will do
            if (bent.has_value() != in.truth.has_value()) return {0, true};
            return {bent ? apart(*bent, *in.truth) : 0};
        });
}

MeasuredForms reflectance(double angle, const StabilityEffort& effort) {
    struct Input {
        float cosine, eta;
        double truth;
    };
    const auto inputs = inputsOf(effort.trials, 28, [&](TrialNumbers& numbers) {
        const float cosine = incident(angle, numbers).y;
        const float eta = numbers.below(2) == 0 ? 1 / kGlass : kGlass; // into it or out of it
        const Real c = cosine, e = eta, sine2 = e * e * (1 - c * c);
        if (sine2 >= 1) return Input{cosine, eta, 1};
        const Real inner = std::sqrt(1 - sine2), s = (e * c - inner) / (e * c + inner),
                   p = (c - e * inner) / (c + e * inner);
        return Input{cosine, eta, static_cast<double>((s * s + p * p) / 2)};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> double {
            using T = decltype(type);
            return textbook::schlick<T>(in.cosine, in.eta);
        },
        [](const Input& in) -> double { return fresnelDielectric(in.cosine, in.eta); },
        [](const Input& in, double share) -> Verdict {
            const double error = std::fabs(share - in.truth);
            return {error, error > 0.01};
        });
}

MeasuredForms throughSlab(double angle, const StabilityEffort& effort) {
    const auto inputs =
        inputsOf(effort.trials, 29, [&](TrialNumbers& numbers) { return incident(angle, numbers); });
    // Out of the lower face: its inner side is up too.
    return compared(
        inputs, effort,
        [](const Vec3& wo, auto type) -> DVec3 {
            using T = decltype(type);
            using V = textbook::Vector<T>;
            const V in = textbook::refracted<T>(V(wo), V(kUp), 1 / T(kGlass));
            return textbook::refracted<T>(-in, V(kUp), 1 / T(kGlass));
        },
        [](const Vec3& wo) -> DVec3 {
            const auto in = refracted(wo, kUp, 1 / kGlass);
            const auto out = in ? refracted(-*in, kUp, kGlass) : std::nullopt;
            return out ? *out : Vec3(NAN);
        },
        [](const Vec3& wo, const DVec3& out) -> Verdict {
            const double error = apart(out, -glm::normalize(DVec3(wo)));
            return {error, error > 1e-3};
        });
}

MeasuredForms mirrored(double angle, const StabilityEffort& effort) {
    const auto inputs =
        inputsOf(effort.trials, 30, [&](TrialNumbers& numbers) { return incident(angle, numbers); });
    return compared(
        inputs, effort,
        [](const Vec3& wo, auto type) -> DVec3 {
            using V = textbook::Vector<decltype(type)>;
            return textbook::reflected<decltype(type)>(V(wo), V(kUp));
        },
        [](const Vec3& wo) -> DVec3 { return reflected(wo, kUp); },
        [](const Vec3& wo, const DVec3& away) -> Verdict {
            const double error = apart(away, DVec3(-wo.x, wo.y, -wo.z));
            return {error, error > 1e-3};
        });
}

MeasuredForms absorbed(double thickness, const StabilityEffort& effort) {
    struct Input {
        float sigma; // per metre
        double truth;
    };
    const auto depth = static_cast<float>(thickness);
    const auto inputs = inputsOf(effort.trials, 37, [&](TrialNumbers& numbers) {
        const auto sigma = static_cast<float>(numbers.uniform(0.1, 1));
        return Input{sigma, static_cast<double>(std::exp(-static_cast<Real>(sigma) * depth))};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> double {
            using T = decltype(type);
            return std::exp(-T(in.sigma)); // the colour of a metre of it
        },
        [=](const Input& in) -> double { return transmittanceOf(Color(in.sigma), depth).x; },
        [](const Input& in, double share) -> Verdict {
            const double error = std::fabs(share - in.truth);
            return {error, error > 0.01};
        });
}

}

std::vector<StabilityCase> opticsCases() {
    return {
        {.id = "F27",
         .title = "Total reflection",
         .why = "beyond the critical angle of 41.81° the root is of a negative number: NaN",
         .fix = "sin² of 1 or more reflects all (Snell's law), in double, where nearly all digits cancel",
         .parameter = "angle in glass (1.5), degrees",
         .error = "length of the direction's error",
         .failure = "not a number, or not reflected",
         .sweep = kAngles,
         .logarithmic = false,
         .showsFailures = true,
         .mark = {1e-4, 0},
         .measure = outOfGlass},
        {.id = "F28",
         .title = "Schlick for Fresnel",
         .why = "a fifth too low at 60°; and with the inner cosine a sixth of the truth on the way out",
         .fix = "the equations themselves (Born, Wolf 1999, 1.5.2)",
         .parameter = "angle on either side of glass (1.5), degrees",
         .error = "error of the reflected share",
         .failure = "off by more than 0.01",
         .sweep = kAngles,
         .logarithmic = false,
         .mark = {1e-6, 0},
         .measure = reflectance},
        {.id = "F29",
         .title = "η not inverted on the way out",
         .why = "the second face bends the ray once more, away from how it came",
         .fix = "η by the side that is hit",
         .parameter = "angle at a slab (1.5), degrees",
         .error = "length of the direction's error behind the slab",
         .failure = "off by more than 10⁻³",
         .sweep = kAngles,
         .logarithmic = false,
         .mark = {1e-5, 0},
         .measure = throughSlab},
        {.id = "F30",
         .title = "Sign of the reflection formula",
         .why = "2(n·l)n + l is up to three times too long, and points back to where the light came from",
         .fix = "2(n·l)n − l",
         .parameter = "angle at the mirror, degrees",
         .error = "length of the direction's error",
         .failure = "off by more than 10⁻³",
         .sweep = kAngles,
         .logarithmic = false,
         .mark = {1e-6, 0},
         .measure = mirrored},
        {.id = "F37",
         .title = "A tint for each hit",
         .why = "the colour of a metre of glass, whether it is a pane or a block",
         .fix = "e^(−σd) (Beer, Lambert)",
         .parameter = "thickness, m",
         .error = "error of what passes",
         .failure = "off by more than 0.01",
         .sweep = decades(-2, 2, 2),
         .mark = {1e-5, 0},
         .measure = absorbed},
    };
}

}
