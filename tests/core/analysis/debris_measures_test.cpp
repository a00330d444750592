#include "core/analysis/debris/debris_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "core/base/error.h"
#include "tests/core/analysis/debris_scene.h"
#include "tests/scenes/level_site.h"

namespace rubble {
namespace {

using namespace analysis_scene;

/// 10 m along x, 4 m along y, around the origin.
const CollapsePlan plan({Vec2(-5, -2), Vec2(5, -2), Vec2(5, 2), Vec2(-5, 2)});

DebrisField fieldOf(Debris debris, const MeasureSettings& settings = {}) {
    return measureDebris(std::move(debris), plan, levelSite, settings);
}

/// Cubes of 1 m in the middle of 2 m cells along a line, one for each mass.
Debris row(const std::vector<double>& masses, double shiftX = 0.0) {
    Debris debris;
    for (std::size_t k = 0; k < masses.size(); ++k) {
        debris.fragments.push_back(boxAt(Vec3(2.0 * static_cast<double>(k) + 1.0 + shiftX, 1.0, 0.5), masses[k]));
    }
    return debris;
}

double massMap(const Debris& a, const Debris& b) {
    return compareDebris(fieldOf(a), fieldOf(b)).of(Measure::MassMap);
}

TEST(DebrisMeasures, EqualFieldsDifferInNothing) {
    const DebrisField field = fieldOf(randomField(1, 300, 15.0));
    const DebrisDifference none = compareDebris(field, field);
    for (std::size_t m = 0; m < measureCount; ++m) {
        EXPECT_EQ(none.departure(static_cast<Measure>(m)), 0.0) << measureKey(static_cast<Measure>(m));
    }
    EXPECT_EQ(none.accuracy, (std::vector<double>{1.0, 1.0, 1.0}));
}

TEST(DebrisMeasures, MassMapDifferenceIsTheShareOfTheMassInOtherCells) {
    EXPECT_DOUBLE_EQ(massMap(row({1, 1, 1, 1}), row({1, 1, 1, 1}, 2.0)), 0.25);
    EXPECT_DOUBLE_EQ(massMap(row({3, 1}), row({3, 1}, 40.0)), 1.0);
    // A quarter of a metre of a cube of 1 m crosses into the next cell.
    EXPECT_DOUBLE_EQ(massMap(row({8}), row({8}, 0.75)), 0.25);
    // Where one field lost a fragment of 4 kg: |8 - 4| over 8 + 4.
    Debris lost = row({4, 4});
    lost.fragments[1].present = false;
    EXPECT_DOUBLE_EQ(massMap(row({4, 4}), lost), 1.0 / 3.0);
}

TEST(DebrisMeasures, CoreIsTheFewestCellsThatHoldTheShare) {
    EXPECT_EQ(fieldOf(row({60, 35, 5})).core, (std::vector<MapCell>{{0, 0}, {0, 1}})) << "95 of 100 reach 95 %";
    EXPECT_EQ(fieldOf(row({60, 34, 6})).core.size(), 3u);
    EXPECT_EQ(fieldOf(row({97, 1, 1, 1})).core.size(), 1u);
    EXPECT_EQ(fieldOf(row({1, 1, 1, 1})).core.size(), 4u);
    EXPECT_EQ(fieldOf(row({90, 5, 5})).core.size(), 3u) << "of equal cells none comes first";
    EXPECT_EQ(fieldOf(row({60, 35, 5})).figures.coreArea, 8.0);
    MeasureSettings all;
    all.coreShare = 1.0;
    EXPECT_EQ(fieldOf(row({60, 35, 5, 0}), all).core.size(), 3u) << "cells without mass never belong to it";
}

// The same by trying all sets of cells of a small field.
TEST(DebrisMeasures, NoFewerCellsHoldTheCore) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const DebrisField field = fieldOf(randomField(seed, 12, 4.0));
        const std::size_t cells = field.mass.size();
        ASSERT_LE(cells, 20u);
        const double wanted = 0.95 * field.mass.sum() * (1.0 - 1e-9);
        std::size_t fewest = cells;
        for (std::uint32_t set = 0; set < (1u << cells); ++set) {
            const auto count = static_cast<std::size_t>(std::popcount(set));
            if (count >= fewest) {
                continue;
            }
            double held = 0.0;
            for (std::size_t k = 0; k < cells; ++k) {
                held += (set >> k & 1) ? field.mass.values[k] : 0.0;
            }
            if (held >= wanted) {
                fewest = count;
            }
        }
        EXPECT_EQ(field.core.size(), fewest) << seed;
    }
}

