// labels: unit
// What lies between two documents, as commands, and the steps of undo.
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/document/history.h"
#include "core/render/render_session.h"
#include "core/scene/world.h"
#include "tests/app_documents.h"

namespace eyeray {
namespace {

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
    session.start(buildWorld(document.scene, buildSettings(document)), document.camera, settings);
    while (session.wait(std::chrono::milliseconds(1000)).active()) {
    }
    return session.image();
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
