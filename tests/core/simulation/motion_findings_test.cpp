#include "core/simulation/run/motion_findings.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

// "Sound" stood beside a bridge of whose bodies one in twelve still moved.
TEST(MotionFindings, TellWhatStillMovedWhenTheSettleTimeWasOver) {
    const auto of = [](const MotionAccount& account) {
        Findings findings;
        addMotionFindings(account, findings);
        return findings;
    };
    const Findings moving = of({0, 0, 790, 4148, 351, false, 19.68});
    ASSERT_EQ(moving.list().size(), 1u);
    EXPECT_EQ(englishText(moving.list()[0].what),
              "351 of 4,148 bodies still moved at 19.68 s, when the settle time was over: the debris is not yet what it comes to");
    EXPECT_EQ(moving.count("simulation.still_moving"), 351);
    EXPECT_TRUE(of({0, 0, 790, 4148, 12, true, 12.0}).empty()) << "99 of 100 sleep: the run ended at rest";
    const Findings held = of({7, 14'088, 623, 40, 0, true, 9.0});
    EXPECT_EQ(held.count("simulation.held_together"), 7);
    EXPECT_EQ(held.count("simulation.speed_held"), 14'088);
}

}  // namespace
}  // namespace rubble
