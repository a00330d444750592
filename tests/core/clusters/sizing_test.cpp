#include "core/clusters/sizing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/clusters/clustering.h"
#include "tests/core/clusters/fragment_blocks.h"

namespace rubble {
namespace {

Sizing size(const FragmentBlocks& blocks, const GridSettings& settings) {
    return sizeBasicGrid(blocks.set, blocks.mesh, blocks.components, settings, Execution());
}

std::size_t countAt(const FragmentBlocks& blocks, const BasicGrid& grid, const GridSettings& settings) {
    return makeClusters(blocks.set, blocks.mesh, grid, settings, Execution()).list.size();
}

GridSettings atMost(std::int64_t bodies) {
    GridSettings settings;
    settings.grouping = Grouping::Axes;
    settings.bodiesMax = bodies;
    return settings;
}

/// 6 x 4 x 5 unit cubes, one birth, in a component of the same size.
FragmentBlocks cubes() {
    FragmentBlocks blocks;
    const ComponentId wall = blocks.component("wall", Vec3::Zero(), Vec3(6.0, 4.0, 5.0));
    for (int i = 0; i < 120; ++i) {
        const int row = i / 6;
        const int layer = i / 24;
        blocks.add(Vec3(i % 6, row % 4, layer), Vec3::Ones(), wall);
    }
    return blocks;
}

std::string allText(const Findings& findings) {
    std::string text;
    for (const Finding& finding : findings.list()) {
        text += englishText(finding.what) + " | " + englishText(finding.remedy) + "\n";
    }
    return text;
}

TEST(Sizing, BoundsOfABlockOfCubesInClosedForm) {
    const Sizing sizing = size(cubes(), atMost(15));
    // Neighbours in the order along x: 19 pairs within each of 6 layers at distance 1, 5 steps to the next layer at distance 2.
    EXPECT_NEAR(sizing.axis[0].meanDistance, (114.0 * 1.0 + 5.0 * 2.0) / 119.0, 1e-12);
    EXPECT_NEAR(sizing.axis[1].meanDistance, (116.0 * 1.0 + 3.0 * 2.0) / 119.0, 1e-12);
    EXPECT_NEAR(sizing.axis[2].meanDistance, (115.0 * 1.0 + 4.0 * 2.0) / 119.0, 1e-12);
    for (const AxisSizing& axis : sizing.axis) {
        EXPECT_NEAR(axis.efficiencyMin, axis.meanDistance * 2.0, 1e-12);  // cbrt(120 / 15)
        EXPECT_DOUBLE_EQ(axis.accuracyMin, 1.0);
        ASSERT_TRUE(axis.largestFragment && axis.smallestComponent);
    }
    EXPECT_DOUBLE_EQ(sizing.axis[0].accuracyMax, 6.0);
    EXPECT_DOUBLE_EQ(sizing.axis[1].accuracyMax, 4.0);
    EXPECT_DOUBLE_EQ(sizing.axis[2].accuracyMax, 5.0);
    // Two cubes a side leave 3 x 2 x 3 = 18 clusters; x, with the largest mean distance, is the first to hold three: 2 x 2 x 3.
    EXPECT_EQ(sizing.clusters, 12u);
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::Efficiency);
    EXPECT_TRUE(sizing.findings.empty()) << allText(sizing.findings);
}

TEST(Sizing, StartsAtTheMeanDistanceAndStopsThereIfThatSuffices) {
    const Sizing sizing = size(cubes(), atMost(120));
    EXPECT_EQ(sizing.commonMultiple, 1.0);
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::Efficiency);
    EXPECT_EQ(sizing.clusters, 120u);
    EXPECT_DOUBLE_EQ(sizing.grid.l, sizing.axis[0].meanDistance);
    EXPECT_EQ(sizing.reachableFps, 24.0);
}

