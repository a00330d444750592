#include "app/gui/session/worker.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTest>
#include <atomic>
#include <cmath>

#include "app/gui/session/watched_sink.h"
#include "core/base/error.h"

namespace rubble {

namespace {

/// What has begun to work until it is cancelled, since the start.
std::atomic<int> begun = 0;

/// Works until it is cancelled.
void untilCancelled(const Execution& execution) {
    ++begun;
    while (true) {
        execution.report({"test", "working", {}}, 0.5);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// Waits for the next of it, however long a busy machine lets it wait.
bool beginsAfter(int before) {
    return QTest::qWaitFor([before] { return begun > before; }, 300'000);
}

}  // namespace

TEST(Worker, RunsOneJobAfterAnotherAndFinishesOnThisThread) {
    Worker worker;
    std::vector<int> order;
    std::thread::id finished;
    worker.start(
        {Worker::Kind::Open, [&](const Execution&) { order.push_back(1); }, [&](std::exception_ptr) { order.push_back(2); }});
    worker.start({Worker::Kind::Simulate, [&](const Execution&) {},
                  [&](std::exception_ptr thrown) {
                      EXPECT_EQ(thrown, nullptr);
                      finished = std::this_thread::get_id();
                  }});
    ASSERT_TRUE(QTest::qWaitFor([&] { return finished != std::thread::id(); }));
    EXPECT_EQ(order, (std::vector<int>{1, 2}));
    EXPECT_EQ(finished, std::this_thread::get_id());
    EXPECT_FALSE(worker.busy());
}

// A window that is busy would else draw progress that is long past.
TEST(Worker, ProgressThatComesWhileTheWindowIsBusyIsToldOnceAndIsTheNewest) {
    constexpr int reports = 1000;
    Worker worker;
    std::vector<double> told;
    QObject::connect(&worker, &Worker::progressed,
                     [&](Worker::Kind, const Progress& progress) { told.push_back(progress.fraction); });
    std::atomic<bool> reported = false, go = false;
    bool finished = false;
    worker.start({Worker::Kind::Study,
                  [&](const Execution& execution) {
                      for (int i = 1; i <= reports; ++i) {
                          execution.report({"test", "working", {}}, static_cast<double>(i) / reports);
                      }
                      reported = true;
                      while (!go) {
                          std::this_thread::sleep_for(std::chrono::milliseconds(1));
                      }
                  },
                  [&](const std::exception_ptr&) { finished = true; }});
    // This thread, the window's, looks at no events meanwhile.
    while (!reported) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(told.empty());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !told.empty(); }, 300'000));
    EXPECT_EQ(told, std::vector<double>{1.0});
    // Who comes to listen later asks for it, as long as the work runs.
    worker.tellProgress();
    EXPECT_EQ(told, (std::vector<double>{1.0, 1.0}));
    go = true;
    ASSERT_TRUE(QTest::qWaitFor([&] { return finished; }, 300'000));
    worker.tellProgress();
    EXPECT_EQ(told.size(), 2u) << "it is through";
}

TEST(Worker, WhatIsQueuedIsAllDone) {
    Worker worker;
    std::atomic<bool> go = false;
    std::vector<int> done;
    for (int i = 0; i < 3; ++i) {
        worker.queue({Worker::Kind::Write,
                      [&](const Execution&) {
                          while (!go) {
                              std::this_thread::sleep_for(std::chrono::milliseconds(1));
                          }
                      },
                      [&, i](std::exception_ptr thrown) {
                          EXPECT_EQ(thrown, nullptr);
                          done.push_back(i);
                      }});
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return worker.waiting() == 2; }));
    go = true;
    ASSERT_TRUE(QTest::qWaitFor([&] { return !worker.busy(); }));
    EXPECT_EQ(done, (std::vector<int>{0, 1, 2}));
}

TEST(Worker, TheLatestOfAKindWins) {
    Worker worker;
    std::atomic<int> last = 0;
    int finished = 0;
    bool firstCancelled = false;
    const int before = begun;
    worker.start({Worker::Kind::Update, untilCancelled, [&](std::exception_ptr thrown) {
                      firstCancelled = thrown != nullptr && !failureOf(thrown);
                      ++finished;
                  }});
    ASSERT_TRUE(beginsAfter(before));
    for (int i = 1; i <= 5; ++i) {
        worker.start({Worker::Kind::Update, [&, i](const Execution&) { last = i; }, [&](std::exception_ptr) { ++finished; }});
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return !worker.busy() && finished == 2; }));
    EXPECT_TRUE(firstCancelled);
    EXPECT_EQ(last, 5);
}

TEST(Worker, CancelReachesWorkWithinHalfASecondAndDropsWhatWaits) {
    Worker worker;
    bool ended = false;
    bool ran = false;
    const int before = begun;
    worker.start({Worker::Kind::Simulate, untilCancelled, [&](std::exception_ptr) { ended = true; }});
    worker.start({Worker::Kind::Write, [&](const Execution&) { ran = true; }, [](std::exception_ptr) {}});
    ASSERT_TRUE(beginsAfter(before));
    worker.cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return ended; }, 5000));
    EXPECT_FALSE(ran);
    EXPECT_FALSE(worker.busy());
}

