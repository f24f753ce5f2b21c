// labels: ui
// The views of the picked pixel's tree and sum.

#include <gtest/gtest.h>

#include "tests/app_screen.h"

namespace eyeray {
namespace {

/// The mirror ball of homage is picked, and what explains it is shown.
class Explained : public Screen {
public:
    Explained() : Screen("homage", 1280, 900) {
        say("explain on=on");
        settle();
        pixel = pixelOf(kMirrorBall);
        click(place(pixel));
        settle();
    }

    void say(const std::string& command) { gui.execute(Command::parse(command)); }
    void openTab(const std::string& tab) {
        click("tab " + tab);
        settle();
    }

    const PixelStudy& study() const { return viewer.study(); }
    const SampleRecord& record() const { return viewer.picked()->trace; }
    std::size_t errors() const {
        return static_cast<std::size_t>(
            std::count_if(viewer.notices().begin(), viewer.notices().end(),
                          [](const Notice& notice) { return notice.kind == Notice::Kind::Error; }));
    }
    /// The first node of this term.
    int nodeOf(Term term) const {
        const auto& nodes = study().ledger().nodes;
        const auto found = std::find_if(nodes.begin(), nodes.end(),
                                        [&](const LedgerNode& node) { return node.term == term; });
        if (found == nodes.end()) throw std::runtime_error("no such term");
        return static_cast<int>(found - nodes.begin());
    }

