#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/support/command_run.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

class CloudCommand : public testing::Test {
protected:
    io::TemporaryFolder m_folder;
    std::string m_scan = sourcePath("tests/data/clouds/point-time-color.laz");

    std::string lay(const std::string& name, const std::string& text) {
        std::ofstream(m_folder / name) << text;
        return m_folder / name;
    }

    /// From one cloud to another, in scales of half a metre.
    static std::vector<std::string> between(const std::string& first, const std::string& second,
                                            const std::vector<std::string>& more) {
        std::vector<std::string> words{"cloud", first,     "--against", second, "--normal-scale", "0.5", "--projection-scale",
                                       "0.5",   "--depth", "2"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
};

TEST_F(CloudCommand, TellsWhatIsInAScan) {
    const Outcome told = cli({"cloud", m_scan, "--json"});
    ASSERT_EQ(told.exitCode, 0) << told.err;
    const nlohmann::json cloud = told.json();
    EXPECT_EQ(cloud["format"], "LAZ");
    EXPECT_EQ(cloud["version"], "1.2");
    EXPECT_EQ(cloud["points"], 1065);
    EXPECT_EQ(cloud["points_promised"], 1065);
    EXPECT_NEAR(cloud["bounds"]["min"][0].get<double>(), 493994.87, 1e-6);
    EXPECT_NEAR(cloud["bounds"]["max"][2].get<double>(), 178.73, 1e-6);
    EXPECT_EQ(cloud["classes"][0]["points"], 789);
    EXPECT_EQ(cloud["classes"][1]["class"], 2);
    EXPECT_TRUE(cloud["units"]["system"].is_null());
    EXPECT_FALSE(cloud["units"]["metres_stated"]);
    const Outcome read = cli({"cloud", m_scan, "--crs", "EPSG:25832"});
    EXPECT_EQ(read.exitCode, 0) << read.err;
    EXPECT_THAT(read.out, HasSubstr("ETRS89 / UTM zone 32N (asked for)"));
    EXPECT_THAT(read.out, HasSubstr("1: 789, 2: 276"));
    EXPECT_THAT(read.out, HasSubstr("bounds            x 493994.87 to "));
}

TEST_F(CloudCommand, PointsThatItWritesAreReadBackTheSame) {
    const std::string csv = m_folder / "points.csv";
    ASSERT_EQ(cli({"cloud", m_scan, "--csv", csv}).exitCode, 0);
    const nlohmann::json first = cli({"cloud", m_scan, "--json"}).json();
    const Outcome again = cli({"cloud", csv, "--json"});
    ASSERT_EQ(again.exitCode, 0) << again.err;
    const nlohmann::json second = again.json();
    EXPECT_EQ(second["format"], "table");
    for (const char* key : {"points", "bounds", "classes", "returns", "intensity"}) {
        EXPECT_EQ(first[key], second[key]) << key;
    }
    EXPECT_EQ(first["colour"]["most"], second["colour"]["most"]);
    EXPECT_EQ(cli({"cloud", csv, "--csv", csv}).exitCode, 2);
}

TEST_F(CloudCommand, TakesColumnsOutPhotographsAndSaysWhatIsNoCloud) {
    const std::string table = lay("bare.xyz", "7 1 2 3\n7 4 5 6\n");
    const nlohmann::json cloud = cli({"cloud", table, "--columns", "skip,x,y,z", "--json"}).json();
    EXPECT_EQ(cloud["bounds"]["max"][2], 6.0);
    EXPECT_EQ(cli({"cloud", table, "--columns", "x,y,fall"}).exitCode, 2);
    const std::string pictures = sourcePath("tests/data/clouds/tiny_pc_and_images.e57");
    const Outcome told = cli({"cloud", pictures, "--photographs", m_folder / "out", "--json"});
    ASSERT_EQ(told.exitCode, 0) << told.err;
    const nlohmann::json photographs = told.json()["photographs"];
    ASSERT_EQ(photographs.size(), 4u);
    EXPECT_EQ(photographs[2]["projection"], "pinhole");
    EXPECT_EQ(std::filesystem::file_size(photographs[2]["file"].get<std::string>()), 1073u);
    const Outcome none = cli({"cloud", lay("words.txt", "no cloud at all\n")});
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_THAT(none.err, HasSubstr("is no point cloud that can be read"));
}

TEST_F(CloudCommand, MakesAnOctreeOnce) {
    const std::string scan = m_folder / "scan.laz";
    std::filesystem::copy_file(m_scan, scan);
    const Outcome made = cli({"cloud", scan, "--index", "--json"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_EQ(made.json()["points"], 1065);
    const nlohmann::json octree = made.json()["octree"];
    EXPECT_TRUE(octree["made"].get<bool>());
    EXPECT_EQ(octree["path"], scan + ".octree");
    EXPECT_EQ(octree["points"], 1065);
    EXPECT_EQ(octree["bytes"], std::filesystem::file_size(scan + ".octree"));
    const Outcome kept = cli({"cloud", scan, "--index"});
    EXPECT_EQ(kept.exitCode, 0) << kept.err;
    EXPECT_THAT(kept.out, HasSubstr("kept from before, opened in"));
    EXPECT_TRUE(cli({"cloud", scan, "--json"}).json()["octree"].is_null());
    EXPECT_EQ(cli({"cloud", scan, "--index", "--against", scan}).exitCode, 2);
}

TEST_F(CloudCommand, MeasuresTheDistanceBetweenTwoClouds) {
    const std::string folder = sourcePath("tests/data/clouds/m3c2/autzen-bmx-");
    const std::vector<std::string> words{"cloud",   folder + "2010.las",        "--against", folder + "2023.las",
                                         "--cores", folder + "largersample.txt"};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = words;
        all.insert(all.end(), more.begin(), more.end());
        return cli(all);
    };
    const std::string csv = m_folder / "distances.csv";
    const std::vector<std::string> scales{"--normal-scale", "1.390432", "--projection-scale", "2.890432", "--depth", "5.5"};
    std::vector<std::string> more = scales;
    more.insert(more.end(), {"--csv", csv, "--json"});
    const Outcome told = with(more);
    ASSERT_EQ(told.exitCode, 0) << told.err;
    const nlohmann::json made = told.json();
    EXPECT_EQ(made["states"]["measured"], 91);
    EXPECT_EQ(made["significant"], 78);
    EXPECT_TRUE(made["registration_error"].is_null()) << "what nobody stated is not 0";
    EXPECT_TRUE(made["unit_m"].is_null()) << "x and y are metres, z feet";
    EXPECT_EQ(cli({"cloud", csv, "--json"}).json()["points"], 103);
    const Outcome read = with(scales);
    EXPECT_THAT(read.out, HasSubstr("not known: nobody stated it"));
    EXPECT_THAT(read.out, HasSubstr("78 of 89"));
    EXPECT_EQ(with({"--normal-scale", "1"}).exitCode, 2);
    EXPECT_EQ(cli({"cloud", folder + "2010.las", "--depth", "5"}).exitCode, 2);
}

TEST_F(CloudCommand, GivesVolumesBetweenTwoClouds) {
    // A square of 20 m, half of which was raised by 0.5 m and a quarter lowered by 0.2 m; the rest stayed.
    std::string before = "x,y,z\n";
    std::string after = "x,y,z\n";
    for (int k = 0; k < 20'000; ++k) {
        const double x = 20.0 * std::fmod(0.754877666 * k, 1.0);
        const double y = 20.0 * std::fmod(0.569840291 * k, 1.0);
        const double noise = 0.02 * (std::fmod(0.618033989 * k, 1.0) - 0.5);
        const std::string place = std::to_string(x) + ',' + std::to_string(y) + ',';
        before += place + std::to_string(noise) + '\n';
        after += place + std::to_string((x < 10.0 ? 0.5 : y < 10.0 ? -0.2 : 0.0) - noise) + '\n';
    }
    std::vector<std::string> words{"cloud",
                                   lay("before.csv", before),
                                   "--against",
                                   lay("after.csv", after),
                                   "--normal-scale",
                                   "0.5",
                                   "--projection-scale",
                                   "0.5",
                                   "--depth",
                                   "2",
                                   "--cell",
                                   "1",
                                   "--json"};
    const Outcome told = cli(words);
    ASSERT_EQ(told.exitCode, 0) << told.err;
    const nlohmann::json volumes = told.json()["volumes"];
    EXPECT_EQ(volumes["cells"], 400);
    EXPECT_EQ(volumes["cells_measured"], 400);
    // 200 m2 by 0.5 m and 100 m2 by 0.2 m; cylinders reach 0.06 m beyond their cells.
    EXPECT_NEAR(volumes["fill_m3"], 100.0, 1.0);
    EXPECT_NEAR(volumes["cut_m3"], 20.0, 1.0);
    EXPECT_NEAR(volumes["net_m3"], 80.0, 1.5);
    EXPECT_LT(volumes["not_detected_m3"], 1.0);
    EXPECT_LT(volumes["fill_errors_m3"][0], 0.5);
    EXPECT_TRUE(volumes["fill_errors_m3"][1].is_null()) << "nobody stated how well the clouds lie";
    words.insert(words.end(), {"--registration-error", "0.01"});
    const nlohmann::json stated = cli(words).json()["volumes"];
    EXPECT_NEAR(stated["cut_errors_m3"][1], 1.96 * 0.01 * 100.0, 0.1);
    EXPECT_NEAR(stated["net_errors_m3"][1].get<double>(),
                stated["fill_errors_m3"][1].get<double>() + stated["cut_errors_m3"][1].get<double>(), 1e-9);
    words.pop_back();
    words.push_back("0.3");
    const nlohmann::json poor = cli(words).json()["volumes"];
    EXPECT_EQ(poor["fill_m3"], 0.0) << "0.5 m is less than 1.96 times 0.3 m";
    EXPECT_NEAR(poor["not_detected_m3"], 120.0, 2.0);
    EXPECT_NEAR(poor["not_detected_fill_m3"].get<double>() + poor["not_detected_cut_m3"].get<double>(), poor["not_detected_m3"],
                1e-9);
    EXPECT_TRUE(cli({"cloud", m_folder / "before.csv", "--against", m_folder / "after.csv", "--normal-scale", "0.5",
                     "--projection-scale", "0.5", "--depth", "2", "--json"})
                    .json()["volumes"]
                    .is_null());
}

TEST_F(CloudCommand, VolumesOfWhatNobodyMeasuredAreNotKnown) {
    std::string low = "x,y,z\n";
    std::string high = "x,y,z\n";
    for (int k = 0; k < 2'000; ++k) {
        const std::string place =
            std::to_string(5.0 * std::fmod(0.754877666 * k, 1.0)) + ',' + std::to_string(5.0 * std::fmod(0.569840291 * k, 1.0));
        low += place + ",0\n";
        // Within the reach of the cores, but beyond the depth.
        high += place + ",2.04\n";
    }
    std::vector<std::string> words =
        between(lay("low.csv", low), lay("high.csv", high), {"--registration-error", "0", "--cell", "1"});
    EXPECT_THAT(cli(words).out, HasSubstr("not known: no cell was measured"));
    words.push_back("--json");
    const nlohmann::json volumes = cli(words).json()["volumes"];
    EXPECT_GT(volumes["cells"], 20);
    EXPECT_EQ(volumes["cells_measured"], 0);
    for (const char* key : {"fill_m3", "cut_m3", "net_m3", "not_detected_m3", "not_detected_fill_m3", "not_detected_cut_m3"}) {
        EXPECT_TRUE(volumes[key].is_null()) << key;
    }
    EXPECT_TRUE(volumes["net_errors_m3"][0].is_null());
}

TEST_F(CloudCommand, ComparesTwoCloudsWithinAnAreaAndWithoutWhatIsLeftOut) {
    // Level ground; between the two epochs trees grew in the west and a car was parked in the midst of the rest.
    std::string before = "x,y,z\n";
    std::string after = "x,y,z\n";
    for (int k = 0; k < 20'000; ++k) {
        const double x = 20.0 * std::fmod(0.754877666 * k, 1.0);
        const double y = 20.0 * std::fmod(0.569840291 * k, 1.0);
        const double noise = 0.02 * (std::fmod(0.618033989 * k, 1.0) - 0.5);
        const bool car = x > 14.0 && x < 16.0 && y > 9.0 && y < 11.0;
        const std::string place = std::to_string(x) + ',' + std::to_string(y) + ',';
        before += place + std::to_string(noise) + '\n';
        after += place + std::to_string((x < 8.0 ? 1.0 : car ? 1.4 : 0.0) - noise) + '\n';
    }
    const auto square = [&](const std::string& name, const std::string& corners) {
        return lay(name, R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}},)"
                         R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[)" +
                             corners + "]]}}]}");
    };
    const std::string area = square("area.geojson", "[9,-1],[30,-1],[30,30],[9,30],[9,-1]");
    const std::string car = square("car.geojson", "[13,8],[17,8],[17,12],[13,12],[13,8]");
    const std::string first = lay("before.csv", before);
    const std::string second = lay("after.csv", after);
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"--cell", "1", "--json"});
        const Outcome outcome = cli(between(first, second, more));
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.exitCode == 0 ? outcome.json() : nlohmann::json();
    };
    EXPECT_GT(with({})["volumes"]["fill_m3"], 150.0);
    const nlohmann::json within = with({"--area", area});
    EXPECT_NEAR(within["volumes"]["fill_m3"], 5.6, 1.0) << "the car";
    EXPECT_EQ(within["volumes"]["cells"], 220);
    EXPECT_GT(within["cores_beyond"], 100);
    EXPECT_NE(within["warnings"].dump().find("distance.beyond"), std::string::npos);
    const nlohmann::json rest = with({"--area", area, "--leave-out", car});
    EXPECT_LT(rest["volumes"]["fill_m3"], 0.3);
    EXPECT_NEAR(rest["distance"]["most"], 0.0, 0.02);
    const Outcome nothing =
        cli(between(first, second, {"--leave-out", square("all.geojson", "[-9,-9],[30,-9],[30,30],[-9,30],[-9,-9]")}));
    EXPECT_EQ(nothing.exitCode, 1);
    EXPECT_THAT(nothing.err, HasSubstr("core points"));
}