// A dialog that shows what is queued would wait for ever.
TEST(Worker, WhatIsCancelledWhileItIsQueuedIsToldSo) {
    Worker worker;
    const int before = begun;
    worker.start({Worker::Kind::Study, untilCancelled, [](std::exception_ptr) {}});
    ASSERT_TRUE(beginsAfter(before));
    bool worked = false, superseded = false;
    std::vector<bool> cancelled;
    for (int k = 0; k < 2; ++k) {
        worker.queue({Worker::Kind::Write, [&](const Execution&) { worked = true; },
                      [&](std::exception_ptr thrown) {
                          try {
                              std::rethrow_exception(thrown);
                          } catch (const Cancelled&) {
                              cancelled.push_back(true);
                          }
                      }});
    }
    worker.start({Worker::Kind::Update, [&](const Execution&) { worked = true; }, [&](std::exception_ptr) { superseded = true; }});
    worker.cancel();
    EXPECT_TRUE(worker.busy(Worker::Kind::Write)) << "until it is told";
    ASSERT_TRUE(QTest::qWaitFor([&] { return !worker.busy(); }, 300'000));
    EXPECT_EQ(cancelled.size(), 2u);
    EXPECT_FALSE(worked);
    EXPECT_FALSE(superseded) << "nobody waits for what never started and was not queued";
}

TEST(Worker, DyingWhileItWorksIsClean) {
    bool ended = false;
    {
        Worker worker;
        const int before = begun;
        worker.start({Worker::Kind::Simulate, untilCancelled, [&](std::exception_ptr) { ended = true; }});
        ASSERT_TRUE(beginsAfter(before));
    }
    QTest::qWait(20);
    EXPECT_FALSE(ended);  // nobody is left to be told
}

TEST(Worker, FailuresSayWhatAndWhatToDo) {
    const auto of = [](const auto& error) { return failureOf(std::make_exception_ptr(error)); };
    const auto failure = of(WorldError({"x.y", "{0} is full", {"disk"}}, {"x.y.remedy", "Make room.", {}}));
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->what(), QStringLiteral("disk is full"));
    EXPECT_EQ(failure->remedy(), QStringLiteral("Make room."));
    EXPECT_EQ(failure->id, "x.y");
    EXPECT_FALSE(of(Cancelled()));
    EXPECT_FALSE(failureOf(nullptr));
    EXPECT_TRUE(of(std::runtime_error("odd")));
    EXPECT_TRUE(of(std::bad_alloc()));
}

TEST(LivePace, AFrameWaitsForTheOneBeforeToBeShownAndForTheClock) {
    LivePace pace(50.0);
    const Execution execution;
    QElapsedTimer clock;
    clock.start();
    std::thread screen([&] {
        for (int i = 0; i < 10; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            pace.shown(0.02 * i);
        }
    });
    for (int i = 0; i < 10; ++i) {
        pace.waitFor(0.02 * i, execution);
    }
    // Nine intervals of 20 ms of collapse take no less of the wall clock.
    EXPECT_GE(clock.nsecsElapsed(), 180'000'000 - 1'000'000);
    screen.join();
}

TEST(LivePace, ThereIsOneLiveFrameForEachFrameTimeWhateverElseIsRecorded) {
    // Frames at steps of 1/60 s, those at 24 a second or at an FE state every 0.08 s recorded.
    LivePace pace(24.0);
    const Execution execution;
    int live = 0;
    double nextFrame = 0.0;
    for (int step = 0; step <= 600; ++step) {
        const double time = step / 60.0;
        const bool frame = time >= nextFrame - 1e-9;
        nextFrame += frame ? 1.0 / 24.0 : 0.0;
        const bool state = std::fmod(time + 1e-9, 0.08) < 1.0 / 60.0;
        if ((frame || state) && pace.isNext(time)) {
            ++live;
            pace.shown(1e9);
            execution.cancel();  // the wall clock is not waited for
            pace.waitFor(time, execution);
        }
    }
    EXPECT_NEAR(live, 241, 1);
}

TEST(LivePace, CancelEndsTheWait) {
    LivePace pace(50.0);
    const Execution execution;
    pace.waitFor(0.0, execution);
    execution.cancel();
    QElapsedTimer clock;
    clock.start();
    pace.waitFor(3600.0, execution);
    EXPECT_LT(clock.elapsed(), 60'000);
}

}  // namespace rubble
