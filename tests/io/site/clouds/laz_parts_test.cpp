#include "io/site/clouds/las/laz_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace rubble::io {

namespace {

/// What RunningMedian does, as LASzip describes it: sorted anew for each number.
class PlainMedian {
public:
    std::int32_t median() const { return m_sorted[2]; }
    void add(std::int32_t number) {
        const std::int32_t before = median();
        m_sorted.erase(m_dropGreatest ? m_sorted.end() - 1 : m_sorted.begin());
        m_sorted.insert(std::upper_bound(m_sorted.begin(), m_sorted.end(), number), number);
        m_dropGreatest = number < before || (number == before && !m_dropGreatest);
    }

private:
    std::vector<std::int32_t> m_sorted = std::vector<std::int32_t>(5, 0);
    bool m_dropGreatest = true;
};

/// Both kinds get the same numbers. @param last  numbers lie between this and its negative
void expectSameMedians(std::int32_t last) {
    std::mt19937 chance(5);
    std::uniform_int_distribution<std::int32_t> number(-last, last);
    RunningMedian median;
    PlainMedian plain;
    for (int i = 0; i < 20'000; ++i) {
        const std::int32_t next = number(chance);
        median.add(next);
        plain.add(next);
        ASSERT_EQ(median.median(), plain.median()) << i;
    }
}

TEST(LazParts, MedianOfTheLastFiveIsThatOfSortedOnes) {
    // Few numbers come again and again, which decides what is dropped.
    for (const std::int32_t last : {1, 3, 1000, std::numeric_limits<std::int32_t>::max()}) {
        SCOPED_TRACE(last);
        expectSameMedians(last);
    }
}

TEST(LazParts, MedianTakesTheLeastAndTheGreatestNumber) {
    constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
    constexpr std::int32_t greatest = std::numeric_limits<std::int32_t>::max();
    RunningMedian median;
    PlainMedian plain;
    for (const std::int32_t next :
         {least, greatest, least, least, greatest, 0, greatest, greatest, greatest, least, least, least, -1}) {
        median.add(next);
        plain.add(next);
        EXPECT_EQ(median.median(), plain.median());
    }
}

}  // namespace

}  // namespace rubble::io
