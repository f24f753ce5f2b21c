#include <fmt/format.h>

#include "app/cli/run.h"
#include "app/gui/gui.h"
#include "app/platform/headless_platform.h"
#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/image/encode.h"

namespace eyeray {
namespace {

constexpr int kDefaultSamples = 16;
constexpr int kSettlingFrames = 3; // until ImGui has measured its windows
constexpr std::size_t kMostPlayBytes = 16U << 20U;

class Snapshot {
public:
    explicit Snapshot(const SnapshotOptions& options)
        : platform_(options.windowWidth, options.windowHeight), gui_(viewer_, platform_, Preferences{}) {
        viewer_.show(openFor(options.picture));
        viewer_.finishJobs();
        settle();
    }

    /// Throws InputError with the command's message if it went wrong.
    void play(const Command& command) {
        gui_.execute(command);
        viewer_.finishJobs();
        settle();
        for (const Notice& notice : viewer_.notices())
            if (notice.kind == Notice::Kind::Error)
                throw InputError("--play", notice.text, "correct the command");
    }

    void refine(int samples) { viewer_.finishRendering(samples); }

    ByteImage draw() {
        settle();
        return platform_.screenshot();
    }

    Viewer& viewer() { return viewer_; }

private:
    void settle() {
        for (int i = 0; i < kSettlingFrames; ++i) {
            platform_.beginFrame();
            gui_.frame();
            platform_.endFrame();
            gui_.afterFrame();
        }
    }

    HeadlessPlatform platform_;
    Viewer viewer_;
    Gui gui_;
};

}

int run(const SnapshotOptions& options) {
    checkOutput(options.output);
    if (formatOf(options.output) != ImageFormat::Png)
        throw InputError(options.output.string(), "a snapshot is a PNG", "give a name that ends in .png");
    std::vector<Command> commands;
    if (options.play) {
        const auto bytes = readFile(*options.play, kMostPlayBytes);
        commands = parseCommands({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                                 options.play->string());
    }
    Snapshot snapshot(options);
    for (const Command& command : commands) snapshot.play(command);
    const Document& document = snapshot.viewer().document();
    snapshot.refine(options.picture.stops ? document.render.stop.samples : kDefaultSamples);
    const Metadata metadata = toMetadata(snapshot.viewer().pictureState(), options.output.parent_path());
    writeFileAtomically(options.output, encodeDisplayed(snapshot.draw(), ImageFormat::Png, metadata));
    return 0;
}

}
