// Whitted's recursion depth by depth. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_STREAM_TRACER_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_STREAM_TRACER_H
#undef EYERAY_STREAM_TRACER_H
#else
#define EYERAY_STREAM_TRACER_H
#endif

#include "core/scene/world_surface.h"
#include "core/transport/integrator.h"
#include "core/transport/next_rays.h"
#include "core/transport/stream_batch.h"
#include "core/transport/stream_shading.h"
#include "core/transport/stream_visibility.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

template <class Index>
class StreamTracer {
public:
    /// `streams` are memory for the rays of each depth.
    StreamTracer(const TraceContext& context, const IndexedGeometry<Index>& geometry, RayCounts& counts,
                 StreamMemory& memory)
        : context_(context), world_(*context.world), geometry_(geometry), glass_(world_), counts_(counts),
          memory_(memory) {}

    /// Whether the tree of a sample has more than kMaxTreeNodes rays.
    bool outgrown() const { return outgrown_; }

    /// Traces the rays in the stream of a depth and leaves their radiance in `direct`.
    void trace(std::size_t depth) {
        RayStream& rays = memory_.stream(depth);
        counts_.deepest = std::max(counts_.deepest, static_cast<int>(depth));
        for (std::size_t i = 0; i < rays.size && mayOutgrow_; ++i)
            outgrown_ |= ++memory_.treeNodes[rays.sample[i]] > kMaxTreeNodes;
        if (outgrown_ || context_.stop.stop_requested()) return;
        findHits(rays);
        sortByMaterial(rays);
        RayStream& next = memory_.stream(depth + 1);
        next.size = 0;
        for (std::size_t first = 0; first < rays.ordered;) {
            if (next.size + 2 * kLanes > RayStream::kCapacity) traceNext(depth);
            const Batch batch = batchAt(rays, first);
            first += batch.count;
            shade(rays, batch, next, static_cast<int>(depth));
        }
        traceNext(depth);
        for (std::size_t i = 0; i < rays.size; i += kLanes)
            store((load(rays.direct, i) + load(rays.onward, i)) * load(rays.transmitted, i), rays.direct, i);
    }

private:
    /// Traces what has gathered in the next stream, and hands its light back.
    void traceNext(std::size_t depth) {
        RayStream &rays = memory_.stream(depth), &next = memory_.stream(depth + 1);
        if (next.size == 0) return;
        trace(depth + 1);
        for (std::size_t i = 0; i < next.size; ++i) {
            const std::uint32_t parent = next.parent[i];
            rays.onward.set(parent, rays.onward.at(parent) + next.share.at(i) * next.direct.at(i));
        }
        next.size = 0;
    }

    /// And the transmittance of the media on the way, the background, and nothing onward yet.
    void findHits(RayStream& rays) {
        const IntTag n;
        for (std::size_t i = 0; i < rays.size; i += kLanes) {
            const RayLanes lanes{load(rays.origin, i), load(rays.direction, i), all(0.0F), all(kInfinity)};
            const auto there = hn::FirstN(FloatTag(), rays.size - i);
            const HitLanes hits = closestHits(geometry_, lanes, there, RayMask::All);
            store(hits.t, rays.t, i), store(hits.u, rays.u, i), store(hits.v, rays.v, i);
            store(hits.primitive, rays.primitive, i);
            store(hn::IfThenElse(hn::RebindMask(n, hits.met()), hits.instance, hn::Set(n, -1)), rays.instance,
                  i);
            store(all(Color(0)), rays.onward, i);
            store(all(Color(1)), rays.transmitted, i);
            store(radianceOf(world_.scene->environment, lanes.direction), rays.direct, i);
        }
        if (!glass_.attenuates) return;
        for (std::size_t i = 0; i < rays.size; ++i)
            rays.transmitted.set(i, transmittanceOf(attenuationIn(world_, rays.media[i]), rays.t[i]));
    }

    std::uint32_t materialOfRay(const RayStream& rays, std::size_t i) const {
        return world_.objects[rays.instance[i]].material;
    }

