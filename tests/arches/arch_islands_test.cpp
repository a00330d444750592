#include <gtest/gtest.h>

#include "core/fragments/lifetimes.h"
#include "core/simulation/bodies/live_islands.h"
#include "tests/samples/arches.h"

namespace rubble {
namespace {

LiveIslands looseIn(const arches::Arch& arch, std::size_t& supported) {
    const Activity activity = activityUnder(arch.fe->activity(), Revival::Latch);
    const std::vector<LiveIsland> islands = liveIslands(*arch.fe, activity, {true, 0.0, nullptr});
    supported = 0;
    for (const LiveIsland& island : islands) {
        supported += island.supported;
    }
    return countLoose(*arch.fe, arch.components, islands);
}

TEST(ArchIslands, RcArchLeavesItsStumpsAndDozensOfLooseParts) {
    std::size_t supported = 0;
    const LiveIslands loose = looseIn(arches::rcArch(), supported);
    EXPECT_EQ(supported, 6u) << "the springings of three ribs";
    // Counted by an independent script from the same file: 60 islands, 6 with a face in place.
    EXPECT_EQ(loose.islands, 54);
    EXPECT_EQ(loose.elements, 12072);
    EXPECT_NEAR(loose.mass, 1546580.5, 1.0);
    EXPECT_EQ(loose.moving, 2604) << "the last spans are still coming down when the analysis ends";
}

TEST(ArchIslands, StoneArchKeepsItsAbutmentsAndTheFeetOfTwoPiers) {
    std::size_t supported = 0;
    const LiveIslands loose = looseIn(arches::stoneArch(), supported);
    EXPECT_EQ(supported, 4u);
    EXPECT_EQ(loose.islands, 3) << "single blocks of pier 1";
    EXPECT_EQ(loose.elements, 3);
}

}  // namespace
}  // namespace rubble
