#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/command_run.h"
#include "tests/support/gltf_rules.h"
#include "tests/support/small_collapse.h"

namespace rubble::cli {

namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;

/// What bash offers for the last of these words.
std::vector<std::string> completions(const std::vector<std::string>& words) {
    std::string script = "eval \"$(" + cliPath() + " --completion)\"; COMP_WORDS=(rubble-cli";
    for (const std::string& word : words) {
        script += " '" + word + "'";
    }
    script += "); COMP_CWORD=" + std::to_string(words.size()) + "; _rubble_cli; printf '%s\\n' \"${COMPREPLY[@]}\"";
    const Outcome outcome = CommandRun().run({"bash", "-c", script});
    EXPECT_EQ(outcome.err, "");
    std::vector<std::string> offered;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty()) {
            offered.push_back(line);
        }
    }
    return offered;
}

std::vector<std::string> commandsInOrder() {
    std::vector<std::string> names;
    std::istringstream lines(cli({"--help"}).out);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("  rubble-cli ") && line[13] != '-') {
            names.push_back(line.substr(13, line.find(' ', 13) - 13));
        }
    }
    return names;
}

TEST(Completion, OffersEveryCommandAndItsOptions) {
    ASSERT_GT(commandsInOrder().size(), 15u);
    EXPECT_THAT(completions({""}), IsSupersetOf(commandsInOrder()));
    EXPECT_THAT(completions({"ins"}), testing::ElementsAre("inspect"));
    EXPECT_THAT(completions({"run", "--"}), IsSupersetOf({"--set", "--out", "--json", "--export", "--tables"}));
    EXPECT_THAT(completions({"inspect", "--o"}), IsEmpty());
    EXPECT_THAT(completions({"cache", ""}), testing::UnorderedElementsAre("list", "clear"));
}

TEST(Completion, OffersParametersAndWhatTheyCanBe) {
    EXPECT_THAT(completions({"run", "a.exo", "--set", "mult"}), testing::ElementsAre("multiple="));
    EXPECT_THAT(completions({"run", "a.exo", "--set", "birth_time", "="}), testing::UnorderedElementsAre("state", "exact"));
    EXPECT_THAT(completions({"run", "a.exo", "--set", "birth_time", "=", "ex"}), testing::ElementsAre("exact"));
    EXPECT_THAT(completions({"run", "a.exo", "--set", "preset", "=", ""}), Contains("paper"));
    EXPECT_THAT(completions({"export", "a.run.h5", "--export", "gl"}), testing::ElementsAre("gltf="));
    EXPECT_THAT(completions({"map", "a.run.h5", "--live", ""}), testing::UnorderedElementsAre("on", "off"));
}

// Where a file belongs nothing is offered: bash then completes names of files.
TEST(Completion, LeavesFilesToTheShell) {
    EXPECT_THAT(completions({"run", ""}), IsEmpty());
    EXPECT_THAT(completions({"run", "a.exo", "--out", ""}), IsEmpty());
    EXPECT_THAT(completions({"export", "a.run.h5", "--export", "gltf", "=", ""}), IsEmpty());
}

TEST(ManPage, IsSoundTroffWithEveryCommand) {
    io::TemporaryFolder folder;
    std::ofstream(folder / "page.1") << cli({"--man-page"}).out;
    const Outcome page = CommandRun().run({"groff", "-man", "-ww", "-K", "utf8", "-T", "utf8", "-P", "-c", folder / "page.1"});
    EXPECT_EQ(page.exitCode, 0);
    EXPECT_EQ(page.err, "");
    for (const std::string& command : commandsInOrder()) {
        EXPECT_THAT(page.out, HasSubstr("rubble-cli " + command));
    }
    EXPECT_THAT(page.out, HasSubstr("wrong usage"));
}

TEST(ExportKinds, AreListedWithWhatOpensThem) {
    const nlohmann::json kinds = cli({"export", "--list", "--json"}).json()["kinds"];
    std::vector<std::string> names;
    for (const nlohmann::json& kind : kinds) {
        names.push_back(kind["kind"]);
        EXPECT_NE(kind["readers"], "");
    }
    EXPECT_THAT(names, testing::ElementsAre("fragments", "series", "vtkhdf", "bodies", "gltf", "page", "debris-map", "footprint",
                                            "figure"));
    EXPECT_THAT(cli({"export", "--list"}).out, HasSubstr("Blender"));
}

class ExportedRun : public SmallRun {};

TEST_F(ExportedRun, AsGltfKeepsTheRules) {
    run({"--export", "gltf=" + (m_folder / "small.glb")}, "0.5");
    const io::CheckedGlb file = io::checkGlb(textOf(m_folder / "small.glb"));
    EXPECT_THAT(file.broken, IsEmpty());
    EXPECT_GT(file.asset["meshes"].size(), 0u);
}

TEST_F(ExportedRun, AsBodiesNeedsTheRunFile) {
    const Outcome refused = cli({"run", m_path, "--export", "bodies=" + (m_folder / "b.xdmf"), "--set", "settle_time=0"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("--out RUN.h5"));
    run({"--export", "bodies=" + (m_folder / "b.xdmf")}, "0");
    EXPECT_THAT(textOf(m_folder / "b.xdmf"), HasSubstr("small.run.h5:/frames/positions"));
}

}  // namespace

}  // namespace rubble::cli
