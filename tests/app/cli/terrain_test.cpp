#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A raster of one height around the small collapse.
std::string writeLevel(const std::string& path, double height) {
    std::ofstream out(path);
    out << "ncols 40\nnrows 40\nxllcorner -20\nyllcorner -20\ncellsize 1\n";
    for (int i = 0; i < 40 * 40; ++i) {
        out << height << (i % 40 == 39 ? '\n' : ' ');
    }
    return path;
}

class Terrain : public SmallRun {
protected:
    nlohmann::json run(std::vector<std::string> more = {}) { return SmallRun::run(std::move(more), "2"); }

    std::string m_terrain = writeLevel(m_folder / "level.asc", -1.5);
};

TEST_F(Terrain, DebrisFallsOnItAndTheRunSaysSo) {
    const nlohmann::json level = run();
    EXPECT_TRUE(level["terrain"].is_null());
    const nlohmann::json lower = run({"--terrain", m_terrain});
    EXPECT_EQ(lower["terrain"]["sha256"], io::sha256OfFile(m_terrain));
    EXPECT_EQ(lower["terrain"]["lowest_m"], -1.5);
    EXPECT_NE(lower["trajectory_hash"], level["trajectory_hash"]);
    EXPECT_GT(lower["energy"]["gravity_work_j"], level["energy"]["gravity_work_j"]);
    // Switched off it changes nothing.
    EXPECT_EQ(run({"--terrain", m_terrain, "--set", "terrain=off"})["trajectory_hash"], level["trajectory_hash"]);
}

TEST_F(Terrain, ARunFindsItsTerrainAgainAndRepeats) {
    run({"--terrain", m_terrain});
    fs::rename(m_terrain, m_folder / "moved.asc");
    const Outcome same = cli({"verify", m_out, "--json"});
    ASSERT_EQ(same.exitCode, 0) << same.err << same.out;
    fs::rename(m_folder / "moved.asc", m_folder / "elsewhere.bin");
    const Outcome lost = cli({"verify", m_out});
    EXPECT_EQ(lost.exitCode, 1);
    EXPECT_THAT(lost.err, HasSubstr("--terrain FILE"));
    EXPECT_EQ(cli({"verify", m_out, "--terrain", m_folder / "elsewhere.bin"}).exitCode, 0);
    const Outcome other = cli({"verify", m_out, "--terrain", writeLevel(m_terrain, -1.0)});
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_THAT(other.err, HasSubstr("SHA-256"));
}

TEST_F(Terrain, ACaseBringsItsOwn) {
    const std::string casePath = m_folder / "small.rubble";
    Case theCase = io::caseForFe(m_path, casePath);
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "level.asc", ""});
    io::saveCase(casePath, theCase);
    const std::string hash = run({"--terrain", m_terrain})["trajectory_hash"];
    m_path = casePath;
    EXPECT_EQ(run()["trajectory_hash"], hash);
    EXPECT_EQ(cli({"verify", casePath}).exitCode, 0);
    writeLevel(m_terrain, -1.0);
    EXPECT_EQ(cli({"verify", casePath}).exitCode, 1);
    EXPECT_THAT(run()["warnings"].dump(), HasSubstr("case.terrain_changed"));
    fs::remove(m_terrain);
    const Outcome missing = cli({"run", casePath});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_THAT(missing.err, HasSubstr("level.asc"));
}

}  // namespace

}  // namespace rubble::cli
