#include "core/validation/grain_column.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/validation/heap_form.h"
#include "tests/support/run_tests.h"

namespace rubble {
namespace {

/// Rods 4 : 1 : 1 in a vessel of two of their lengths; full columns are a set of `rubble-cli validate`.
GrainColumn rods(double aspect) {
    GrainColumn column;
    column.grain = sizedTo(Vec3(0.6, 0.15, 0.15), Vec3(0.4536, 0.1134, 0.1134));
    column.aspect = aspect;
    return column;
}

TEST(GrainColumn, OfRodsRunsOutByTheMeasuredExponent) {
    const ColumnDeposit low = collapseOf(rods(2.5), Execution());
    const ColumnDeposit high = collapseOf(rods(sizedTo(6.0, 9.0)), Execution());
    EXPECT_EQ(low.grains, std::lround(0.6 * std::numbers::pi * 2.5 / rods(2.5).grain.prod()));
    for (const ColumnDeposit& each : {low, high}) {
        EXPECT_GT(each.solidFraction, 0.35);
        EXPECT_LT(each.solidFraction, 0.72);
        EXPECT_LT(each.height, each.aspect) << "it has collapsed";
    }
    const PowerLaw law = powerLawThrough({{low.aspect, low.runOut}, {high.aspect, high.runOut}});
    // Trepanier & Franklin 2010: 0.6 +- 0.1; two columns of few rods scatter by as much again.
    EXPECT_NEAR(law.exponent, 0.6, 0.2);
}

TEST(GrainColumn, OfPlatesRunsOutAndRepeats) {
    GrainColumn plates;
    plates.grain = Vec3(0.3, 0.3, 0.1);
    plates.aspect = 2.0;
    const ColumnDeposit deposit = collapseOf(plates, Execution());
    // Lube et al. 2004: 1.6 a^0.5, whatever the grains; plates are few here.
    EXPECT_LT(factorApart(deposit.runOut, 1.6 * std::sqrt(deposit.aspect)), 1.8);
    EXPECT_EQ(collapseOf(plates, Execution()).runOut, deposit.runOut);
}

}  // namespace
}  // namespace rubble
