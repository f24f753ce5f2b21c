#pragma once
// A student's picture held against the scene with each known mistake, in the background.

#include <filesystem>
#include <optional>

#include "app/viewer/background_job.h"
#include "core/study/name_bug.h"

namespace eyeray {

/// What is known of a picture, and its size.
struct BugReport {
    std::filesystem::path picture;
    int width = 0, height = 0;
    NamedBug bug;
};

/// The displayed bytes of a picture file, those of linear ones as the screen would show them. Throws
/// InputError, Failure.
ByteImage readDisplayed(const std::filesystem::path&);

/// Used by one thread.
class BugNaming {
public:
    /// Throws InputError if the picture cannot be read; what is known of the last one is forgotten.
    void start(const std::filesystem::path& picture, std::shared_ptr<const World>, const Camera&,
               const RenderSettings&, int threads);
    void clear();

    bool running() const { return naming_.running(); }
    void wait() const { naming_.wait(); }
    /// True once for each report. Rethrows what went wrong.
    bool update();
    const std::optional<BugReport>& report() const { return report_; }

private:
    BackgroundJob<std::optional<BugReport>> naming_;
    std::optional<BugReport> report_;
};

}
