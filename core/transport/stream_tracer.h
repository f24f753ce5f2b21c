// Whitted's recursion depth by depth. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_STREAM_TRACER_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_STREAM_TRACER_H
#undef EYERAY_STREAM_TRACER_H
#else
#define EYERAY_STREAM_TRACER_H
#endif

#include "core/transport/integrator.h"
#include "core/transport/next_rays.h"
#include "core/transport/stream_hits.h"
#include "core/transport/stream_materials.h"
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
        sortByMaterial(world_, rays);
        RayStream& next = memory_.stream(depth + 1);
        next.size = 0;
        for (std::size_t place = 0; place < rays.ends.back();) {
            if (next.size + 2 * kLanes > kStreamCapacity) traceNext(depth);
            const Batch batch = batchAt(world_, rays, place);
            place += batch.count;
            shade(rays, batch, next, static_cast<int>(depth));
        }
        traceNext(depth);
        for (std::size_t i = 0; i < rays.size; i += kLanes) {
            const Vec3Lanes sum = load(rays.direct, i) + load(rays.onward, i);
            store(glass_.attenuates ? sum * load(rays.transmitted, i) : sum, rays.direct, i);
        }
    }

private:
    /// Traces what has gathered in the next stream, and hands its light back.
    void traceNext(std::size_t depth) {
        RayStream &rays = memory_.stream(depth), &next = memory_.stream(depth + 1);
        if (next.size == 0) return;
        trace(depth + 1);
        for (std::size_t i = 0; i < next.size;) i += handBack(next, i, rays);
        next.size = 0;
    }

    /// To the parents of the rays from `i` on, as far as these lie side by side; returns how many.
    static std::size_t handBack(const RayStream& rays, std::size_t i, RayStream& parents) {
        const IntTag n;
        const std::uint32_t first = rays.parent[i];
        const auto together = loadInts(rays.parent, i) == countedFrom(first);
        const std::uint32_t run =
            ~bitsOf(hn::RebindMask(FloatTag(), hn::And(together, hn::FirstN(n, rays.size - i))));
        const auto count = static_cast<std::size_t>(std::countr_zero(run));
        const Vec3Lanes sum = load(parents.onward, first) + load(rays.share, i) * load(rays.direct, i);
        storeFirst(count, sum, parents.onward, first);
        return count;
    }

    /// And the background, what the media on the way leave, and nothing onward yet.
    void findHits(RayStream& rays) {
        if (!rays.hitsKnown) closestHits(geometry_, rays);
        for (std::size_t i = 0; i < rays.size; i += kLanes) {
            store(all(Color(0)), rays.onward, i);
            if (!hn::AllFalse(IntTag(), loadInts(rays.instance, i) == missed()))
                store(radianceOf(world_.scene->environment, load(rays.direction, i)), rays.direct, i);
        }
        if (glass_.attenuates) findTransmittance(rays);
    }

    void findTransmittance(RayStream& rays) {
        const auto sigmaOf = [&](std::uint32_t medium) {
            return attenuationIn(world_, memory_.media.at(medium));
        };
        const bool firstIsClear = isBlack(sigmaOf(0)); // most rays run in the medium of the eye
        for (std::size_t i = 0; i < rays.size; i += kLanes) {
            const IntTag n;
            const auto others = loadInts(rays.media, i) != hn::Zero(n);
            if (firstIsClear && hn::AllFalse(n, hn::And(others, hn::FirstN(n, rays.size - i)))) {
                store(all(Color(1)), rays.transmitted, i);
                continue;
            }
            for (std::size_t k = i; k < std::min(i + kLanes, rays.size); ++k)
                rays.transmitted.set(k, transmittanceOf(sigmaOf(rays.media[k]), rays.t[k]));
        }
    }

    void shade(RayStream& rays, const Batch& batch, RayStream& next, int depth) {
        const RayLanes lanes{batch.of(rays.origin), batch.of(rays.direction), all(0.0F), all(kInfinity)};
        const HitLanes hits{batch.of(rays.t), batch.of(rays.u), batch.of(rays.v), batch.of(rays.primitive),
                            batch.of(rays.instance)};
        const SurfaceLanes at = surfacesAt(geometry_, lanes, hits, batch.active);
        const ShadingLanes p = shadingOf(at, lanes.direction);
        const std::uint32_t material = materialOfRay(world_, rays, batch.first);
        const MaterialLanes m =
            materialAt(world_, geometry_, material, at.position, hits, batch.active, surfaces_);
        const IntLanes media = batch.of(rays.media);
        const Vec3Lanes origin = spawnOrigin(at, p.geometricNormal);
        batch.put(directLight(batch, p, m, media, origin), rays.direct);
        if (depth < context_.settings.maxDepth) sendOn(rays, batch, p, m, media, hits.instance, origin, next);
    }

    /// As directLight of one point. `origin`: of rays on this side of the surface.
    Vec3Lanes directLight(const Batch& batch, const ShadingLanes& p, const MaterialLanes& m, IntLanes media,
                          const Vec3Lanes& origin) {
        const FloatTag f;
        Vec3Lanes radiance = m.of(&Surface::emission) + m.ambient() * all(world_.scene->ambient);
        if (m.isBlack(&Surface::diffuse) && m.isBlack(&Surface::specular)) return radiance;
        for (const WorldLight& light : context_.lights) {
            const LightLanes sample = sampleLight(light, p.at.position);
            auto asked = hn::And(batch.active, sample.shines);
            if (hn::AllFalse(f, asked)) continue;
            const Vec3Lanes local = localModel(p, m, sample.wi, asked);
            Vec3Lanes arriving = local * (sample.irradiance / all(kPi));
            asked = hn::And(asked, hn::And(notBlack(local), notBlack(arriving)));
            if (hn::AllFalse(f, asked)) continue;
            if (context_.settings.shadows) {
                const RayLanes rays{origin + p.at.lift, sample.wi, all(0.0F),
                                    sample.distance * all(kBeforeLamp)};
                counts_[RayKind::Shadow] += hn::CountTrue(f, asked);
                arriving =
                    arriving * visibility(context_, geometry_, glass_, rays, asked, {memory_.media, media});
            }
            radiance = radiance + orZero(asked, arriving);
        }
        return radiance;
    }

    /// As onward of one point.
    void sendOn(const RayStream& rays, const Batch& batch, const ShadingLanes& p, const MaterialLanes& m,
                IntLanes media, IntLanes instances, const Vec3Lanes& origin, RayStream& next) {
        const FloatTag f;
        const TraceSettings& settings = context_.settings;
        const bool noGlass = m.isBlack(&Surface::transmission);
        if (noGlass && m.isBlack(&Surface::reflectivity) && m.isBlack(&Surface::grazingReflectivity)) return;
        const auto transmits = hn::And(batch.active, notBlack(m.of(&Surface::transmission)));
        const auto reflects =
            hn::Or(notBlack(m.of(&Surface::reflectivity)), notBlack(m.of(&Surface::grazingReflectivity)));
        const auto goesOn = hn::And(batch.active, hn::Or(transmits, reflects));
        if (hn::AllFalse(f, goesOn)) return;
        NextLanes onward = mirrored(p, m, settings.fresnel);
        InterfaceLanes interface{all(1.0F), p.front, media};
        if (!noGlass) {
            interface = interfacesAt(instances, p.front, media, transmits);
            addGlass(p, m, settings.fresnel, interface.eta, interface.solid, onward);
        }
        Vec3Lanes weight = batch.of(rays.weight);
        if (glass_.attenuates) weight = weight * batch.of(rays.transmitted);
        const Parents parents{batch.rays, batch.of(rays.sample), p, origin, weight, goesOn};
        if (settings.reflections)
            append(parents, {RayKind::Reflection, onward.reflection, onward.reflectedShare, media}, next);
        if (settings.refractions)
            append(parents, {RayKind::Refraction, onward.refraction, onward.refractedShare, interface.beyond},
                   next);
    }

    /// As Interface, and whether the surface has an inside.
    struct InterfaceLanes {
        FloatLanes eta;
        FloatMask solid;
        IntLanes beyond;
    };

    /// Those of the `asked` lanes; lanes that meet the same side of the same object in the same media
    /// together.
    InterfaceLanes interfacesAt(IntLanes instances, FloatMask front, IntLanes media, FloatMask asked) {
        const FloatTag f;
        const IntTag n;
        InterfaceLanes result{all(1.0F), hn::MaskFromVec(hn::Zero(f)), media};
        const SpreadInt numbers = spread(media);
        eachInstance(instances, asked, [&](std::uint32_t id, FloatMask there) HWY_ATTR {
            const WorldObject& object = world_.objects[id];
            if (object.solid) result.solid = hn::Or(result.solid, there);
            while (!hn::AllFalse(f, there)) {
                const auto lane = static_cast<std::size_t>(hn::FindKnownFirstTrue(f, there));
                const std::uint32_t number = numbers.at(lane);
                const bool isFront = ((bitsOf(front) >> lane) & 1U) != 0;
                const auto sameMedia = media == hn::Set(n, static_cast<std::int32_t>(number));
                const auto alike =
                    hn::And(hn::And(there, hn::RebindMask(f, sameMedia)), isFront ? front : hn::Not(front));
                const Crossing& crossing = crossingOf(id, isFront, number);
                const auto beyond = hn::Set(n, static_cast<std::int32_t>(crossing.beyond));
                result.eta = hn::IfThenElse(alike, all(crossing.eta), result.eta);
                result.beyond = hn::IfThenElse(hn::RebindMask(n, alike), beyond, result.beyond);
                there = hn::AndNot(alike, there);
            }
        });
        return result;
    }

    /// Interface of a side of an object, met in a medium.
    struct Crossing {
        std::uint32_t object = ~0U;
        bool front = false;
        std::uint32_t medium = 0, beyond = 0; // by number
        float eta = 1;
    };

    const Crossing& crossingOf(std::uint32_t id, bool front, std::uint32_t medium) {
        Crossing& known = crossings_[(2 * id + (front ? 1 : 0) + 8 * medium) % crossings_.size()];
        if (known.object == id && known.front == front && known.medium == medium) return known;
        const WorldObject& object = world_.objects[id];
        const float ior = world_.materials[object.material].surface.ior;
        const Interface interface =
            interfaceAt(world_, {.instance = id, .solid = object.solid, .front = front, .ior = ior},
                        memory_.media.at(medium));
        known = {id, front, medium, memory_.media.numberOf(interface.beyond), interface.eta};
        return known;
    }

    /// Rays of a batch that may go on.
    struct Parents {
        IntLanes ray, sample;
        const ShadingLanes& p;
        const Vec3Lanes& origin; // of rays on this side of the surface
        Vec3Lanes weight;        // of their radiance at the hit
        FloatMask goOn;
    };

    struct Onward {
        RayKind kind;
        Vec3Lanes direction, share;
        IntLanes media;
    };

    /// Adds to the next stream the rays that are worth tracing.
    void append(const Parents& parents, const Onward& onward, RayStream& next) {
        const FloatTag f;
        const Vec3Lanes weight = parents.weight * onward.share;
        const auto largest = maxComponent(weight);
        const auto worth =
            hn::And(parents.goOn, hn::And(largest > hn::Zero(f), largest >= all(context_.settings.cutoff)));
        if (hn::AllFalse(f, worth)) return;
        compress(originTowards(parents, onward.direction, worth), worth, next.origin, next.size);
        compress(onward.direction, worth, next.direction, next.size);
        compress(onward.share, worth, next.share, next.size);
        compress(weight, worth, next.weight, next.size);
        compress(onward.media, worth, next.media, next.size);
        compress(parents.ray, worth, next.parent, next.size);
        compress(parents.sample, worth, next.sample, next.size);
        const std::size_t count = hn::CountTrue(f, worth);
        counts_[onward.kind] += count;
        next.size += count;
    }

    /// Where the `asked` rays of this direction start.
    static Vec3Lanes originTowards(const Parents& parents, const Vec3Lanes& direction, FloatMask asked) {
        const SurfaceLanes& at = parents.p.at;
        const auto below = isNegative(dot(at.geometricNormal, direction));
        const auto elsewhere = hn::And(asked, hn::Not(hn::Xor(below, parents.p.front)));
        return hn::AllFalse(FloatTag(), elsewhere) ? parents.origin : spawnOrigin(at, direction);
    }

    const TraceContext& context_;
    const World& world_;
    const IndexedGeometry<Index>& geometry_;
    GlassNeeds glass_;
    RayCounts& counts_;
    StreamMemory& memory_;
    std::array<Crossing, 64> crossings_;   // the last ones
    std::array<Surface, kLanes> surfaces_; // of a batch
    bool outgrown_ = false;
    // Two rays go on from a hit at most, so that a tree has less than 2^(depth + 1) of them.
    const bool mayOutgrow_ = context_.settings.maxDepth + 1 > std::countr_zero(unsigned{kMaxTreeNodes});
};

}
HWY_AFTER_NAMESPACE();

#endif
