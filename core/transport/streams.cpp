#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/transport/streams.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <numeric>

#include "core/transport/eye_ray_lanes.h"
#include "core/transport/stream_tracer.h"
#include "core/transport/streams.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// The samples of a tile, as many at a time as a stream takes.
template <class Index>
class TileSamples {
public:
    TileSamples(const TraceContext& context, const IndexedGeometry<Index>& geometry, int pass,
                TileResult& result)
        : context_(context), pass_(static_cast<std::uint32_t>(pass)), result_(result),
          eye_(memory_.stream(0)), tracer_(context, geometry, result.counts, memory_) {
        eye_.size = 0;
        const Tile& tile = result.tile;
        eye_.width = tile.wanted.empty()
                         ? static_cast<std::size_t>((tile.x1 - tile.x0 + tile.step - 1) / tile.step)
                         : 0;
        memory_.media.reset(context.eyeMedia);
    }

    void add(int x, int y) {
        memory_.x[eye_.size] = static_cast<std::uint32_t>(x);
        memory_.y[eye_.size] = static_cast<std::uint32_t>(y);
        if (++eye_.size == kStreamCapacity) trace();
    }

    /// True if no tree was too large.
    bool finish() {
        if (eye_.size > 0) trace();
        return !tracer_.outgrown();
    }

private:
    static StreamMemory& memoryOfThread() {
        thread_local StreamMemory memory;
        return memory;
    }

    void makeEyeRays() {
        const EyeRays& rays = context_.eyeRays;
        for (std::size_t i = 0; i < eye_.size && !rays.aimed(); i += kLanes) {
            const BitLanes x = load(memory_.x, i), y = load(memory_.y, i);
            const PlaceLanes inPixel = pixelSample(context_.seed, x, y, pass_);
            store(eyeDirections(rays.frame(), x, y, inPixel), eye_.direction, i);
            store(all(rays.frame().eye), eye_.origin, i);
        }
        for (std::size_t i = 0; i < eye_.size && rays.aimed(); ++i) {
            const SampleAddress address{context_.seed, memory_.x[i], memory_.y[i], pass_};
            const Ray ray = rays.through(static_cast<int>(address.x), static_cast<int>(address.y),
                                         eyeray::pixelSample(address));
            eye_.origin.set(i, ray.origin);
            eye_.direction.set(i, ray.direction);
        }
        for (std::size_t i = 0; i < eye_.size; i += kLanes) store(all(Color(1)), eye_.weight, i);
        std::fill_n(eye_.media.begin(), eye_.size, 0U);
        std::iota(eye_.sample.begin(), eye_.sample.begin() + static_cast<std::ptrdiff_t>(eye_.size), 0U);
    }

    /// Calls each(of the stream, of the tile) for the columns that hits are in, from the next sample on.
    template <class Each>
    void eachHitColumn(const Each& each) {
        const TileHits& kept = result_.tile.hits;
        const std::size_t next = result_.radiance.size();
        each(eye_.t.data(), kept.t + next), each(eye_.u.data(), kept.u + next);
        each(eye_.v.data(), kept.v + next), each(eye_.primitive.data(), kept.primitive + next);
        each(eye_.instance.data(), kept.instance + next);
    }

    void trace() {
        if (!context_.stop.stop_requested()) traceAll();
        eye_.size = 0;
    }

    void traceAll() {
        makeEyeRays();
        memory_.treeNodes.assign(eye_.size, 0);
        result_.counts[RayKind::Eye] += eye_.size;
        eye_.hitsKnown = result_.tile.hits.known;
        if (eye_.hitsKnown)
            eachHitColumn([&](auto* ours, const auto* kept) { std::copy_n(kept, eye_.size, ours); });
        tracer_.trace(0);
        if (result_.tile.hits.kept() && !eye_.hitsKnown)
            eachHitColumn([&](const auto* ours, auto* kept) { std::copy_n(ours, eye_.size, kept); });
        handOver();
    }

    /// As validSample.
    void handOver() {
        const FloatTag f;
        const std::size_t before = result_.radiance.size();
        result_.radiance.resize(before + eye_.size + kLanes);
        for (std::size_t i = 0; i < eye_.size; i += kLanes) {
            const Vec3Lanes c = load(eye_.direct, i);
            const auto valid = hn::And(hn::And(hn::IsFinite(c.x), hn::IsFinite(c.y)), hn::IsFinite(c.z));
            result_.counts.invalidSamples +=
                hn::CountTrue(f, hn::AndNot(valid, hn::FirstN(f, eye_.size - i)));
            const Vec3Lanes kept = orZero(valid, c);
            hn::StoreInterleaved3(kept.x, kept.y, kept.z, f, &result_.radiance[before + i].x);
        }
        result_.radiance.resize(before + eye_.size);
    }

    const TraceContext& context_;
    const std::uint32_t pass_;
    TileResult& result_;
    StreamMemory& memory_ = memoryOfThread();
    RayStream& eye_;
    StreamTracer<Index> tracer_;
};

bool traceTileByStreams(const TraceContext& context, int pass, TileResult& result) {
    const Tile& tile = result.tile;
    return std::visit(
        [&]<class Index>(const IndexedGeometry<Index>& geometry) {
            TileSamples<Index> samples(context, geometry, pass, result);
            eachTraced(tile, [&](int x, int y) { samples.add(x, y); });
            return samples.finish();
        },
        *context.world->accel);
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyeray {

HWY_EXPORT(traceTileByStreams);

std::optional<TileResult> renderByStreams(const TraceContext& context, const Tile& tile, int pass) {
    TileResult result{.tile = tile, .radiance = {}, .counts = {}};
    if (!HWY_DYNAMIC_DISPATCH(traceTileByStreams)(context, pass, result)) return std::nullopt;
    result.complete = !context.stop.stop_requested();
    return result;
}

}
#endif
