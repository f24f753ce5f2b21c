#pragma once
// What comes of many photons: counts, and the picture that those make which enter the eye.

#include "core/base/thread_pool.h"
#include "core/image/pixels.h"
#include "core/study/photon_walk.h"

namespace eyeray {

struct PhotonTally {
    std::uint64_t emitted = 0, bounces = 0;
    std::uint64_t absorbed = 0, escaped = 0, reached = 0; // photons by their end; reached: the lens
    std::uint64_t onPicture = 0;                          // of those that reached the lens
    DVec3 powerEmitted{0}, powerAbsorbed{0}, powerEscaped{0}, powerReached{0}; // sums over photons, W

    void add(const PhotonPath&);
    void add(const PhotonTally&);
    double fraction() const { // that reached the lens
        return emitted > 0 ? static_cast<double>(reached) / static_cast<double>(emitted) : 0;
    }
};

/// Used by one thread at a time. The same photons in the same rounds give the same bits on any number of
/// threads.
class PhotonFilm {
public:
    PhotonFilm(int width, int height) : sums_(width, height) {}

    /// Sends the next `count` photons. False, and nothing has changed, if `stop` came first. To be called if
    /// there are lamps.
    bool add(const PhotonWalk&, int count, ThreadPool&, const std::stop_token& stop);

    const PhotonTally& tally() const { return tally_; }
    /// What the lens has seen so far, as radiance: with more photons, the picture that a lens would make.
    ColorImage radiance() const;
    /// The last few photons, and those that reached the lens last.
    const std::vector<PhotonPath>& latest() const { return latest_; }
    const std::vector<PhotonPath>& latestSeen() const { return seen_; }

    static constexpr std::size_t kLatest = 24, kLatestSeen = 8;

private:
    struct Batch;

    Pixels<DVec3> sums_;
    PhotonTally tally_;
    std::vector<PhotonPath> latest_, seen_;
};

}
