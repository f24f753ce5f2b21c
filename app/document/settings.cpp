#include "app/document/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/errors.h"

namespace eyeray {
namespace {

using namespace std::string_view_literals;

constexpr double kMostSeconds = 1e6, kMostRadiance = 1e6;
constexpr double kLargestLens = 1e3, kFarthestFocus = 1e9; // metres

// Each setting is a reference into a Document, with how to read it.
template <auto Field>
struct Flag {
    static std::string get(const Document& d) { return toText(Field(d)); }
    static void set(Document& d, const Command& c, std::string_view key) { Field(d) = *c.flag(key); }
};

template <auto Field, int lowest, int highest>
struct Integer {
    static std::string get(const Document& d) { return fmt::format("{}", Field(d)); }
    static void set(Document& d, const Command& c, std::string_view key) {
        auto& field = Field(d);
        field = static_cast<std::decay_t<decltype(field)>>(*c.integer(key, lowest, highest));
    }
};

template <auto Field, auto lowest, auto highest>
struct Number {
    static std::string get(const Document& d) { return fmt::format("{}", Field(d)); }
    static void set(Document& d, const Command& c, std::string_view key) {
        auto& field = Field(d);
        field = static_cast<std::decay_t<decltype(field)>>(*c.number(key, lowest, highest));
    }
};

template <auto Field, const auto& names>
struct Choice {
    static std::string get(const Document& d) {
        return std::string(names[static_cast<std::size_t>(Field(d))]);
    }
    static void set(Document& d, const Command& c, std::string_view key) {
        auto& field = Field(d);
        field = static_cast<std::decay_t<decltype(field)>>(*c.choice(key, names));
    }
};

struct Aspect {
    static std::string get(const Document& d) { return d.aspect == 0 ? "free" : toText(d.aspect); }
    static void set(Document& d, const Command& c, std::string_view key) {
        const std::string value = c.required(key);
        const std::size_t colon = value.find(':');
        std::optional<double> ratio;
        if (value == "free") {
            ratio = 0;
        } else if (colon == std::string::npos) {
            ratio = toNumber(value);
        } else {
            const auto w = toNumber(value.substr(0, colon)), h = toNumber(value.substr(colon + 1));
            if (w && h && *h > 0) ratio = *w / *h;
        }
        if (!ratio || (value != "free" && (*ratio < 0.1 || *ratio > 10)))
            throw InputError(fmt::format("{} {}={}", c.name(), key, value), "not an aspect",
                             "give free, a ratio such as 16:9, or a number from 0.1 to 10");
        d.aspect = *ratio;
    }
};

struct Fov {
    static std::string get(const Document& d) { return degreesText(d.camera.verticalFov); }
    static void set(Document& d, const Command& c, std::string_view key) {
        d.camera.verticalFov = radians(*c.number(key, 1, 170));
    }
};

struct Faults {
    static std::string get(const Document& d) { return toText(d.render.trace.faults); }
    static void set(Document& d, const Command& c, std::string_view key) {
        d.render.trace.faults = faultsNamed(c.required(key));
    }
};

template <class S>
constexpr Setting entry(std::string_view key, std::string_view help) {
    return {key, help, S::get, S::set};
}

constexpr auto method = [](auto& d) -> auto& { return d.render.trace.method; };
constexpr auto maxDepth = [](auto& d) -> auto& { return d.render.trace.maxDepth; };
constexpr auto cutoff = [](auto& d) -> auto& { return d.render.trace.cutoff; };
constexpr auto shadows = [](auto& d) -> auto& { return d.render.trace.shadows; };
constexpr auto reflections = [](auto& d) -> auto& { return d.render.trace.reflections; };
constexpr auto refractions = [](auto& d) -> auto& { return d.render.trace.refractions; };
constexpr auto diffuse = [](auto& d) -> auto& { return d.render.trace.diffuse; };
constexpr auto sampler = [](auto& d) -> auto& { return d.render.trace.sampler; };
constexpr auto fresnel = [](auto& d) -> auto& { return d.render.trace.fresnel; };
constexpr auto glassShadows = [](auto& d) -> auto& { return d.render.trace.glassShadows; };
constexpr auto epsilon = [](auto& d) -> auto& { return d.render.trace.epsilon; };
constexpr auto clamp = [](auto& d) -> auto& { return d.render.trace.clamp; };
constexpr auto aim = [](auto& d) -> auto& { return d.render.trace.aim; };
constexpr auto precision = [](auto& d) -> auto& { return d.render.trace.precision; };
constexpr auto lens = [](auto& d) -> auto& { return d.camera.lensRadius; };
constexpr auto focus = [](auto& d) -> auto& { return d.camera.focusDistance; };
constexpr auto samples = [](auto& d) -> auto& { return d.render.stop.samples; };
constexpr auto seconds = [](auto& d) -> auto& { return d.render.stop.seconds; };
constexpr auto error = [](auto& d) -> auto& { return d.render.stop.error; };
constexpr auto adaptive = [](auto& d) -> auto& { return d.render.stop.adaptive; };
constexpr auto exposure = [](auto& d) -> auto& { return d.render.display.exposure; };
constexpr auto toneMap = [](auto& d) -> auto& { return d.render.display.toneMap; };
constexpr auto accel = [](auto& d) -> auto& { return d.accel; };
constexpr auto threads = [](auto& d) -> auto& { return d.threads; };
constexpr auto seed = [](auto& d) -> auto& { return d.render.seed; };

constexpr std::array kSettings = {
    entry<Choice<method, kMethodNames>>(
        "method",
        "local (no shadows), cast (eye and shadow rays), whitted (and mirrors and glass), distributed "
        "(soft shadows, rough mirrors and glass) or path (and light from everywhere)"),
    entry<Integer<maxDepth, 0, kMaxDepth>>("max-depth", "deepest rays traced: 0 is eye rays alone, up to 64"),
    entry<Number<cutoff, 0, 1>>("cutoff", "rays that would contribute less than this are not traced: 0 to 1"),
    entry<Flag<shadows>>("shadows", "shadow rays: on or off"),
    entry<Flag<reflections>>("reflections", "reflection rays: on or off"),
    entry<Flag<refractions>>("refractions", "refraction rays: on or off"),
    entry<Flag<diffuse>>("diffuse", "diffuse rays, of the method path: on or off"),
    entry<Choice<fresnel, kFresnelModeNames>>(
        "fresnel", "weights at glass: exact Fresnel equations, or constant kr and kt"),
    entry<Choice<glassShadows, kGlassShadowNames>>(
        "glass-shadows",
        "shadow rays at glass: opaque objects alone block, straight through with tint, or all block"),
    entry<Choice<sampler, kSamplerNames>>(
        "sampler", "random numbers of distributed and path: independent, stratified or sobol"),
    entry<Fov>("fov", "vertical field of view: 1 to 170 degrees"),
    entry<Number<lens, 0, kLargestLens>>(
        "lens", "radius of the camera's lens in metres, of distributed and path; 0 is a pinhole"),
    entry<Number<focus, 0, kFarthestFocus>>("focus", "distance in metres that is sharp; 0 is the target's"),
    entry<Aspect>("aspect", "width by height of the picture: free, 16:9, 1.5"),
    entry<Number<exposure, -20, 20>>("exposure", "EV: each step doubles the brightness shown, -20 to 20"),
    entry<Choice<toneMap, kToneMapNames>>(
        "tonemap", "how bright radiance is shown: none (linear), clamp, reinhard or aces"),
    entry<Integer<samples, 1, 1000000>>("samples", "stop after so many samples per pixel: 1 to 1000000"),
    entry<Number<seconds, 0, kMostSeconds>>("seconds", "stop after so much time; 0 is no limit"),
    entry<Number<error, 0, 1>>(
        "error", "stop when the estimated error of the displayed values (0 to 1) is below this; 0 is never"),
    entry<Flag<adaptive>>("adaptive",
                          "each pixel stops when the error around it is below the one asked for: on; or all "
                          "together when the worst tile's is: off"),
    entry<Choice<accel, kAccelNames>>(
        "accel", "index that finds hits: auto (by scene and method), brute (force), bvh2 or bvh8"),
    entry<Integer<threads, 0, 1024>>("threads", "threads that trace; 0 is one per core"),
    entry<Integer<seed, 0, 2147483647>>("seed", "start of the addressed random numbers"),
    entry<Faults>("fault", "mistakes to show, with commas between; none is as well as is known"),
    entry<Number<epsilon, 0, 1>>("epsilon", "what the fault global-epsilon skips of a ray: 0 to 1"),
    entry<Number<clamp, 0, kMostRadiance>>("clamp",
                                           "radiance that the fault early-clamp cuts off at: 0 to 1000000"),
    entry<Choice<precision, kPrecisionNames>>("precision",
                                              "of the textbook formulas of faults: float or double"),
    entry<Choice<aim, kAimNames>>(
        "aim", "what eye rays go through: samples of their pixels, or edges of meshes that cross them"),
};

}

std::span<const Setting> settings() { return kSettings; }

const Setting& settingNamed(std::string_view key) {
    const auto setting =
        std::find_if(kSettings.begin(), kSettings.end(), [&](const Setting& s) { return s.key == key; });
    if (setting != kSettings.end()) return *setting;
    std::string known;
    for (const Setting& s : kSettings) known += fmt::format("{}{}", known.empty() ? "" : " ", s.key);
    throw InputError(fmt::format("set {}=…", key), "there is no such setting", "use one of " + known);
}

}
