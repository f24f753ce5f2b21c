#pragma once
// Which of the known mistakes explains a picture that has come out wrong.

#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/thread_pool.h"
#include "core/image/pixels.h"
#include "core/render/render_settings.h"
#include "core/scene/camera.h"
#include "core/scene/world.h"

namespace eyeray {

struct FaultMatch {
    FaultSet faults;           // one, or none
    double rmse = 0;           // of displayed values, 0 to 1, against the picture
    std::size_t differing = 0; // pixels that clearly differ from it
};

struct WrongPixel {
    int x = 0, y = 0;
};

struct NamedBug {
    std::vector<FaultMatch> ranked;       // the best explanation first; no fault at all is among them
    std::size_t pixels = 0;               // of the picture
    std::optional<WrongPixel> firstWrong; // from the top left: no colour between those beside it
};

/// Renders the scene at the picture's size with each fault alone, by the settings' method, and ranks the
/// faults by how much of the picture each leaves unexplained. Nothing if `stop` was requested.
std::optional<NamedBug> nameBug(const std::shared_ptr<const World>&, const Camera&, RenderSettings,
                                const ByteImage& picture, ThreadPool&, const std::stop_token& stop = {});

}
