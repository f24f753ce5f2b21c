#pragma once
// What the eye rays of a picture's first sample hit, for the pictures after it that look at the same surfaces
// from the same place: edits of materials, lamps and settings trace no eye ray twice.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/render/film.h"
#include "core/render/render_settings.h"
#include "core/transport/integrator.h"

namespace eyeray {

/// Of sample 0 alone, which goes through the middle of each pixel whatever the seed, and of coarse pictures,
/// each step by itself: 22 bytes a pixel. Pictures without a coarse one are not watched while they change and
/// keep no hits; nor do those of a lens or of faults, and those whose rays are aimed.
class EyeHits {
public:
    /// For a picture that is about to be traced: forgets all hits unless its eye rays are those of the
    /// picture before. Where a few objects are elsewhere, it forgets those of the tiles that may show them,
    /// now or before.
    void begin(const TraceContext&, const RenderSettings&, const Film&);

    /// Lets a tile of the picture's first sample find or leave its hits. Thread-safe for different tiles, as
    /// is takeBack.
    void lend(int index, Tile&);

    /// The tile is complete.
    void takeBack(int index, const Tile&);

private:
    void keepTilesWithout(std::span<const Bounds> changed, const EyeRays::Frame&, const Film&);
    void allocate(std::size_t tiles);

    // The bits of the floats that tell eye rays of one picture from those of another: 0 and −0 differ.
    using FrameBits = std::array<std::uint32_t, sizeof(EyeRays::Frame) / sizeof(std::uint32_t)>;
    struct Key {
        std::shared_ptr<const Accel> accel;
        FrameBits frame;
        friend bool operator==(const Key&, const Key&) = default;
    };

    std::optional<Key> key_;
    // By step, then tile, then sample. Not initialised: what no step needs is not touched.
    std::unique_ptr<float[]> t_, u_, v_;
    std::unique_ptr<std::uint32_t[]> primitive_, instance_;
    std::vector<std::uint8_t> steps_; // of each tile, added up: those of which its hits are there
};

}
