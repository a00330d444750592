#include "core/pipeline/time_left.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rubble {
namespace {

/// What is said at an instant [s] of a stage that is so far.
class Told {
public:
    double at(double seconds, double fraction, const char* stage = "test.stage") {
        return m_left.after({{stage, "working", {}}, fraction},
                            m_from + std::chrono::duration_cast<TimeLeft::Clock::duration>(std::chrono::duration<double>(seconds)));
    }
    void restart() { m_left.restart(); }

private:
    TimeLeft m_left;
    TimeLeft::Clock::time_point m_from = TimeLeft::Clock::now();
};

TEST(TimeLeft, IsWhatTheStageTookForWhatItDid) {
    Told told;
    EXPECT_TRUE(std::isnan(told.at(0.0, 0.0)));
    EXPECT_TRUE(std::isnan(told.at(0.9, 0.3))) << "the first moments say nothing";
    EXPECT_NEAR(told.at(10.0, 0.25), 30.0, 1e-6);
    EXPECT_NEAR(told.at(20.0, 0.5), 20.0, 1e-6);
    EXPECT_TRUE(std::isnan(told.at(21.0, 0.6, "test.next"))) << "another stage has a clock of its own";
    EXPECT_NEAR(told.at(31.0, 0.8, "test.next"), 10.0, 1e-6) << "half of what was left of it took 10 s";
}

// A stage counted some of its work as done before it began with the rest: for 20 s it said 0.0 s.
TEST(TimeLeft, IsNotSaidWhereNoneSeemsLeft) {
    Told told;
    told.at(0.0, 0.0);
    EXPECT_TRUE(std::isnan(told.at(30.0, 0.995)));
    EXPECT_TRUE(std::isnan(told.at(30.0, 1.0)));
    Told nearly;
    nearly.at(0.0, 0.0);
    EXPECT_TRUE(std::isnan(nearly.at(20.0, 0.98))) << "0.4 s";
}

TEST(TimeLeft, DoesNotGrowAndIsNotSaidWhereItMisleads) {
    Told told;
    told.at(0.0, 0.0);
    EXPECT_NEAR(told.at(10.0, 0.5), 10.0, 1e-6);
    EXPECT_NEAR(told.at(12.0, 0.5), 10.0, 1e-6) << "12 s by now: it was said shorter";
    EXPECT_TRUE(std::isnan(told.at(40.0, 0.6))) << "27 s are left: 10 s would mislead";
    EXPECT_NEAR(told.at(50.0, 0.9), 50.0 / 9.0, 1e-6) << "again once it is near";
    told.restart();
    EXPECT_TRUE(std::isnan(told.at(51.0, 0.1)));
    EXPECT_NEAR(told.at(61.0, 0.2), 80.0, 1e-6) << "another piece of work";
}

}  // namespace
}  // namespace rubble
