#include "core/clusters/grid_sizer.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "core/clusters/clustering.h"
#include "tests/core/clusters/fragment_blocks.h"

namespace rubble {
namespace {

void expectSame(const Sizing& a, const Sizing& b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(a.axis[axis].meanDistance, b.axis[axis].meanDistance);
        EXPECT_EQ(a.axis[axis].efficiencyMin, b.axis[axis].efficiencyMin);
        EXPECT_EQ(a.axis[axis].accuracyMin, b.axis[axis].accuracyMin);
        EXPECT_EQ(a.axis[axis].accuracyMax, b.axis[axis].accuracyMax);
        EXPECT_EQ(a.axis[axis].size, b.axis[axis].size);
        EXPECT_EQ(a.axis[axis].multiple, b.axis[axis].multiple);
        EXPECT_EQ(a.axis[axis].clampedBy, b.axis[axis].clampedBy);
    }
    EXPECT_EQ(a.commonMultiple, b.commonMultiple);
    EXPECT_EQ(a.clusters, b.clusters);
    EXPECT_EQ(a.stoppedBy, b.stoppedBy);
    EXPECT_EQ(a.reachableFps, b.reachableFps);
    EXPECT_EQ(a.awake, b.awake);
    ASSERT_EQ(a.findings.list().size(), b.findings.list().size());
    for (std::size_t i = 0; i < a.findings.list().size(); ++i) {
        EXPECT_EQ(englishText(a.findings.list()[i].what), englishText(b.findings.list()[i].what));
    }
}

/// Settings as a user would try them, one after the other.
GridSettings randomSettings(std::mt19937& random) {
    GridSettings settings;
    settings.bodiesMax = std::uniform_int_distribution<std::int64_t>(5, 300)(random);
    settings.acrossComponents = random() % 4 == 0;
    settings.oneBodyPerFragment = random() % 8 == 0;
    settings.velocityTolerance = random() % 3 == 0 ? 0.0 : 0.5;
    if (random() % 2 == 0) {
        settings.multiple = uniform(random, 0.5, 6.0);
    }
    if (random() % 4 == 0) {
        settings.height = uniform(random, 0.1, 20.0);
    }
    return settings;
}

}  // namespace

// What is kept between two sizes must reach no result: each is held against one that was made with nothing kept.
TEST(GridSizer, SizesAgainAndAgainAsIfForTheFirstTime) {
    std::mt19937 random(11);
    for (int scene = 0; scene < 4; ++scene) {
        const FragmentBlocks blocks = randomBlocks(random, 6, 40, 6.0);
        GridSizer sizer(blocks.set, blocks.mesh, blocks.components);
        for (int i = 0; i < 40; ++i) {
            const GridSettings settings = randomSettings(random);
            const Sizing sizing = sizer.size(settings, Execution());
            expectSame(sizing, sizeBasicGrid(blocks.set, blocks.mesh, blocks.components, settings, Execution()));
            EXPECT_EQ(sizing.clusters, makeClusters(blocks.set, blocks.mesh, sizing.grid, settings, Execution()).list.size());
            EXPECT_EQ(sizer.counted().clusters(), sizing.clusters);
        }
    }
}

TEST(GridSizer, CanBeUsedAgainAfterACancel) {
    std::mt19937 random(12);
    const FragmentBlocks blocks = randomBlocks(random, 6, 40, 6.0);
    GridSizer sizer(blocks.set, blocks.mesh, blocks.components);
    GridSettings settings;
    settings.bodiesMax = 20;
    const Execution cancelled;
    cancelled.cancel();
    EXPECT_THROW(sizer.size(settings, cancelled), Cancelled);
    expectSame(sizer.size(settings, Execution()), sizeBasicGrid(blocks.set, blocks.mesh, blocks.components, settings, Execution()));
}

TEST(GridSizer, ASetWithoutFragmentsHasNoClusters) {
    const FragmentBlocks none;
    GridSizer sizer(none.set, none.mesh, none.components);
    GridSettings settings;
    settings.multiple = 2.0;
    EXPECT_EQ(sizer.size(settings, Execution()).clusters, 0u);
}

}  // namespace rubble