TEST(Sizing, BodiesAtRestLeaveTheirPlaceToThoseBornLater) {
    // Three walls of cubes, born 0.1 s apart.
    FragmentBlocks blocks;
    const ComponentId wall = blocks.component("wall", Vec3::Zero(), Vec3(60.0, 4.0, 5.0));
    for (int i = 0; i < 360; ++i) {
        const int cube = i % 120;
        blocks.add(Vec3(cube % 6, (cube / 6) % 4, cube / 24), Vec3::Ones(), wall, static_cast<std::uint32_t>(i / 120));
    }
    const auto with = [&](double awakeTime) {
        GridSettings settings = atMost(120);
        settings.awakeTime = awakeTime;
        return size(blocks, settings);
    };
    const Sizing all = with(10.0);
    EXPECT_LE(all.clusters, 120u);
    EXPECT_EQ(all.awake, all.clusters);
    EXPECT_GT(all.commonMultiple, 1.0);
    // Just under a tenth of a second each birth has the place to itself; at a tenth two share it.
    const Sizing alone = with(0.099);
    EXPECT_EQ(alone.commonMultiple, 1.0);
    EXPECT_EQ(alone.clusters, 360u);
    EXPECT_EQ(alone.awake, 120u);
    EXPECT_EQ(alone.reachableFps, 24.0);
    const Sizing two = with(0.101);
    EXPECT_GT(two.clusters, all.clusters);
    EXPECT_LT(two.clusters, alone.clusters);
    EXPECT_EQ(two.awake * 3, two.clusters * 2);
    // By hand the target is judged by what is awake too.
    GridSettings byHand = atMost(120);
    byHand.multiple = 1.0;
    EXPECT_EQ(size(blocks, byHand).findings.count("sizing.more_than_bodies_max"), 1);
    EXPECT_DOUBLE_EQ(size(blocks, byHand).reachableFps, 8.0);
    byHand.awakeTime = 0.0;
    EXPECT_EQ(size(blocks, byHand).findings.count("sizing.more_than_bodies_max"), 0);
    GridSettings each;
    each.oneBodyPerFragment = true;
    each.awakeTime = 0.101;
    EXPECT_EQ(size(blocks, each).awake, 240u);
}

TEST(Sizing, AnAxisThatIsHeldLeavesItsShareToTheOthers) {
    FragmentBlocks blocks = cubes();
    blocks.component("slab", Vec3::Zero(), Vec3(6.0, 4.0, 1.5));  // holds z at 1.5
    const Sizing sizing = size(blocks, atMost(20));
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::Efficiency);
    EXPECT_EQ(sizing.axis[2].clampedBy, ClampedBy::ComponentSize);
    EXPECT_DOUBLE_EQ(sizing.grid.h, 1.5);
    EXPECT_EQ(at(sizing.axis[2].smallestComponent.value()), 1u);
    // Five layers along z; along x and y at least three a side are needed: 2 x 2 x 5.
    EXPECT_EQ(sizing.clusters, 20u);
    EXPECT_EQ(sizing.axis[0].clampedBy, ClampedBy::None);
    EXPECT_GE(sizing.grid.l, 3.0);
    EXPECT_LT(sizing.grid.l, 3.0 * 1.01);
    EXPECT_NEAR(sizing.axis[0].multiple, sizing.commonMultiple, 1e-12);
    EXPECT_LT(sizing.axis[2].multiple, sizing.commonMultiple);
}

TEST(Sizing, TheRefinedMultipleIsTheLeastToAThousandth) {
    const Sizing sizing = size(cubes(), atMost(8));
    const GridSettings settings = atMost(8);
    BasicGrid smaller = sizing.grid;
    for (double* s : {&smaller.l, &smaller.w, &smaller.h}) {
        *s /= 1.0011;
    }
    EXPECT_LE(countAt(cubes(), sizing.grid, settings), 8u);
    EXPECT_GT(countAt(cubes(), smaller, settings), 8u);
}

