#include "core/validation/validate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/standard_gravity.h"

namespace rubble {

namespace {

/// Blocks that slide to rest on level ground, measured by the law of friction.
ValidationSet slidingBlocks(double friction) {
    ValidationSet set;
    set.id = "slides";
    for (int i = 0; i < 12; ++i) {
        LooseBody body;
        body.id = std::to_string(i);
        body.mass = 500.0;
        body.sides = {1.0, 1.0, 0.2};
        body.pose.position = {0.0, 5.0 * i, 0.1};
        body.velocity = {2.0 + 0.2 * i, 0.0, 0.0};
        MeasuredEnd end;
        end.place = body.pose.position + Vec3(body.velocity.squaredNorm() / (2.0 * friction * standardGravity), 0.0, 0.0);
        end.group = i % 2 == 0 ? "even" : "odd";
        set.bodies.push_back(body);
        set.measured.push_back(end);
    }
    set.variants.push_back({"right", "", {{"friction", std::to_string(friction), "given"}}, {}});
    return set;
}

TEST(Validate, LawOfFrictionIsMet) {
    ValidationSet set = slidingBlocks(0.5);
    set.criteria = {{"right", "run_out_m.error", -0.02, 0.02, {}},
                    {"right", "run_out_m[even].simulated", 0.0, 9.0, "run_out_m[odd].simulated"},
                    {"right", "run_out_m.measured", 5.0, 9.0, {}}};
    const SetResult result = validate(set, {}, Execution{});
    const VariantResult& variant = result.variants.front();
    EXPECT_EQ(variant.bodies, 12);
    EXPECT_EQ(variant.moving + variant.left + variant.lost, 0);
    // 2 % of a slide of a metre: twice the criterion of the self-test, at fewer steps than it takes.
    EXPECT_NEAR(variant.figure("run_out_m.error"), 0.0, 0.02);
    EXPECT_NEAR(variant.figure("run_out_m.scatter_ratio"), 1.0, 0.02);
    ASSERT_EQ(variant.verdicts.size(), 3u);
    EXPECT_TRUE(variant.verdicts[0].within);
    EXPECT_TRUE(variant.verdicts[1].within);
    EXPECT_FALSE(variant.verdicts[2].within);
    EXPECT_TRUE(std::isnan(variant.figure("nothing")));
}

TEST(Validate, WrongFrictionIsSeen) {
    ValidationSet set = slidingBlocks(0.5);
    set.variants.front().parameters.front().value = "0.25";
    const VariantResult variant = validate(set, {}, Execution{}).variants.front();
    const SampleComparison& found = variant.quantities.front().comparison;
    EXPECT_NEAR(found.error.value, found.measured.mean, 0.02 * found.measured.mean);  // twice as far
    EXPECT_GT(found.error.low, 0.0);
    EXPECT_GT(found.area, found.areaByChance);
}

TEST(Validate, FrictionIsFoundOnEachHalfAndJudgedOnTheOther) {
    ValidationSet set = slidingBlocks(0.5);
    set.variants = {{"fitted", "", {}, {{"friction", 0.2, 0.7}}}};
    const VariantResult variant = validate(set, {}, Execution{}).variants.front();
    EXPECT_EQ(variant.bodies, 12);
    ASSERT_EQ(variant.used.size(), 2u);
    // The last round tries steps of 0.5 x 0.4^3 / 6.
    EXPECT_NEAR(std::stod(variant.used[0].value), 0.5, 0.015);
    EXPECT_NEAR(std::stod(variant.used[1].value), 0.5, 0.015);
    EXPECT_EQ(variant.used[0].source, "fitted on one half, judged on the other");
    EXPECT_EQ(variant.used[1].source, "fitted on the other half, judged on the one");
    EXPECT_NEAR(variant.figure("run_out_m.error"), 0.0, 0.03);
}

TEST(Validate, AFitIsJudgedByBodiesThatItHasNotSeen) {
    ValidationSet set = slidingBlocks(0.5);
    const ValidationSet other = slidingBlocks(0.25);
    // Every second block slid on ground of another friction: what is found on the ones is wrong for the others.
    for (std::size_t i = 1; i < set.bodies.size(); i += 2) {
        set.bodies[i] = other.bodies[i];
        set.measured[i] = other.measured[i];
    }
    set.variants = {{"fitted", "", {}, {{"friction", 0.2, 0.7}}}};
    const VariantResult variant = validate(set, {}, Execution{}).variants.front();
    ASSERT_EQ(variant.used.size(), 2u);
    EXPECT_NEAR(std::stod(variant.used[0].value), 0.5, 0.015);
    EXPECT_NEAR(std::stod(variant.used[1].value), 0.25, 0.015);
    // Those of less friction stop at half of their way, the others go twice as far.
    EXPECT_GT(variant.figure("run_out_m.area"), 0.1);
    EXPECT_GT(variant.figure("run_out_m[even].error"), 0.3);
    EXPECT_LT(variant.figure("run_out_m[odd].error"), -0.3);
}

TEST(Validate, ThreadsChangeNothingAndAVariantMayAskForMoreRepeats) {
    ValidationSet set = slidingBlocks(0.5);
    set.repeats = 2;
    set.variants = {{"blind", "", {}, {}, {{variationFrom("friction", "uniform:0.3:0.7"), "given"}}, 6},
                    {"fitted", "", {}, {{"friction", 0.2, 0.7}}}};
    const SetResult alone = validate(set, {}, Execution{}.withThreads(1)), together = validate(set, {}, Execution{}.withThreads(3));
    for (std::size_t v = 0; v < 2; ++v) {
        const VariantResult &one = alone.variants[v], &other = together.variants[v];
        EXPECT_EQ(one.simulated, (v == 0 ? 6 : 2) * one.bodies);
        EXPECT_EQ(one.used.back().value, other.used.back().value);
        ASSERT_EQ(one.figures.size(), other.figures.size());
        for (std::size_t i = 0; i < one.figures.size(); ++i) {
            EXPECT_EQ(std::isnan(one.figures[i].value.value) ? 0.0 : one.figures[i].value.value,
                      std::isnan(other.figures[i].value.value) ? 0.0 : other.figures[i].value.value)
                << one.figures[i].key;
        }
    }
    ValidationOptions options;
    options.repeats = 1;
    EXPECT_EQ(validate(set, options, Execution{}).variants[0].simulated, alone.variants[0].bodies) << "who asks has it as asked";
}

TEST(Validate, WhatIsDrawnWidensTheScatter) {
    ValidationSet set = slidingBlocks(0.5);
    set.repeats = 8;
    const double scatter = validate(set, {}, Execution{}).variants.front().figure("run_out_m.scatter_ratio");
    set.variants.front().parameters.clear();
    set.variants.front().varied = {{variationFrom("friction", "uniform:0.3:0.7"), "given"}};
    const VariantResult variant = validate(set, {}, Execution{}).variants.front();
    ASSERT_EQ(variant.used.size(), 1u);
    EXPECT_EQ(variant.used.front().key, "friction");
    EXPECT_EQ(variant.used.front().value, "uniform:0.3:0.7");
    EXPECT_EQ(variant.used.front().source, "given");
    EXPECT_GT(variant.figure("run_out_m.scatter_ratio"), 1.1 * scatter);
}

}  // namespace

}  // namespace rubble
