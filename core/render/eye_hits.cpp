#include "core/render/eye_hits.h"

#include <bit>

#include "core/render/film.h"

namespace eyeray {

static_assert(std::size_t{kTileSize} * kTileSize <= TileHits::kPixels);

void EyeHits::begin(const TraceContext& context, const RenderSettings& settings, int tiles) {
    const bool lens = isPhysical(settings.trace.method) && context.eyeRays.hasLens();
    const bool keeps = settings.coarse && settings.firstPass == 0 && !lens && !context.eyeRays.aimed() &&
                       context.textbook == nullptr;
    std::optional<Key> key;
    if (keeps) key = {context.world->accel, std::bit_cast<FrameBits>(context.eyeRays.frame())};
    known_ = keeps && key == key_;
    if (known_) return;
    key_.reset(); // until there is memory
    const auto count = static_cast<std::size_t>(keeps ? tiles : 0);
    if (steps_.size() != count) hits_ = std::make_unique_for_overwrite<TileHits[]>(count);
    steps_.assign(count, 0);
    key_ = std::move(key);
}

void EyeHits::lend(int index, Tile& tile) {
    if (!key_) return;
    const auto i = static_cast<std::size_t>(index);
    tile.hits = &hits_[i];
    tile.hitsKnown = (steps_[i] & (1 | tile.step)) != 0; // step 1 is every pixel
}

void EyeHits::takeBack(int index, const Tile& tile) {
    if (key_) steps_[static_cast<std::size_t>(index)] |= static_cast<std::uint8_t>(tile.step);
}

}