TEST(Sizing, ALargeFragmentAgainstAThinComponentIsNamedAndTheGridGoesOnAtTheFragment) {
    FragmentBlocks blocks = cubes();
    blocks.component("thin slab", Vec3::Zero(), Vec3(6.0, 4.0, 1.2));
    blocks.add(Vec3(2.0, 2.0, 6.0), Vec3(1.0, 1.0, 1.7));
    const Sizing sizing = size(blocks, atMost(30));
    const AxisSizing& z = sizing.axis[2];
    EXPECT_EQ(z.clampedBy, ClampedBy::FragmentSize);
    EXPECT_DOUBLE_EQ(sizing.grid.h, 1.7);
    EXPECT_EQ(at(z.largestFragment.value()), 120u);
    EXPECT_EQ(sizing.findings.count("sizing.fragment_over_component.z"), 1);
    const std::string text = allText(sizing.findings);
    EXPECT_NE(text.find("element 1121"), std::string::npos) << text;
    EXPECT_NE(text.find("thin slab"), std::string::npos) << text;
    blocks.components.list[1].structural = false;
    const Sizing freed = size(blocks, atMost(30));
    EXPECT_EQ(freed.findings.count("sizing.fragment_over_component.z"), 0);
    EXPECT_DOUBLE_EQ(freed.axis[2].accuracyMax, 5.0);
}

TEST(Sizing, FragmentsFartherApartThanAComponentIsThickAreHeldBySpacing) {
    FragmentBlocks blocks;
    const ComponentId slab = blocks.component("slab", Vec3::Zero(), Vec3(30.0, 30.0, 2.0));
    for (int i = 0; i < 10; ++i) {
        blocks.add(Vec3(i, i, 5.0 * i), Vec3::Ones(), slab);
    }
    const Sizing sizing = size(blocks, atMost(4));
    EXPECT_EQ(sizing.axis[2].clampedBy, ClampedBy::Spacing);
    EXPECT_DOUBLE_EQ(sizing.grid.h, 1.0);
    EXPECT_EQ(sizing.findings.count("sizing.spacing_over_component.z"), 1);
    EXPECT_NE(allText(sizing.findings).find("\"slab\""), std::string::npos);
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::FpsUnreachable);
}

TEST(Sizing, OutOfReachGoesOnAtTheUpperBoundsAndSaysWhatIsReachable) {
    const FragmentBlocks blocks = cubes();
    FragmentBlocks halves = blocks;
    for (std::size_t f = 0; f < halves.set.size(); ++f) {
        halves.set.list[f].handOverState = f < 60 ? 0 : 1;
    }
    const Sizing sizing = size(halves, atMost(1));
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::FpsUnreachable);
    EXPECT_EQ(sizing.clusters, 2u);
    EXPECT_DOUBLE_EQ(sizing.reachableFps, 12.0);
    EXPECT_DOUBLE_EQ(sizing.grid.l, 6.0);
    EXPECT_DOUBLE_EQ(sizing.grid.w, 4.0);
    EXPECT_DOUBLE_EQ(sizing.grid.h, 5.0);
    for (const AxisSizing& axis : sizing.axis) {
        EXPECT_EQ(axis.clampedBy, ClampedBy::ComponentSize);
    }
    EXPECT_EQ(sizing.findings.count("sizing.fps_unreachable"), 1);
    EXPECT_EQ(sizing.findings.count("sizing.many_births"), 0) << "the search counts, nobody follows the guide";
    GridSettings byHand = atMost(1);
    byHand.multiple = 2.0;
    EXPECT_EQ(size(halves, byHand).findings.count("sizing.many_births"), 1);
    EXPECT_EQ(size(blocks, byHand).findings.count("sizing.many_births"), 0);
    EXPECT_EQ(size(blocks, atMost(1)).stoppedBy, StoppedBy::Efficiency);
}

