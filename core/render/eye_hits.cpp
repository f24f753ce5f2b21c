#include "core/render/eye_hits.h"

#include <algorithm>
#include <bit>

#include "core/geometry/same_instances.h"

namespace eyeray {

namespace {

constexpr std::size_t kTilePixels = std::size_t{kTileSize} * kTileSize;

std::size_t samplesOfTile(int step) { return kTilePixels / static_cast<std::size_t>(step * step); }

/// Those of all finer steps, which are powers of two: a geometric series.
std::size_t samplesBefore(int step) { return (kTilePixels - samplesOfTile(step)) * 4 / 3; }

/// Whether eye rays of the tile may meet the box: not if all of it lies beyond one side of their pyramid,
/// which is a pixel wider than the tile, and by what rounding turns a ray.
bool mayShow(const Tile& tile, const Bounds& box, const EyeRays::Frame& frame) {
    if (box.empty()) return false;
    if (!box.finite()) return true;
    constexpr double kTurn = 1e-6;
    const DVec3 right(frame.halfRight), up(frame.halfUp);
    const DVec2 halves(glm::length(right), glm::length(up)), size(frame.width, frame.height);
    const DVec2 wider = 2.0 / size + kTurn / halves;
    const DVec2 least = 2.0 * DVec2(tile.x0, size.y - tile.y1) / size - 1.0 - wider;
    const DVec2 most = 2.0 * DVec2(tile.x1, size.y - tile.y0) / size - 1.0 + wider;
    std::array<bool, 4> beyond{true, true, true, true};
    for (unsigned corner = 0; corner < 8; ++corner) {
        const DVec3 p = DVec3(corner & 1 ? box.lo.x : box.hi.x, corner & 2 ? box.lo.y : box.hi.y,
                              corner & 4 ? box.lo.z : box.hi.z) -
                        DVec3(frame.eye);
        const double depth = glm::dot(p, DVec3(frame.forward));
        const DVec2 place = DVec2(glm::dot(p, right), glm::dot(p, up)) / (halves * halves);
        beyond[0] &= place.x < least.x * depth;
        beyond[1] &= place.x > most.x * depth;
        beyond[2] &= place.y < least.y * depth;
        beyond[3] &= place.y > most.y * depth;
    }
    return std::ranges::none_of(beyond, [](bool all) { return all; });
}

}

void EyeHits::begin(const TraceContext& context, const RenderSettings& settings, const Film& film) {
    const bool lens = isPhysical(settings.trace.method) && context.eyeRays.hasLens();
    const bool keeps = settings.coarse && settings.firstPass == 0 && !lens && !context.eyeRays.aimed() &&
                       context.textbook == nullptr;
    std::optional<Key> key;
    if (keeps) key = {context.world->accel, std::bit_cast<FrameBits>(context.eyeRays.frame())};
    std::optional<std::vector<Bounds>> changed;
    if (key && key_ && key->frame == key_->frame) changed = changedBounds(*key_->accel, *key->accel);
    key_.reset(); // until there is memory
    if (changed) {
        keepTilesWithout(*changed, context.eyeRays.frame(), film);
    } else {
        const auto tiles = static_cast<std::size_t>(film.tiles());
        if (keeps && steps_.size() != tiles) allocate(tiles); // else what is there is soon needed again
        std::ranges::fill(steps_, 0);
    }
    key_ = std::move(key);
}

/// Forgets the hits of all others.
void EyeHits::keepTilesWithout(std::span<const Bounds> changed, const EyeRays::Frame& frame,
                               const Film& film) {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const Tile tile = film.tile(static_cast<int>(i));
        const bool shows =
            std::ranges::any_of(changed, [&](const Bounds& box) { return mayShow(tile, box, frame); });
        if (shows) steps_[i] = 0;
    }
}

void EyeHits::allocate(std::size_t tiles) {
    steps_.clear(); // until there is memory
    const std::size_t samples = tiles * samplesBefore(2 * kTileSize);
    for (auto* column : {&t_, &u_, &v_}) *column = std::make_unique_for_overwrite<float[]>(samples);
    for (auto* column : {&primitive_, &instance_})
        *column = std::make_unique_for_overwrite<std::uint32_t[]>(samples);
    steps_.resize(tiles);
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
