// labels: unit
#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/document/document.h"
#include "app/document/document_commands.h"
#include "app/document/history.h"
#include "app/document/scene_files.h"
#include "app/document/settings.h"
#include "core/base/errors.h"
#include "core/render/render_session.h"
#include "core/scene/world.h"

namespace eyeray {
namespace {

Document edited(const Document& document, const std::string& line) {
    return apply(document, Command::parse(line));
}

/// What the error of a command says; nothing if it was carried out.
std::string errorOf(const Document& document, const std::string& line) {
    try {
        edited(document, line);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::vector<std::string> textsBetween(const Document& from, const Document& to) {
    std::vector<std::string> texts;
    for (const Command& command : commandsBetween(from, to)) texts.push_back(command.text());
    return texts;
}

/// The document that a picture's metadata brings back: through text, as it is read from a file.
Document broughtBack(const Document& from, const Document& to) {
    std::string text;
    for (const Command& command : commandsBetween(from, to)) text += command.text() + "\n";
    Document result = from;
    for (const Command& command : parseCommands(text, "metadata")) result = apply(result, command);
    return result;
}

ColorImage rendered(const Document& document) {
    RenderSettings settings = document.render;
    settings.width = 32;
    settings.height = 18;
    settings.coarse = false;
    settings.stop = {1, 0, 0};
    RenderSession session(1);
    session.start(buildWorld(document.scene, document.build), document.camera, settings);
    while (session.wait(std::chrono::milliseconds(1000)).active()) {
    }
    return session.image();
}

class Documents : public testing::Test {
protected:
    Document homage = openScene("homage").document;
    Document shadows = openScene("shadows").document; // several lamps
};

TEST(Command, WhatIsParsedIsWrittenTheSameWay) {
    for (const char* line :
         {"frame", "set max-depth=5", "set max-depth=5 cutoff=0.002", "open scene=\"my scenes/ball.glb\"",
          "select object=\"Kugel aus \\\"Glas\\\"\"", "open scene=Größe/η.gltf", "light light=\"a\\\\ b\"",
          "add-light name=\"\"", "camera eye=1,-2.5,3e-05"})
        EXPECT_EQ(Command::parse(line).text(), line);
}

TEST(Command, AnyValueSurvivesItsText) {
    for (const char* value : {"", " ", "a b", "\"", "\\", "a\\b c", "tab\there", "two\nlines", "\r", "=",
                              "x=y", "n", "\\n", "ηθσ °", "#"}) {
        const Command command("open", {{"scene", value}, {"after", "1"}});
        EXPECT_EQ(Command::parse(command.text()), command) << command.text();
        const auto lines = parseCommands(command.text() + "\n", "here");
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_EQ(lines[0], command);
    }
}

TEST(Command, ABadLineGivesOneClearLine) {
    for (const auto& [line, about] : {std::pair{"", "empty"},
                                      {"   ", "empty"},
                                      {"set max-depth", "without ="},
                                      {"set =5", "without ="},
                                      {"open scene=\"a", "quote"},
                                      {"set fov=1 fov=2", "twice"}})
        try {
            Command::parse(line);
            ADD_FAILURE() << line;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(about), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
}

TEST(Command, ATextNamesTheLineThatIsWrong) {
    EXPECT_EQ(parseCommands("# a comment\n\n  set fov=40\r\nframe\n", "play").size(), 2U);
    try {
        parseCommands("frame\n\nset oops\n", "play");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.where(), "play:3");
    }
}

TEST(Command, NumbersThatAreNoneAreRefused) {
    for (const char* text : {"", "nan", "inf", "-inf", "1e999", "0x10", "1,5", "1 ", " 1", "five", "--1"})
        EXPECT_EQ(toNumber(text), std::nullopt) << text;
    EXPECT_EQ(toNumber("-1.5e3"), -1500);
}

TEST(Command, DegreesReadBackAsTheSameRadians) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(0, 180);
    for (int i = 0; i < 20000; ++i) {
        const double radiansValue = radians(angle(random));
        ASSERT_EQ(radians(*toNumber(degreesText(radiansValue))), radiansValue);
    }
    for (int i = 1; i <= 170; ++i) EXPECT_EQ(degreesText(radians(i)), fmt::format("{}", i));
}

TEST_F(Documents, EverySettingReadsBackWhatItWrites) {
    struct Case {
        const char* key;
        std::vector<const char*> good, bad;
    };
    const std::vector<Case> cases = {
        {"method", {"local", "cast", "whitted"}, {"Whitted", "raster", ""}},
        {"max-depth", {"0", "5", "64"}, {"-1", "65", "2.5", "nan", "deep"}},
        {"cutoff", {"0", "0.002", "1"}, {"-0.1", "1.1", "inf"}},
        {"shadows", {"on", "off"}, {"yes", "1", ""}},
        {"reflections", {"on", "off"}, {"true"}},
        {"refractions", {"on", "off"}, {"ON"}},
        {"fresnel", {"exact", "constant"}, {"schlick"}},
        {"glass-shadows", {"opaque", "straight", "all"}, {"none"}},
        {"fov", {"1", "30.5", "45", "170"}, {"0", "171", "-45", "nan"}},
        {"aspect", {"free", "1.5", "0.1", "10"}, {"0", "0.05", "11", "16:0", "16:", ":9", "a:b", "-1"}},
        {"exposure", {"-20", "0", "0.1", "20"}, {"-20.5", "21", "nan"}},
        {"tonemap", {"none", "clamp", "reinhard", "aces"}, {"filmic"}},
        {"samples", {"1", "16", "1000000"}, {"0", "1000001", "1.5", "-3"}},
        {"seconds", {"0", "2.5", "1000000"}, {"-1", "1000001"}},
        {"error", {"0", "0.01", "1"}, {"-0.01", "2"}},
        {"accel", {"auto", "brute", "bvh2", "bvh8"}, {"kd"}},
        {"threads", {"0", "1", "1024"}, {"-1", "1025", "1.5"}},
        {"seed", {"0", "1", "2147483647"}, {"-1", "2147483648"}}};
    ASSERT_EQ(cases.size(), settings().size());
    for (const Case& c : cases) {
        const Setting& setting = settingNamed(c.key);
        EXPECT_FALSE(setting.help.empty());
        for (const char* value : c.good)
            EXPECT_EQ(setting.get(edited(homage, fmt::format("set {}={}", c.key, value))), value) << c.key;
        for (const char* value : c.bad) {
            const std::string error = errorOf(homage, fmt::format("set {}=\"{}\"", c.key, value));
            EXPECT_NE(error.find(c.key), std::string::npos) << c.key << "=" << value << " was taken";
            EXPECT_EQ(error.find('\n'), std::string::npos);
        }
    }
}

TEST_F(Documents, AnAspectMayBeARatio) {
    EXPECT_EQ(edited(homage, "set aspect=16:9").aspect, 16.0 / 9);
    EXPECT_EQ(edited(homage, "set aspect=free").aspect, 0);
}

TEST_F(Documents, WhatNoCommandKnowsIsRefusedByName) {
    EXPECT_NE(errorOf(homage, "explode").find("no such command"), std::string::npos);
    EXPECT_NE(errorOf(homage, "set wings=2").find("no such setting"), std::string::npos);
    for (const DocumentCommand& command : documentCommands()) {
        if (command.name == "set") continue;
        EXPECT_NE(errorOf(homage, fmt::format("{} wings=2", command.name)), "") << command.name;
        EXPECT_FALSE(command.help.empty());
    }
}

TEST_F(Documents, WrongArgumentsAreRefusedInOneLine) {
    for (const char* line : {"set",
                             "step",
                             "step n=5",
                             "toggle key=fov",
                             "toggle key=wings",
                             "adjust key=method by=1",
                             "adjust key=fov",
                             "adjust key=fov by=nan",
                             "camera camera=nobody",
                             "camera eye=1,2",
                             "camera eye=0,0,0 target=0,0,0",
                             "camera target=1e300,0,0",
                             "camera eye=1e300,0,0",
                             "camera fov=180",
                             "orbit yaw=1e9",
                             "pan right=1e300",
                             "dolly",
                             "dolly factor=0",
                             "dolly factor=-1",
                             "turn yaw=x",
                             "frame object=nobody",
                             "select",
                             "select object=99",
                             "select object=-1",
                             "object object=0 material=99",
                             "object object=0 visible=maybe",
                             "object object=0 position=1e300,0,0",
                             "object object=0 x=1e300,0,0",
                             "move object=0",
                             "move by=1,1,1",
                             "move object=0 by=1,1",
                             "light",
                             "light light=9",
                             "light light=0 color=-1,0,0",
                             "light light=0 color=1e300",
                             "light light=0 intensity=-1",
                             "light light=0 position=1e300,0,0",
                             "light light=0 direction=0,0,0",
                             "light light=0 type=laser",
                             "add-light type=laser",
                             "remove-light",
                             "remove-light light=9",
                             "ambient",
                             "ambient color=red",
                             "environment zenith=1,2",
                             "material",
                             "material material=99",
                             "material material=0 ior=0.5",
                             "material material=0 ior=nan",
                             "material material=0 shininess=0"}) {
        const std::string error = errorOf(homage, line);
        EXPECT_FALSE(error.empty()) << line << " was taken";
        EXPECT_EQ(error.find('\n'), std::string::npos);
        EXPECT_LT(error.size(), 500U) << error;
    }
}

TEST_F(Documents, ANumberNamesAnItemBeforeAnItemOfThatName) {
    auto scene = std::make_shared<Scene>(*homage.scene);
    scene->objects[1].name = "0";
    Document document = homage;
    document.scene = scene;
    EXPECT_EQ(edited(document, "select object=0").selectedObject, 0);
    EXPECT_EQ(edited(homage, "select object=\"glass ball\"").selectedObject, 1);
}

TEST_F(Documents, StepsAddTheLecturesRaysOneByOne) {
    for (int n = 1; n <= 4; ++n) {
        const TraceSettings trace = edited(homage, fmt::format("step n={}", n)).render.trace;
        EXPECT_EQ(trace.method, Method::Whitted);
        EXPECT_EQ(trace.shadows, n >= 2);
        EXPECT_EQ(trace.reflections, n >= 3);
        EXPECT_EQ(trace.refractions, n >= 4);
    }
}

TEST_F(Documents, TogglingTwiceChangesNothing) {
    const Document off = edited(homage, "toggle key=shadows");
    EXPECT_FALSE(off.render.trace.shadows);
    EXPECT_TRUE(commandsBetween(homage, edited(off, "toggle key=shadows")).empty());
}

TEST_F(Documents, AdjustingAddsAndStopsAtTheEndOfTheRange) {
    EXPECT_EQ(edited(homage, "adjust key=max-depth by=2").render.trace.maxDepth, 7);
    Document document = homage;
    for (int i = 0; i < 80; ++i) document = edited(document, "adjust key=max-depth by=1");
    EXPECT_EQ(document.render.trace.maxDepth, 64);
    for (int i = 0; i < 80; ++i) document = edited(document, "adjust key=max-depth by=-1");
    EXPECT_EQ(document.render.trace.maxDepth, 0);
}

TEST_F(Documents, CameraCommandsMoveTheEyeAsTheySay) {
    const Camera& camera = homage.camera;
    const double distance = camera.distance();
    EXPECT_NEAR(edited(homage, "orbit yaw=90 pitch=10").camera.distance(), distance, 1e-9);
    EXPECT_EQ(edited(homage, "orbit yaw=90").camera.target, camera.target);
    EXPECT_EQ(edited(homage, "turn yaw=20").camera.eye, camera.eye);
    EXPECT_NEAR(edited(homage, "dolly factor=0.5").camera.distance(), distance / 2, 1e-9);
    const Document panned = edited(homage, "pan right=1 up=2 forward=3");
    EXPECT_NEAR(glm::length(panned.camera.eye - camera.eye), std::sqrt(14.0), 1e-9);
    EXPECT_NEAR(glm::length(panned.camera.target - camera.target), std::sqrt(14.0), 1e-9);
    const Document above = edited(homage, "camera camera=\"from above\"");
    EXPECT_EQ(above.camera, homage.scene->cameras[1]);
    EXPECT_EQ(edited(homage, "camera camera=1").camera, above.camera);
    const Document framed = edited(homage, "frame object=\"mirror ball\"");
    EXPECT_NEAR(glm::length(framed.camera.target - DVec3(1.05, 1.3, -1.4)), 0, 1e-6);
    EXPECT_EQ(edited(homage, "camera eye=1,2,3 fov=60").camera.eye, DVec3(1, 2, 3));
}

TEST_F(Documents, SceneCommandsChangeWhatTheyName) {
    const Document moved = edited(homage, "move object=\"mirror ball\" by=1,0,-1");
    EXPECT_EQ(DVec3(moved.scene->objects[3].transform[3]),
              DVec3(homage.scene->objects[3].transform[3]) + DVec3(1, 0, -1));
    EXPECT_EQ(edited(homage, "select object=3").selectedObject, 3);
    EXPECT_EQ(edited(homage, "select object=none").selectedObject, -1);
    EXPECT_FALSE(edited(homage, "object object=1 visible=off").scene->objects[1].visible);
    EXPECT_EQ(edited(homage, "object object=1 material=0").scene->objects[1].material, 0);
    EXPECT_EQ(edited(homage, "ambient color=0.5").scene->ambient, Color(0.5F));
    EXPECT_EQ(edited(homage, "environment nadir=1,2,3").scene->environment.nadir, Color(1, 2, 3));
    const Document glass = edited(homage, "material material=glass ior=2.42 transmission=0.5,1,1");
    EXPECT_EQ(std::get<TaughtMaterial>(glass.scene->materials[1].model).ior, 2.42F);
    const Document lamp = edited(homage, "light light=0 type=spot outer=30 inner=40 color=1,0,0 enabled=off");
    const SpotLamp& spot = std::get<SpotLamp>(lamp.scene->lights[0].shape);
    EXPECT_EQ(spot.outerCone, radians(30));
    EXPECT_EQ(spot.innerCone, spot.outerCone);
    EXPECT_FALSE(lamp.scene->lights[0].enabled);
    const Document two = edited(homage, "add-light name=second position=1,2,3");
    ASSERT_EQ(two.scene->lights.size(), 2U);
    EXPECT_EQ(DVec3(two.scene->lights[1].transform[3]), DVec3(1, 2, 3));
    EXPECT_EQ(edited(two, "remove-light light=second").scene->lights.size(), 1U);
}

TEST_F(Documents, ApplyLeavesItsInputAlone) {
    const Document before = homage;
    const Scene scene = *homage.scene;
    for (const char* line :
         {"set max-depth=1", "orbit yaw=5", "move object=0 by=1,1,1", "remove-light light=0",
          "material material=0 diffuse=1", "ambient color=1", "select object=1"})
        edited(homage, line);
    EXPECT_EQ(homage.scene, before.scene);
    EXPECT_EQ(homage.camera, before.camera);
    EXPECT_EQ(homage.render, before.render);
    EXPECT_EQ(homage.selectedObject, -1);
    EXPECT_EQ(homage.scene->objects[0].transform, scene.objects[0].transform);
    EXPECT_EQ(homage.scene->lights.size(), scene.lights.size());
    EXPECT_EQ(homage.scene->ambient, scene.ambient);
}

TEST_F(Documents, NothingLiesBetweenADocumentAndItself) {
    EXPECT_TRUE(commandsBetween(homage, homage).empty());
    EXPECT_TRUE(commandsBetween(homage, edited(homage, "select object=1")).empty());
    EXPECT_EQ(textsBetween(homage, edited(homage, "set max-depth=3 fov=50")),
              std::vector<std::string>{"set max-depth=3 fov=50"});
}

TEST_F(Documents, ALampThatIsRemovedTakesNothingFromTheOthers) {
    auto scene = std::make_shared<Scene>(*shadows.scene);
    ASSERT_GE(scene->lights.size(), 2U);
    scene->lights[1].range = 30;
    scene->lights[1].transform[0] = {0.6, 0.8, 0, 0}; // turned about its direction
    scene->lights[1].transform[1] = {-0.8, 0.6, 0, 0};
    scene->lights[1].transform[2] = {0, 0, 1, 0};
    Document from = shadows;
    from.scene = scene;
    const Document to = edited(from, "remove-light light=0");
    const Document back = broughtBack(from, to);
    EXPECT_TRUE(commandsBetween(back, to).empty());
    EXPECT_EQ(back.scene->lights[0].range, 30);
    EXPECT_EQ(back.scene->lights[0].transform, scene->lights[1].transform);
}

TEST_F(Documents, AnAddedLampComesBackAsItIs) {
    for (const char* more :
         {"", " falloff=on intensity=1", " position=0,0,0 direction=0,0,-1",
          " type=spot outer=33.3 inner=12.1", " type=rectangle width=2 height=0.5",
          " type=sphere radius=0.3 color=1e-05,2,3", " type=directional direction=1,2,3"}) {
        const Document to = edited(homage, std::string("add-light name=\"two\\nlines\"") + more);
        const Document back = broughtBack(homage, to);
        ASSERT_EQ(back.scene->lights.size(), 2U);
        const Light &made = back.scene->lights[1], &wanted = to.scene->lights[1];
        EXPECT_EQ(made.name, "two\nlines");
        EXPECT_EQ(made.transform, wanted.transform) << more;
        EXPECT_EQ(made.falloff, wanted.falloff) << more;
        EXPECT_EQ(made.intensity, wanted.intensity) << more;
        EXPECT_EQ(made.color, wanted.color) << more;
        EXPECT_TRUE(commandsBetween(back, to).empty()) << more;
    }
}

/// One edit at random, of any document command that fits the scene.
std::string randomEdit(std::mt19937& random, const Document& document) {
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    const auto real = [&](double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    const auto triple = [&](double lo, double hi) {
        return fmt::format("{},{},{}", real(lo, hi), real(lo, hi), real(lo, hi));
    };
    const Scene& scene = *document.scene;
    const auto lamp = [&] { return below(scene.lights.size()); };
    switch (below(scene.lights.empty() ? 12 : 16)) {
    case 0:
        return fmt::format("set fov={} max-depth={}", real(20, 80), below(6));
    case 1:
        return fmt::format("set cutoff={} exposure={}", real(0, 0.1), real(-3, 3));
    case 2:
        return fmt::format("orbit yaw={} pitch={}", real(-40, 40), real(-20, 20));
    case 3:
        return fmt::format("dolly factor={}", real(0.8, 1.3));
    case 4:
        return fmt::format("turn yaw={} pitch={}", real(-5, 5), real(-5, 5));
    case 5:
        return fmt::format("toggle key={}", below(2) != 0 ? "shadows" : "reflections");
    case 6:
        return fmt::format("move object={} by={}", below(scene.objects.size()), triple(-0.5, 0.5));
    case 7:
        return fmt::format("object object={} visible={} x={}", below(scene.objects.size()),
                           below(2) != 0 ? "on" : "off", triple(0.5, 1.5));
    case 8:
        return fmt::format("material material={} ior={} transmission={}", below(scene.materials.size()),
                           real(1, 2), real(0, 1));
    case 9:
        return fmt::format("environment zenith={} nadir={}", triple(0, 1), triple(0, 1));
    case 10:
        return fmt::format("ambient color={}", triple(0, 0.3));
    case 11:
        return fmt::format("add-light position={} direction={}", triple(-5, 5), triple(-1, 1));
    case 12:
        return fmt::format("remove-light light={}", lamp());
    case 13:
        return fmt::format("light light={} direction={} position={}", lamp(), triple(-1, 1), triple(1, 6));
    case 14:
        return fmt::format("light light={} type=spot outer={} inner={}", lamp(), real(10, 80), real(0, 80));
    default:
        return fmt::format("light light={} color={} intensity={} falloff={}", lamp(), triple(0, 2),
                           real(0, 3), below(2) != 0 ? "on" : "off");
    }
}

TEST_F(Documents, CommandsBetweenBringBackTheSamePictureAfterAnyEdits) {
    std::mt19937 random(1980);
    for (const Document& start : {homage, shadows, openScene("metals").document})
        for (int sequence = 0; sequence < 8; ++sequence) {
            Document to = start;
            std::string lines;
            for (int edit = 0; edit < 12; ++edit) {
                const std::string line = randomEdit(random, to);
                to = edited(to, line);
                lines += line + "\n";
            }
            const Document back = broughtBack(start, to);
            EXPECT_EQ(textsBetween(back, to), std::vector<std::string>{}) << lines;
            EXPECT_EQ(rendered(back), rendered(to)) << lines;
        }
}

TEST_F(Documents, UndoAndRedoWalkThroughAllSteps) {
    History history(homage);
    EXPECT_FALSE(history.canUndo());
    history.undo();
    history.redo();
    for (int depth = 1; depth <= 3; ++depth)
        history.change(edited(history.document(), fmt::format("set max-depth={}", depth)));
    const auto depth = [&] { return history.document().render.trace.maxDepth; };
    history.undo();
    EXPECT_EQ(depth(), 2);
    history.undo();
    history.undo();
    EXPECT_EQ(depth(), 5);
    EXPECT_FALSE(history.canUndo());
    history.redo();
    EXPECT_EQ(depth(), 1);
    history.change(edited(history.document(), "set max-depth=9"));
    EXPECT_FALSE(history.canRedo()) << "a change after undo ends what could be done again";
    EXPECT_EQ(history.original().render.trace.maxDepth, 5);
}

TEST_F(Documents, ADragIsOneStep) {
    History history(homage);
    const auto orbit = [&](const char* gesture) {
        history.change(edited(history.document(), "orbit yaw=1"), gesture);
    };
    for (int i = 0; i < 10; ++i) orbit("drag 1");
    const Camera afterFirst = history.document().camera;
    for (int i = 0; i < 10; ++i) orbit("drag 2");
    history.undo();
    EXPECT_EQ(history.document().camera, afterFirst);
    history.undo();
    EXPECT_EQ(history.document().camera, homage.camera);
    EXPECT_FALSE(history.canUndo());
    orbit("drag 3");
    history.endGesture();
    orbit("drag 3");
    history.undo();
    EXPECT_TRUE(history.canUndo());
}

TEST_F(Documents, WhatIsNoEditIsNoStep) {
    History history(homage);
    history.replace(edited(homage, "select object=1"));
    EXPECT_FALSE(history.canUndo());
    EXPECT_EQ(history.document().selectedObject, 1);
}

}
}
