#include "core/fe/fe_result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>

#include "core/base/error.h"

namespace rubble {
namespace {

constexpr std::size_t nodes = 1000;
constexpr std::size_t stateBytes = nodes * sizeof(Vec3);

/// States whose content says which they are; counts what is read.
class CountingSource : public StateSource {
public:
    explicit CountingSource(std::size_t states) : reads(states) {}

    FeState read(std::size_t k) const override {
        ++reads[k];
        if (slow) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        if (failures > 0) {
            --failures;
            throw WorldError({"test", "The disk is gone", {}}, {"test", "Wait.", {}});
        }
        FeState state;
        state.time = static_cast<double>(k);
        state.positions.assign(nodes, Vec3::Constant(static_cast<double>(k)));
        return state;
    }

    mutable std::vector<std::atomic<int>> reads;
    mutable std::atomic<int> failures{0};
    bool slow = false;
};

struct Fixture {
    explicit Fixture(std::size_t states, std::size_t budget) : source(std::make_shared<CountingSource>(states)) {
        auto mesh = std::make_shared<Mesh>();
        mesh->nodes.assign(nodes, Vec3::Zero());
        mesh->offsets = {0};
        FeResult::Contents contents;
        contents.mesh = mesh;
        for (std::size_t k = 0; k < states; ++k) {
            contents.times.push_back(static_cast<double>(k));
        }
        contents.activity = Activity(states, 0);
        contents.source = source;
        fe = std::make_unique<FeResult>(std::move(contents), budget);
    }

    std::shared_ptr<CountingSource> source;
    std::unique_ptr<FeResult> fe;
};

TEST(FeResult, KeepsStatesWithinItsBudget) {
    Fixture f(10, 4 * stateBytes + 4 * sizeof(FeState));
    for (std::size_t k = 0; k < 4; ++k) {
        f.fe->state(k);
    }
    f.fe->state(0);
    EXPECT_EQ(f.source->reads[0], 1);
    // A fifth state drops the one least recently used, which is now 1 and not 0.
    EXPECT_EQ(f.fe->state(4)->positions[7].x(), 4.0);
    f.fe->state(0);
    EXPECT_EQ(f.source->reads[0], 1);
    f.fe->state(1);
    EXPECT_EQ(f.source->reads[1], 2);
}

TEST(FeResult, HoldsNoMoreBytesThanItsBudgetHoweverLongTheSeries) {
    constexpr std::size_t series = 500, kept = 7;
    Fixture f(series, kept * (stateBytes + sizeof(FeState)));
    std::vector<std::weak_ptr<const FeState>> seen(series);
    std::size_t most = 0;
    for (std::size_t i = 0; i < 3 * series; ++i) {
        // Across the series, as somebody who drags the time line.
        const std::size_t k = i * i * 7919 % series;
        seen[k] = f.fe->state(k);
        const auto held = std::count_if(seen.begin(), seen.end(), [](const auto& state) { return !state.expired(); });
        most = std::max(most, static_cast<std::size_t>(held));
    }
    EXPECT_EQ(most, kept) << "states of the budget, no more, and no fewer";
}

TEST(FeResult, KeepsTwoStatesWhateverTheBudget) {
    Fixture f(3, 0);
    for (int i = 0; i < 5; ++i) {
        f.fe->state(0);
        f.fe->state(1);
    }
    EXPECT_EQ(f.source->reads[0], 1);
    EXPECT_EQ(f.source->reads[1], 1);
    f.fe->state(2);
    f.fe->state(0);
    EXPECT_EQ(f.source->reads[0], 2);
}

TEST(FeResult, HeldStatesOutliveTheCache) {
    Fixture f(5, 0);
    const auto held = f.fe->state(0);
    for (std::size_t k = 1; k < 5; ++k) {
        f.fe->state(k);
    }
    EXPECT_EQ(held->positions[3].z(), 0.0);
    f.fe.reset();
    EXPECT_EQ(held->positions.size(), nodes);
}

TEST(FeResult, ThreadsThatWantOneStateReadItOnce) {
    Fixture f(4, std::size_t{64} << 20);
    f.source->slow = true;
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (int t = 0; t < 8; ++t) {
        threads.emplace_back([&] {
            for (std::size_t k = 0; k < 4; ++k) {
                wrong += f.fe->state(k)->positions[0].x() != static_cast<double>(k);
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(wrong, 0);
    for (const auto& reads : f.source->reads) {
        EXPECT_EQ(reads, 1);
    }
}

TEST(FeResult, AFailedReadIsToldAndTriedAnew) {
    Fixture f(2, 0);
    f.source->failures = 1;
    EXPECT_THROW(f.fe->state(1), WorldError);
    EXPECT_EQ(f.fe->state(1)->time, 1.0);
}

}  // namespace
}  // namespace rubble
