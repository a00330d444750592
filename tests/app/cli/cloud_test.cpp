#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace

}  // namespace rubble::cli
