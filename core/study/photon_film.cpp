#include "core/study/photon_film.h"

#include <algorithm>

namespace eyeray {
namespace {

constexpr int kBatch = 512; // photons that one thread traces in a row

/// Light that a pixel takes in.
struct Splat {
    int x, y;
    Color power;    // W
    double cosine4; // of its angle to the view, to the fourth power
};

std::optional<Splat> splatOf(const PhotonPath& path, const Lens& lens, int width, int height) {
    const PhotonStep& last = path.steps.back();
    const Vec3 direction = glm::normalize(last.to - last.from);
    const Vec2 place = lens.onPicture(last.to, direction);
    const int x = static_cast<int>(std::floor(0.5F * (place.x + 1) * static_cast<float>(width)));
    const int y = static_cast<int>(std::floor(0.5F * (1 - place.y) * static_cast<float>(height)));
    if (!(std::fabs(place.x) <= 1) || !(std::fabs(place.y) <= 1) || x >= width || y >= height)
        return std::nullopt;
    const double cosine = -glm::dot(direction, lens.forward);
    return Splat{x, y, last.power, cosine * cosine * cosine * cosine};
}

template <class T>
void keepLast(std::vector<T>& values, std::size_t most) {
    if (values.size() > most) values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(most));
}

}

struct PhotonFilm::Batch {
    PhotonTally tally;
    std::vector<Splat> splats;
    std::vector<PhotonPath> seen; // those that reached the lens
};

void PhotonTally::add(const PhotonPath& path) {
    const DVec3 left(path.steps.back().power);
    ++emitted;
    bounces += path.steps.size() - 1;
    powerEmitted += DVec3(path.emitted.power);
    powerAbsorbed += DVec3(path.absorbed);
    switch (path.end) {
    case PhotonEnd::Absorbed:
        ++absorbed;
        break;
    case PhotonEnd::Escaped:
        ++escaped;
        powerEscaped += left;
        break;
    case PhotonEnd::Lens:
        ++reached;
        powerReached += left;
        break;
    }
}

void PhotonTally::add(const PhotonTally& other) {
    emitted += other.emitted;
    bounces += other.bounces;
    absorbed += other.absorbed;
    escaped += other.escaped;
    reached += other.reached;
    onPicture += other.onPicture;
    powerEmitted += other.powerEmitted;
    powerAbsorbed += other.powerAbsorbed;
    powerEscaped += other.powerEscaped;
    powerReached += other.powerReached;
}

bool PhotonFilm::add(const PhotonWalk& walk, int count, ThreadPool& pool, const std::stop_token& stop) {
    const int batches = (count + kBatch - 1) / kBatch;
    std::vector<Batch> results(static_cast<std::size_t>(batches));
    std::vector<PhotonPath> last;
    pool.forEach(batches, stop, [&](int index) {
        Batch& batch = results[static_cast<std::size_t>(index)];
        const int from = index * kBatch, size = std::min(kBatch, count - from);
        const bool isLast = index == batches - 1;
        walk.walk(tally_.emitted + static_cast<std::uint64_t>(from), size, stop, [&](const PhotonPath& path) {
            batch.tally.add(path);
            if (isLast && size - static_cast<int>(batch.tally.emitted) < static_cast<int>(kLatest))
                last.push_back(path);
            if (path.end != PhotonEnd::Lens) return;
            batch.seen.push_back(path);
            keepLast(batch.seen, kLatestSeen);
            if (const auto splat = splatOf(path, walk.lens(), sums_.width(), sums_.height())) {
                ++batch.tally.onPicture;
                batch.splats.push_back(*splat);
            }
        });
    });
    if (stop.stop_requested()) return false;
    const Lens& lens = walk.lens();
    const double area = kPiD * lens.radius * lens.radius;
    const double pixel = 4.0 * lens.half.x * lens.half.y / (1.0 * sums_.width() * sums_.height());
    for (Batch& batch : results) {
        tally_.add(batch.tally);
        for (const Splat& splat : batch.splats)
            sums_.at(splat.x, splat.y) += DVec3(splat.power) / (area * pixel * splat.cosine4);
        std::move(batch.seen.begin(), batch.seen.end(), std::back_inserter(seen_));
        keepLast(seen_, kLatestSeen);
    }
    std::move(last.begin(), last.end(), std::back_inserter(latest_));
    keepLast(latest_, kLatest);
    return true;
}

ColorImage PhotonFilm::radiance() const {
    ColorImage image(sums_.width(), sums_.height());
    const double share = tally_.emitted > 0 ? 1.0 / static_cast<double>(tally_.emitted) : 0;
    std::transform(sums_.values().begin(), sums_.values().end(), image.values().begin(),
                   [&](const DVec3& sum) { return Color(sum * share); });
    return image;
}

}
