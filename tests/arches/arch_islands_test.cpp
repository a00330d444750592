#include <gtest/gtest.h>

#include "core/fe/live_islands.h"
#include "core/fe/loose_structure.h"
#include "core/fragments/lifetimes.h"
#include "core/simulation/bodies/loose_count.h"
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

LooseAccount looseOver(const arches::Arch& arch) {
    const Activity activity = activityUnder(arch.fe->activity(), Revival::Latch);
    const LooseStructure loose = looseStructure(*arch.fe, activity, {true, 0.0, nullptr}, Execution());
    return accountOf(loose, *arch.fe, activity, arch.components);
}

TEST(ArchIslands, NineTenthsOfTheDebrisOfBothArchesHadComeLooseBefore) {
    const LooseAccount stone = looseOver(arches::stoneArch());
    EXPECT_EQ(stone.dead, 49561);
    EXPECT_NEAR(static_cast<double>(stone.deadLoose) / 49561.0, 0.909, 0.01) << "counted by shared faces";
    EXPECT_NEAR(stone.median, 2.4, 0.5) << "by shared faces, which part a little earlier";
    EXPECT_NEAR(static_cast<double>(stone.looseAtOnce), 30117.0, 500.0);
    const LooseAccount concrete = looseOver(arches::rcArch());
    EXPECT_EQ(concrete.dead, 9643);
    EXPECT_GT(concrete.deadLoose, 8000);
    // Its ribs break at the springings: nearly all of it falls as one.
    EXPECT_EQ(concrete.islands.front().elements, 20582);
    EXPECT_NEAR(concrete.islands.front().from, 1.65, 1e-3);
}

}  // namespace
}  // namespace rubble