    void sortByMaterial(RayStream& rays) const {
        constexpr std::size_t kMostBuckets = 256;
        const std::size_t buckets = std::min(kMostBuckets, world_.materials.size());
        std::array<std::uint32_t, kMostBuckets + 1> starts{};
        const auto hit = [&](std::size_t i) { return rays.instance[i] != RayStream::kMissed; };
        for (std::size_t i = 0; i < rays.size; ++i)
            if (hit(i)) ++starts[materialOfRay(rays, i) % buckets + 1];
        for (std::size_t i = 1; i <= buckets; ++i) starts[i] += starts[i - 1];
        rays.ordered = starts[buckets];
        for (std::uint32_t i = 0; i < rays.size; ++i)
            if (hit(i)) rays.order[starts[materialOfRay(rays, i) % buckets]++] = i;
    }

    Batch batchAt(const RayStream& rays, std::size_t first) const {
        const std::uint32_t* order = &rays.order[first];
        const std::size_t most = std::min(kLanes, rays.ordered - first);
        std::size_t count = 1;
        while (count < most && materialOfRay(rays, order[count]) == materialOfRay(rays, order[0])) ++count;
        return Batch(order, count);
    }

    void shade(RayStream& rays, const Batch& batch, RayStream& next, int depth) {
        const RayLanes lanes{batch.of(rays.origin), batch.of(rays.direction), all(0.0F), all(kInfinity)};
        const HitLanes hits{batch.of(rays.t), batch.of(rays.u), batch.of(rays.v), batch.of(rays.primitive),
                            batch.of(rays.instance)};
        const SurfaceLanes at = surfacesAt(geometry_, lanes, hits, batch.active);
        const ShadingLanes p = shadingOf(at, lanes.direction);
        const MaterialLanes m = materialAt(batch, materialOfRay(rays, batch.ray[0]), at, hits);
        MediumLanes media;
        if (glass_.any)
            for (std::size_t lane = 0; lane < kLanes; ++lane) media[lane] = rays.media[batch.ray[lane]];
        batch.put(directLight(batch, p, m, media), rays.direct);
        if (depth < context_.settings.maxDepth) sendOn(rays, batch, p, m, media, next);
    }

    MaterialLanes materialAt(const Batch& batch, std::uint32_t id, const SurfaceLanes& at,
                             const HitLanes& hits) const {
        const WorldMaterial& material = world_.materials[id];
        const HitSpread hit(hits);
        const auto varies = [&](std::size_t lane) {
            return material.varies || world_.objects[hit.instance.at(lane)].vertexColors;
        };
        MaterialLanes m = materialOf(material.surface);
        bool any = false;
        if (world_.needs.textures) eachLane(batch.active, [&](std::size_t lane) { any |= varies(lane); });
        if (!any) return m;
        const Spread3 positions = spread(at.position);
        const auto* taught = std::get_if<TaughtMaterial>(&material.model);
        Spread3 factors = spread(all(Color(1)));
        std::array<Surface, kLanes> surfaces;
        eachLane(batch.active, [&](std::size_t lane) {
            surfaces[lane] = material.surface;
            if (!varies(lane)) return;
            SurfacePoint point;
            point.position = positions.at(lane);
            const auto uv = [&](int set) { return textureCoordinates(geometry_, point, hit.at(lane), set); };
            const Color color(vertexColor(geometry_, hit.at(lane)));
            if (taught != nullptr)
                factors.set(lane, eyeray::detail::diffuseFactor(*world_.scene, *taught, uv, color));
            else
                surfaces[lane] = eyeray::surfaceAt(world_, material, uv, color);
        });
        if (taught == nullptr) return materialOf(surfaces);
        m.ambient = m.ambient * gathered(factors);
        m.diffuse = m.diffuse * gathered(factors);
        return m;
    }

    /// As directLight of one point.
    Vec3Lanes directLight(const Batch& batch, const ShadingLanes& p, const MaterialLanes& m,
                          const MediumLanes& media) {
        const FloatTag f;
        Vec3Lanes radiance = m.emission + m.ambient * all(world_.scene->ambient);
        const Vec3Lanes origin = shadowOrigin(p);
        for (const WorldLight& light : context_.lights) {
            const LightLanes sample = sampleLight(light, p.at.position);
            auto asked = hn::And(batch.active, sample.shines);
            if (hn::AllFalse(f, asked)) continue;
            Vec3Lanes arriving = localModel(p, m, sample.wi, asked) * (sample.irradiance / all(kPi));
            asked = hn::And(asked, notBlack(arriving));
            if (hn::AllFalse(f, asked)) continue;
            if (context_.settings.shadows) {
                const RayLanes rays{origin, sample.wi, all(0.0F), sample.distance * all(kBeforeLamp)};
                counts_[RayKind::Shadow] += hn::CountTrue(f, asked);
                arriving = arriving * visibility(context_, geometry_, glass_, rays, asked, media);
            }
            radiance = radiance + orZero(asked, arriving);
        }
        return radiance;
    }

