// labels: unit
// A sample played ray by ray: steps, what is on record so far, and the lines of the algorithm.

#include <gtest/gtest.h>

#include "core/study/playback.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

RayRecord ray(RayKind kind, int parent, RayEnd end) { return {.parent = parent, .kind = kind, .end = end}; }

/// eye → shadow, reflection → shadow, refraction into the background.
SampleRecord sample() {
    SampleRecord record;
    record.rays = {ray(RayKind::Eye, -1, RayEnd::Hit), ray(RayKind::Shadow, 0, RayEnd::Blocked),
                   ray(RayKind::Reflection, 0, RayEnd::Hit), ray(RayKind::Shadow, 2, RayEnd::Unblocked),
                   ray(RayKind::Refraction, 0, RayEnd::Background)};
    record.lamps = {{.ray = 0, .shadowRay = 1}, {.ray = 2, .shadowRay = 3}};
    record.untraced = {{.parent = 2}};
    return record;
}

TEST(Playback, StepsForwardAndBackWithinTheSample) {
    const SampleRecord record = sample();
    EXPECT_EQ(played(record, 3, PlayTo::Next), 4);
    EXPECT_EQ(played(record, 5, PlayTo::Next), 5);
    EXPECT_EQ(played(record, 3, PlayTo::Back), 2);
    EXPECT_EQ(played(record, 1, PlayTo::Back), 1) << "the eye ray stays";
    EXPECT_EQ(played(record, 3, PlayTo::Start), 1);
    EXPECT_EQ(played(record, 3, PlayTo::End), 5);
    for (int traced = 1; traced < 5; ++traced)
        EXPECT_EQ(played(record, played(record, traced, PlayTo::Next), PlayTo::Back), traced);
}

TEST(Playback, GoesToTheNextHitOrLampRayAndElseToTheEnd) {
    const SampleRecord record = sample();
    EXPECT_EQ(played(record, 1, PlayTo::Hit), 3);
    EXPECT_EQ(played(record, 3, PlayTo::Hit), 5) << "no further hit";
    EXPECT_EQ(played(record, 1, PlayTo::Light), 2);
    EXPECT_EQ(played(record, 2, PlayTo::Light), 4);
}

TEST(Playback, HasOnRecordWhatTheRaysSoFarHaveFound) {
    const SampleRecord record = sample();
    const SampleRecord two = firstRays(record, 2), three = firstRays(record, 3), all = firstRays(record, 5);
    EXPECT_EQ(two.rays.size(), 2U);
    EXPECT_EQ(two.lamps.size(), 1U);
    EXPECT_TRUE(two.untraced.empty());
    EXPECT_EQ(three.lamps.size(), 1U) << "the shadow ray of the mirrored hit is still to come";
    EXPECT_EQ(three.untraced.size(), 1U);
    EXPECT_EQ(all.rays.size(), record.rays.size());
    EXPECT_EQ(all.lamps.size(), record.lamps.size());
    EXPECT_TRUE(firstRays({}, 3).rays.empty());
}

TEST(Playback, MarksTheLineThatSendsADiffuseRay) {
    const RayRecord diffuse{.kind = RayKind::Diffuse, .end = RayEnd::Hit};
    const std::size_t caller = linesOf(Method::Path, diffuse).front();
    EXPECT_NE(pseudoCode(Method::Path)[caller].find("random ray of that kind"), std::string::npos);
}

TEST(Playback, MarksTheLinesThatTraceARay) {
    const SampleRecord record = sample();
    const auto code = pseudoCode(Method::Whitted);
    const auto text = [&](std::size_t index) {
        std::string all;
        for (const std::size_t line : linesOf(Method::Whitted, record.rays[index])) all += code[line];
        return all;
    };
    EXPECT_NE(text(0).find("eye ray"), std::string::npos);
    EXPECT_NE(text(0).find("closest hit"), std::string::npos);
    EXPECT_EQ(text(1).find("add"), std::string::npos) << "blocked: nothing is added";
    EXPECT_NE(text(2).find("kr"), std::string::npos);
    EXPECT_NE(text(3).find("add the lamp"), std::string::npos);
    EXPECT_NE(text(4).find("kt"), std::string::npos);
    EXPECT_NE(text(4).find("background"), std::string::npos);
    for (const Method method :
         {Method::Local, Method::Cast, Method::Whitted, Method::Distributed, Method::Path})
        for (const RayRecord& one : record.rays)
            for (const std::size_t line : linesOf(method, one)) EXPECT_LT(line, pseudoCode(method).size());
}

}
}
