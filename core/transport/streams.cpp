#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/transport/streams.cpp"
#include <hwy/foreach_target.h>

#include "core/transport/stream_tracer.h"
#include "core/transport/streams.h"
#include "core/transport/valid_sample.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// The samples of a tile, as many at a time as a stream takes.
template <class Index>
class TileSamples {
public:
    TileSamples(const TraceContext& context, const IndexedGeometry<Index>& geometry, TileResult& result)
        : context_(context), result_(result), eye_(memory().stream(0)),
          tracer_(context, geometry, result.counts, memory()) {
        eye_.size = 0;
    }

    void add(int x, int y, int pass) {
        const SampleAddress address{context_.seed, static_cast<std::uint32_t>(x),
                                    static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(pass)};
        const Ray ray = context_.eyeRays.through(x, y, pixelSample(address));
        const std::size_t i = eye_.size++;
        eye_.origin.set(i, ray.origin);
        eye_.direction.set(i, ray.direction);
        eye_.weight.set(i, Color(1));
        eye_.media[i] = context_.eyeMedia;
        eye_.sample[i] = static_cast<std::uint32_t>(i);
        if (eye_.size == RayStream::kCapacity) trace();
    }

    /// True if no tree was too large.
    bool finish() {
        trace();
        return !tracer_.outgrown();
    }

private:
    static StreamMemory& memory() {
        thread_local StreamMemory memory;
        return memory;
    }

    void trace() {
        memory().treeNodes.assign(eye_.size, 0);
        result_.counts[RayKind::Eye] += eye_.size;
        tracer_.trace(0);
        for (std::size_t i = 0; i < eye_.size; ++i)
            result_.radiance.push_back(validSample(eye_.direct.at(i), result_.counts));
        eye_.size = 0;
    }

    const TraceContext& context_;
    TileResult& result_;
    RayStream& eye_;
    StreamTracer<Index> tracer_;
};

bool traceTileByStreams(const TraceContext& context, int pass, TileResult& result) {
    const Tile& tile = result.tile;
    return std::visit(
        [&]<class Index>(const IndexedGeometry<Index>& geometry) {
            TileSamples<Index> samples(context, geometry, result);
            eachTraced(tile, [&](int x, int y) {
                if (!context.stop.stop_requested()) samples.add(x, y, pass);
            });
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
