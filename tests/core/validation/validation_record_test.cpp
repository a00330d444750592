#include "core/validation/validation_record.h"

#include <gtest/gtest.h>

#include "core/base/unknown.h"
#include "tests/scenes/validation_records.h"

namespace rubble {
namespace {

TEST(ValidationRecord, SaysWhatWasAskedAndWhetherItHolds) {
    ValidationSet set;
    set.id = "own";
    set.bodies.resize(3);
    SetVariant variant{"one", "words", {{"friction", "0.5", "given"}}, {{"friction", 0.1, 0.9}}};
    set.criteria = {{"one", "a", 0.5, 0.7, {}}, {"one", "b", -std::numeric_limits<double>::infinity(), 1.0, "a"}};
    VariantResult made;
    made.variant = variant;
    made.used = variant.parameters;
    made.figures = {{"a", "", {0.6, unknown, unknown}}, {"b", "", {0.65, unknown, unknown}}};
    judge(made, set);
    SetResult result;
    result.set = &set;
    result.variants = {made};
    const ValidationRecord record = recordOf(result);
    EXPECT_EQ(record.bodies, 3u);
    ASSERT_EQ(record.variants.size(), 1u);
    EXPECT_TRUE(record.variants[0].fitted);
    ASSERT_EQ(record.variants[0].verdicts.size(), 2u);
    EXPECT_EQ(record.variants[0].verdicts[0].asked, "at least 0.5, at most 0.7");
    EXPECT_TRUE(record.variants[0].verdicts[0].within);
    EXPECT_EQ(record.variants[0].verdicts[1].asked, "at most 1, below a 0.6");
    EXPECT_FALSE(record.variants[0].verdicts[1].within);
}

TEST(ValidationRecord, FiguresOfQuantitiesAreNotToldTwice) {
    const ValidationRecord record = scenes::tossRecord();
    const std::vector<SetFigure> others = record.variants[0].otherFigures();
    ASSERT_EQ(others.size(), 1u);
    EXPECT_EQ(others[0].key, "right_face_share");
}

}  // namespace
}  // namespace rubble
