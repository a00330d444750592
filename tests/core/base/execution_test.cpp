#include "core/base/execution.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/base/hash.h"

namespace rubble {
namespace {

TEST(Execution, CancelIsStickyAndSharedByCopies) {
    const Execution original;
    const Execution copy = original;
    EXPECT_NO_THROW(copy.check());
    std::thread([&] { original.cancel(); }).join();
    EXPECT_THROW(copy.check(), Cancelled);
    EXPECT_THROW(copy.report({"s", "s", {}}, 0.5), Cancelled);
    EXPECT_TRUE(copy.cancelled());
}

TEST(Execution, ThinsOutProgressButNeverTheEnds) {
    std::vector<double> seen;
    const Execution execution([&](const Progress& progress) { seen.push_back(progress.fraction); });
    for (int i = 0; i <= 100000; ++i) {
        execution.report({"s", "s", {}}, i / 100000.0);
    }
    ASSERT_GE(seen.size(), 2u);
    EXPECT_LT(seen.size(), 1000u);
    EXPECT_EQ(seen.front(), 0.0);
    EXPECT_EQ(seen.back(), 1.0);
}

TEST(Hash, KnowsNeighboursApart) {
    EXPECT_NE(Hasher().text("ab").text("c").finish(), Hasher().text("a").text("bc").finish());
    EXPECT_NE(Hasher().value(0.0).finish(), Hasher().value(-0.0).finish());
    EXPECT_EQ(Hasher().text("ab").value(1).finish(), Hasher().text("ab").value(1).finish());
}

TEST(Hash, IsThePublishedXxh3) {
    // Value of the empty input from the XXH3 specification.
    EXPECT_EQ(Hasher().finish().hex(), "99aa06d3014798d86001c324468d497f");
}

}  // namespace
}  // namespace rubble
