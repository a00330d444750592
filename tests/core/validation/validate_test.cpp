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

TEST(Validate, FrictionIsFoundOnOneHalfAndJudgedOnTheOther) {
    ValidationSet set = slidingBlocks(0.5);
    set.variants = {{"fitted", "", {}, {{"friction", 0.2, 0.7}}}};
    const VariantResult variant = validate(set, {}, Execution{}).variants.front();
    EXPECT_EQ(variant.bodies, 6);
    ASSERT_EQ(variant.used.size(), 1u);
    // The last round tries steps of 0.5 x 0.4 x 0.4 / 6.
    EXPECT_NEAR(std::stod(variant.used.front().value), 0.5, 0.015);
    EXPECT_EQ(variant.used.front().source, "fitted on one half, judged on the other");
    EXPECT_NEAR(variant.figure("run_out_m.error"), 0.0, 0.03);
}

}  // namespace

}  // namespace rubble
