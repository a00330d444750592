#include "io/base/length_unit.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

TEST(LengthUnit, IsKnownByAllNamesThatRastersAndTablesGiveIt) {
    for (const char* name : {"m", "Metre", "METERS"}) {
        EXPECT_EQ(metresInUnit(name), 1.0) << name;
    }
    for (const char* name : {"ft", "Feet", "ift", "international foot"}) {
        EXPECT_EQ(metresInUnit(name), 0.3048) << name;
    }
    for (const char* name : {"US survey foot", "ftUS", "us-ft", "usfeet", "us_survey_feet", "foot_us"}) {
        EXPECT_EQ(metresInUnit(name), 1200.0 / 3937.0) << name;
    }
    EXPECT_EQ(metresInUnit("millimetre"), 0.001);
    EXPECT_EQ(metresInUnit("centimeters"), 0.01);
    EXPECT_EQ(metresInUnit("kilometre"), 1000.0);
    EXPECT_EQ(metresInUnit("degree"), std::nullopt);
    EXPECT_EQ(metresInUnit(""), std::nullopt);
}

// Rasters knew this name, tables did not.
TEST(LengthUnit, OfATableMayBeWrittenOut) {
    const TemporaryFolder folder;
    const std::string path = folder / "long.csv";
    std::ofstream(path) << "x [m],y [m],z [millimetres]\n1,2,3000\n2,2,4000\n3,2,5000\n";
    const WholeCloud cloud = readCloud(path);
    ASSERT_EQ(cloud.points.size(), 3u);
    EXPECT_DOUBLE_EQ(cloud.summary.metres.min().z(), 3.0);
    EXPECT_DOUBLE_EQ(cloud.summary.metres.max().z(), 5.0);
}

}  // namespace

}  // namespace rubble::io
