#pragma once
// The layer that the viewer shows, traced in the background.

#include <memory>
#include <optional>

#include "app/viewer/background_job.h"
#include "core/study/layer_film.h"

namespace eyeray {

/// What a layer is traced from.
struct LayerRequest {
    Layer layer;
    std::shared_ptr<const World> world;
    Camera camera;
    RenderSettings settings;
    int threads = 0;

    friend bool operator==(const LayerRequest&, const LayerRequest&) = default;
};

/// Used by one thread, which never waits but in wait(). What is shown stays until something newer of the
/// whole picture is there: first a coarse film of fewer pixels, then the picture's own.
class LayerRendering {
public:
    /// Traces this layer; nothing happens if it is the last request again.
    void show(const LayerRequest&);
    void clear();

    /// Takes over what has been traced; true if something that a window shows may have changed. Throws what
    /// the tracing has thrown.
    bool update();
    bool active() const { return job_.running(); }
    void wait() const { job_.wait(); }

    /// Null as long as there is nothing to show.
    const std::shared_ptr<const LayerFilm>& film() const { return shown_; }
    /// Samples per pixel that it is traced with.
    int samplesInAll() const { return request_ ? request_->settings.stop.samples : 0; }

private:
    std::optional<LayerRequest> request_;
    struct Films; // of the last request, as the job makes them
    std::shared_ptr<Films> films_;
    std::shared_ptr<const LayerFilm> shown_;
    BackgroundJob<bool> job_;
};

}
