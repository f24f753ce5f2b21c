// labels: unit
// Which solid a ray is in, against a plain list of them.

#include <gtest/gtest.h>

#include <vector>

#include "core/transport/medium_stack.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

TEST(MediumStack, IsEmptyAtFirst) {
    EXPECT_EQ(MediumStack().top(), MediumStack::kVacuum);
    EXPECT_EQ(MediumStack().left(3).top(), MediumStack::kVacuum) << "what was never entered may be left";
}

TEST(MediumStack, BehavesLikeASetOfSixAtMostWhoseHighestRankRules) {
    cases::Random random(1);
    const auto rankOf = [](std::uint32_t instance) { return instance * 7 % 9; };
    const auto lower = [&](std::uint32_t a, std::uint32_t b) { return rankOf(a) < rankOf(b); };
    for (int round = 0; round < 200; ++round) {
        MediumStack stack;
        std::vector<std::uint32_t> list;
        for (int step = 0; step < 50; ++step) {
            const auto instance = static_cast<std::uint32_t>(random.below(9));
            const bool inside = std::find(list.begin(), list.end(), instance) != list.end();
            EXPECT_EQ(stack.contains(instance), inside);
            if (random.below(2) == 0) {
                stack = stack.entered(instance, rankOf(instance));
                if (!inside && list.size() < 6) list.push_back(instance);
            } else {
                stack = stack.left(instance);
                std::erase(list, instance);
            }
            ASSERT_EQ(stack.top(), list.empty() ? MediumStack::kVacuum
                                                : *std::max_element(list.begin(), list.end(), lower));
        }
    }
}

}
}