TEST(DebrisMeasures, IousCountCells) {
    // Cores of the cells 0 to 3 and 1 to 4; footprints of 1 m cells: two by two metres each, moved by one of them.
    const DebrisDifference shifted = compareDebris(fieldOf(row({1, 1, 1, 1})), fieldOf(row({1, 1, 1, 1}, 2.0)));
    EXPECT_DOUBLE_EQ(shifted.of(Measure::CoreIou), 3.0 / 5.0);
    EXPECT_DOUBLE_EQ(shifted.of(Measure::FootprintIou), 3.0 / 5.0);
    const DebrisDifference apart = compareDebris(fieldOf(row({1})), fieldOf(row({1}, 20.0)));
    EXPECT_EQ(apart.of(Measure::CoreIou), 0.0);
    EXPECT_EQ(apart.of(Measure::FootprintIou), 0.0);
    EXPECT_EQ(apart.departure(Measure::CoreIou), 1.0);
}

// The IoU of sets, by sets.
TEST(DebrisMeasures, IousAreThoseOfSets) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const DebrisField a = fieldOf(randomField(seed, 100, 12.0));
        const DebrisField b = fieldOf(randomField(seed + 100, 100, 12.0));
        const auto byHand = [](const std::vector<MapCell>& x, const std::vector<MapCell>& y) {
            const std::set<MapCell> first(x.begin(), x.end());
            std::set<MapCell> either = first;
            either.insert(y.begin(), y.end());
            const auto both = std::count_if(y.begin(), y.end(), [&](MapCell cell) { return first.contains(cell); });
            return static_cast<double>(both) / static_cast<double>(either.size());
        };
        const DebrisDifference difference = compareDebris(a, b);
        EXPECT_EQ(difference.of(Measure::CoreIou), byHand(a.core, b.core));
        EXPECT_EQ(difference.of(Measure::FootprintIou), byHand(a.heights.cells, b.heights.cells));
    }
}

TEST(DebrisMeasures, RunOutIsTheDistanceThatHoldsTheShareOfTheMass) {
    const auto at = [](double x, double mass) { return boxAt(Vec3(x, 0.0, 0.5), mass); };
    // 95 kg within the plan, then 3 kg 2 m and 2 kg 7 m beyond its end.
    EXPECT_EQ(fieldOf(debrisFrom({at(0, 95), at(7, 3), at(12, 2)})).figures.runOut, 0.0);
    EXPECT_DOUBLE_EQ(fieldOf(debrisFrom({at(0, 94), at(7, 3), at(12, 3)})).figures.runOut, 2.0);
    EXPECT_DOUBLE_EQ(fieldOf(debrisFrom({at(0, 90), at(-7, 4), at(12, 6)})).figures.runOut, 7.0);
    EXPECT_DOUBLE_EQ(fieldOf(debrisFrom({at(8, 1)})).figures.runOut, 3.0);
    const DebrisDifference further = compareDebris(fieldOf(debrisFrom({at(8, 1)})), fieldOf(debrisFrom({at(9.5, 1)})));
    EXPECT_DOUBLE_EQ(further.of(Measure::RunOut), 1.5);
    EXPECT_TRUE(std::isnan(measureDebris(debrisFrom({at(0, 1)}), CollapsePlan(std::vector<Vec2>{}), levelSite, {}).figures.runOut));
}

TEST(DebrisMeasures, HeightsAndCentroid) {
    const DebrisField low = fieldOf(debrisFrom({boxAt(Vec3(0.5, 0.5, 0.5), 2.0), boxAt(Vec3(1.5, 0.5, 0.5), 6.0)}));
    const DebrisField high = fieldOf(debrisFrom({boxAt(Vec3(0.5, 0.5, 0.5), 2.0), boxAt(Vec3(0.5, 0.5, 1.5), 6.0)}));
    EXPECT_DOUBLE_EQ(low.figures.meanHeight, 0.5);
    EXPECT_DOUBLE_EQ(high.figures.meanHeight, 1.25);
    EXPECT_DOUBLE_EQ(low.figures.pileHeight, 1.0);
    EXPECT_DOUBLE_EQ(high.figures.pileHeight, 2.0);
    EXPECT_EQ(low.figures.footprintArea, 2.0);
    EXPECT_EQ(low.figures.mass, 8.0);
    EXPECT_EQ(low.figures.centroid, Vec3(1.25, 0.5, 0.5));
    const DebrisDifference difference = compareDebris(low, high);
    EXPECT_DOUBLE_EQ(difference.of(Measure::MeanHeight), 0.75);
    // 1 m less in one cell, 1 m more in the other.
    EXPECT_DOUBLE_EQ(difference.of(Measure::HeightRms), 1.0);
    EXPECT_DOUBLE_EQ(difference.of(Measure::CentroidShift), std::hypot(0.75, 0.75));
    SiteSurface hill;
    hill.levelHeight = 0.25;
    EXPECT_DOUBLE_EQ(measureDebris(low.debris, plan, hill, {}).figures.meanHeight, 0.25);
}

