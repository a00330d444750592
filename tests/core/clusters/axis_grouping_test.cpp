#include "core/clusters/axis_grouping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include "core/clusters/clustering.h"
#include "tests/core/clusters/fragment_blocks.h"
#include "tests/core/clusters/matrix_oracle.h"

namespace rubble {
namespace {

struct Intervals {
    std::vector<double> low;
    std::vector<double> high;
    std::vector<double> centre;
    std::vector<std::int64_t> id;

    std::size_t size() const { return low.size(); }
    void add(double from, double to, double middle) {
        low.push_back(from);
        high.push_back(to);
        centre.push_back(middle);
        id.push_back(static_cast<std::int64_t>(id.size()) + 1);
    }
    void add(double from, double to) { add(from, to, 0.5 * (from + to)); }
    void shuffle(std::mt19937& random) {
        std::vector<std::size_t> place(size());
        std::iota(place.begin(), place.end(), std::size_t{0});
        std::shuffle(place.begin(), place.end(), random);
        const Intervals old = *this;
        for (std::size_t i = 0; i < place.size(); ++i) {
            low[i] = old.low[place[i]];
            high[i] = old.high[place[i]];
            centre[i] = old.centre[place[i]];
            id[i] = old.id[place[i]];
        }
    }
};

std::vector<std::uint32_t> fast(const Intervals& set, double size) {
    return groupAlongAxis(set.low, set.high, set.centre, set.id, size);
}
std::vector<std::uint32_t> plain(const Intervals& set, double size) {
    return matrixGroups(set.low, set.high, set.centre, set.id, size);
}

/// Intervals of many kinds: equal and unequal sizes, from sparse to heaped, centres in the middle or anywhere inside.
Intervals randomSet(std::mt19937& random, std::size_t n) {
    const double span = std::exp(uniform(random, 0.0, 4.0));
    const double spread = uniform(random, 0.0, 1.0);
    const bool eccentric = random() % 2 == 0;
    const bool heavyTail = random() % 3 == 0;
    Intervals set;
    for (std::size_t i = 0; i < n; ++i) {
        double width = 1.0 + spread * uniform(random, -0.9, 1.0);
        width *= heavyTail && random() % 8 == 0 ? uniform(random, 2.0, 20.0) : 1.0;
        const double from = uniform(random, -span, span);
        set.add(from, from + width, from + width * (eccentric ? uniform(random, 0.0, 1.0) : 0.5));
    }
    return set;
}

/// A structured mesh: everything tied, with the rounding of a file.
Intervals tiedSet(std::mt19937& random) {
    const double pitch = std::vector{0.1, 0.3, 1.0, 1.0 / 3.0}[random() % 4];
    const std::size_t layers = 1 + random() % 12;
    const std::size_t perLayer = 1 + random() % 9;
    Intervals set;
    for (std::size_t layer = 0; layer < layers; ++layer) {
        for (std::size_t k = 0; k < perLayer; ++k) {
            const double from = static_cast<double>(layer) * pitch;
            set.add(from, from + pitch * static_cast<double>(1 + random() % 2));
        }
    }
    set.shuffle(random);
    return set;
}

TEST(AxisGrouping, NothingAndOne) {
    EXPECT_TRUE(fast({}, 1.0).empty());
    Intervals one;
    one.add(0.0, 5.0);
    EXPECT_EQ(fast(one, 1.0), std::vector<std::uint32_t>{0});
    EXPECT_EQ(fast(one, 0.0), std::vector<std::uint32_t>{0});
}

TEST(AxisGrouping, TheFullestRowGoesFirstAndRowsAreCountedAnew) {
    // Unit blocks at 0, 1, 2 and 5, 6: at a size of 2 the rows hold 2, 2, 1, 2, 1; the first of the fullest wins, then 5 and 6.
    Intervals set;
    for (const double from : {0.0, 1.0, 2.0, 5.0, 6.0}) {
        set.add(from, from + 1.0);
    }
    EXPECT_EQ(fast(set, 2.0), (std::vector<std::uint32_t>{0, 0, 2, 1, 1}));
    EXPECT_EQ(fast(set, 3.0), (std::vector<std::uint32_t>{0, 0, 0, 1, 1}));
}

TEST(AxisGrouping, AFragmentWiderThanTheGridStandsAloneUnlessANarrowerRowReachesIt) {
    Intervals set;
    set.add(0.0, 4.0, 2.0);  // wider than 3
    set.add(1.2, 2.0, 1.6);  // reaches 4.2: takes the wide one in
    EXPECT_EQ(fast(set, 3.0), (std::vector<std::uint32_t>{0, 0}));
    EXPECT_EQ(fast(set, 2.0), (std::vector<std::uint32_t>{1, 0}));
}

TEST(AxisGrouping, ToleranceKeepsEqualBlocksTogether) {
    Intervals set;
    for (int i = 0; i < 10; ++i) {
        set.add(0.1 * i, 0.1 * i + 0.1);
    }
    const auto groups = fast(set, 0.3);
    EXPECT_EQ(groups, (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1, 2, 2, 2, 3}));
}

TEST(AxisGrouping, EqualsTheMatrixOnRandomSets) {
    std::mt19937 random(1);
    for (int round = 0; round < 1500; ++round) {
        const Intervals set = randomSet(random, 1 + random() % 60);
        for (const double size : {0.0, 0.3, 0.9, 1.4, 2.2, 4.0, 9.0}) {
            ASSERT_EQ(fast(set, size), plain(set, size)) << "round " << round << " size " << size;
        }
    }
}

TEST(AxisGrouping, EqualsTheMatrixOnTiedShuffledSets) {
    std::mt19937 random(2);
    for (int round = 0; round < 1000; ++round) {
        const Intervals set = tiedSet(random);
        for (const double size : {0.1, 0.2, 0.3, 2.0 / 3.0, 1.0, 2.0, 3.0}) {
            ASSERT_EQ(fast(set, size), plain(set, size)) << "round " << round << " size " << size;
        }
    }
}

TEST(AxisGrouping, EqualsTheMatrixOnLargeSets) {
    std::mt19937 random(3);
    for (int round = 0; round < 6; ++round) {
        const Intervals set = randomSet(random, 400 + random() % 300);
        for (const double size : {0.8, 1.9, 5.0}) {
            ASSERT_EQ(fast(set, size), plain(set, size)) << "round " << round << " size " << size;
        }
    }
}

TEST(AxisGrouping, DoesNotDependOnTheOrderOfTheInput) {
    std::mt19937 random(4);
    for (int round = 0; round < 50; ++round) {
        Intervals set = tiedSet(random);
        const auto before = fast(set, 0.65);
        std::vector<std::uint32_t> byId(set.size());
        for (std::size_t i = 0; i < set.size(); ++i) {
            byId[static_cast<std::size_t>(set.id[i]) - 1] = before[i];
        }
        set.shuffle(random);
        const auto after = fast(set, 0.65);
        for (std::size_t i = 0; i < set.size(); ++i) {
            ASSERT_EQ(after[i], byId[static_cast<std::size_t>(set.id[i]) - 1]);
        }
    }
}

TEST(AxisGrouping, EveryMemberEndsWithinTheSizeOfSomeMembersNearFace) {
    // The row fragment is a member; so the far faces of a group lie within the size of at least one near face. Holds for 5,000
    // intervals, where the matrix would not fit a test.
    std::mt19937 random(5);
    Intervals set;
    for (int i = 0; i < 5000; ++i) {
        const double from = uniform(random, 0.0, 300.0);
        set.add(from, from + uniform(random, 0.3, 1.5));
    }
    const double size = 1.7;
    const auto groups = fast(set, size);
    const std::uint32_t count = *std::ranges::max_element(groups) + 1;
    std::vector<double> farthestLow(count, -1e300);
    std::vector<double> farthestHigh(count, -1e300);
    std::vector<int> members(count, 0);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        farthestLow[groups[i]] = std::max(farthestLow[groups[i]], set.low[i]);
        farthestHigh[groups[i]] = std::max(farthestHigh[groups[i]], set.high[i]);
        ++members[groups[i]];
    }
    for (std::uint32_t g = 0; g < count; ++g) {
        ASSERT_GT(members[g], 0);
        ASSERT_LE(farthestHigh[g] - farthestLow[g], size * (1.0 + 1e-9)) << g;
    }
    // Groups are taken by falling count of ones, so their sizes never rise.
    EXPECT_TRUE(std::ranges::is_sorted(members, std::greater<>()));
}

TEST(AxisOrder, MeanDistanceIsTheOuterDistanceOfNeighbours) {
    Intervals set;
    set.add(2.0, 3.0);
    set.add(0.0, 1.0);
    set.add(4.0, 6.0);
    const AxisOrder order = orderAlongAxis(set.low, set.high, set.centre, set.id);
    EXPECT_EQ(order.item, (std::vector<std::uint32_t>{1, 0, 2}));
    EXPECT_DOUBLE_EQ(order.meanDistance(), ((3.0 - 0.0) + (6.0 - 2.0)) / 2.0);
    EXPECT_DOUBLE_EQ(AxisOrder().meanDistance(), 0.0);
}

}  // namespace
}  // namespace rubble
