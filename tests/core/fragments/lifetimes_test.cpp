#include "core/fragments/lifetimes.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

struct Scanned {
    std::vector<Lifetime> lives;
    Findings findings;
};

std::shared_ptr<const FeResult> withActivity(const std::vector<std::string>& activity) {
    test::ElementScene scene;
    for (const std::string& a : activity) {
        scene.element(ElementShape::Tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, a);
    }
    return scene.result();
}

Scanned scan(const std::vector<std::string>& activity, Revival policy) {
    const auto fe = withActivity(activity);
    Scanned scanned;
    scanned.lives = endedLifetimes(*fe, test::ElementScene::components(*fe), policy, scanned.findings, Execution());
    return scanned;
}

TEST(Lifetimes, AreOrderedByHandOverThenElement) {
    const Scanned s = scan({"11110", "11000", "11111", "10000", "11000"}, Revival::Latch);
    ASSERT_EQ(s.lives.size(), 4u);
    const std::size_t elements[]{3, 1, 4, 0};
    const std::uint32_t last[]{0, 1, 1, 3};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(at(s.lives[i].element), elements[i]);
        EXPECT_EQ(s.lives[i].firstActive, 0u);
        EXPECT_EQ(s.lives[i].lastActive, last[i]);
        EXPECT_EQ(s.lives[i].firstDead, last[i] + 1);
        EXPECT_FALSE(s.lives[i].backAt);
    }
    EXPECT_TRUE(s.findings.empty());
}

TEST(Lifetimes, LatchKeepsTheDeadDead) {
    const Scanned s = scan({"110110", "111111"}, Revival::Latch);
    ASSERT_EQ(s.lives.size(), 1u);
    EXPECT_EQ(s.lives[0].lastActive, 1u);
    EXPECT_FALSE(s.lives[0].backAt);
    EXPECT_EQ(s.findings.count("fragments.revived"), 1);
    EXPECT_EQ(s.findings.list()[0].example, "element 1,001 (rubble) at state 3");
}

TEST(Lifetimes, LatchCountsAnElementOnceHoweverOftenItReturns) {
    EXPECT_EQ(scan({"1010101"}, Revival::Latch).findings.count("fragments.revived"), 1);
}

TEST(Lifetimes, FollowMakesOneOfEveryDeath) {
    const Scanned s = scan({"1101100", "1001011"}, Revival::Follow);
    ASSERT_EQ(s.lives.size(), 4u);
    // In order of their hand-over: 1 at 0, 0 at 1, 1 at 3, 0 at 4.
    EXPECT_EQ(at(s.lives[0].element), 1u);
    EXPECT_EQ(s.lives[0].backAt, 3u);
    EXPECT_EQ(at(s.lives[1].element), 0u);
    EXPECT_EQ(s.lives[1].backAt, 3u);
    EXPECT_EQ(at(s.lives[2].element), 1u);
    EXPECT_EQ(s.lives[2].firstActive, 3u);
    EXPECT_EQ(s.lives[2].backAt, 5u);
    EXPECT_EQ(at(s.lives[3].element), 0u);
    EXPECT_EQ(s.lives[3].firstActive, 3u);
    EXPECT_EQ(s.lives[3].firstDead, 5u);
    EXPECT_FALSE(s.lives[3].backAt);
    EXPECT_EQ(s.findings.count("fragments.revived"), 3);
}

TEST(Lifetimes, RefuseNamesElementAndState) {
    try {
        scan({"1111", "1101"}, Revival::Refuse);
        FAIL() << "a revival went through";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("element 1,002 (rubble) at state 3"), std::string::npos) << error.what();
    }
    EXPECT_EQ(scan({"1100", "0110"}, Revival::Refuse).lives.size(), 2u);
}

TEST(Lifetimes, NeverActiveAndLateElementsAreCounted) {
    const Scanned s = scan({"0000", "0110", "0011", "1111"}, Revival::Latch);
    ASSERT_EQ(s.lives.size(), 1u);
    EXPECT_EQ(at(s.lives[0].element), 1u);
    EXPECT_EQ(s.lives[0].firstActive, 1u);
    EXPECT_EQ(s.findings.count("fragments.never_active"), 1);
    EXPECT_EQ(s.findings.count("fragments.activated_later"), 2);
    EXPECT_EQ(s.findings.count("fragments.revived"), 0);
}

TEST(Lifetimes, ActivityUnderAPolicy) {
    const auto fe = withActivity({"0110110", "1111111", "1000001"});
    const Activity latched = activityUnder(fe->activity(), Revival::Latch);
    const std::string expected[]{"0110000", "1111111", "1000000"};
    for (std::size_t e = 0; e < 3; ++e) {
        for (std::size_t k = 0; k < 7; ++k) {
            EXPECT_EQ(latched.active(k, idAt<ElementIndex>(e)), expected[e][k] == '1') << e << " at " << k;
        }
    }
    EXPECT_TRUE(activityUnder(fe->activity(), Revival::Follow).active(6, idAt<ElementIndex>(2)));
}

TEST(Lifetimes, CancelStopsTheScan) {
    const auto fe = withActivity({"1100"});
    Execution execution;
    execution.cancel();
    Findings findings;
    EXPECT_THROW(endedLifetimes(*fe, test::ElementScene::components(*fe), Revival::Latch, findings, execution), Cancelled);
}

}  // namespace
}  // namespace rubble
