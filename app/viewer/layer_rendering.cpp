#include "app/viewer/layer_rendering.h"

namespace eyeray {
namespace {

constexpr int kCoarseStep = 4; // pixels

RenderSettings coarser(RenderSettings settings) {
    settings.width = (settings.width + kCoarseStep - 1) / kCoarseStep;
    settings.height = (settings.height + kCoarseStep - 1) / kCoarseStep;
    settings.stop.samples = 1;
    return settings;
}

}

struct LayerRendering::Films {
    std::mutex mutex;
    std::vector<std::shared_ptr<LayerFilm>> films; // ever finer
};

void LayerRendering::show(const LayerRequest& request) {
    if (request_ == request) return;
    request_ = request;
    films_ = std::make_shared<Films>();
    job_.start([request, made = films_](const std::stop_token& stop) {
        for (const RenderSettings& settings : {coarser(request.settings), request.settings}) {
            const auto film =
                std::make_shared<LayerFilm>(std::vector{request.layer}, settings.width, settings.height);
            {
                const std::scoped_lock lock(made->mutex);
                made->films.push_back(film);
            }
            traceLayers(*film, request.world, request.camera, settings, request.threads, stop);
        }
        return true;
    });
}

void LayerRendering::clear() {
    job_.cancel();
    request_.reset();
    films_ = nullptr;
    shown_ = nullptr;
}

bool LayerRendering::update() {
    const bool wasActive = active();
    job_.take();
    if (!films_) return wasActive;
    const std::scoped_lock lock(films_->mutex);
    for (const auto& film : films_->films)
        if (film->passes() > 0) shown_ = film;
    return wasActive;
}

}
