#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/command_run.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

TEST(Help, OverviewNamesEveryCommandOfTheDesign) {
    const Outcome outcome = cli({"--help"});
    EXPECT_EQ(outcome.exitCode, 0);
    for (const char* command :
         {"inspect", "size", "effects", "run", "convert", "cache", "export", "figure", "verify", "parameters"}) {
        EXPECT_THAT(outcome.out, HasSubstr(std::string("rubble-cli ") + command));
    }
    EXPECT_EQ(outcome.err, "");
}

TEST(Help, EveryCommandExplainsItself) {
    for (const char* command : {"inspect", "size", "effects", "run", "export", "figure", "verify", "parameters"}) {
        const Outcome outcome = cli({command, "--help"});
        EXPECT_EQ(outcome.exitCode, 0) << command;
        EXPECT_THAT(outcome.out, HasSubstr(std::string("Usage: rubble-cli ") + command));
        EXPECT_THAT(outcome.out, HasSubstr("--json"));
        EXPECT_THAT(outcome.out, HasSubstr("Exit codes: 0 ok, 1 failed, 2 wrong usage, 3 cancelled."));
    }
}

TEST(Help, VersionNamesTheBuild) {
    const Outcome outcome = cli({"--version"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.out, testing::MatchesRegex("rubble-cli [0-9]+\\.[0-9]+\\.[0-9]+ \\(.+\\)\n"));
}

struct WrongUsage {
    std::vector<std::string> words;
    std::string says;
};

class Usage : public testing::TestWithParam<WrongUsage> {};

TEST_P(Usage, IsRefusedWithCode2AndARemedy) {
    const Outcome outcome = cli(GetParam().words);
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, Usage,
    testing::Values(
        WrongUsage{{}, "rubble-cli COMMAND --help"}, WrongUsage{{"crush"}, "Commands: inspect, size, effects, run"},
        WrongUsage{{"inspect"}, "needs a file"}, WrongUsage{{"inspect", "a", "b"}, "cannot use \"b\""},
        WrongUsage{{"convert", "a.exo"}, "needs a file"}, WrongUsage{{"convert", "a", "b.h5", "c"}, "cannot use \"c\""},
        WrongUsage{{"cache", "polish"}, "list or clear"}, WrongUsage{{"cache", "list", "--only", "dust"}, "fe, worlds"},
        WrongUsage{{"inspect", "a", "--follow", "0"}, "--follow"}, WrongUsage{{"inspect", "--speed", "a"}, "no option --speed"},
        WrongUsage{{"inspect", "a", "--csv"}, "--csv needs a value"}, WrongUsage{{"inspect", "a", "--json=yes"}, "takes no value"},
        WrongUsage{{"run", "a", "--out", "b", "--out", "c"}, "given twice"},
        WrongUsage{{"inspect", ""}, "name of the file is empty"}, WrongUsage{{"parameters", "a"}, "cannot use \"a\""},
        WrongUsage{{"run", "a", "--set", "multiple"}, "no \"=\""}, WrongUsage{{"run", "a", "--set", "=3"}, "no \"=\""},
        WrongUsage{{"run", "a", "--set", "speed=3"}, "speed"}, WrongUsage{{"run", "a", "--set", "multiple=much"}, "multiple"},
        WrongUsage{{"run", "a", "--set", "friction=-1"}, "friction"}, WrongUsage{{"run", "a", "--set", "friction=nan"}, "friction"},
        WrongUsage{{"run", "a", "--set", "preset=fast"}, "fast"}, WrongUsage{{"run", "a", "--scenario", "x"}, "not a case"}));

// Options are checked before files are opened, but a wrong file is told by its own code.
TEST(Usage, JsonErrorsAreOneObjectToo) {
    const Outcome outcome = cli({"inspect", "no-such-file.exo", "--json"});
    EXPECT_EQ(outcome.exitCode, 1);
    const nlohmann::json object = outcome.json();
    EXPECT_THAT(object["error"]["what"].get<std::string>(), HasSubstr("no-such-file.exo"));
    EXPECT_NE(object["error"]["remedy"], "");
    EXPECT_THAT(outcome.err, HasSubstr("no-such-file.exo"));
}

TEST(Usage, AnOutputThatCannotBeWrittenIsAnError) {
    const Outcome outcome = CommandRun().run({"sh", "-c", cliPath() + " parameters > /dev/full"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("could not be written"));
}

}  // namespace

}  // namespace rubble::cli
