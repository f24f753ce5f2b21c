// labels: unit

#include "core/base/fault.h"

#include <gtest/gtest.h>

#include "app/document/document.h"
#include "core/base/errors.h"
#include "tests/app_documents.h"

namespace eyeray {
namespace {

TEST(FaultSet, IsReadBackFromItsText) {
    for (int i = 0; i < kFaults; ++i) {
        const auto fault = static_cast<Fault>(i);
        EXPECT_EQ(faultNamed(describe(fault).name), fault);
        EXPECT_EQ(toText(fault), describe(fault).name);
        EXPECT_FALSE(describe(fault).wrong.empty());
    }
    FaultSet two = Fault::NoGamma;
    two.set(Fault::SphereSlide, true);
    EXPECT_EQ(toText(two), "sphere-slide,no-gamma");
    EXPECT_EQ(faultsNamed("no-gamma,sphere-slide"), two);
    two.set(Fault::NoGamma, false);
    EXPECT_EQ(two, FaultSet(Fault::SphereSlide));
    EXPECT_EQ(toText(FaultSet()), "none");
    EXPECT_TRUE(faultsNamed("none").empty());
}

TEST(FaultSet, NamesTheKnownFaultsWhenAskedForAnother) {
    try {
        faultsNamed("sphere-slide,typo");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("fault typo"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("roulette-unweighted"), std::string::npos) << error.what();
    }
}

TEST_F(Documents, FaultsAreSettingsWithAWordOfTheirOwnForOne) {
    const Document one = edited(homage, "fault name=sphere-slide");
    EXPECT_EQ(one.render.trace.faults, FaultSet(Fault::SphereSlide));
    const Document two = edited(one, "fault name=no-gamma on=on");
    const std::vector<Command> commands =
        commandsBetween(homage, edited(two, "set epsilon=0.01 precision=double"));
    ASSERT_EQ(commands.size(), 1U);
    EXPECT_EQ(commands[0].text(), "set fault=sphere-slide,no-gamma epsilon=0.01 precision=double");
    EXPECT_EQ(edited(homage, commands[0].text()).render.trace.faults, two.render.trace.faults);
    EXPECT_TRUE(edited(two, "set fault=none").render.trace.faults.empty());
    EXPECT_EQ(edited(two, "fault name=no-gamma on=off").render.trace.faults, one.render.trace.faults);
    EXPECT_THROW(edited(homage, "fault name=typo"), InputError);
    EXPECT_THROW(edited(homage, "set epsilon=2"), InputError);
}

}
}
