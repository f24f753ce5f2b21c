#include "core/transport/methods.h"
#include "core/transport/ray_tree.h"
#include "core/transport/tile_loop.h"

namespace eyeray {
namespace {

struct Cast {
    static constexpr bool kByStreams = true;

    template <Features F, class Index, class Recorder>
    static Color radiance(SampleState<Index, Recorder>& state, const Ray& eyeRay) {
        const TreeRay ray{.ray = eyeRay, .media = state.context.eyeMedia};
        return radianceAlong<F>(state, ray, [](const auto&...) { return Color(0); });
    }
};

}

std::unique_ptr<Integrator> makeCast() { return std::make_unique<TiledIntegrator<Cast>>(); }

}
