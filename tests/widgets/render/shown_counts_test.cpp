#include "widgets/render/shown_counts.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"

namespace rubble::render {
namespace {

TEST(ElementCounts, AreThoseOfThePlainDefinition) {
    const double infinity = std::numeric_limits<double>::infinity();
    ShowTimes times;
    times.spans = {{-infinity, 1.0}, {2.0, 3.0}, {-infinity, infinity}, {1.0, 1.0}, {1.0, 2.5}, {2.0, infinity}};
    times.offsets = {0, 2, 3, 5, 6};
    const ElementCounts counts(times);
    for (const double time : {-1.0, 0.0, 1.0, 1.5, 2.0, 2.2, 2.5, 2.7, 3.0, 9.0}) {
        std::size_t shown = 0;
        for (const TimeSpan& span : times.spans) {
            shown += span.from <= time && time < span.to;
        }
        EXPECT_EQ(counts.at(time), shown) << time;
    }
}

FragmentSlots::Counts byDefinition(const SceneData& data, bool carried, double time) {
    FragmentSlots::Counts counts;
    counts.bornByComponent.assign(data.components->list.size(), 0);
    std::set<ClusterId> clusters;
    for (std::size_t f = 0; f < data.fragments->size(); ++f) {
        const Fragment& fragment = data.fragments->list[f];
        if (fragment.birthTime <= time && time < fragment.endTime) {
            ++counts.born;
            ++counts.bornByComponent[at(fragment.component)];
            clusters.insert(data.clustering->of[f]);
        } else if (carried && fragment.handOverTime <= time && time < fragment.birthTime) {
            ++counts.onTheWay;
        }
    }
    counts.clusters = clusters.size();
    return counts;
}

TEST(FragmentSlots, CountOnFromAnySlotToAnyOther) {
    const SceneData data = scenes::ballisticRun(scenes::collapsingWall(12, 8), 0.7);
    ASSERT_TRUE(data.clustering && data.components);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anyTime(-0.1, 1.2);
    for (const bool carried : {false, true}) {
        FragmentSlots slots(*data.fragments, data.clustering.get(), data.components->list.size(), carried);
        std::size_t most = 0;
        for (int i = 0; i < 200; ++i) {
            const double time = anyTime(random);
            const std::size_t slot = slots.slotAt(time);
            const auto& counts = slots.countsAt(slot);
            EXPECT_EQ(counts, byDefinition(data, carried, time)) << time;
            most = std::max(most, counts.born);
            for (std::size_t f = 0; f < data.fragments->size(); ++f) {
                const Fragment& fragment = data.fragments->list[f];
                const double from = carried ? fragment.handOverTime : fragment.birthTime;
                EXPECT_EQ(slots.drawn(f, slot), from <= time && time < fragment.endTime);
                EXPECT_EQ(slots.born(f, slot), fragment.birthTime <= time && time < fragment.endTime);
            }
        }
        EXPECT_GT(most, 10u);
    }
}

}  // namespace
}  // namespace rubble::render
