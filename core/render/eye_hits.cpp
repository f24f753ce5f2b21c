#include "core/render/eye_hits.h"

#include <bit>

#include "core/render/film.h"

namespace eyeray {

namespace {

constexpr std::size_t kTilePixels = std::size_t{kTileSize} * kTileSize;

std::size_t samplesOfTile(int step) { return kTilePixels / static_cast<std::size_t>(step * step); }

/// Those of all finer steps, which are powers of two: a geometric series.
std::size_t samplesBefore(int step) { return (kTilePixels - samplesOfTile(step)) * 4 / 3; }

}

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
    if (steps_.size() != count) allocate(count);
    steps_.assign(count, 0);
    key_ = std::move(key);
}

void EyeHits::allocate(std::size_t tiles) {
    const std::size_t samples = tiles * samplesBefore(2 * kTileSize);
    for (auto* column : {&t_, &u_, &v_}) *column = std::make_unique_for_overwrite<float[]>(samples);
    for (auto* column : {&primitive_, &instance_})
        *column = std::make_unique_for_overwrite<std::uint32_t[]>(samples);
}

void EyeHits::lend(int index, Tile& tile) {
    if (!key_) return;
    const auto i = static_cast<std::size_t>(index);
    const std::size_t first = samplesBefore(tile.step) * steps_.size() + i * samplesOfTile(tile.step);
    tile.hits = {&t_[first],         &u_[first],        &v_[first],
                 &primitive_[first], &instance_[first], (steps_[i] & tile.step) != 0};
}

void EyeHits::takeBack(int index, const Tile& tile) {
    if (key_) steps_[static_cast<std::size_t>(index)] |= static_cast<std::uint8_t>(tile.step);
}

}
