#include "core/base/memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace rubble {
namespace {

TEST(Memory, RoomInLargePagesKeepsWhatIsThere) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1000}, std::size_t{3'000'000}}) {
        std::vector<double> items(10);
        std::iota(items.begin(), items.end(), 0.0);
        reserveLarge(items, count);
        EXPECT_GE(items.capacity(), count);
        EXPECT_EQ(items.size(), 10u);
        EXPECT_EQ(std::accumulate(items.begin(), items.end(), 0.0), 45.0);
        items.resize(std::max<std::size_t>(count, 10), 1.0);
        EXPECT_EQ(items.back(), count > 10 ? 1.0 : 9.0);
    }
}

TEST(Memory, AHintForWhatIsSmallerThanAPageDoesNothing) {
    std::vector<char> items(100, 'a');
    takeLargePages(items.data(), items.size());
    takeLargePages(items.data(), 0);
    EXPECT_EQ(items.back(), 'a');
}

}  // namespace
}  // namespace rubble
