#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A slope of 3 in 5 to the east, so many metres long.
std::string writeSlope(const std::string& path, std::size_t length) {
    const io::AsciiGrid slope{length, 200, -20.0, -100.0};
    return slope.write(path, [](double x, double) { return -1.0 - 0.6 * x; });
}

/// Columns final_x_m and final_z_m of a table of fragments.
std::vector<std::pair<double, double>> finalPlaces(const std::string& path) {
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    std::vector<std::pair<double, double>> places;
    while (std::getline(in, line)) {
        std::vector<std::string> cells;
        std::stringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) {
            cells.push_back(cell);
        }
        places.emplace_back(std::stod(cells.at(8)), std::stod(cells.at(10)));
    }
    return places;
}

class Terrain : public SmallRun {
protected:
    nlohmann::json run(std::vector<std::string> more = {}) { return SmallRun::run(std::move(more), "2"); }

    std::string m_terrain = io::AsciiGrid().writeLevel(m_folder / "level.asc", -1.5);
};

/// Points of the same level ground at places that follow no lattice.
std::string writeLevelCloud(const std::string& path, double height) {
    std::ofstream out(path);
    out << "x,y,z\n";
    for (int k = 0; k < 8'000; ++k) {
        // Steps of two irrational numbers fill a square evenly.
        out << -20.0 + 40.0 * std::fmod(0.754877666 * k, 1.0) << ',' << -20.0 + 40.0 * std::fmod(0.569840291 * k, 1.0) << ','
            << height << '\n';
    }
    return path;
}

TEST_F(Terrain, APointCloudIsGroundAndSurveyAsARasterIs) {
    const std::string cloud = writeLevelCloud(m_folder / "ground.csv", -1.5);
    const nlohmann::json onRaster = run({"--terrain", m_terrain});
    const nlohmann::json onCloud = run({"--terrain", cloud});
    EXPECT_EQ(onCloud["terrain"]["sha256"], io::sha256OfFile(cloud));
    EXPECT_NEAR(onCloud["terrain"]["lowest_m"].get<double>(), -1.5, 1e-9);
    EXPECT_NEAR(onCloud["terrain"]["highest_m"].get<double>(), -1.5, 1e-9);
    EXPECT_THAT(onCloud.dump(), HasSubstr("cloud.gridded"));
    EXPECT_NEAR(onCloud["energy"]["gravity_work_j"].get<double>(), onRaster["energy"]["gravity_work_j"].get<double>(),
                0.05 * onRaster["energy"]["gravity_work_j"].get<double>());
    // A survey that equals the ground shows no debris at all.
    const Outcome surveyed = cli({"survey", m_out, "--survey", cloud, "--json"});
    ASSERT_EQ(surveyed.exitCode, 0) << surveyed.err;
    EXPECT_EQ(surveyed.json()["surveyed"]["area_m2"], 0.0);
    EXPECT_NEAR(surveyed.json()["volumes"]["net_m3"].get<double>(), 0.0, 1e-6);
    EXPECT_TRUE(surveyed.json()["volumes"]["net_systematic_m3"].is_null()) << "nobody stated an offset";
}

TEST_F(Terrain, ATableWithoutAHeadingIsReadAsItsColumnsAreStated) {
    std::ifstream in(writeLevelCloud(m_folder / "ground.csv", -1.5));
    const std::string table = m_folder / "ground.txt";
    std::ofstream out(table);
    std::string line;
    std::getline(in, line);
    for (int number = 1; std::getline(in, line); ++number) {
        std::istringstream fields(line);
        double x = 0.0, y = 0.0, z = 0.0;
        char comma = 0;
        fields >> x >> comma >> y >> comma >> z;
        out << number << ',' << y / 0.3048 << ',' << x / 0.3048 << ',' << z / 0.3048 << ",GROUND\n";
    }
    out.close();
    const std::vector<std::string> how{"--terrain-columns", "skip,y,x,z,skip", "--terrain-crs",
                                       R"(LOCAL_CS["site",UNIT["foot",0.3048]])"};
    std::vector<std::string> words{"--terrain", table};
    words.insert(words.end(), how.begin(), how.end());
    const nlohmann::json made = run(words);
    EXPECT_NEAR(made["terrain"]["lowest_m"].get<double>(), -1.5, 1e-4);
    EXPECT_NEAR(made["terrain"]["highest_m"].get<double>(), -1.5, 1e-4);
    // The run knows how its terrain is read.
    EXPECT_EQ(cli({"verify", m_out}).exitCode, 0);
    // So does a case that states it.
    const std::string path = m_folder / "small.rubble";
    Case theCase = io::caseForFe(m_path, path);
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "ground.txt", {}});
    theCase.inputs.back().read = {how[3], {"skip", "y", "x", "z", "skip"}};
    io::saveCase(path, theCase);
    const Outcome ofCase = cli({"run", path, "--set", "settle_time=0.1", "--json"});
    ASSERT_EQ(ofCase.exitCode, 0) << ofCase.err;
    EXPECT_NEAR(ofCase.json()["terrain"]["lowest_m"].get<double>(), -1.5, 1e-4);
    words = {"run", m_path, "--set", "settle_time=0.1"};
    words.insert(words.end(), how.begin(), how.end());
    EXPECT_EQ(cli(words).exitCode, 2) << "there is no terrain to be read so";
    EXPECT_EQ(cli({"survey", m_out, "--survey", table, "--terrain-columns", "x,y,z"}).exitCode, 2) << "of a recorded run";
}

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