    /// As onward of one point.
    void sendOn(const RayStream& rays, const Batch& batch, const ShadingLanes& p, const MaterialLanes& m,
                MediumLanes& media, RayStream& next) {
        const FloatTag f;
        const TraceSettings& settings = context_.settings;
        const auto transmits = hn::And(batch.active, notBlack(m.transmission));
        const auto reflects = hn::Or(notBlack(m.reflectivity), notBlack(m.grazingReflectivity));
        const auto goesOn = hn::And(batch.active, hn::Or(transmits, reflects));
        if (hn::AllFalse(f, goesOn)) return;
        NextLanes onward = mirrored(p, m, settings.fresnel);
        const MediumLanes before = media;
        if (!hn::AllFalse(f, transmits)) {
            Spread eta = spread(m.ior);
            const Spread ior = spread(m.ior);
            std::uint32_t solid = 0;
            const std::uint32_t front = bitsOf(p.front);
            eachLane(transmits, [&](std::size_t lane) {
                const std::uint32_t instance = rays.instance[batch.ray[lane]];
                const Side side{.instance = instance,
                                .solid = world_.objects[instance].solid,
                                .front = ((front >> lane) & 1U) != 0,
                                .ior = ior.lane[lane]};
                const Interface interface = interfaceAt(world_, side, before[lane]);
                eta.lane[lane] = interface.eta;
                media[lane] = interface.beyond;
                solid |= (side.solid ? 1U : 0U) << lane;
            });
            addGlass(p, m, settings.fresnel, gathered(eta), maskOf(solid), onward);
        }
        const Vec3Lanes weight = batch.of(rays.weight) * batch.of(rays.transmitted);
        if (settings.reflections)
            append(rays, batch, p.at, goesOn, {onward.reflection, onward.reflectedShare, weight}, before,
                   RayKind::Reflection, next);
        if (settings.refractions)
            append(rays, batch, p.at, goesOn, {onward.refraction, onward.refractedShare, weight}, media,
                   RayKind::Refraction, next);
    }

    struct Onward {
        Vec3Lanes direction, share, weight; // the weight of the parent's radiance at the hit
    };

    /// Adds to the next stream the rays that are worth tracing.
    void append(const RayStream& rays, const Batch& batch, const SurfaceLanes& at, FloatMask asked,
                const Onward& onward, const MediumLanes& media, RayKind kind, RayStream& next) {
        const FloatTag f;
        const Vec3Lanes weight = onward.weight * onward.share;
        const auto largest = maxComponent(weight);
        const auto worth =
            hn::And(asked, hn::And(largest > hn::Zero(f), largest >= all(context_.settings.cutoff)));
        if (hn::AllFalse(f, worth)) return;
        compress(spawnOrigin(at, onward.direction), worth, next.origin, next.size);
        compress(onward.direction, worth, next.direction, next.size);
        compress(onward.share, worth, next.share, next.size);
        compress(weight, worth, next.weight, next.size);
        counts_[kind] += hn::CountTrue(f, worth);
        eachLane(worth, [&](std::size_t lane) {
            next.media[next.size] = media[lane];
            next.parent[next.size] = batch.ray[lane];
            next.sample[next.size] = rays.sample[batch.ray[lane]];
            ++next.size;
        });
    }

    const TraceContext& context_;
    const World& world_;
    const IndexedGeometry<Index>& geometry_;
    GlassNeeds glass_;
    RayCounts& counts_;
    StreamMemory& memory_;
    bool outgrown_ = false;
    // Two rays go on from a hit at most, so that a tree has less than 2^(depth + 1) of them.
    const bool mayOutgrow_ = context_.settings.maxDepth + 1 > std::countr_zero(unsigned{kMaxTreeNodes});
};

}
HWY_AFTER_NAMESPACE();

#endif
