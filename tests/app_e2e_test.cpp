// labels: e2e
// The real window on a screen of its own, driven as a person does: with mouse and keys.
#include <algorithm>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/gui/widgets.h"
#include "core/image/atomic_file.h"
#include "core/image/decode.h"
#include "tests/app_process.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = EYERAY_BINARY_DIR "/eyeray";

class Window : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name : {"screen", "viewer", "tool", "render", "Pictures"})
            fs::create_directory(folder / name);
        screen =
            start("Xvfb", {"-displayfd", "1", "-screen", "0", "1280x800x24", "-nolisten", "tcp"}, "screen");
        ASSERT_TRUE(
            eventually([&] { return screen->out().find('\n') != std::string::npos || !screen->running(); }));
        ASSERT_TRUE(screen->running()) << screen->err();
        const std::string number = screen->out();
        display = fmt::format(":{}", number.substr(0, number.find('\n')));
        viewer =
            start(kProgram, {"view", "homage", "--samples", "1", "--widgets", (folder / "widgets").string()},
                  "viewer");
        ASSERT_TRUE(eventually([&] { return rectangles().count("reflections") != 0 || !viewer->running(); }));
        ASSERT_TRUE(viewer->running()) << viewer->err();
        ASSERT_TRUE(eventually([&] { return tool({"search", "--onlyvisible", "--name", "Eyeray"}) == 0; }));
        window = toolSaid.substr(0, toolSaid.find('\n'));
    }

    std::unique_ptr<Process> start(const std::string& program, const std::vector<std::string>& arguments,
                                   const char* place) const {
        const std::string home = folder.path().string();
        return std::make_unique<Process>(program, arguments, folder / place,
                                         Process::Environment{"HOME=" + home,
                                                              "XDG_CONFIG_HOME=" + home + "/config",
                                                              "DISPLAY=" + display, "WAYLAND_DISPLAY="});
    }

    int tool(const std::vector<std::string>& words) {
        const auto xdotool = start("xdotool", words, "tool");
        const int code = xdotool->wait();
        toolSaid = xdotool->out();
        return code;
    }

    /// As the viewer last wrote them; it may be writing.
    std::map<std::string, WidgetRect> rectangles() const {
        std::map<std::string, WidgetRect> result;
        std::istringstream lines(textOf(folder / "widgets"));
        WidgetRect r;
        for (std::string name; lines >> r.x0 >> r.y0 >> r.x1 >> r.y1 && std::getline(lines >> std::ws, name);)
            result[name] = r;
        return result;
    }
    WidgetRect rectangle(const std::string& name) const {
        std::map<std::string, WidgetRect> now;
        if (!eventually([&] { return (now = rectangles()).count(name) != 0; }))
            throw std::runtime_error("no widget " + name);
        return now.at(name);
    }

    void point(const std::string& widget) {
        const WidgetRect r = rectangle(widget);
        tool({"mousemove", "--window", window, fmt::format("{:.0f}", r.x0 + 8),
              fmt::format("{:.0f}", (r.y0 + r.y1) / 2), "sleep", "0.1"});
    }
    void click(const std::string& widget) {
        point(widget);
        tool({"mousedown", "1", "sleep", "0.1", "mouseup", "1"});
    }
    void key(const std::string& name) { tool({"keydown", name, "sleep", "0.1", "keyup", name}); }

    /// The newest screenshot of the picture; empty if there is none yet.
    ByteImage screenshot() const {
        fs::path newest;
        for (const auto& entry : fs::directory_iterator(folder / "Pictures"))
            if (entry.path().extension() == ".png") newest = std::max(newest, entry.path());
        return newest.empty() ? ByteImage{} : decoded(newest);
    }
    static ByteImage decoded(const fs::path& file) {
        return decodeImage(readFile(file, 1U << 26U), file.string()).pixels;
    }

    /// Takes screenshots by key until one shows exactly this.
    bool comesToShow(const ByteImage& wanted) {
        return eventually([&] {
            key("F12");
            return screenshot() == wanted;
        });
    }

    /// What the command line renders with these options at the size of the window's picture.
    ByteImage rendered(std::vector<std::string> options) const {
        const WidgetRect r = rectangle("picture");
        options.insert(options.begin(),
                       {"render", "homage", "--samples", "1", "-o", "out.png", "--width",
                        fmt::format("{:.0f}", r.x1 - r.x0), "--height", fmt::format("{:.0f}", r.y1 - r.y0)});
        EXPECT_EQ(start(kProgram, options, "render")->wait(), 0);
        return decoded(folder / "render/out.png");
    }

    TemporaryFolder folder;
    std::string display, window, toolSaid;
    std::unique_ptr<Process> screen, viewer;
};

TEST_F(Window, ShowsWhatTheCommandLineRendersHeedsMouseAndKeysAndEndsInOrder) {
    const ByteImage whole = rendered({}), plain = rendered({"--no-reflections"});
    ASSERT_NE(whole, plain);
    point("picture");
    EXPECT_TRUE(comesToShow(whole));
    click("reflections");
    EXPECT_TRUE(comesToShow(plain)) << "after a click on the switch of reflection rays";
    key("r");
    EXPECT_TRUE(comesToShow(whole)) << "after its key";

    tool({"keydown", "ctrl", "sleep", "0.1", "keydown", "q", "sleep", "0.1", "keyup", "q", "keyup", "ctrl"});
    ASSERT_TRUE(eventually([&] { return !viewer->running(); }));
    EXPECT_EQ(viewer->wait(), 0) << viewer->err();
    EXPECT_EQ(viewer->err(), "");
    EXPECT_NE(textOf(folder / "config/eyeray/preferences").find("recent scene=homage"), std::string::npos);
}

}
}