TEST(Sizing, FindsAGridThatSufficesEvenWhereTheUpperBoundsDoNot) {
    // The count is not monotone: a search that looks only at the upper bounds, or bisects, would give up on some of these.
    std::mt19937 random(1);
    int upperBoundWasWorse = 0;
    for (int round = 0; round < 40; ++round) {
        FragmentBlocks blocks = randomBlocks(random, 3, 40, 2.0);
        blocks.component("small", Vec3::Zero(), Vec3::Constant(3.1));
        const Sizing limits = size(blocks, atMost(1));
        std::size_t fewest = blocks.set.size();
        std::size_t last = 0;
        double multiple = 1.0;
        for (bool more = true; more; multiple = std::min(multiple * 1.05, limits.commonMultiple)) {
            more = multiple < limits.commonMultiple;
            std::array<double, 3> s;
            for (std::size_t a = 0; a < 3; ++a) {
                const AxisSizing& axis = limits.axis[a];
                s[a] = std::max(axis.accuracyMin, std::min(axis.accuracyMax, multiple * axis.meanDistance));
            }
            last = countAt(blocks, {s[0], s[1], s[2]}, atMost(1));
            fewest = std::min(fewest, last);
        }
        EXPECT_EQ(last, limits.clusters);
        upperBoundWasWorse += last > fewest ? 1 : 0;
        const Sizing sizing = size(blocks, atMost(static_cast<std::int64_t>(fewest)));
        EXPECT_EQ(sizing.stoppedBy, StoppedBy::Efficiency);
        EXPECT_LE(sizing.clusters, fewest);
        EXPECT_EQ(sizing.clusters, countAt(blocks, sizing.grid, atMost(1)));
    }
    EXPECT_GT(upperBoundWasWorse, 0);
}

TEST(Sizing, TheUsersMultipleIsTakenAsItIs) {
    GridSettings settings = atMost(3);
    settings.multiple = 7.0;
    const Sizing sizing = size(cubes(), settings);
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::User);
    EXPECT_EQ(sizing.commonMultiple, 7.0);
    for (const AxisSizing& axis : sizing.axis) {
        EXPECT_DOUBLE_EQ(axis.size, 7.0 * axis.meanDistance);
        EXPECT_EQ(axis.clampedBy, ClampedBy::None);
    }
    EXPECT_EQ(sizing.findings.count("sizing.above_component.x"), 1);
    settings.multiple = 0.5;
    const Sizing small = size(cubes(), settings);
    EXPECT_EQ(small.clusters, 120u);
    EXPECT_EQ(small.findings.count("sizing.below_fragment.y"), 1);
    EXPECT_EQ(small.findings.count("sizing.more_than_bodies_max"), 1);
    EXPECT_DOUBLE_EQ(small.reachableFps, 24.0 * 3.0 / 120.0);
}

TEST(Sizing, TheUsersSizesAreTakenAndTheAxisLeftOpenIsSearched) {
    GridSettings settings = atMost(12);
    settings.length = 2.0;
    settings.height = 1.0;
    const Sizing searched = size(cubes(), settings);
    EXPECT_EQ(searched.stoppedBy, StoppedBy::FpsUnreachable);
    EXPECT_EQ(searched.clusters, 15u);  // 3 x 1 x 5
    EXPECT_EQ(searched.axis[0].clampedBy, ClampedBy::None);
    EXPECT_EQ(searched.axis[1].clampedBy, ClampedBy::ComponentSize);
    settings.width = 2.0;
    const Sizing byHand = size(cubes(), settings);
    EXPECT_EQ(byHand.stoppedBy, StoppedBy::User);
    EXPECT_EQ(byHand.clusters, 30u);
    EXPECT_DOUBLE_EQ(byHand.grid.w, 2.0);
}

TEST(Sizing, OneBodyPerFragmentNeedsNoGrid) {
    GridSettings settings = atMost(10);
    settings.oneBodyPerFragment = true;
    const Sizing sizing = size(cubes(), settings);
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::User);
    EXPECT_EQ(sizing.clusters, 120u);
    EXPECT_EQ(sizing.grid.l, 0.0);
    EXPECT_TRUE(sizing.findings.empty()) << allText(sizing.findings);
}

