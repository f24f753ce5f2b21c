#include "core/transport/coat_albedo.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/transport/microfacet.h"
#include "core/transport/optics.h"

namespace eyeray {
namespace {

constexpr std::size_t kCosines = 32, kRoughnesses = 20, kIors = 13;
constexpr int kSamples = 10;          // each way, of the visible normals
constexpr float kLargestRoot = 0.45F; // (η − 1)/(η + 1) at the last node; then η = 1.5 lies on a node, too

/// A place between two nodes of an axis.
struct Between {
    std::size_t node;
    float part;
    Between(float x, std::size_t nodes) {
        const float at = std::clamp(x, 0.0F, 1.0F) * static_cast<float>(nodes - 1);
        node = std::min(static_cast<std::size_t>(at), nodes - 2);
        part = at - static_cast<float>(node);
    }
};

CoatAlbedo mixed(const CoatAlbedo& a, const CoatAlbedo& b, float part) {
    return {glm::mix(a.constant, b.constant, part), glm::mix(a.rising, b.rising, part)};
}

/// Sum over the visible normals at the nodes of a grid in the sampler's square.
CoatAlbedo integrated(float cosine, float roughness, float ior) {
    if (roughness == 0) return {1, fresnelRise(cosine, ior)};
    const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
    const Ggx ggx{roughness * roughness};
    CoatAlbedo sum{0, 0};
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const Vec2 u = (Vec2(i % kSamples, i / kSamples) + 0.5F) / static_cast<float>(kSamples);
        const Vec3 h = ggx.visibleNormal(wo, u), wi = reflected(wo, h);
        if (!(wi.z > 0)) continue;
        const float seen = ggx.maskingShadowing(wo, wi) / ggx.masking(wo);
        sum.constant += seen;
        sum.rising += seen * fresnelRise(glm::dot(wo, h), ior);
    }
    constexpr auto kAll = static_cast<float>(kSamples * kSamples);
    return {sum.constant / kAll, sum.rising / kAll};
}

class Table {
public:
    Table() : directional_(kIors * kRoughnesses * kCosines), mean_(kIors * kRoughnesses) {
        for (std::size_t i = 0; i < kIors; ++i)
            for (std::size_t r = 0; r < kRoughnesses; ++r) fill(i, r);
    }

    CoatAlbedo directional(float cosine, float roughness, float ior) const {
        const Between c(std::sqrt(std::max(0.0F, cosine)), kCosines);
        return across(roughness, ior, [&](std::size_t row) {
            const std::size_t first = row * kCosines + c.node;
            return mixed(directional_[first], directional_[first + 1], c.part);
        });
    }
    CoatAlbedo mean(float roughness, float ior) const {
        return across(roughness, ior, [&](std::size_t row) { return mean_[row]; });
    }

private:
    void fill(std::size_t i, std::size_t r) {
        const float x = static_cast<float>(i) / (kIors - 1), root = kLargestRoot * x * x;
        const float roughness = static_cast<float>(r) / (kRoughnesses - 1);
        const std::size_t row = i * kRoughnesses + r;
        CoatAlbedo* const nodes = &directional_[row * kCosines];
        CoatAlbedo sum{0, 0};
        float weights = 0;
        for (std::size_t c = 0; c < kCosines; ++c) {
            const float s = static_cast<float>(c) / (kCosines - 1);
            nodes[c] = integrated(std::max(s * s, 1e-4F), roughness, (1 + root) / (1 - root));
            const float weight = s * s * s * (c + 1 < kCosines ? 1.0F : 0.5F); // μ dμ with μ = s²
            weights += weight;
            sum.constant += weight * nodes[c].constant;
            sum.rising += weight * nodes[c].rising;
        }
        mean_[row] = {sum.constant / weights, sum.rising / weights};
    }

    template <class ValueOf>
    static CoatAlbedo across(float roughness, float ior, const ValueOf& valueOf) {
        const Between i(std::sqrt(std::fabs(ior - 1) / (ior + 1) / kLargestRoot), kIors);
        const Between r(roughness, kRoughnesses);
        const auto of = [&](std::size_t row) {
            const std::size_t first = row * kRoughnesses + r.node;
            return mixed(valueOf(first), valueOf(first + 1), r.part);
        };
        return mixed(of(i.node), of(i.node + 1), i.part);
    }

    std::vector<CoatAlbedo> directional_, mean_; // by index of refraction, roughness, √cosine
};

const Table& table() {
    static const Table kTable;
    return kTable;
}

}

CoatAlbedo directionalAlbedo(float cosine, float roughness, float ior) {
    if (roughness == 0) return {1, fresnelRise(cosine, ior)};
    return table().directional(cosine, roughness, ior);
}

CoatAlbedo meanAlbedo(float roughness, float ior) { return table().mean(roughness, ior); }

}