TEST(DebrisMeasures, AccuracyRateAndMedianDistance) {
    const Debris before = row({1, 1, 1, 1});
    Debris after = before;
    after.fragments[1].centre.x() += 0.15;
    after.fragments[2].centre.y() -= 0.25;
    after.fragments[3].centre.z() += 0.75;
    MeasureSettings settings;
    settings.tolerances = {0.1, 0.2, 0.3, 0.75, 1.0};
    const DebrisDifference difference = compareDebris(fieldOf(before, settings), fieldOf(after, settings));
    EXPECT_EQ(difference.accuracy, (std::vector<double>{0.25, 0.5, 0.75, 0.75, 1.0}))
        << "a distance equal to the tolerance is not below it";
    EXPECT_DOUBLE_EQ(difference.of(Measure::MedianDistance), 0.2) << "the mean of 0.15 and 0.25";
    after.fragments[3].present = false;
    const DebrisDifference without = compareDebris(fieldOf(before), fieldOf(after));
    EXPECT_DOUBLE_EQ(without.of(Measure::MedianDistance), 0.15);
    EXPECT_EQ(without.accuracy.back(), 0.75) << "what is absent in one is within no tolerance";
}

TEST(DebrisMeasures, ExchangeChangesOnlySigns) {
    const DebrisField a = fieldOf(randomField(21, 400, 15.0));
    const DebrisField b = fieldOf(randomField(22, 400, 17.0));
    const DebrisDifference there = compareDebris(a, b);
    const DebrisDifference back = compareDebris(b, a);
    for (std::size_t m = 0; m < measureCount; ++m) {
        const Measure measure = static_cast<Measure>(m);
        const bool isSigned = measure == Measure::RunOut || measure == Measure::MeanHeight;
        EXPECT_EQ(there.of(measure), isSigned ? -back.of(measure) : back.of(measure)) << measureKey(measure);
        EXPECT_GE(there.departure(measure), 0.0);
    }
    EXPECT_EQ(there.accuracy, back.accuracy);
    for (const Measure share : {Measure::MassMap, Measure::CoreIou, Measure::FootprintIou}) {
        EXPECT_GE(there.of(share), 0.0);
        EXPECT_LE(there.of(share), 1.0);
    }
}

TEST(DebrisMeasures, MovingBothByWholeCellsChangesNothing) {
    const Debris a = randomField(31, 300, 15.0);
    const Debris b = randomField(32, 300, 15.0);
    const Vec3 by(128.0, -64.0, 0.0);
    std::vector<Vec2> outline = plan.outline();
    for (Vec2& corner : outline) {
        corner += by.head<2>();
    }
    const CollapsePlan movedPlan(outline);
    const DebrisDifference here = compareDebris(fieldOf(a), fieldOf(b));
    const DebrisDifference there =
        compareDebris(measureDebris(moved(a, by), movedPlan, levelSite, {}), measureDebris(moved(b, by), movedPlan, levelSite, {}));
    for (std::size_t m = 0; m < measureCount; ++m) {
        // Places near 100 m are rounded to 1.4e-14 m.
        EXPECT_NEAR(here.values[m], there.values[m], 1e-9) << measureKey(static_cast<Measure>(m));
    }
}

TEST(DebrisMeasures, MassMapDifferenceKeepsTheTriangle) {
    const DebrisField a = fieldOf(randomField(41, 200, 10.0));
    const DebrisField b = fieldOf(moved(a.debris, Vec3(0.3, 0.1, 0.0)));
    const DebrisField c = fieldOf(moved(a.debris, Vec3(0.9, -0.4, 0.0)));
    const auto d = [](const DebrisField& x, const DebrisField& y) { return compareDebris(x, y).of(Measure::MassMap); };
    EXPECT_LE(d(a, c), d(a, b) + d(b, c) + 1e-12);
    EXPECT_LT(d(a, b), d(a, c)) << "a smaller move changes less";
}

TEST(DebrisMeasures, ASmallMoveChangesLittle) {
    const DebrisField a = fieldOf(randomField(51, 500, 15.0));
    const DebrisField b = fieldOf(moved(a.debris, Vec3(1e-6, 1e-6, 0.0)));
    // The mass map follows places without a jump: blocks of about 1 m lose 1e-6 of themselves at each edge of a cell they cross.
    EXPECT_LT(compareDebris(a, b).of(Measure::MassMap), 4e-6);
}

