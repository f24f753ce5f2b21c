// labels: unit
#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/document/document.h"
#include "app/document/settings.h"
#include "core/base/errors.h"
#include "tests/app_documents.h"

namespace eyeray {
namespace {

/// What the error of a command says; nothing if it was carried out.
std::string errorOf(const Document& document, const std::string& line) {
    try {
        edited(document, line);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

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
                                      {"set fov=1 fov=2", "twice"},
                                      {"\"set it\" fov=1", "name of a command"},
                                      {"set \"the fov\"=1", "letters"}})
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
        {"method", {"local", "cast", "whitted", "distributed", "path"}, {"Whitted", "raster", ""}},
        {"max-depth", {"0", "5", "64"}, {"-1", "65", "2.5", "nan", "deep"}},
        {"cutoff", {"0", "0.002", "1"}, {"-0.1", "1.1", "inf"}},
        {"shadows", {"on", "off"}, {"yes", "1", ""}},
        {"reflections", {"on", "off"}, {"true"}},
        {"refractions", {"on", "off"}, {"ON"}},
        {"diffuse", {"on", "off"}, {"maybe"}},
        {"sampler", {"independent", "stratified", "sobol"}, {"halton"}},
        {"lens", {"0", "0.05", "2"}, {"-1", "wide"}},
        {"focus", {"0", "3.5"}, {"-1", "inf"}},
        {"fresnel", {"exact", "constant"}, {"schlick"}},
        {"fault", {"none", "no-gamma", "sphere-slide,no-gamma"}, {"typo", "no-gamma,typo"}},
        {"epsilon", {"0", "0.0001", "1"}, {"-0.1", "2"}},
        {"clamp", {"0", "1", "1000000"}, {"-1", "1000001"}},
        {"precision", {"float", "double"}, {"half"}},
        {"aim", {"samples", "edges"}, {"vertices"}},
        {"glass-shadows", {"opaque", "straight", "all"}, {"none"}},
        {"fov", {"1", "30.5", "45", "170"}, {"0", "171", "-45", "nan"}},
        {"aspect", {"free", "1.5", "0.1", "10"}, {"0", "0.05", "11", "16:0", "16:", ":9", "a:b", "-1"}},
        {"exposure", {"-20", "0", "0.1", "20"}, {"-20.5", "21", "nan"}},
        {"tonemap", {"none", "clamp", "reinhard", "aces"}, {"filmic"}},
        {"samples", {"1", "16", "1000000"}, {"0", "1000001", "1.5", "-3"}},
        {"seconds", {"0", "2.5", "1000000"}, {"-1", "1000001"}},
        {"error", {"0", "0.01", "1"}, {"-0.01", "2"}},
        {"adaptive", {"on", "off"}, {"yes"}},
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

}
}
