#include "core/clusters/rejoin.h"

#include <gtest/gtest.h>

#include "core/base/execution.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

class Rejoin : public testing::Test {
protected:
    FragmentSet fragments(double shift) const {
        FragmentSettings settings;
        settings.birthShift = shift;
        return makeFragments(*fe, components, settings, Execution());
    }
    Clustering clusters(const FragmentSet& set, double size) const {
        GridSettings settings;
        settings.grouping = Grouping::Axes;
        return makeClusters(set, fe->mesh(), {size, size, size}, settings, Execution());
    }
    std::shared_ptr<const FeResult> fe = scenes::collapsingWall(6, 4);
    Components components = groupComponents(fe->mesh(), {}, {}, {});
};

TEST_F(Rejoin, GivesTheSameClustersForTheSameFragments) {
    const FragmentSet set = fragments(0.0);
    const Clustering pattern = clusters(set, 2.0);
    ASSERT_LT(pattern.list.size(), set.size());
    const Clustering rejoined = rejoinClusters(pattern, set);
    ASSERT_EQ(rejoined.list.size(), pattern.list.size());
    EXPECT_EQ(rejoined.members, pattern.members);
    for (std::size_t c = 0; c < pattern.list.size(); ++c) {
        EXPECT_EQ(rejoined.list[c].mass, pattern.list[c].mass);
        EXPECT_EQ(rejoined.list[c].centre, pattern.list[c].centre);
        EXPECT_EQ(rejoined.list[c].inertia, pattern.list[c].inertia);
        EXPECT_EQ(rejoined.list[c].velocity, pattern.list[c].velocity);
    }
}

TEST_F(Rejoin, KeepsTheGroupsWhereAShiftWouldChangeThem) {
    const FragmentSet straight = fragments(0.0);
    const FragmentSet shifted = fragments(1e-6);
    // Two cells of 1 m fit into 2 m exactly, and no longer once they are shifted.
    const Clustering pattern = clusters(straight, 2.0);
    ASSERT_NE(clusters(shifted, 2.0).of, pattern.of);
    const Clustering rejoined = rejoinClusters(pattern, shifted);
    EXPECT_EQ(rejoined.of, pattern.of);
    for (std::size_t c = 0; c < pattern.list.size(); ++c) {
        const double moved = (rejoined.list[c].centre - pattern.list[c].centre).norm();
        EXPECT_GT(moved, 0.0);
        EXPECT_LE(moved, 1e-6 * (1.0 + 1e-6));
    }
}

}  // namespace
}  // namespace rubble
