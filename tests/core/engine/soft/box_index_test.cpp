#include "core/engine/soft/box_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace rubble {
namespace {

using Boxes = std::map<std::uint32_t, Aabb>;

class BoxIndexTest : public testing::Test {
protected:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }

    Aabb anyBox(double span, double largest) {
        const Vec3 low(uniform(-span, span), uniform(-span, span), uniform(0.0, span));
        return {low, low + Vec3(uniform(0.0, largest), uniform(0.0, largest), uniform(0.0, largest))};
    }

    void put(std::uint32_t key, const Aabb& box) {
        m_index.set(key, box);
        m_boxes[key] = box;
    }

    void takeOut(std::uint32_t key) {
        m_index.remove(key);
        m_boxes.erase(key);
    }

    /// Keys found whose boxes do overlap, in order; each may be found once only.
    std::vector<std::uint32_t> found(const Aabb& box) {
        std::vector<std::uint32_t> keys;
        m_index.find(box, [&](std::uint32_t key) {
            if (m_boxes.at(key).intersects(box)) {
                keys.push_back(key);
            }
        });
        std::sort(keys.begin(), keys.end());
        EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
        return keys;
    }

    std::vector<std::uint32_t> lookedAt(const Aabb& box) const {
        std::vector<std::uint32_t> keys;
        for (const auto& [key, other] : m_boxes) {
            if (other.intersects(box)) {
                keys.push_back(key);
            }
        }
        return keys;
    }

    BoxIndex m_index;
    Boxes m_boxes;

private:
    std::mt19937 m_random{7};
};

TEST_F(BoxIndexTest, FindsNothingInNothing) {
    m_index.refit();
    EXPECT_TRUE(found(anyBox(1.0, 1.0)).empty());
    m_index.remove(3);
    put(5, anyBox(1.0, 1.0));
    takeOut(5);
    m_index.refit();
    EXPECT_TRUE(found(Aabb(Vec3::Constant(-9.0), Vec3::Constant(9.0))).empty());
}

TEST_F(BoxIndexTest, FindsWhatLookingAtEveryBoxFinds) {
    std::uint32_t next = 0;
    for (int step = 0; step < 60; ++step) {
        // Boxes come in bursts, all move, some far, a few leave: nodes are widened, added, emptied and laid out anew.
        for (int i = 0; i < (step % 7 == 0 ? 90 : 1); ++i) {
            put(next++, anyBox(20.0, 2.0));
        }
        for (auto& [key, box] : Boxes(m_boxes)) {
            const double way = key % 50 == 0 ? 30.0 : 0.3;
            put(key, box.translated(Vec3(uniform(-way, way), uniform(-way, way), uniform(-way, way))));
        }
        takeOut(static_cast<std::uint32_t>(uniform(0.0, next)));
        m_index.refit();
        for (int i = 0; i < 20; ++i) {
            const Aabb box = anyBox(20.0, i == 0 ? 60.0 : 3.0);
            ASSERT_EQ(found(box), lookedAt(box)) << "step " << step;
        }
    }
}

TEST_F(BoxIndexTest, BoxesThatJustTouchFarFromTheOriginAreFound) {
    // At 1e6 m single precision rounds to centimetres.
    for (std::uint32_t i = 0; i < 100; ++i) {
        const Vec3 low(1e6 + 0.1 * i, -1e6, 1e6);
        put(i, Aabb(low, low + Vec3(0.1, 0.1, 0.1)));
    }
    m_index.refit();
    for (const auto& [key, box] : m_boxes) {
        EXPECT_EQ(found(box), lookedAt(box));
    }
}

}  // namespace
}  // namespace rubble
