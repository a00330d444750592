#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/selftest/suite.h"
#include "tests/support/command_run.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SelfTest, JsonHasTheDocumentedKeys) {
    const Outcome outcome = cli({"self-test", "--only", "free-fall", "--only", "topple", "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json object = outcome.json();
    ASSERT_EQ(object["cases"].size(), 2u);
    EXPECT_EQ(object["passed"], 2);
    EXPECT_EQ(object["failed"], 0);
    EXPECT_EQ(object["solver"], "soft-step");
    for (const nlohmann::json& one : object["cases"]) {
        for (const char* key : {"id", "title", "criterion", "unit"}) {
            EXPECT_TRUE(one[key].is_string()) << key;
        }
        EXPECT_TRUE(one["pass"].get<bool>());
        EXPECT_LE(one["measured"].get<double>(), one["limit"].get<double>());
        EXPECT_FALSE(one["checks"].empty());
    }
    EXPECT_EQ(object["cases"][0]["id"], "free-fall");
}

TEST(SelfTest, ThreadsChangeNoNumber) {
    const auto measured = [](const char* threads) {
        std::string numbers;
        const nlohmann::json object =
            cli({"self-test", "--only", "bounce", "--only", "slide-to-rest", "--threads", threads, "--json"}).json();
        for (const nlohmann::json& one : object["cases"]) {
            for (const nlohmann::json& check : one["checks"]) {
                numbers += check["measured"].dump() + ' ';
            }
        }
        return numbers;
    };
    EXPECT_EQ(measured("1"), measured("3"));
}

TEST(SelfTest, TheTableNamesCaseRiskCriterionAndVerdict) {
    io::TemporaryFolder folder;
    const std::string csv = folder / "suite.csv";
    const Outcome outcome = cli({"self-test", "--only", "form-projectile", "--csv", csv});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* word : {"what could go wrong", "criterion", "measured", "limit", "form-projectile", "pass", "expected",
                             "tolerance", "1 passed, 0 failed"}) {
        EXPECT_THAT(outcome.out, HasSubstr(word));
    }
    EXPECT_THAT(textOf(csv), HasSubstr("case,what_could_go_wrong,criterion,measured,limit,unit,result\n"));
    EXPECT_THAT(outcome.err, HasSubstr("pass  form-projectile, "));
}

// The stock solver is known to let towers fall (PHYSICS section 4): the suite must be able to fail.
TEST(SelfTest, FailsWhereTheStockSolverDoes) {
    const Outcome outcome = cli({"self-test", "--only", "tower-20", "--solver", "bullet", "--json"});
    EXPECT_EQ(outcome.exitCode, 1);
    const nlohmann::json object = outcome.json();
    EXPECT_EQ(object["failed"], 1);
    EXPECT_FALSE(object["cases"][0]["pass"].get<bool>());
    EXPECT_GT(object["cases"][0]["measured"].get<double>(), object["cases"][0]["limit"].get<double>());
}

TEST(SelfTest, RefusesWhatDoesNotExist) {
    const Outcome unknown = cli({"self-test", "--only", "free-fal"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err, HasSubstr("\"free-fall\""));
    EXPECT_EQ(cli({"self-test", "--solver", "magic"}).exitCode, 2);
    EXPECT_EQ(cli({"self-test", "--threads", "0"}).exitCode, 2);
    EXPECT_EQ(cli({"self-test", "--threads", "two"}).exitCode, 2);
}

TEST(SelfTest, TheManualListsEveryCase) {
    const std::string page = textOf(sourcePath("resources/manual/self-test.md"));
    for (const selftest::HardCase& one : selftest::hardCases()) {
        const std::string row = "| `" + std::string(one.id) + "` | " + std::string(one.title) + " | " + std::string(one.risk) +
                                " | " + std::string(one.criterion) + " |";
        EXPECT_THAT(page, HasSubstr(row));
    }
    EXPECT_EQ(static_cast<std::size_t>(std::count(page.begin(), page.end(), '\n')) > selftest::hardCases().size(), true);
}

}  // namespace

}  // namespace rubble::cli
