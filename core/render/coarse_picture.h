#pragma once
// Pictures of large blocks, which are whole within a frame.

#include <functional>
#include <optional>
#include <span>
#include <stop_token>

#include "core/base/thread_pool.h"

namespace eyeray {

/// Chooses the size of the blocks: by how long one block of the picture before took, and then by how long
/// those of a few tiles take.
class CoarsePicture {
public:
    static constexpr int kCoarsestStep = 32, kFinestStep = 4;

    /// Calls traceTile(tile, step) by all threads for each of the tiles, once with the step that it returns:
    /// the finest of these powers of two that is foreseen to take no longer than `seconds`. Unless that is
    /// infinite, a few tiles are traced before the others, perhaps with another step. Nothing if `stop` was
    /// requested. Throws what traceTile throws.
    std::optional<int> trace(ThreadPool&, std::span<const int> tiles, double seconds,
                             const std::stop_token& stop,
                             const std::function<void(int tile, int step)>& traceTile);

private:
    int stepWithin(double seconds, std::size_t tiles) const;

    double secondsPerBlock_ = -1; // on all threads; negative before the first picture
};

}
