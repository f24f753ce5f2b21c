#pragma once
// The other side of a comparison: traced in step with the viewer's own picture, or a still picture.

#include <memory>

#include "app/document/document.h"
#include "app/viewer/background_job.h"
#include "core/render/render_session.h"

namespace eyeray {

/// How two pictures of one size differ after the same number of samples, or the same time.
struct PictureChange {
    int samples = 0, samplesThere = 0;        // whole passes
    std::size_t pixels = 0, changed = 0;      // in all, and whose displayed colours differ
    std::size_t wrong = 0;                    // of which clearly, as clearlyDiffers has it
    RayCounts here, there;                    // none for a still picture
    double secondsHere = 0, secondsThere = 0; // of tracing, both sides at once; 0 for a still picture
    double lightHere = 0, lightThere = 0;     // mean luminance of the radiance
    ColorImage difference;                    // |here − there|, radiance
    ByteImage marks;                          // over what is wrong, else transparent
};

/// What two traced sides are given as much of: samples, up to `most`; or seconds, until this side has ended.
struct ComparedShare {
    EqualShare equal = EqualShare::Samples;
    int most = 1;
};

/// Used by one thread, which waits for nothing. Both traced sides share the cores. With equal samples they
/// are held at 1, 2, 4, 8, 16 and further multiples of 8 samples until the other is there too: with the same
/// random numbers, a pixel whose light has not changed has the same bits on both. With equal seconds both go
/// on side by side, and are compared by their whole passes when both have traced for a quarter of a second,
/// and each time for half as long again.
class ComparisonRendering {
public:
    /// Traces the other side. To be called right before `here` starts its own picture.
    void start(std::shared_ptr<const World>, const Camera&, RenderSettings, int threads, ComparedShare,
               RenderSession& here);
    /// Compares `here` with a picture that stays as it is, as soon as both have the same size.
    void start(std::shared_ptr<const ColorImage> still, int mostSamples, RenderSession& here);
    /// Ends the comparison and lets `here` go on alone.
    void stop(RenderSession& here);
    void setPaused(bool);

    /// Leads both sides on; true for each new change(). They are compared as displayed.
    bool update(RenderSession& here, const DisplaySettings& display, const DisplaySettings& otherDisplay);

    /// True until both have been compared with all samples or seconds that this side needs, or the most.
    bool active() const { return active_; }
    /// True while a change() is being counted.
    bool measuring() const { return measuring_.running(); }
    /// That traces the other side; null before the first comparison of two traced sides.
    const RenderSession* session() const { return session_.get(); }
    /// Null before both have been compared.
    const std::shared_ptr<const PictureChange>& change() const { return change_; }

private:
    void begin(RenderSession& here, ComparedShare);
    void hold(RenderSession& here, int samples);
    bool updateBySamples(RenderSession& here);
    bool updateBySeconds(RenderSession& here);
    bool otherReady() const;
    bool otherIsLost(const RenderStatus& ours) const;
    bool measure(const RenderSession& here);

    std::unique_ptr<RenderSession> session_;
    std::shared_ptr<const ColorImage> still_; // in place of the session's picture, if there is one
    int threads_ = 0;
    ComparedShare share_;
    int target_ = 0;         // samples that both are led to
    double nextSeconds_ = 0; // of tracing, when both are compared next
    bool active_ = false, paused_ = false;
    struct Displays {
        DisplaySettings here, there;
        friend bool operator==(const Displays&, const Displays&) = default;
    };
    Displays asked_, compared_; // now, and as last compared
    BackgroundJob<PictureChange> measuring_;
    std::shared_ptr<const PictureChange> change_;
};

}
