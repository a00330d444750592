#include "widgets/render/node_motion.h"

#include <gtest/gtest.h>

#include "tests/scenes/fe_scenes.h"

namespace rubble::render {
namespace {

constexpr float rounding = 1e-5f;  // m, of single precision at a few metres

std::shared_ptr<const FeResult> fallingBlock(bool withVelocity) {
    scenes::Block block{.low = Vec3(0, 0, 10), .velocity = Vec3(1, 0, 0), .gravity = 10.0};
    block.deathState = [](std::size_t) { return std::size_t{3}; };
    return scenes::makeScene({block}, 5, 0.1, withVelocity);
}

TEST(NodeMotion, MeetsEveryStateAndIsLinearBetween) {
    const auto fe = fallingBlock(true);
    NodeMotion motion(fe);
    for (std::size_t k = 0; k < 2; ++k) {
        motion.moveTo(fe->times()[k]);
        EXPECT_EQ(motion.state(), k);
        EXPECT_FALSE(motion.interpolated());
        for (std::size_t n = 0; n < 8; ++n) {
            EXPECT_LT((motion[n] - fe->state(k)->positions[n].cast<float>()).norm(), rounding);
        }
        motion.moveTo(fe->times()[k] + 0.025);
        EXPECT_TRUE(motion.interpolated());
        for (std::size_t n = 0; n < 8; ++n) {
            const Vec3 expected = 0.75 * fe->state(k)->positions[n] + 0.25 * fe->state(k + 1)->positions[n];
            EXPECT_LT((motion[n] - expected.cast<float>()).norm(), rounding);
        }
    }
}

TEST(NodeMotion, NodesOfDyingElementsFlyOnWhateverTheFileSays) {
    for (const bool withVelocity : {true, false}) {
        const auto fe = fallingBlock(withVelocity);
        NodeMotion motion(fe);
        motion.moveTo(0.25);  // dead at 0.3, so the positions there are not asked for
        const Vec3 before = fe->state(1)->positions[0], last = fe->state(2)->positions[0];
        const Vec3 step = withVelocity ? Vec3(0.1 * Vec3(1, 0, -10.0 * 0.2)) : Vec3(last - before);
        EXPECT_LT((motion[0] - (last + 0.5 * step).cast<float>()).norm(), rounding) << withVelocity;
    }
}

TEST(NodeMotion, StandsStillBeforeTheFirstAndAfterTheLastState) {
    const auto fe = scenes::makeScene({{.velocity = Vec3(1, 0, 0)}}, 3, 0.1);
    NodeMotion motion(fe);
    motion.moveTo(-5.0);
    EXPECT_EQ(motion.state(), 0u);
    EXPECT_EQ(motion[0], fe->state(0)->positions[0].cast<float>());
    motion.moveTo(99.0);
    EXPECT_EQ(motion.state(), 2u);
    EXPECT_FALSE(motion.interpolated());
    EXPECT_EQ(motion[0], fe->state(2)->positions[0].cast<float>());
}

}  // namespace
}  // namespace rubble::render
