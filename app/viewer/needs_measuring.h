#pragma once
// What the scene shown needs, measured in the background, and looked at again once it is applied.

#include <memory>
#include <optional>
#include <string>

#include "app/document/document_needs.h"
#include "app/viewer/background_job.h"

namespace eyeray {

/// Used by one thread.
class NeedsMeasuring {
public:
    /// Begins anew for this document.
    void measure(const Document&, int width, int height, int threads);
    /// Looks at what was measured again, in the whole picture.
    void check();
    void clear();

    bool running() const { return job_.running(); }
    void wait() const { job_.wait(); }
    /// True once for each result. Rethrows what went wrong.
    bool update();

    /// What the work is at, and how much of it is done, 0 to 1.
    std::string doing() const;
    double done() const;

    const std::optional<MeasuredNeeds>& needs() const { return needs_; }
    bool checking() const { return checking_; } // as long as that goes on
    bool checked() const { return checked_; }
    /// The document as it was measured, and with what was found.
    const Document& before() const { return before_; }
    Document after() const { return withNeeded(before_, *needs_); }

private:
    struct Steps;
    template <class Work>
    void start(std::size_t steps, Work);

    Document before_;
    NeedsPlan plan_;
    std::optional<MeasuredNeeds> needs_;
    bool checking_ = false, checked_ = false;
    std::shared_ptr<Steps> steps_; // shared with the work under way
    BackgroundJob<std::optional<MeasuredNeeds>> job_;
};

}
