#include "app/viewer/bug_naming.h"

#include "core/image/atomic_file.h"
#include "core/image/read_picture.h"

namespace eyeray {

ByteImage readDisplayed(const std::filesystem::path& path) {
    constexpr std::size_t kMostBytes = std::size_t{1} << 28U;
    ReadPicture picture = readPicture(readFile(path, kMostBytes), path.string());
    return picture.displayed ? std::move(*picture.displayed) : display(picture.linear, {});
}

void BugNaming::start(const std::filesystem::path& path, std::shared_ptr<const World> world,
                      const Camera& camera, const RenderSettings& settings, int threads) {
    clear();
    naming_.start([path, picture = readDisplayed(path), world = std::move(world), camera, settings,
                   threads](const std::stop_token& stop) -> std::optional<BugReport> {
        ThreadPool pool(threads);
        auto bug = nameBug(world, camera, settings, picture, pool, stop);
        if (!bug) return std::nullopt;
        return BugReport{path, picture.width(), picture.height(), std::move(*bug)};
    });
}

void BugNaming::clear() {
    naming_.cancel();
    report_.reset();
}

bool BugNaming::update() {
    auto done = naming_.take();
    if (!done || !*done) return false;
    report_ = std::move(*done);
    return true;
}

}