TEST(Sizing, NothingAndOneFragment) {
    FragmentBlocks blocks;
    blocks.component("wall", Vec3::Zero(), Vec3::Ones());
    const Sizing none = size(blocks, {});
    EXPECT_EQ(none.clusters, 0u);
    EXPECT_EQ(none.stoppedBy, StoppedBy::Efficiency);
    EXPECT_TRUE(std::isfinite(none.grid.l) && std::isfinite(none.axis[0].multiple));
    EXPECT_TRUE(none.findings.empty()) << allText(none.findings);
    blocks.add(Vec3::Zero(), Vec3::Constant(0.5));
    const Sizing one = size(blocks, {});
    EXPECT_EQ(one.clusters, 1u);
    EXPECT_DOUBLE_EQ(one.axis[0].meanDistance, 0.5);
    EXPECT_DOUBLE_EQ(one.grid.l, 0.5);
}

TEST(Sizing, WithoutAStructuralComponentTheFragmentsThemselvesEndTheSearch) {
    FragmentBlocks blocks = cubes();
    blocks.components.list[0].structural = false;
    const Sizing sizing = size(blocks, atMost(1));
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::Efficiency);
    EXPECT_EQ(sizing.clusters, 1u);
    EXPECT_DOUBLE_EQ(sizing.axis[0].accuracyMax, 6.0);
    EXPECT_FALSE(sizing.axis[0].smallestComponent);
}

TEST(Sizing, NestedClustersAreHeldByNoComponent) {
    FragmentBlocks blocks = cubes();
    blocks.component("thin slab", Vec3::Zero(), Vec3(6.0, 4.0, 0.5));
    GridSettings settings;
    settings.bodiesMax = 2;
    const Sizing sizing = size(blocks, settings);
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::Efficiency);
    EXPECT_LE(sizing.clusters, 2u);
    EXPECT_EQ(sizing.clusters, countAt(blocks, sizing.grid, settings));
    EXPECT_GT(sizing.grid.h, 0.5);
    for (const AxisSizing& axis : sizing.axis) {
        EXPECT_EQ(axis.clampedBy, ClampedBy::None);
        EXPECT_NEAR(axis.multiple, sizing.commonMultiple, 1e-12);
    }
    EXPECT_TRUE(sizing.findings.empty()) << allText(sizing.findings);
    settings.multiple = 7.0;
    EXPECT_TRUE(size(blocks, settings).findings.empty());
    settings.acrossComponents = true;
    EXPECT_EQ(size(blocks, settings).findings.count("sizing.above_component.z"), 1);
}

TEST(Sizing, NestedClustersEndWhereEachBirthOfAComponentIsOne) {
    FragmentBlocks halves = cubes();
    for (std::size_t f = 0; f < halves.set.size(); ++f) {
        halves.set.list[f].handOverState = f < 60 ? 0 : 1;
    }
    GridSettings settings;
    settings.bodiesMax = 1;
    const Sizing sizing = size(halves, settings);
    EXPECT_EQ(sizing.stoppedBy, StoppedBy::FpsUnreachable);
    EXPECT_EQ(sizing.clusters, 2u);
    EXPECT_EQ(sizing.findings.count("sizing.fps_unreachable"), 1);
}

TEST(Sizing, CancelStopsIt) {
    const Execution execution;
    execution.cancel();
    const FragmentBlocks blocks = cubes();
    EXPECT_THROW(sizeBasicGrid(blocks.set, blocks.mesh, blocks.components, {}, execution), Cancelled);
}

TEST(Sizing, NamesInFiles) {
    EXPECT_EQ(clampedByName(ClampedBy::None), "none");
    EXPECT_EQ(clampedByName(ClampedBy::Spacing), "spacing");
    EXPECT_EQ(clampedByName(ClampedBy::FragmentSize), "fragment_size");
    EXPECT_EQ(clampedByName(ClampedBy::ComponentSize), "component_size");
    EXPECT_EQ(stoppedByName(StoppedBy::Efficiency), "efficiency");
    EXPECT_EQ(stoppedByName(StoppedBy::FpsUnreachable), "fps_unreachable");
    EXPECT_EQ(stoppedByName(StoppedBy::User), "user");
}

}  // namespace
}  // namespace rubble
