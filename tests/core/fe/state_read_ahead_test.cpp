#include "core/fe/state_read_ahead.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <random>
#include <thread>

#include "core/base/error.h"

namespace rubble {
namespace {

constexpr std::size_t states = 100;
constexpr double interval = 0.1;  // s
using Milliseconds = std::chrono::milliseconds;

/// States whose content says which they are.
class SlowSource : public StateSource {
public:
    explicit SlowSource(Milliseconds lasts) : m_lasts(lasts) {}

    FeState read(std::size_t k) const override {
        ++reads;
        std::this_thread::sleep_for(m_lasts);
        if (k == damaged) {
            throw WorldError({"test", "The disk is gone", {}}, {"test", "Wait.", {}});
        }
        return {interval * static_cast<double>(k), {Vec3::Constant(static_cast<double>(k))}, {}};
    }

    mutable std::atomic<int> reads{0};
    std::atomic<std::size_t> damaged{states};

private:
    Milliseconds m_lasts;
};

struct Series {
    explicit Series(Milliseconds lasts, std::size_t budget = std::size_t{1} << 20) : source(std::make_shared<SlowSource>(lasts)) {
        auto mesh = std::make_shared<Mesh>();
        mesh->nodes.assign(1, Vec3::Zero());
        mesh->offsets = {0};
        FeResult::Contents contents;
        contents.mesh = mesh;
        for (std::size_t k = 0; k < states; ++k) {
            contents.times.push_back(interval * static_cast<double>(k));
        }
        contents.activity = Activity(states, 0);
        contents.source = source;
        fe = std::make_shared<FeResult>(std::move(contents), budget);
    }

    std::shared_ptr<SlowSource> source;
    std::shared_ptr<const FeResult> fe;
};

/// What every interval has to keep, wherever its states come from.
void expectAround(const StateReadAhead::Interval& found, double time) {
    const auto number = [](const std::shared_ptr<const FeState>& state) {
        return static_cast<std::size_t>(state->positions[0].x());
    };
    EXPECT_EQ(number(found.atFrom), found.from);
    EXPECT_LE(interval * static_cast<double>(found.from), time + 1e-9);
    EXPECT_EQ(found.atTo != nullptr, found.to > found.from);
    EXPECT_EQ(found.atBefore != nullptr, found.before < found.from);
    if (found.atTo) {
        EXPECT_EQ(number(found.atTo), found.to);
        EXPECT_GT(interval * static_cast<double>(found.to), time);
        EXPECT_LE(interval * static_cast<double>(found.to - found.from), StateReadAhead::widest + 2.0 * interval);
    } else {
        EXPECT_EQ(found.from, states - 1);
    }
    if (found.atBefore) {
        EXPECT_EQ(number(found.atBefore), found.before);
    }
}

TEST(StateReadAhead, AJumpMeetsTheStatesNextToTheTime) {
    const Series series(Milliseconds(0));
    StateReadAhead ahead(series.fe);
    for (const double time : {0.05, 5.0, 9.95, 2.22, 7.0, -1.0, 100.0}) {
        const auto found = ahead.nearest(time);
        const auto exact = ahead.next(time);
        EXPECT_EQ(found.from, ahead.stateAt(time)) << time;
        EXPECT_EQ(found.to, exact.to) << time;
        EXPECT_EQ(found.atFrom, exact.atFrom) << time;
        EXPECT_EQ(found.atTo, exact.atTo) << time;
    }
}

TEST(StateReadAhead, StatesAreLeftOutWhereReadingCannotKeepUp) {
    for (const int direction : {1, -1}) {
        const Series series(Milliseconds(10));
        StateReadAhead ahead(series.fe);
        std::size_t widest = 0;
        // Ten seconds of the collapse in half a second: at 10 ms a state no more than 50 of the 100 can be read.
        for (int i = 0; i < 100; ++i) {
            const double time = direction > 0 ? 0.1 * i + 0.01 : 9.91 - 0.1 * i;
            const auto found = ahead.nearest(time);
            expectAround(found, time);
            widest = std::max(widest, found.to - found.from);
            EXPECT_LE(ahead.atHand(), StateReadAhead::kept);
            std::this_thread::sleep_for(Milliseconds(5));
        }
        EXPECT_GT(widest, 1u) << direction;
        EXPECT_LT(series.source->reads, 60) << direction;
    }
}

TEST(StateReadAhead, WhatIsReadInTimeIsReadAhead) {
    const Series series(Milliseconds(1));
    StateReadAhead ahead(series.fe);
    ahead.nearest(1.01);
    std::this_thread::sleep_for(Milliseconds(20));
    ahead.nearest(1.02);
    ahead.settle();
    const int reads = series.source->reads;
    EXPECT_EQ(reads, 4);  // the interval, the state before it and the one after
    const auto found = ahead.nearest(1.11);
    EXPECT_EQ(found.from, 11u);
    EXPECT_GT(found.to, 11u);
    EXPECT_EQ(found.before, 10u);
    ahead.settle();
    EXPECT_LE(series.source->reads, reads + 1) << "what is at hand is not read again";
    ahead.next(1.11);
    EXPECT_EQ(ahead.atHand(), 0u) << "at rest nothing is held";
}

TEST(StateReadAhead, ClosingDropsWhatHasNotBegun) {
    const Series series(Milliseconds(30));
    {
        StateReadAhead ahead(series.fe);
        ahead.nearest(1.01);
        std::this_thread::sleep_for(Milliseconds(1));
        ahead.nearest(1.02);
    }
    const int reads = series.source->reads;
    EXPECT_LE(reads, 4);
    std::this_thread::sleep_for(Milliseconds(50));
    EXPECT_EQ(series.source->reads, reads);
}

TEST(StateReadAhead, AnErrorComesToWhoeverNeedsTheState) {
    const Series series(Milliseconds(1));
    series.source->damaged = 13;
    StateReadAhead ahead(series.fe);
    int errors = 0;
    for (const double time : {1.01, 1.02, 1.12, 1.14}) {
        ahead.nearest(time);
        std::this_thread::sleep_for(Milliseconds(10));
    }
    try {
        ahead.nearest(5.0);  // away from it
        ahead.nearest(1.31);
    } catch (const WorldError&) {
        ++errors;
    }
    EXPECT_EQ(errors, 1);
    series.source->damaged = states;
    expectAround(ahead.nearest(1.31), 1.31);
}

TEST(StateReadAhead, ScrubbingAtRandomNeverMixesStatesUp) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> step(-0.3, 0.3), jump(0.0, 10.0);
    for (int round = 0; round < 10; ++round) {
        // A budget of two states: nearly everything is read anew. The result goes while a state is being read.
        Series series(Milliseconds(round % 3), 1);
        StateReadAhead ahead(std::exchange(series.fe, nullptr));
        double time = 3.0;
        for (int i = 0; i < 60; ++i) {
            time = i % 20 == 19 ? jump(random) : std::clamp(time + step(random), 0.0, 9.95);
            expectAround(ahead.nearest(time), time);
            EXPECT_LE(ahead.atHand(), StateReadAhead::kept);
        }
    }
}

}  // namespace
}  // namespace rubble
