// labels: robustness
// A person who does everything at once, for EYERAY_SOAK_SECONDS (30 unless told): orbits, edits, opens scenes
// good and bad, exports, while the picture is being traced on 1, 2 and 8 threads.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "tests/app_screen.h"
#include "tests/geometry_cases.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

using Clock = std::chrono::steady_clock;

double soakSeconds() {
    const char* const told =
        std::getenv("EYERAY_SOAK_SECONDS"); // NOLINT(concurrency-mt-unsafe): nothing sets it
    return told != nullptr ? std::atof(told) : 30;
}

std::ptrdiff_t openFiles() {
    const std::filesystem::directory_iterator files("/proc/self/fd");
    return std::distance(begin(files), end(files));
}

/// The program in a small window.
struct Program {
    explicit Program(int threads) : viewer(threads), gui(viewer, platform, Preferences{}) {
        viewer.openInBackground("shadows", {});
        viewer.finishJobs();
    }

    void frame() {
        platform.beginFrame();
        gui.frame();
        platform.endFrame();
        gui.afterFrame();
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }
    bool say(const std::string& command) { return gui.execute(Command::parse(command)); }

    HeadlessPlatform platform{480, 360};
    Viewer viewer;
    Gui gui;
};

class Soak {
public:
    explicit Soak(std::uint32_t seed) : random_(seed) {
        std::ofstream(folder_.path() / "broken.gltf")
            << R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [7]}]})";
    }

    void run(int threads, Clock::time_point end) {
        auto program = std::make_unique<Program>(threads);
        while (Clock::now() < end) {
            if (random_.below(200) == 0) {
                program.reset(); // while it traces
                program = std::make_unique<Program>(threads);
            }
            program->say(anyCommand());
            if (random_.below(3) == 0) program->frame();
            while (program->viewer.notices().size() > 3) program->viewer.dismissNotice(0);
            std::this_thread::sleep_for(std::chrono::milliseconds(random_.below(20)));
            ++events_;
        }
        const ColorImage image = settled(*program);
        program.reset();
        Program fresh(1);
        const ColorImage expected = settled(fresh);
        ASSERT_GT(expected.values().size(), 0U);
        EXPECT_EQ(image, expected) << threads << " threads, after " << events_ << " events";
    }

    int events() const { return events_; }

private:
    std::string anyCommand() {
        const auto number = [&](double lo, double hi) {
            return fmt::format("{:.3f}", random_.uniform(lo, hi));
        };
        const auto one = [&](std::initializer_list<const char*> words) {
            return std::string(words.begin()[random_.below(static_cast<int>(words.size()))]);
        };
        switch (random_.below(15)) {
        case 0:
            return "orbit yaw=" + number(-90, 90) + " pitch=" + number(-40, 40);
        case 1:
            return "dolly factor=" + number(0.3, 3);
        case 2:
            return "set method=" + one({"local", "cast", "whitted", "distributed", "path"});
        case 3:
            return "set max-depth=" + std::to_string(random_.below(20));
        case 4:
            return "toggle key=" + one({"shadows", "reflections", "refractions"});
        case 5:
            return "open scene=" + one({"shadows", "phong", "bubble", "mirrors", "perspective"});
        case 6:
            return "open scene=" + (folder_.path() / one({"broken.gltf", "missing.gltf"})).string();
        case 7:
            return "screenshot file=" + (folder_.path() / one({"a.png", "b.exr", "c.ppm"})).string();
        case 8:
            return "pick x=" + std::to_string(random_.below(300)) +
                   " y=" + std::to_string(random_.below(200));
        case 9:
            return one({"undo", "redo", "reset", "reload"});
        case 10:
            return "explain on=" + one({"on", "off"});
        case 11:
            return "set accel=" + one({"auto", "brute", "bvh2", "bvh8"});
        case 12:
            return one({"compare with=\"max-depth=0\"", "compare on=off", "rasterised", "play-grid",
                        "from-light", "difference"});
        case 13:
            return "layer name=" + one({"color", "normal", "depth", "rays", "visits"});
        default:
            return "pause on=" + one({"on", "off"});
        }
    }

    /// The picture of a scene as it is in its file, traced to two samples.
    static ColorImage settled(Program& program) {
        EXPECT_TRUE(program.say("open scene=shadows"));
        program.viewer.finishJobs();
        for (const char* command : {"reset", "pause on=off", "explain on=off", "compare on=off",
                                    "rasterised on=off", "set samples=2 error=0"})
            EXPECT_TRUE(program.say(command)) << command;
        program.frames(3);
        program.viewer.finishJobs();
        program.viewer.finishRendering(2);
        program.frames(3);
        return program.viewer.session().image();
    }

    cases::Random random_;
    TemporaryFolder folder_;
    int events_ = 0;
};

TEST(Soak, LeavesTheProgramAsItWas) {
    {
        const Program first(1);
    } // what is opened once for all
    const std::ptrdiff_t files = openFiles();
    int events = 0;
    for (const int threads : {1, 2, 8}) {
        Soak soak(static_cast<std::uint32_t>(threads));
        const auto length = std::chrono::duration<double>(soakSeconds() / 3);
        soak.run(threads, Clock::now() + std::chrono::duration_cast<Clock::duration>(length));
        events += soak.events();
    }
    RecordProperty("events", events);
    EXPECT_GT(events, 0);
    EXPECT_EQ(openFiles(), files) << "after " << events << " events";
}

}
}
