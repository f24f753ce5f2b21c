#pragma once
// The loop over a tile's pixels that every method shares: it is specialised once per tile, then nothing is
// virtual.

#include "core/transport/direct_light.h"
#include "core/transport/integrator.h"
#include "core/transport/streams.h"
#include "core/transport/valid_sample.h"

namespace eyeray {

/// The ray through a sample's place in its pixel.
template <class Index, class Recorder>
Ray eyeRayOf(const SampleState<Index, Recorder>& state) {
    const auto faults = state.faults();
    const TraceContext& context = state.context;
    const int x = static_cast<int>(state.address.x), y = static_cast<int>(state.address.y);
    Vec2 inPixel = pixelSample(state.address);
    if (faults.has(Fault::CentreSampling)) inPixel = Vec2(0.5F);
    if (faults.has(Fault::CornerSampling)) inPixel -= Vec2(0.5F);
    return context.eyeRays.through(x, faults.has(Fault::FlippedRows) ? context.height - 1 - y : y, inPixel);
}

/// An Integrator from a method: a type with
/// `template <Features F, class Index, class Recorder> static Color radiance(SampleState<Index, Recorder>&,
/// const Ray& eyeRay)`. One with a member kByStreams has renderByStreams for a fast twin.
template <class Method>
class TiledIntegrator final : public Integrator {
public:
    TileResult renderTile(const TraceContext& context, const Tile& tile, int pass) const override {
        if constexpr (requires { Method::kByStreams; })
            if (!context.textbook)
                if (auto streamed = renderByStreams(context, tile, pass)) return *std::move(streamed);
        TileResult result{.tile = tile, .radiance = {}, .counts = {}};
        specialised(context, [&]<Features F>(const auto& geometry) {
            NoRecorder recorder;
            eachTraced(tile, [&](int x, int y) {
                if (context.stop.stop_requested()) return;
                const EyeHit eyeHit{tile.hits, result.radiance.size()};
                result.radiance.push_back(
                    sample<F>(context, geometry, result.counts, recorder, x, y, pass, eyeHit));
            });
            result.complete = !context.stop.stop_requested();
        });
        return result;
    }

    Retrace retrace(const TraceContext& context, int x, int y, int pass) const override {
        Retrace result;
        specialised(context, [&]<Features F>(const auto& geometry) {
            TreeRecorder recorder;
            RayCounts counts;
            const Color radiance = sample<F>(context, geometry, counts, recorder, x, y, pass);
            result = {std::move(recorder.record), radiance};
        });
        return result;
    }

    std::optional<RayCounts> retraceTile(const TraceContext& context, const Tile& tile, int pass,
                                         const EachSample& each) const override {
        RayCounts counts;
        specialised(context, [&]<Features F>(const auto& geometry) {
            TreeRecorder recorder; // one for all, so that its memory is taken once
            for (int y = tile.y0; y < tile.y1; ++y)
                for (int x = tile.x0; x < tile.x1 && !context.stop.stop_requested(); ++x) {
                    recorder.clear();
                    const Color radiance = sample<F>(context, geometry, counts, recorder, x, y, pass);
                    each(x, y, recorder.record, radiance);
                }
        });
        return context.stop.stop_requested() ? std::nullopt : std::optional(counts);
    }

private:
    template <class Body>
    static void specialised(const TraceContext& context, const Body& body) {
        if (context.textbook)
            return body.template operator()<Features{.varying = true, .transparent = true}>(
                *context.textbook);
        const SceneNeeds& needs = context.world->needs;
        std::visit(
            [&](const auto& geometry) {
                if (needs.textures && needs.refractions)
                    body.template operator()<Features{.varying = true, .transparent = true}>(geometry);
                else if (needs.textures)
                    body.template operator()<Features{.varying = true, .transparent = false}>(geometry);
                else if (needs.refractions)
                    body.template operator()<Features{.varying = false, .transparent = true}>(geometry);
                else
                    body.template operator()<Features{}>(geometry);
            },
            *context.world->accel);
    }

    template <Features F, class Index, class Recorder>
    static Color sample(const TraceContext& context, const IndexedGeometry<Index>& geometry,
                        RayCounts& counts, Recorder& recorder, int x, int y, int pass,
                        const EyeHit& eyeHit = {}) {
        const SampleAddress address{context.seed, static_cast<std::uint32_t>(x),
                                    static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(pass)};
        SampleState<Index, Recorder> state{context, geometry, counts, recorder, address, eyeHit};
        const Color radiance = Method::template radiance<F>(state, eyeRayOf(state));
        counts.truncatedSamples += state.treeNodes > kMaxTreeNodes ? 1 : 0;
        return validSample(radiance, counts);
    }
};

}
