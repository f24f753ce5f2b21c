#pragma once
// The photons that the viewer shows, sent in the background.

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include "app/viewer/background_job.h"
#include "core/study/photon_film.h"

namespace eyeray {

inline constexpr double kMostPhotonsPerSecond = 1e6; // then they go as fast as they can
inline constexpr double kMostPhotons = 1e15;         // that can be asked for

/// Side of the blocks that stand for the pixels of a picture: one pixel that lights up now and then is lost
/// on a screen.
inline constexpr int kPhotonBlock = 4;

/// How a person looks at the light.
struct PhotonSettings {
    bool on = false;
    double radius = 0; // of the lens, metres; 0: the camera's or, of a pinhole, a hundredth of its distance
    double perSecond = kMostPhotonsPerSecond;
    std::uint64_t most = 0; // then it stands still; 0: never
    friend bool operator==(const PhotonSettings&, const PhotonSettings&) = default;
};

/// The radius that is meant, metres.
double lensRadius(const PhotonSettings&, const Camera&);

/// What photons are sent for.
struct PhotonRequest {
    std::shared_ptr<const World> world;
    Camera camera;
    int width = 0, height = 0; // pixels of the picture
    double radius = 0;         // of the lens, metres
    int threads = 0;
    std::uint32_t seed = 0;
    friend bool operator==(const PhotonRequest&, const PhotonRequest&) = default;
};

/// What has come of them so far.
struct PhotonPicture {
    Lens lens;
    PhotonTally tally;
    std::uint64_t pixels = 0;            // of the picture
    double seconds = 0;                  // in which they were sent, pauses left out
    ColorImage radiance;                 // in blocks of kPhotonBlock pixels
    std::vector<PhotonPath> paths;       // the latest
    bool lamps = true, replaced = false; // if there are any; if one stands for one without falloff
};

/// Used by one thread, which never waits but in wait().
class PhotonRendering {
public:
    /// Sends photons for this request, from the first one if it is another than before; how many, and how
    /// fast, may change meanwhile.
    void show(const PhotonRequest&, const PhotonSettings&);
    void clear();
    void setPaused(bool);

    /// Takes over what there is; true while photons are sent, or if there is something new. Throws what the
    /// work has thrown.
    bool update();
    /// True while it sends photons that will come to an end.
    bool ends() const;

    /// Null as long as there is nothing to show.
    const std::shared_ptr<const PhotonPicture>& picture() const { return shown_; }

private:
    struct Run; // of the last request, shared with the job
    class Sender;

    std::optional<PhotonRequest> request_;
    std::shared_ptr<Run> run_;
    bool paused_ = false;
    std::shared_ptr<const PhotonPicture> shown_;
    BackgroundJob<bool> job_;
};

}
