#include "io/run/run_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

RunEntry someRun(int i) {
    RunEntry run;
    run.when = "2024-05-31T08:15:3" + std::to_string(i) + "Z";
    run.scenarioId = "scenario-1";
    run.scenarioName =
        "Br\xC3\xBC"
        "cke \"1\"";
    run.fingerprint.bytes[3] = static_cast<std::uint8_t>(i + 1);
    run.feSha256 = std::string(64, 'a');
    run.build = "text of the build";
    run.live = i % 2 == 0;
    run.complete = i % 3 != 0;
    run.wallSeconds = 0.1 * i;
    run.fragments = 1000000007LL * i;
    run.bodies = 4453;
    run.endTime = 19.7;
    run.asleepAtEnd = 1.0 / 3.0;
    run.msPerStep = 9.1;
    run.maxSpeed = 24.2;
    run.bulkingFactor = 1.5;
    run.energyDrift = 1e-17;
    run.breaches = i;
    run.grade = i == 0 ? std::nullopt : std::optional(static_cast<HealthGrade>(i % 3));
    run.acknowledged = i == 2;
    run.trajectoryHash.bytes[0] = 255;
    run.file = "/somewhere/first.run.h5";
    return run;
}

TEST(RunHistory, ComesBackAsItWas) {
    const TemporaryFolder folder;
    const std::string file = folder / "deep/case.rubble.runs.json";
    EXPECT_TRUE(readRunHistory(file).empty()) << "there is none yet";
    std::vector<RunEntry> runs;
    for (int i = 0; i < 5; ++i) {
        runs.push_back(someRun(i));
        writeRunHistory(file, runs);
        EXPECT_EQ(readRunHistory(file), runs);
    }
    runs[0].grade = HealthGrade::Notice;
    writeRunHistory(file, runs);
    EXPECT_EQ(runs[0].breaches, 0);
    EXPECT_FALSE(readRunHistory(file)[0].grade) << "a limit that was not passed has no grade";
    runs[0].bulkingFactor = std::nan("");
    writeRunHistory(file, runs);
    EXPECT_TRUE(std::isnan(readRunHistory(file)[0].bulkingFactor));
}

TEST(RunHistory, RunsBesideTheCaseMoveWithItsFolder) {
    const TemporaryFolder folder;
    RunEntry beside = someRun(1);
    beside.file = folder / "then/runs/first.run.h5";
    RunEntry stopped;
    stopped.when = beside.when;
    stopped.file = "/somewhere/else.run.h5";
    writeRunHistory(folder / "then/case.rubble.runs.json", {beside, stopped});
    std::filesystem::rename(folder / "then", folder / "now");
    const std::vector<RunEntry> runs = readRunHistory(folder / "now/case.rubble.runs.json");
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].file, folder / "now/runs/first.run.h5");
    EXPECT_EQ(runs[1].file, stopped.file);
    EXPECT_TRUE(std::isnan(runs[1].maxSpeed) && std::isnan(runs[1].msPerStep) && std::isnan(runs[1].asleepAtEnd));
}

TEST(RunHistory, OfEarlierVersionsSaysNoGrade) {
    const TemporaryFolder folder;
    const std::string file = folder / "case.rubble.runs.json";
    writeRunHistory(file, {someRun(2)});
    std::ifstream in(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    for (const std::string_view key : {"\"acknowledged\"", "\"grade\""}) {
        const std::size_t from = text.rfind('\n', text.find(key));
        text.erase(from, text.find('\n', from + 1) - from);
    }
    std::ofstream(file, std::ios::binary) << text;
    const std::vector<RunEntry> runs = readRunHistory(file);
    ASSERT_EQ(runs.size(), 1U) << text;
    EXPECT_EQ(runs[0].breaches, 2);
    EXPECT_FALSE(runs[0].grade || runs[0].acknowledged || runs[0].tainted());
    RunEntry lost = runs[0];
    lost.file = folder / "gone.run.h5";
    const RunEntry before = lost;
    takeVerdict(lost);
    EXPECT_EQ(lost, before) << "its file is not there to ask";
    RunEntry sound = runs[0];
    sound.breaches = 0;
    takeVerdict(sound);
    EXPECT_EQ(sound.grade, HealthGrade::Notice);
}

TEST(RunHistory, DamageIsAnErrorWithItsPlace) {
    const TemporaryFolder folder;
    const std::string file = folder / "case.rubble.runs.json";
    writeRunHistory(file, {someRun(1), someRun(2)});
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (std::size_t length = 1; length + 2 < text.size(); length += 11) {
        std::ofstream(file, std::ios::binary) << text.substr(0, length);
        EXPECT_THROW(readRunHistory(file), ParseError) << length;
    }
    std::ofstream(file, std::ios::binary) << R"({"format": "rubble-run-history", "version": 2, "runs": []})";
    try {
        readRunHistory(file);
        FAIL() << "a newer version was read";
    } catch (const ParseError& error) {
        EXPECT_NE(std::string(error.what()).find(file + " is of version 2"), std::string::npos) << error.what();
    }
}

TEST(RunHistory, AFolderInTheWayIsAnError) {
    const TemporaryFolder folder;
    const std::string file = folder / "case.rubble.runs.json";
    std::filesystem::create_directory(file);
    EXPECT_THROW(readRunHistory(file), WorldError);
    EXPECT_THROW(writeRunHistory(file, {someRun(1)}), WorldError);
}

}  // namespace
}  // namespace rubble::io
