#include "widgets/render/shapes/node_motion.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

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
    NodeMotion motion(fe, std::make_shared<StateReadAhead>(fe));
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
        NodeMotion motion(fe, std::make_shared<StateReadAhead>(fe));
        motion.moveTo(0.25);  // dead at 0.3, so the positions there are not asked for
        const Vec3 before = fe->state(1)->positions[0], last = fe->state(2)->positions[0];
        const Vec3 step = withVelocity ? Vec3(0.1 * Vec3(1, 0, -10.0 * 0.2)) : Vec3(last - before);
        EXPECT_LT((motion[0] - (last + 0.5 * step).cast<float>()).norm(), rounding) << withVelocity;
    }
}

TEST(NodeMotion, StandsStillBeforeTheFirstAndAfterTheLastState) {
    const auto fe = scenes::makeScene({{.velocity = Vec3(1, 0, 0)}}, 3, 0.1);
    NodeMotion motion(fe, std::make_shared<StateReadAhead>(fe));
    motion.moveTo(-5.0);
    EXPECT_EQ(motion.state(), 0u);
    EXPECT_EQ(motion[0], fe->state(0)->positions[0].cast<float>());
    motion.moveTo(99.0);
    EXPECT_EQ(motion.state(), 2u);
    EXPECT_FALSE(motion.interpolated());
    EXPECT_EQ(motion[0], fe->state(2)->positions[0].cast<float>());
}

TEST(NodeMotion, ComesFromAnyTimeToTheSamePlaces) {
    for (const bool withVelocity : {true, false}) {
        scenes::Block block{.low = Vec3(0, 0, 10), .size = Vec3(4, 3, 3), .cells = {4, 3, 3}, .velocity = Vec3(1, 0, 0)};
        block.deathState = [](std::size_t e) { return 1 + e % 8; };
        const auto fe = scenes::makeScene({block}, 10, 0.1, withVelocity);
        const auto states = std::make_shared<StateReadAhead>(fe);
        NodeMotion motion(fe, states);
        for (const double time : {0.45, 0.05, 0.85, 0.86, 0.3, 0.12, 0.95, 0.0, 0.55}) {
            motion.moveTo(time);
            NodeMotion anew(fe, states);
            anew.moveTo(time);
            for (std::size_t n = 0; n < fe->mesh().nodeCount(); ++n) {
                EXPECT_EQ(motion[n], anew[n]) << time;
            }
        }
    }
}

TEST(NodeMotion, BetweenStatesFurtherApartPlacesAreLinearToo) {
    const auto slow = [](std::shared_ptr<const StateSource> source) {
        class Slow : public StateSource {
        public:
            explicit Slow(std::shared_ptr<const StateSource> source) : m_source(std::move(source)) {}
            FeState read(std::size_t k) const override {
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
                return m_source->read(k);
            }

        private:
            std::shared_ptr<const StateSource> m_source;
        };
        return std::make_shared<Slow>(std::move(source));
    };
    const auto falling = scenes::makeScene({{.low = Vec3(0, 0, 50), .velocity = Vec3(1, 0, 0), .gravity = 10.0}}, 40, 0.05, true);
    FeResult::Contents contents = falling->contents();
    contents.source = slow(contents.source);
    const auto result = std::make_shared<const FeResult>(std::move(contents));
    NodeMotion motion(result, std::make_shared<StateReadAhead>(result));
    std::size_t apart = 1;
    for (int i = 0; i < 90; ++i) {
        const double time = 0.02 * i;
        motion.moveTo(time, false);
        apart = std::max(apart, motion.statesApart());
        EXPECT_EQ(motion.state(), static_cast<std::size_t>((time + 1e-6) / 0.05));
        // A chord of the parabola is off by no more than an eighth of its acceleration times the square of its length.
        const double length = 0.05 * static_cast<double>(motion.statesApart());
        const Vec3 exact = falling->mesh().nodes[0] + Vec3(time, 0, -5.0 * time * time);
        EXPECT_LT((motion[0].cast<double>() - exact).norm(), 10.0 * length * length / 8.0 + 1e-4) << time;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_GT(apart, 1u);
    motion.moveTo(0.43);
    EXPECT_EQ(motion.statesApart(), 1u);
}

}  // namespace
}  // namespace rubble::render
