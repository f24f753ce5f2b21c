#include "core/render/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

namespace eyeray {
namespace {

constexpr double kLargestVariance = 1e4; // in sums with larger ones, small ones would drown

/// The sum of `count` samples whose mean is a multiple of 1/255.
DVec3 roundedMean(const DVec3& sum, int count) {
    constexpr double kCodes = 255;
    return glm::round(glm::clamp(sum / static_cast<double>(count), 0.0, 1.0) * kCodes) / kCodes *
           static_cast<double>(count);
}

std::uint64_t nextFilmId() {
    static std::atomic<std::uint64_t> id = 0;
    return ++id;
}

}

Film::Film(int width, int height) : width_(width), height_(height), id_(nextFilmId()) {
    ENSURE(width >= 1 && height >= 1);
    try {
        for (auto& sum : sums_) sum.resize(pixels());
        for (auto& square : squares_) square.resize(pixels());
        limits_ = std::make_unique_for_overwrite<int[]>(pixels());
        shown_.resize(pixels());
    } catch (const std::bad_alloc&) {
        throw Failure(fmt::format("picture of {}x{}", width, height), "there is not enough memory",
                      "choose a smaller size");
    }
    for (int y = 0; y < height; y += kTileSize)
        for (int x = 0; x < width; x += kTileSize)
            tiles_.push_back({{x, y, std::min(x + kTileSize, width), std::min(y + kTileSize, height), 1}});
}

void Film::reset(bool eightBit) {
    eightBit_ = eightBit;
    shown_.resize(pixels()); // for it may have been taken
    for (TileState& state : tiles_) {
        state.passes = 0;
        state.blank = true;
        state.leastLimit = state.mostLimit = kNoLimit;
        ++state.version;
    }
    id_ = nextFilmId();
}

int Film::passes(int tileIndex) const {
    const std::scoped_lock lock(mutexOf(tileIndex));
    return tiles_[static_cast<std::size_t>(tileIndex)].passes;
}

void Film::limit(std::span<const int> samples) {
    ENSURE(samples.size() == shown_.size());
    for (int i = 0; i < tiles(); ++i) {
        const std::scoped_lock lock(mutexOf(i));
        TileState& state = tiles_[static_cast<std::size_t>(i)];
        state.leastLimit = kNoLimit;
        state.mostLimit = 0;
        for (int y = state.area.y0; y < state.area.y1; ++y)
            for (int x = state.area.x0; x < state.area.x1; ++x) {
                const std::size_t pixel = index(x, y);
                limits_[pixel] = samples[pixel];
                state.leastLimit = std::min(state.leastLimit, samples[pixel]);
                state.mostLimit = std::max(state.mostLimit, samples[pixel]);
            }
    }
}

bool Film::ended(int passes) const {
    return std::ranges::all_of(tiles_, [&](const TileState& tile) { return tile.mostLimit <= passes; });
}

std::vector<std::uint8_t> Film::wanted(int tileIndex, int pass) const {
    const std::scoped_lock lock(mutexOf(tileIndex));
    const TileState& state = tiles_[static_cast<std::size_t>(tileIndex)];
    std::vector<std::uint8_t> wanted;
    if (state.leastLimit > pass) return wanted;
    for (int y = state.area.y0; y < state.area.y1; ++y)
        for (int x = state.area.x0; x < state.area.x1; ++x)
            wanted.push_back(limits_[index(x, y)] > pass ? 1 : 0);
    return wanted;
}

void Film::add(int tileIndex, const TileResult& result, int pass) {
    TileState& state = tiles_[static_cast<std::size_t>(tileIndex)];
    const std::scoped_lock lock(mutexOf(tileIndex));
    const int before = std::exchange(state.passes, pass + 1);
    state.blank = false;
    if (state.mostLimit < pass) return; // both sums hold all that there will be
    if (pass == 1 && before == 1) keepFirst(state);
    if (pass == 0)
        showFirst(state, result);
    else if (state.leastLimit > pass)
        addAll(state, result, pass);
    else
        addWanted(state, result, pass);
    if (eightBit_) roundMeans(state, pass);
    ++state.version;
}

void Film::showFirst(const TileState& state, const TileResult& result) {
    const auto width = state.area.x1 - state.area.x0;
    auto row = result.radiance.begin();
    for (int y = state.area.y0; y < state.area.y1; ++y, row += width)
        std::copy_n(row, width, &shown_[index(state.area.x0, y)]);
}

void Film::keepFirst(const TileState& state) {
    for (int y = state.area.y0; y < state.area.y1; ++y)
        for (int x = state.area.x0; x < state.area.x1; ++x) {
            const std::size_t i = index(x, y);
            const DVec3 sample(shown_[i]);
            const double luma = luminance(sample);
            sums_[0][i] = sample;
            squares_[0][i] = luma * luma;
        }
}

void Film::addAll(const TileState& state, const TileResult& result, int pass) {
    const auto now = static_cast<std::size_t>(pass & 1), before = now ^ 1U;
    std::size_t next = 0;
    for (int y = state.area.y0; y < state.area.y1; ++y)
        for (int x = state.area.x0; x < state.area.x1; ++x) {
            const std::size_t i = index(x, y);
            const DVec3 sample(result.radiance[next++]);
            const double luma = luminance(sample);
            sums_[now][i] = sums_[before][i] + sample;
            squares_[now][i] = squares_[before][i] + luma * luma;
            shown_[i] = Color(sums_[now][i] / static_cast<double>(pass + 1));
        }
}

// Apart from the others, as the rounding below: a branch among the sums makes them take four times as long.
void Film::addWanted(const TileState& state, const TileResult& result, int pass) {
    const auto now = static_cast<std::size_t>(pass & 1), before = now ^ 1U;
    std::size_t next = 0;
    for (int y = state.area.y0; y < state.area.y1; ++y)
        for (int x = state.area.x0; x < state.area.x1; ++x) {
            const std::size_t i = index(x, y);
            sums_[now][i] = sums_[before][i];
            squares_[now][i] = squares_[before][i];
            if (limits_[i] <= pass) continue;
            const Color& sample = result.radiance[next++];
            const double luma = luminance(DVec3(sample));
            sums_[now][i] += DVec3(sample);
            squares_[now][i] += luma * luma;
            shown_[i] = Color(sums_[now][i] / static_cast<double>(pass + 1));
        }
}

void Film::roundMeans(const TileState& state, int pass) {
    const auto now = static_cast<std::size_t>(pass & 1);
    for (int y = state.area.y0; y < state.area.y1; ++y)
        for (int x = state.area.x0; x < state.area.x1; ++x) {
            const std::size_t i = index(x, y);
            const int count = samplesOf(state, i, pass + 1);
            const DVec3 sum = roundedMean(pass == 0 ? DVec3(shown_[i]) : sums_[now][i], count);
            if (pass > 0) sums_[now][i] = sum;
            shown_[i] = Color(sum / static_cast<double>(count));
        }
}

void Film::preview(int tileIndex, const TileResult& result) {
    TileState& state = tiles_[static_cast<std::size_t>(tileIndex)];
    const std::scoped_lock lock(mutexOf(tileIndex));
    if (state.passes > 0) return;
    const Tile& traced = result.tile;
    const int columns = (traced.x1 - traced.x0 + traced.step - 1) / traced.step;
    for (int y = traced.y0; y < traced.y1; ++y)
        for (int x = traced.x0; x < traced.x1; ++x) {
            const int block = (y - traced.y0) / traced.step * columns + (x - traced.x0) / traced.step;
            shown_[index(x, y)] = result.radiance[static_cast<std::size_t>(block)];
        }
    state.blank = false;
    ++state.version;
}

void Film::copyRow(const TileState& state, int y, ColorImage& to) const {
    const int width = state.area.x1 - state.area.x0;
    if (state.blank)
        std::fill_n(&to.at(state.area.x0, y), width, Color(0));
    else
        std::copy_n(&shown_[index(state.area.x0, y)], width, &to.at(state.area.x0, y));
}

std::vector<int> Film::read(Picture& picture) const {
    if (picture.film != id_ || picture.radiance.width() != width_ || picture.radiance.height() != height_) {
        if (picture.radiance.width() != width_ || picture.radiance.height() != height_)
            picture.radiance = ColorImage(width_, height_);
        picture.versions.assign(tiles_.size(), 0xffffffff);
        picture.film = id_;
    }
    std::vector<int> changed;
    for (int i = 0; i < tiles(); ++i) {
        const TileState& state = tiles_[static_cast<std::size_t>(i)];
        const std::scoped_lock lock(mutexOf(i));
        auto& version = picture.versions[static_cast<std::size_t>(i)];
        if (version == state.version) continue;
        version = state.version;
        changed.push_back(i);
        for (int y = state.area.y0; y < state.area.y1; ++y) copyRow(state, y, picture.radiance);
    }
    return changed;
}

FilmPixel Film::pixel(int x, int y) const {
    const int tile = y / kTileSize * ((width_ + kTileSize - 1) / kTileSize) + x / kTileSize;
    const std::scoped_lock lock(mutexOf(tile));
    const TileState& state = tiles_[static_cast<std::size_t>(tile)];
    return {state.blank ? Color(0) : shown_[index(x, y)], samplesOf(state, index(x, y), state.passes), id_};
}

std::vector<int> Film::samples(int passes) const {
    std::vector<int> samples(shown_.size());
    for (const TileState& state : tiles_)
        for (int y = state.area.y0; y < state.area.y1; ++y)
            for (int x = state.area.x0; x < state.area.x1; ++x)
                samples[index(x, y)] = samplesOf(state, index(x, y), passes);
    return samples;
}

ColorImage Film::mean(int passes) const {
    ENSURE(passes >= 1);
    ColorImage result(width_, height_);
    const auto& sum = sums_[static_cast<std::size_t>((passes - 1) & 1)];
    for (int tile = 0; tile < tiles(); ++tile) {
        const TileState& state = tiles_[static_cast<std::size_t>(tile)];
        const std::scoped_lock lock(mutexOf(tile)); // the next pass may be on its way
        for (int y = state.area.y0; y < state.area.y1; ++y) {
            if (state.passes == passes) {
                copyRow(state, y, result);
                continue;
            }
            for (int x = state.area.x0; x < state.area.x1; ++x) {
                const std::size_t i = index(x, y);
                result.at(x, y) = Color(sum[i] / static_cast<double>(samplesOf(state, i, passes)));
            }
        }
    }
    return result;
}

ColorImage Film::takeMean(int passes) {
    const auto asShown = [=](const TileState& state) { return state.passes == passes; };
    if (!std::ranges::all_of(tiles_, asShown)) return mean(passes);
    return {width_, height_, std::move(shown_)};
}

Film::Estimate Film::estimate(std::size_t pixel, int samples, std::size_t last) const {
    const double n = samples, mean = luminance(sums_[last][pixel] / n);
    const double variance = (squares_[last][pixel] / n - mean * mean) / (n - 1);
    return {mean, variance > 1e-12 * mean * mean ? variance : 0}; // below it is rounding
}

std::vector<double> Film::displayedVariances(int passes, const DisplaySettings& settings) const {
    ENSURE(passes >= 2);
    const std::vector<int> count = samples(passes);
    std::vector<double> variances(count.size());
    for (std::size_t i = 0; i < count.size(); ++i) {
        const auto [mean, variance] = estimate(i, count[i], static_cast<std::size_t>((passes - 1) & 1));
        if (variance == 0) continue;
        const double darkest = std::max(0.0, mean - 2 * std::sqrt(variance));
        const double slope = displaySlope(static_cast<float>(darkest), settings);
        variances[i] = std::min(count[i] * variance * slope * slope, kLargestVariance);
    }
    return variances;
}

double Film::estimatedError(int passes, const DisplaySettings& settings) const {
    ENSURE(passes >= 2);
    double largest = 0;
    for (const TileState& state : tiles_) {
        double squared = 0;
        for (int y = state.area.y0; y < state.area.y1; ++y)
            for (int x = state.area.x0; x < state.area.x1; ++x) {
                const std::size_t i = index(x, y);
                const auto [mean, variance] =
                    estimate(i, samplesOf(state, i, passes), static_cast<std::size_t>((passes - 1) & 1));
                if (variance == 0) continue;
                const double slope = displaySlope(static_cast<float>(mean), settings);
                squared += variance * slope * slope;
            }
        const int pixels = (state.area.x1 - state.area.x0) * (state.area.y1 - state.area.y0);
        largest = std::max(largest, squared / pixels);
    }
    return std::sqrt(largest);
}

}