TEST_F(Terrain, WhatIsReadBesideItIsPartOfItsDigest) {
    const auto writeSystem = [&](const char* name) {
        std::ofstream(m_folder / "level.prj") << "LOCAL_CS[\"" << name << "\",UNIT[\"metre\",1]]";
    };
    writeSystem("site");
    const nlohmann::json made = run({"--terrain", m_terrain});
    EXPECT_NE(made["terrain"]["sha256"], io::sha256OfFile(m_terrain));
    const std::string path = m_folder / "small.rubble";
    Case theCase = io::caseForFe(m_path, path);
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "level.asc", {}});
    io::saveCase(path, theCase);
    EXPECT_EQ(cli({"verify", path}).exitCode, 0);
    EXPECT_EQ(cli({"verify", m_out}).exitCode, 0);
    std::ofstream(m_terrain + ".ovr") << "pyramids";
    EXPECT_EQ(cli({"verify", path}).exitCode, 0);
    writeSystem("other site");
    const Outcome changed = cli({"verify", path});
    EXPECT_EQ(changed.exitCode, 1);
    EXPECT_THAT(changed.out, HasSubstr("inputs differ"));
    EXPECT_EQ(cli({"verify", m_out}).exitCode, 1);
    // A case of before keeps the digest of the file alone.
    theCase.inputs.back().sha256 = io::sha256OfFile(m_terrain);
    fs::remove(path);
    io::saveCase(path, theCase);
    EXPECT_EQ(cli({"verify", path}).exitCode, 0);
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
    const Outcome other = cli({"verify", m_out, "--terrain", io::AsciiGrid().writeLevel(m_terrain, -1.0)});
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
    io::AsciiGrid().writeLevel(m_terrain, -1.0);
    EXPECT_EQ(cli({"verify", casePath}).exitCode, 1);
    EXPECT_THAT(run()["warnings"].dump(), HasSubstr("case.terrain_changed"));
    fs::remove(m_terrain);
    const Outcome missing = cli({"run", casePath});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_THAT(missing.err, HasSubstr("level.asc"));
}

// The structure is 3 m high: ten heights are 30 m.
TEST_F(Terrain, DebrisSlidesDownALongSlopeAsFarAsTheRasterGoes) {
    const std::vector<std::string> smooth{"--set", "friction=0", "--set", "restitution=0", "--terrain"};
    const auto slide = [&](const std::string& terrain, std::vector<std::string> more = {}) {
        more.insert(more.end(), smooth.begin(), smooth.end());
        more.push_back(terrain);
        more.insert(more.end(), {"--export", "fragments=" + (m_folder / "f.csv")});
        return SmallRun::run(std::move(more), "7");
    };
    const nlohmann::json far = slide(writeSlope(m_folder / "far.asc", 400));
    EXPECT_EQ(far["terrain"]["columns"], 400);
    for (const auto& [x, z] : finalPlaces(m_folder / "f.csv")) {
        EXPECT_GT(x, 60.0);
        // Its centre lies no more than a few sizes of it above the slope.
        EXPECT_GT(z, -1.0 - 0.6 * x);
        EXPECT_LT(z, -1.0 - 0.6 * x + 4.0);
    }
    EXPECT_THAT(far["warnings"].dump(), Not(HasSubstr("terrain_ended")));
    EXPECT_THAT(far["warnings"].dump(), Not(HasSubstr("outside_site")));
    EXPECT_EQ(cli({"verify", m_out}).exitCode, 0);
    EXPECT_EQ(slide(m_folder / "far.asc")["trajectory_hash"], far["trajectory_hash"]);

    // The same slope ends after 60 m: there it goes on level, and the run says what it takes.
    const nlohmann::json ended = slide(writeSlope(m_folder / "short.asc", 80));
    EXPECT_NE(ended["trajectory_hash"], far["trajectory_hash"]);
    EXPECT_THAT(ended["cautions"].dump(), HasSubstr("ran beyond the end of the terrain"));
    EXPECT_THAT(far["cautions"].dump(), Not(HasSubstr("ran beyond")));
    for (const nlohmann::json& finding : ended["warnings"]) {
        if (finding["id"] == "simulation.terrain_ended") {
            EXPECT_GE(finding["count"], smallDead);
            EXPECT_THAT(finding["remedy"].dump(), HasSubstr("give a larger raster, beyond x = "));
            return;
        }
    }
    FAIL() << ended["warnings"];
}

}  // namespace

}  // namespace rubble::cli
