#include "core/fe/activity.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace rubble {
namespace {

TEST(Activity, KeepsEveryBitApart) {
    std::mt19937 random(1);
    for (const std::size_t elements : {1u, 63u, 64u, 65u, 200u}) {
        const std::size_t states = 7;
        Activity activity(states, elements);
        std::vector<std::vector<bool>> expected(states, std::vector<bool>(elements, false));
        for (int i = 0; i < 2000; ++i) {
            const std::size_t k = random() % states, e = random() % elements;
            const bool active = random() % 2;
            activity.set(k, idAt<ElementIndex>(e), active);
            expected[k][e] = active;
        }
        for (std::size_t k = 0; k < states; ++k) {
            std::size_t count = 0;
            for (std::size_t e = 0; e < elements; ++e) {
                EXPECT_EQ(activity.active(k, idAt<ElementIndex>(e)), expected[k][e]);
                count += expected[k][e];
            }
            EXPECT_EQ(activity.activeCount(k), count);
        }
    }
}

TEST(Activity, StartsInactiveAndMayBeEmpty) {
    EXPECT_EQ(Activity(3, 100).activeCount(2), 0u);
    EXPECT_EQ(Activity().states(), 0u);
    EXPECT_EQ(Activity(2, 0).activeCount(1), 0u);
}

}  // namespace
}  // namespace rubble