    PixelPosition pixel;
};

TEST(Explain, AClickOnANodeSelectsItsRayAndOneOnARowOfTheTableToo) {
    Explained screen;
    ASSERT_GT(screen.record().rays.size(), 2U);
    EXPECT_EQ(screen.viewer.selectedRay(), 0);
    screen.click("ray 2");
    EXPECT_EQ(screen.viewer.selectedRay(), 2);
    screen.click("tree=table");
    screen.settle();
    const WidgetRect row = screen.rect("row 1"); // it spans columns that are out of sight
    screen.click(Point{row.x0 + 20, (row.y0 + row.y1) / 2});
    EXPECT_EQ(screen.viewer.selectedRay(), 1);
    screen.click("tree=diagram");
    EXPECT_FALSE(screen.study().settings().table);
    EXPECT_EQ(screen.errors(), 0U);
}

TEST(Explain, TheTreeFollowsThePickedPixel) {
    Explained screen;
    EXPECT_EQ(screen.study().diagram().nodes.size(),
              screen.record().rays.size() + screen.record().untraced.size());
    screen.click(screen.place(PixelPosition{3, 3}));
    screen.settle();
    ASSERT_EQ(screen.study().diagram().nodes.size(), 1U);
    EXPECT_EQ(screen.study().diagram().nodes[0].title, "nothing hit");
}

TEST(Explain, TheKnobOfANodeFoldsWhatHangsOnIt) {
    Explained screen;
    const std::size_t all = screen.study().diagram().nodes.size();
    screen.click("fold 0");
    EXPECT_EQ(screen.study().diagram().nodes.size(), 1U);
    screen.settle();
    screen.click("fold 0");
    EXPECT_EQ(screen.study().diagram().nodes.size(), all);
    screen.say("collapse ray=0 on=on");
    EXPECT_EQ(screen.study().diagram().nodes.size(), 1U);
    screen.press("Right");
    screen.settle();
    EXPECT_GT(screen.study().diagram().nodes.size(), 1U) << "another pixel has another tree";
}

TEST(Explain, ASwitchHidesAKindOfRayFromTheTreeButNotFromThePicture) {
    Explained screen;
    const ColorImage picture = screen.viewer.session().image();
    const std::size_t all = screen.study().diagram().nodes.size();
    screen.click("tree shadow");
    const auto& nodes = screen.study().diagram().nodes;
    EXPECT_LT(nodes.size(), all);
    EXPECT_TRUE(std::none_of(nodes.begin(), nodes.end(),
                             [](const DiagramNode& node) { return node.kind == RayKind::Shadow; }));
    screen.settle();
    EXPECT_EQ(screen.viewer.session().image(), picture);
    screen.say("tree kind=shadow on=on least-weight=1");
    for (const DiagramNode& node : screen.study().diagram().nodes)
        if (node.traced) {
            EXPECT_GE(maxComponent(screen.record().rays[static_cast<std::size_t>(node.ray)].weight), 1);
        }
}

TEST(Explain, AStruckTermChangesThePixelAtOnceAndComesBack) {
    Explained screen;
    screen.openTab("Sum");
    EXPECT_EQ(screen.gui.widgets().count("strike"), 0U) << "nothing to bring back";
    const Color film = screen.viewer.picked()->trace.radiance;
    EXPECT_EQ(evaluate(screen.study().ledger()), film);
    const int mirrored = screen.nodeOf(Term::Sent);
    screen.click(fmt::format("strike {}", mirrored));
    ASSERT_EQ(screen.study().strikes().size(), 1U);
    const Color without = evaluate(screen.study().ledger(), screen.study().strikes());
    EXPECT_LT(luminance(without), luminance(film));
    screen.settle();
    EXPECT_EQ(screen.gui.widgets().count("ledger total"), 1U);
    EXPECT_EQ(screen.gui.widgets().count("ledger struck"), 1U) << "before and after stand side by side";
    screen.click("strike");
    EXPECT_TRUE(screen.study().strikes().empty());
    screen.say(fmt::format("strike term={}", mirrored));
    EXPECT_TRUE(screen.study().isStruck(mirrored));
    screen.say(fmt::format("strike term={} on=off", mirrored));
    EXPECT_FALSE(screen.study().isStruck(mirrored));
}

TEST(Explain, AStruckReflectionIsThePixelWithoutReflectionRays) {
    Explained screen;
    screen.say(fmt::format("strike term={}", screen.nodeOf(Term::Sent)));
    const Color without = evaluate(screen.study().ledger(), screen.study().strikes());
    screen.say("set reflections=off");
    screen.settle();
    EXPECT_EQ(screen.viewer.picked()->trace.radiance, without);
    EXPECT_TRUE(screen.study().strikes().empty()) << "the sum is another one now";
}

TEST(Explain, WhatIsStruckOutCanBeTakenOutOfTheWholePictureInOneStepOfUndo) {
    Explained screen;
    screen.openTab("Sum");
    screen.click(fmt::format("strike {}", screen.nodeOf(Term::Sent)));
    screen.click(fmt::format("strike {}", screen.nodeOf(Term::Lamp)));
    screen.click(fmt::format("strike {}", screen.nodeOf(Term::Ambient)));
    const Color without = evaluate(screen.study().ledger(), screen.study().strikes());
    screen.settle();
    screen.click("strike-picture");
    screen.settle();
    EXPECT_FALSE(screen.document().render.trace.reflections);
    EXPECT_EQ(screen.document().scene->ambient, Color(0));
    EXPECT_EQ(screen.viewer.picked()->trace.radiance, without);
    screen.press("Ctrl+Z");
    EXPECT_TRUE(screen.document().render.trace.reflections);
    EXPECT_FALSE(screen.viewer.canUndo());
    EXPECT_FALSE(screen.gui.execute(Command::parse("strike-picture"))) << "nothing is struck out now";
}

TEST(Explain, TabsAreShownByACommandToo) {
    Explained screen;
    screen.say("tab name=sum");
    screen.settle();
    EXPECT_EQ(screen.gui.widgets().count("ledger total"), 1U);
    screen.say("tab name=tree");
    screen.settle();
    EXPECT_EQ(screen.gui.widgets().count("ray 0"), 1U);
}

TEST(Explain, AClickOnATermSelectsItsRay) {
    Explained screen;
    screen.openTab("Sum");
    const int sent = screen.nodeOf(Term::Sent);
    const WidgetRect term = screen.rect(fmt::format("term {}", sent));
    screen.click(Point{term.x1 - 10, (term.y0 + term.y1) / 2});
    EXPECT_EQ(screen.viewer.selectedRay(), screen.study().ledger().at(sent).ray);
    EXPECT_GT(screen.viewer.selectedRay(), 0);
}

TEST(Explain, SamplesAreChosenByTheirArrows) {
    Explained screen;
    screen.openTab("Sum");
    const Color first = screen.viewer.picked()->trace.radiance;
    screen.click("sample after");
    EXPECT_EQ(screen.viewer.picked()->sample, 1);
    EXPECT_NE(screen.viewer.picked()->trace.radiance, first);
    screen.settle();
    screen.click("sample before");
    EXPECT_EQ(screen.viewer.picked()->trace.radiance, first);
}

TEST(Explain, TheMeanOfTheRetracedSamplesIsTheFilm) {
    Explained screen;
    const auto film = screen.viewer.session().pixel(screen.pixel.x, screen.pixel.y);
    ASSERT_TRUE(film);
    EXPECT_EQ(film->samples, kSamples);
    EXPECT_EQ(screen.study().mean().samples(), kSamples);
    EXPECT_EQ(screen.study().mean().value(), film->mean);
    EXPECT_EQ(screen.viewer.session().image().at(screen.pixel.x, screen.pixel.y), film->mean);
    screen.say("set max-depth=0");
    screen.settle();
    EXPECT_EQ(screen.study().mean().value(),
              screen.viewer.session().image().at(screen.pixel.x, screen.pixel.y))
        << "another picture, another mean";
}

TEST(Explain, TheNotationIsChosenInTheMenu) {
    Explained screen;
    screen.openTab("Sum");
    const ByteImage letters = screen.picture();
    screen.click("notation");
    screen.settle();
    screen.click("notation=glm");
    EXPECT_EQ(screen.study().settings().notation, Notation::Glm);
    EXPECT_NE(screen.picture(), letters);
    screen.say("notation name=a");
    EXPECT_EQ(screen.picture(), letters);
}

TEST(Explain, TheSumOfAPathIsShownNestedOrAsAFlatList) {
    Explained screen;
    screen.say("set method=path");
    screen.settle();
    screen.openTab("Sum");
    const ByteImage nested = screen.picture();
    screen.click("flat list");
    EXPECT_TRUE(screen.study().settings().flatSum);
    EXPECT_NE(screen.picture(), nested);
    screen.click("path term 0");
    EXPECT_EQ(screen.errors(), 0U);
    screen.say("sum show=nested");
    EXPECT_FALSE(screen.study().settings().flatSum);
}

TEST(Explain, WrongCommandsAreRefusedWithOneLineEach) {
    Explained screen;
    std::size_t refused = 0;
    for (const char* command :
         {"strike term=1000000", "strike term=-1", "tree kind=laser", "tree show=pie", "tree least-weight=2",
          "collapse", "collapse ray=x", "notation", "tab name=pie", "notation name=c", "sum show=pie"}) {
        while (!screen.viewer.notices().empty()) screen.viewer.dismissNotice(0);
        EXPECT_FALSE(screen.gui.execute(Command::parse(command))) << command;
        refused += screen.errors();
    }
    EXPECT_EQ(refused, 11U);
    screen.press("Escape");
    EXPECT_FALSE(screen.gui.execute(Command::parse("strike term=0"))) << "nothing is picked";
}

TEST(Explain, WithNothingPickedTheViewsSayWhatToDo) {
    Explained screen;
    screen.press("Escape");
    screen.settle();
    EXPECT_EQ(screen.gui.widgets().count("ray 0"), 0U);
    screen.openTab("Sum");
    EXPECT_EQ(screen.gui.widgets().count("ledger total"), 0U);
    EXPECT_EQ(screen.errors(), 0U);
}

}
}
