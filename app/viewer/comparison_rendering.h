#pragma once
// The other side of a comparison, traced in step with the viewer's own picture.

#include <memory>
#include <optional>

#include "app/viewer/background_job.h"
#include "core/render/render_session.h"

namespace eyeray {

/// How two pictures of one size differ after the same number of samples.
struct PictureChange {
    int samples = 0;
    std::size_t pixels = 0, changed = 0; // in all, and whose displayed colours differ
    RayCounts here, there;
    ColorImage difference; // |here − there|, radiance
};

/// Used by one thread, which waits for nothing. Both sides share the cores and are held at 1, 2, 4, 8, 16 and
/// further multiples of 8 samples until the other is there too: with the same random numbers, a pixel whose
/// light has not changed has the same bits on both.
class ComparisonRendering {
public:
    /// Traces the other side. To be called right before `here` starts its own picture, to compare them up to
    /// `mostSamples`.
    void start(std::shared_ptr<const World>, const Camera&, RenderSettings, int threads, int mostSamples,
               RenderSession& here);
    /// Ends the comparison and lets `here` go on alone.
    void stop(RenderSession& here);
    void setPaused(bool);

    /// Leads both sides on; true for each new change(). They are compared as displayed.
    bool update(RenderSession& here, const DisplaySettings& display, const DisplaySettings& otherDisplay);

    /// True until both have been compared with as many samples as this side needs, or the most.
    bool active() const { return active_; }
    /// Null before the first comparison.
    const RenderSession* session() const { return session_.get(); }
    const std::optional<PictureChange>& change() const { return change_; }

private:
    void hold(RenderSession& here, int samples);
    void measure(const RenderSession& here, const DisplaySettings& display,
                 const DisplaySettings& otherDisplay);

    std::unique_ptr<RenderSession> session_;
    int threads_ = 0, mostSamples_ = 0;
    int target_ = 0; // samples that both are led to
    bool active_ = false, paused_ = false;
    BackgroundJob<PictureChange> measuring_;
    std::optional<PictureChange> change_;
};

}
