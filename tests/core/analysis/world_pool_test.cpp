#include "core/analysis/accuracy/world_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/simulation/run/checkpoint.h"

namespace rubble {
namespace {

const Message stage{"test.stage", "working", {}};
const Message simulating{std::string(simulatingStage), "simulating", {}};

TEST(WorldPool, DoesEveryPieceOnceWhateverTheThreads) {
    for (const int threads : {0, 1, 2, 7, 64}) {
        std::vector<int> done(23, 0);
        runInParallel(done.size(), {threads}, stage, Execution(), [&](std::size_t i, const Execution&) { ++done[i]; });
        EXPECT_EQ(done, std::vector<int>(23, 1)) << threads;
    }
    runInParallel(0, {2}, stage, Execution(), [](std::size_t, const Execution&) { FAIL(); });
}

TEST(WorldPool, WorksOnNoMoreThreadsThanAsked) {
    std::mutex mutex;
    std::set<std::thread::id> ids;
    runInParallel(30, {2}, stage, Execution(), [&](std::size_t, const Execution&) {
        const std::scoped_lock lock(mutex);
        ids.insert(std::this_thread::get_id());
    });
    EXPECT_LE(ids.size(), 2u);
    EXPECT_FALSE(ids.contains(std::this_thread::get_id()));
}

TEST(WorldPool, SharesTheThreadsAmongThePieces) {
    const auto threadsOfAPiece = [](std::size_t count, int threads, const Execution& execution) {
        std::atomic<int> seen{0};
        runInParallel(count, {threads}, stage, execution, [&](std::size_t, const Execution& own) { seen = own.threads(); });
        return seen.load();
    };
    EXPECT_EQ(threadsOfAPiece(2, 8, Execution()), 4);
    EXPECT_EQ(threadsOfAPiece(3, 8, Execution()), 2);
    EXPECT_EQ(threadsOfAPiece(9, 8, Execution()), 1);
    EXPECT_EQ(threadsOfAPiece(1, 0, Execution().withThreads(6)), 6);
}

TEST(WorldPool, ReportsFromTheCallingThreadAndNeverBackwards) {
    const std::thread::id caller = std::this_thread::get_id();
    std::vector<double> fractions;
    const Execution execution([&](const Progress& progress) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_EQ(progress.stage.id, stage.id);
        fractions.push_back(progress.fraction);
    });
    runInParallel(4, {2}, stage, execution, [&](std::size_t, const Execution& own) {
        for (int k = 0; k <= 10; ++k) {
            own.report(simulating, k / 10.0);
            std::this_thread::sleep_for(std::chrono::milliseconds(15));
        }
        own.report(simulating, 0.2);
    });
    ASSERT_FALSE(fractions.empty());
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1.0);
}

// A repeat makes its fragments in an instant: it is not nearly done then, for all of it is yet to be simulated.
TEST(WorldPool, WhatPreparesAPieceDoesNotCount) {
    double most = 0.0;
    const Execution execution(
        [&](const Progress& progress) { most = progress.fraction < 1.0 ? std::max(most, progress.fraction) : most; });
    runInParallel(2, {2}, stage, execution, [&](std::size_t, const Execution& own) {
        own.report({"fragments.progress", "Making fragments", {}}, 1.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(150));
        own.report(simulating, 0.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(60));
        own.report(simulating, 0.25);
        std::this_thread::sleep_for(std::chrono::milliseconds(150));
    });
    EXPECT_GT(most, 0.1) << "what is simulated counts";
    EXPECT_LE(most, 0.5 * (0.25 + 1.0)) << "one piece may have ended while the other is looked at";
}

TEST(WorldPool, CancelReachesEveryPieceAndKeepsWhatIsDone) {
    const Execution execution;
    std::atomic<int> finished{0};
    const auto work = [&](std::size_t i, const Execution& own) {
        if (i == 0) {
            ++finished;
            execution.cancel();
            return;
        }
        for (;;) {
            own.check();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    };
    EXPECT_THROW(runInParallel(5, {2}, stage, execution, work), Cancelled);
    EXPECT_EQ(finished, 1);
    EXPECT_THROW(runInParallel(5, {2}, stage, execution, work), Cancelled) << "nothing begins after a cancel";
    EXPECT_EQ(finished, 1);
}

TEST(WorldPool, TheErrorOfTheFirstPieceStopsTheRest) {
    std::atomic<int> begun{0};
    const auto work = [&](std::size_t i, const Execution& own) {
        ++begun;
        if (i == 1) {
            throw UsageError({"test.broken", "piece {0} is broken", {i}}, {});
        }
        while (i == 0) {
            own.check();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    };
    try {
        runInParallel(40, {2}, stage, Execution(), work);
        FAIL() << "no error came out";
    } catch (const UsageError& error) {
        EXPECT_EQ(error.message().id, "test.broken");
    }
    EXPECT_LT(begun, 40);
}

TEST(WorldPool, SaysHowManyWorldsWentOnFromCheckpoints) {
    std::mutex mutex;
    std::vector<Message> said;
    const Execution execution([&](const Progress& progress) {
        const std::scoped_lock lock(mutex);
        said.push_back(progress.stage);
    });
    const auto work = [&](std::size_t i, const Execution& own) {
        if (i != 1) {
            own.report({std::string(resumedStage), "going on at {0}", {Argument(10.0 + static_cast<double>(i), "s")}}, 0.0);
        }
        // Long enough for the watcher to look.
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    };
    runInParallel(3, {1}, stage, execution, work);
    const auto lastText = [&] {
        const auto last = std::find_if(said.rbegin(), said.rend(), [](const Message& m) { return m.id == worldsResumedStage; });
        return last == said.rend() ? std::string() : englishText(*last);
    };
    EXPECT_EQ(lastText(), "simulating 3 worlds; 2 went on from checkpoints, the latest at 12 s");
    said.clear();
    runInParallel(3, {1}, stage, execution, [](std::size_t, const Execution&) {});
    EXPECT_EQ(lastText(), "");
}

}  // namespace
}  // namespace rubble
