#include "core/selftest/suite.h"
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <cmath>
#include <limits>
#include <regex>
#include <set>

#include "core/base/error.h"

namespace rubble::selftest {
namespace {

TEST(Check, PassesOnTheRightSideOfItsLimit) {
    Outcome outcome;
    outcome.atMost("a", 1.0, 1.0);
    outcome.atLeast("b", 0.9, 0.9);
    outcome.near("c", 9.9, 10.0, 0.2);
    outcome.none("d", 0);
    EXPECT_TRUE(outcome.pass());
    EXPECT_NEAR(outcome.checks()[2].measured, 0.1, 1e-12) << "what counts is the distance from the law";
    EXPECT_TRUE(outcome.checks()[2].closedForm());
    EXPECT_FALSE(outcome.checks()[0].closedForm());
    outcome.atMost("e", 1.0001, 1.0);
    EXPECT_FALSE(outcome.pass());
    EXPECT_EQ(outcome.governing()->name, "e");
}

TEST(Check, WhatIsNotANumberFails) {
    for (const double bad : {unknown, std::numeric_limits<double>::infinity()}) {
        Outcome most, least, near;
        most.atMost("x", bad, 1e300);
        least.atLeast("x", bad, 0.0);
        near.near("x", bad, 1.0, 10.0);
        EXPECT_FALSE(most.pass());
        EXPECT_FALSE(least.pass());
        EXPECT_FALSE(near.pass());
    }
    EXPECT_FALSE(Outcome().pass()) << "a case that measured nothing has shown nothing";
}

TEST(Check, GoverningIsTheOneThatUsesMostOfItsLimit) {
    Outcome outcome;
    outcome.atMost("half", 0.5, 1.0);
    outcome.atLeast("nearly", 1.0, 0.95);
    outcome.none("none", 0.0);
    EXPECT_EQ(outcome.governing()->name, "nearly");
    outcome.atLeast("nan", unknown, 1.0);
    EXPECT_EQ(outcome.governing()->name, "nan");
}

TEST(Suite, IdsAreStableAndUnique) {
    std::set<std::string_view> ids;
    for (const HardCase& one : hardCases()) {
        EXPECT_TRUE(ids.insert(one.id).second) << one.id;
        EXPECT_TRUE(std::regex_match(std::string(one.id), std::regex("[a-z0-9]+(-[a-z0-9]+)*"))) << one.id;
        EXPECT_FALSE(one.title.empty() || one.risk.empty() || one.criterion.empty()) << one.id;
        EXPECT_GT(one.seconds, 0.0) << one.id;
    }
    // Every case that the issue of this suite names.
    for (const char* id :
         {"births-in-debris", "piece-25",        "births-neighbours",   "elements-inverted", "elements-slivers", "plates-2cm",
          "mass-ratio",       "sizes-1cm-10m",   "thin-deck-60m",       "coarse-output",     "support-dies",     "revival-latch",
          "revival-follow",   "revival-refuse",  "pile-50000",          "pile-rest-60s",     "far-from-origin",  "step-halved",
          "births-shuffled",  "piece-closes",    "births-in-structure", "restitution-09",    "friction-0",       "friction-2",
          "gravity",          "worlds-parallel", "kill-resume",         "nan-input"}) {
        EXPECT_TRUE(ids.contains(id)) << id;
    }
}

TEST(Suite, ChoosesByIdAndByGroup) {
    EXPECT_EQ(chosenCases({}).size(), hardCases().size());
    const auto two = chosenCases({"topple", "free-fall"});
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[0]->id, "free-fall") << "in the order of the table";
    const auto laws = chosenCases({"closed-form"});
    EXPECT_GE(laws.size(), 7u);
    for (const HardCase* one : laws) {
        EXPECT_TRUE(one->id.starts_with("form-"));
    }
    EXPECT_THROW(chosenCases({"freefall"}), UsageError);
}

// A report says "seconds" of the laws: it made its reader wait for ten minutes of columns.
TEST(Suite, AReportTakesOfTheLawsThoseOfSeconds) {
    const auto laws = reportCases("closed-form");
    EXPECT_GE(laws.size(), 7u);
    double seconds = 0.0;
    for (const HardCase* one : laws) {
        EXPECT_TRUE(one->id.starts_with("form-"));
        seconds += one->seconds;
    }
    EXPECT_LE(seconds, 10.0);
    EXPECT_EQ(reportCases("all").size(), hardCases().size());
    EXPECT_TRUE(reportCases("none").empty());
}

TEST(Suite, ResultsDoNotDependOnTheThreads) {
    const auto cases = chosenCases({"free-fall", "bounce", "slide-to-rest", "births-overlap", "piece-carries", "tower-10"});
    SuiteSettings settings;
    settings.threads = 1;
    const std::vector<CaseResult> alone = runSuite(cases, settings, Execution());
    settings.threads = 4;
    const std::vector<CaseResult> together = runSuite(cases, settings, Execution());
    ASSERT_EQ(alone.size(), together.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_EQ(alone[i].hardCase, together[i].hardCase);
        ASSERT_EQ(alone[i].outcome.checks().size(), together[i].outcome.checks().size());
        for (std::size_t c = 0; c < alone[i].outcome.checks().size(); ++c) {
            EXPECT_EQ(alone[i].outcome.checks()[c].measured, together[i].outcome.checks()[c].measured) << alone[i].hardCase->id;
        }
    }
}

TEST(Suite, CancelKeepsWhatWasFinished) {
    const auto cases = chosenCases({"free-fall", "slide-to-rest", "pile-50000"});
    // The long one starts first; the two short ones finish on the other thread.
    const Execution* toCancel = nullptr;
    const Execution execution([&](const Progress& progress) {
        if (progress.fraction > 0.0) {
            toCancel->cancel();
        }
    });
    toCancel = &execution;
    const std::vector<CaseResult> results = runSuite(cases, {}, execution);
    ASSERT_EQ(results.size(), 3u);
    EXPECT_FALSE(results[2].finished);
    EXPECT_FALSE(results[2].pass());
    EXPECT_TRUE(results[0].finished || results[1].finished);
    EXPECT_TRUE(execution.cancelled());
}

TEST(Suite, AnErrorFailsTheCaseAndTellsWhy) {
    const HardCase broken{"broken", "t", "r", "c", 1.0, [](const CaseSetting&, Outcome& outcome) {
                              outcome.none("fine so far", 0);
                              throw UsageError({"test.broken", "it broke", {}}, {"test.remedy", "mend it", {}});
                          }};
    const CaseResult result = runCase(broken, {}, Execution());
    EXPECT_TRUE(result.finished);
    EXPECT_FALSE(result.pass());
    EXPECT_NE(result.error.find("it broke"), std::string::npos);
}

}  // namespace
}  // namespace rubble::selftest