TEST_F(CloudCommand, MetresKeepTheSystemOfEastingsWhereHeightsAloneWereInFeet) {
    const std::string folder = sourcePath("tests/data/clouds/m3c2/autzen-bmx-");
    const nlohmann::json first = cli({"cloud", folder + "2010.las", "--json"}).json();
    ASSERT_EQ(first["units"]["metres"], 1.0);
    ASSERT_NE(first["units"]["height_metres"], 1.0);
    const std::string out = m_folder / "metres.las";
    ASSERT_EQ(cli({"cloud", folder + "2010.las", "--against", folder + "2023.las", "--normal-scale", "1.4", "--projection-scale",
                   "2.9", "--depth", "3", "--metres", "--out", out})
                  .exitCode,
              0);
    const nlohmann::json made = cli({"cloud", out, "--json"}).json();
    EXPECT_EQ(made["units"]["metres"], 1.0);
    EXPECT_EQ(made["units"]["height_metres"], 1.0);
    ASSERT_TRUE(made["units"]["system"].is_string());
    EXPECT_THAT(first["units"]["system"].get<std::string>(), HasSubstr(made["units"]["system"].get<std::string>()));
    EXPECT_FALSE(made["units"]["height_metres_stated"]) << "feet are not those of the file any more";
}

TEST_F(CloudCommand, FitsByWhatDidNotMove) {
    // Ground that rolls and two walls; the second cloud lies elsewhere by a shift, and half a metre of ground was dug away.
    std::string before = "x,y,z\n";
    std::string after = "x,y,z\n";
    const auto add = [&](double x, double y, double z, double dug) {
        before += std::to_string(x) + ',' + std::to_string(y) + ',' + std::to_string(z) + '\n';
        after += std::to_string(x + 0.12) + ',' + std::to_string(y - 0.08) + ',' + std::to_string(z - dug + 0.06) + '\n';
    };
    for (int k = 1; k <= 12'000; ++k) {
        const double u = 16.0 * std::fmod(0.754877666 * k, 1.0);
        const double v = 16.0 * std::fmod(0.569840291 * k, 1.0);
        add(u, v, 0.3 * std::sin(0.5 * u) + 0.2 * std::cos(0.4 * v), u > 12.0 && v > 12.0 ? 0.5 : 0.0);
        add(k % 2 == 0 ? u : -0.5, k % 2 == 0 ? -0.5 : u, 0.25 * v, 0.0);
    }
    const std::vector<std::string> words{"cloud",
                                         lay("before.csv", before),
                                         "--against",
                                         lay("after.csv", after),
                                         "--normal-scale",
                                         "0.5",
                                         "--projection-scale",
                                         "0.5",
                                         "--depth",
                                         "1",
                                         "--json"};
    const nlohmann::json loose = cli(words).json();
    EXPECT_TRUE(loose["registration"].is_null());
    const auto fitted = [&](const std::string& by) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"--fit", by});
        const Outcome outcome = cli(all);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    };
    const std::string stable =
        lay("stable.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
                              R"({"type":"Polygon","coordinates":[[[-500,-500],[500,-500],[500,10],[-500,10],[-500,-500]]]}}]})");
    for (const std::string& by : {std::string("all"), stable}) {
        const nlohmann::json made = fitted(by);
        const nlohmann::json& registration = made["registration"];
        EXPECT_NEAR(registration["shift"][0], -0.12, 0.02);
        EXPECT_NEAR(registration["shift"][1], 0.08, 0.02);
        EXPECT_NEAR(registration["shift"][2], -0.06, 0.02);
        EXPECT_EQ(made["registration_error"], registration["error"]) << "nobody stated another";
        EXPECT_LT(made["significant"], loose["significant"]);
        EXPECT_NEAR(made["distance"]["least"], -0.5, 0.05) << "what was dug away stays";
    }
}