TEST(DebrisMeasures, EmptyFieldsAreEqualAndAnEmptyOneIsAllDifferent) {
    const DebrisField empty = fieldOf(Debris{});
    const DebrisDifference same = compareDebris(empty, empty);
    EXPECT_EQ(same.of(Measure::MassMap), 0.0);
    EXPECT_EQ(same.of(Measure::CoreIou), 1.0);
    EXPECT_EQ(same.of(Measure::FootprintIou), 1.0);
    EXPECT_EQ(same.of(Measure::HeightRms), 0.0);
    for (const Measure undefined : {Measure::RunOut, Measure::MeanHeight, Measure::CentroidShift, Measure::MedianDistance}) {
        EXPECT_TRUE(std::isnan(same.of(undefined)));
    }
    EXPECT_TRUE(std::isnan(same.accuracy.front()));
    Debris gone = row({5, 5});
    gone.fragments[0].present = gone.fragments[1].present = false;
    const DebrisDifference all = compareDebris(fieldOf(row({5, 5})), fieldOf(gone));
    EXPECT_EQ(all.of(Measure::MassMap), 1.0);
    EXPECT_EQ(all.of(Measure::CoreIou), 0.0);
    EXPECT_EQ(all.accuracy.front(), 0.0);
}

TEST(DebrisMeasures, DebrisWithoutMassHasPlacesOnly) {
    const DebrisField weightless = fieldOf(row({0, 0}));
    EXPECT_TRUE(weightless.core.empty());
    EXPECT_EQ(weightless.figures.footprintArea, 8.0) << "each reaches into four cells of 1 m";
    EXPECT_TRUE(std::isnan(weightless.figures.meanHeight));
    const DebrisDifference difference = compareDebris(weightless, fieldOf(row({0, 0}, 0.25)));
    EXPECT_EQ(difference.of(Measure::MassMap), 0.0);
    EXPECT_DOUBLE_EQ(difference.of(Measure::MedianDistance), 0.25);
}

TEST(DebrisMeasures, RefusesWhatCannotBeMeasured) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(fieldOf(debrisFrom({boxAt(Vec3(nan, 0, 0), 1.0)})), UsageError);
    const auto with = [](auto change) {
        MeasureSettings settings;
        change(settings);
        return settings;
    };
    const Debris one = row({1});
    for (const double bad : {nan, 0.0, -1.0, 1.5}) {
        EXPECT_THROW(fieldOf(one, with([&](MeasureSettings& s) { s.coreShare = bad; })), UsageError);
        EXPECT_THROW(fieldOf(one, with([&](MeasureSettings& s) { s.runOutShare = bad; })), UsageError);
    }
    for (const double bad : {nan, 0.0, -1.0}) {
        EXPECT_THROW(fieldOf(one, with([&](MeasureSettings& s) { s.tolerances = {0.1, bad}; })), UsageError);
        EXPECT_THROW(fieldOf(one, with([&](MeasureSettings& s) { s.massCell = bad; })), UsageError);
        EXPECT_THROW(fieldOf(one, with([&](MeasureSettings& s) { s.footprintCell = bad; })), UsageError);
    }
    EXPECT_THROW(compareDebris(fieldOf(row({1})), fieldOf(row({1, 1}))), UsageError);
    EXPECT_THROW(compareDebris(fieldOf(one), fieldOf(one, with([](MeasureSettings& s) { s.massCell = 4.0; }))), UsageError);
}

TEST(DebrisMeasures, TheLargerOfTwoDifferencesIsTheWorseInEachMeasure) {
    const DebrisField a = fieldOf(randomField(61, 100, 10.0));
    DebrisDifference x = compareDebris(a, fieldOf(moved(a.debris, Vec3(0.4, 0, 0))));
    DebrisDifference y = compareDebris(a, fieldOf(moved(a.debris, Vec3(0.2, 0, -0.3))));
    const DebrisDifference larger = largerOf(x, y);
    for (std::size_t m = 0; m < measureCount; ++m) {
        const Measure measure = static_cast<Measure>(m);
        EXPECT_EQ(larger.departure(measure), std::max(x.departure(measure), y.departure(measure))) << measureKey(measure);
    }
    EXPECT_EQ(larger.accuracy[2], std::min(x.accuracy[2], y.accuracy[2]));
    y.of(Measure::RunOut) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(largerOf(x, y).of(Measure::RunOut), x.of(Measure::RunOut));
    EXPECT_EQ(largerOf(y, x).of(Measure::RunOut), x.of(Measure::RunOut));
}

TEST(DebrisMeasures, KeysAreAllDifferent) {
    std::set<std::string_view> keys;
    for (std::size_t m = 0; m < measureCount; ++m) {
        keys.insert(measureKey(static_cast<Measure>(m)));
    }
    EXPECT_EQ(keys.size(), measureCount);
}

}  // namespace
}  // namespace rubble
