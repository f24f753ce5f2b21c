#include "core/study/path_sum.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "core/study/wording.h"

namespace eyeray {
namespace {

using Source = PathTerm::Source;

Color throughputTo(const RayRecord& ray) { return ray.weight * ray.transmitted; }

Color productOf(const PathTerm& t) {
    const float perPdf = t.pdfW > 0 ? 1 / t.pdfW : 1;
    return t.throughput * t.scattered * perPdf * t.mis * t.radiance * t.visibility;
}

class Collector {
public:
    explicit Collector(const SampleRecord& record) : record_(record) {}

    std::vector<PathTerm> collect() {
        for (std::size_t i = 0; i < record_.rays.size(); ++i) {
            const RayRecord& ray = record_.rays[i];
            if (ray.kind == RayKind::Shadow) continue;
            const bool hit = ray.end == RayEnd::Hit;
            found(static_cast<int>(i), hit ? Source::Emission : Source::Background,
                  hit ? ray.hit.emission : ray.background);
        }
        for (std::size_t i = 0; i < record_.lamps.size(); ++i) {
            const LampTerm& lamp = record_.lamps[i];
            light(static_cast<int>(i), Source::DiffuseLight, lamp.diffuse, lamp.diffuseMis);
            light(static_cast<int>(i), Source::SpecularLight, lamp.specular, lamp.specularMis);
        }
        std::sort(terms_.begin(), terms_.end(), [](const PathTerm& a, const PathTerm& b) {
            return std::tuple(a.ray, a.lamp, a.source) < std::tuple(b.ray, b.lamp, b.source);
        });
        return std::move(terms_);
    }

private:
    void found(int ray, Source source, const Color& weighed) {
        const RayRecord& r = record_.rays[static_cast<std::size_t>(ray)];
        if (!(r.foundMis > 0)) return;
        add({.source = source,
             .ray = ray,
             .throughput = throughputTo(r),
             .mis = r.foundMis,
             .radiance = weighed / r.foundMis});
    }

    void light(int index, Source source, const Color& weighed, float mis) {
        const LampTerm& lamp = record_.lamps[static_cast<std::size_t>(index)];
        if (!(mis > 0)) return;
        add({.source = source,
             .ray = lamp.ray,
             .lamp = index,
             .throughput = throughputTo(record_.rays[static_cast<std::size_t>(lamp.ray)]),
             .scattered = weighed / (kPi * mis),
             .pdfW = lamp.pdfW,
             .mis = mis,
             .radiance = lamp.irradiance * (lamp.pdfW > 0 ? kPi * lamp.pdfW : kPi),
             .visibility = lamp.visibility});
    }

    void add(PathTerm term) {
        term.value = productOf(term);
        if (!isBlack(term.value)) terms_.push_back(term);
    }

    const SampleRecord& record_;
    std::vector<PathTerm> terms_;
};

}

std::vector<PathTerm> pathTermsOf(const SampleRecord& record) {
    return record.physical ? Collector(record).collect() : std::vector<PathTerm>{};
}

DVec3 sumOf(const std::vector<PathTerm>& terms) {
    DVec3 sum(0);
    for (const PathTerm& term : terms) sum += DVec3(term.value);
    return sum;
}

std::string wayOf(const Scene& scene, const SampleRecord& record, const PathTerm& term) {
    const RayRecord& ray = record.rays[static_cast<std::size_t>(term.ray)];
    if (term.source == Source::Background) return fmt::format("the sky, by ray #{}", term.ray);
    const std::string place = fmt::format("{} #{}", objectName(scene, ray.hit.object), term.ray);
    if (term.source == Source::Emission) return "glow of " + place;
    const std::string lamp = lampName(scene, record.lamps[static_cast<std::size_t>(term.lamp)].light);
    return fmt::format("{} at {}{}", lamp, place, term.source == Source::SpecularLight ? ", mirrored" : "");
}

std::string factorsOf(const PathTerm& t) {
    std::string text = amountText(t.throughput);
    const auto times = [&](const Color& c) {
        if (c != Color(1)) text += " · " + amountText(c);
    };
    times(t.scattered);
    if (t.pdfW > 0) text += fmt::format(" / {:.3g}", t.pdfW);
    times(Color(t.mis));
    times(t.radiance);
    times(t.visibility);
    return text;
}

}
