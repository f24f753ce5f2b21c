// labels: ui
// What a picture needs, as a person asks: by a key, in the panel, on the command line.

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/document/saved_scene.h"
#include "core/image/atomic_file.h"
#include "core/study/picture_model.h"
#include "tests/app_documents.h"
#include "tests/app_process.h"
#include "tests/app_screen.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

class NeedsView : public testing::Test {
protected:
    Screen screen{"mirrors", 900, 620};
};

TEST_F(NeedsView, OneKeyAppliesAndUndoBringsAllBack) {
    const Document before = screen.document();
    screen.press("U");
    screen.settle();
    EXPECT_TRUE(screen.viewer.needs().checked());
    EXPECT_TRUE(screen.viewer.needsApplied());
    EXPECT_FALSE(screen.document().render.trace.refractions) << "proved";
    EXPECT_TRUE(screen.document().render.trace.reflections);
    screen.press("Ctrl+Z");
    EXPECT_TRUE(commandsBetween(before, screen.document()).empty());
    EXPECT_FALSE(screen.viewer.canUndo());
}

TEST_F(NeedsView, PanelListsThemAndItsButtonApplies) {
    screen.press("Shift+U");
    screen.settle();
    EXPECT_TRUE(screen.viewer.needsHold());
    EXPECT_NO_THROW(screen.rect("needs summary"));
    EXPECT_TRUE(screen.document().render.trace.refractions) << "asking changes nothing";
    screen.click("apply-needs");
    screen.settle();
    EXPECT_FALSE(screen.document().render.trace.refractions);
    screen.click("undo");
    EXPECT_TRUE(screen.document().render.trace.refractions);
}

TEST_F(NeedsView, AreMeasuredAnewAfterAnEdit) {
    screen.gui.execute(Command::parse("needs"));
    screen.settle();
    screen.gui.execute(Command::parse("set max-depth=3"));
    EXPECT_FALSE(screen.viewer.needsHold());
    screen.press("U");
    screen.settle();
    EXPECT_LE(screen.document().render.trace.maxDepth, 3);
    EXPECT_TRUE(screen.viewer.needsApplied());
}

TEST_F(NeedsView, AreForgottenWithTheirScene) {
    screen.gui.execute(Command::parse("needs"));
    EXPECT_TRUE(screen.viewer.needs().running());
    screen.gui.execute(Command::parse("open scene=phong"));
    screen.viewer.finishJobs();
    EXPECT_FALSE(screen.viewer.needs().running());
    EXPECT_FALSE(screen.viewer.needs().needs());
}

TEST_F(NeedsView, WaitForAPicture) {
    Viewer viewer(1);
    EXPECT_FALSE(viewer.execute(Command::parse("measure-needs")));
    viewer.show(openScene("phong"));
    EXPECT_FALSE(viewer.execute(Command::parse("apply-needs"))) << "of no size";
}

TEST(NeedsInWords, SayWhereAllIsNeeded) { EXPECT_EQ(summaryText({}), "the picture needs all that is set"); }

class NeedsOnTheCommandLine : public Documents {
protected:
    std::pair<int, std::string> run(const std::vector<std::string>& arguments) const {
        Process process(EYERAY_BINARY_DIR "/eyeray", arguments, folder.path(),
                        {"HOME=" + folder.path().string(), "DISPLAY="});
        const int code = process.wait();
        return {code, process.out() + process.err()};
    }
    TemporaryFolder folder;
};

TEST_F(NeedsOnTheCommandLine, AreWrittenIntoTheSceneThatComesBackSmaller) {
    const auto [code, said] =
        run({"needs", "phong", "--json", "--apply", "-o", "lean.gltf", "--width", "96", "--threads", "1"});
    ASSERT_EQ(code, 0) << said;
    const auto json = nlohmann::json::parse(said);
    EXPECT_EQ(json.at("tiles"), json.at("of_tiles")) << "the whole picture was looked at";
    EXPECT_EQ(json.at("items").at(0).at("how"), "proved");
    EXPECT_LE(json.at("error").at("flip"), json.at("tolerance"));

    const OpenedScene lean = openScene((folder / "lean.gltf").string());
    Document asTold = openScene("phong").document;
    for (const std::string line : json.at("commands")) asTold = edited(asTold, line);
    EXPECT_EQ(lean.document.render.trace, asTold.render.trace);
    EXPECT_EQ(lean.document.render.stop.samples, asTold.render.stop.samples);
    EXPECT_EQ(lean.document.render.stop.error, asTold.render.stop.error);
    EXPECT_FALSE(lean.meterExposure);
    EXPECT_EQ(lean.document.render.trace.maxDepth, 0);

    ASSERT_EQ(run({"render", "lean.gltf", "-o", "a.png", "--width", "96", "--stats", "a.json"}).first, 0);
    const auto text = readFile(folder / "a.json", 1U << 16U);
    const auto stats = nlohmann::json::parse(reinterpret_cast<const char*>(text.data()),
                                             reinterpret_cast<const char*>(text.data() + text.size()));
    EXPECT_EQ(stats.at("samples"), asTold.render.stop.samples) << "what the scene states is rendered";
    EXPECT_LT(stats.at("samples_per_pixel"), asTold.render.stop.samples) << "and pixels end by its error";
}

TEST_F(NeedsOnTheCommandLine, SayWhatIsWrongWithTheRequest) {
    EXPECT_EQ(run({"needs", "phong", "--apply"}).first, 2);
    EXPECT_EQ(run({"needs", "phong", "-o", "x.gltf"}).first, 2);
    EXPECT_EQ(run({"needs", "phong", "--apply", "-o", "x.png"}).first, 2);
    EXPECT_EQ(run({"needs", "phong", "--tolerance", "2"}).first, 2);
    EXPECT_EQ(run({"needs", "no-such-scene"}).first, 2);
}

TEST_F(Documents, TexturesCanBeDroppedByACommand) {
    const Document checkered = openScene("checkerboard").document;
    const auto textured = [](const Document& document) {
        return std::ranges::count_if(document.scene->materials,
                                     [](const Material& m) { return needsOf(m.model).textured; });
    };
    ASSERT_GT(textured(checkered), 0);
    Document bare = checkered;
    for (std::size_t i = 0; i < checkered.scene->materials.size(); ++i)
        bare = edited(bare, fmt::format("material material={} textures=off", i));
    EXPECT_EQ(textured(bare), 0);
    Document again = checkered;
    for (const Command& command : commandsBetween(checkered, bare)) again = apply(again, command);
    EXPECT_EQ(textured(again), 0);
}

TEST_F(Documents, SavedScenesStateTheirExposure) {
    for (const char* const line : {"set exposure=0", "set exposure=1.5"}) {
        const std::vector<std::string> settings = savedScene(edited(homage, line)).settings;
        EXPECT_EQ(
            std::ranges::count_if(
                settings, [](const std::string& s) { return s.find("exposure=") != std::string::npos; }),
            1)
            << line;
    }
}

}
}