TEST_F(CloudCommand, TwoCloudsArePlacedByPairs) {
    // The second cloud of one rolling ground has coordinates of its own, a kilometre off and turned by 30 degrees.
    const double c = std::cos(0.5235987756);
    const double s = std::sin(0.5235987756);
    std::string first = "x,y,z\n";
    std::string second = "x,y,z\n";
    for (int k = 1; k <= 6'000; ++k) {
        const double u = 16.0 * std::fmod(0.754877666 * k, 1.0);
        const double v = 16.0 * std::fmod(0.569840291 * k, 1.0);
        const double z = 0.3 * std::sin(0.5 * u) + 0.2 * std::cos(0.4 * v);
        first += std::to_string(u) + ',' + std::to_string(v) + ',' + std::to_string(z) + '\n';
        second += std::to_string(c * u - s * v + 1000.0) + ',' + std::to_string(s * u + c * v - 500.0) + ',' +
                  std::to_string(z + 7.0) + '\n';
    }
    std::string pairs = "survey_x,survey_y,survey_z,x_m,y_m,z_m\n";
    for (const auto& [u, v, z] :
         {std::array{0.0, 0.0, 0.0}, std::array{16.0, 1.0, 0.5}, std::array{3.0, 15.0, -0.5}, std::array{12.0, 12.0, 1.0}}) {
        // Four millimetres of error, so that the pairs have one.
        const double off = u == 12.0 ? 0.004 : 0.0;
        pairs += std::to_string(c * u - s * v + 1000.0) + ',' + std::to_string(s * u + c * v - 500.0) + ',' +
                 std::to_string(z + 7.0) + ',' + std::to_string(u) + ',' + std::to_string(v) + ',' + std::to_string(z + off) + '\n';
    }
    std::vector<std::string> words{"cloud",
                                   lay("first.csv", first),
                                   "--against",
                                   lay("second.csv", second),
                                   "--normal-scale",
                                   "1",
                                   "--projection-scale",
                                   "1",
                                   "--depth",
                                   "1",
                                   "--json"};
    EXPECT_NE(cli(words).exitCode, 0) << "they do not meet";
    words.insert(words.end(), {"--pairs", lay("pairs.csv", pairs)});
    const Outcome outcome = cli(words);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json made = outcome.json();
    EXPECT_EQ(made["placed"]["pairs"], 4);
    EXPECT_NEAR(made["placed"]["turn_deg"][2], -30.0, 0.05);
    EXPECT_NEAR(made["distance"]["median"], 0.0, 0.004);
    EXPECT_GT(made["registration_error"], 0.0005) << "the error of the pairs is in the level of detection";
    EXPECT_EQ(made["registration_error"], made["placed"]["error"]);
    EXPECT_LT(made["significant"].get<double>(), 0.05 * made["with_level_of_detection"].get<double>());
    // A fit goes on from the pairs, and its error stands.
    words.insert(words.end(), {"--fit", "all"});
    const nlohmann::json fitted = cli(words).json();
    EXPECT_EQ(fitted["registration_error"], fitted["registration"]["error"]);
    EXPECT_LT(fitted["registration"]["shift"][2].get<double>(), 0.01);
}

}  // namespace

}  // namespace rubble::cli
