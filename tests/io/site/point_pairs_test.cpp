#include "io/site/point_pairs.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/error_id.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

class PairTables : public testing::Test {
protected:
    TemporaryFolder folder;

    std::string write(const std::string& text) const {
        std::ofstream(folder / "pairs.csv") << text;
        return folder / "pairs.csv";
    }
    std::string refusal(const std::string& text) const {
        return idOfError([&] { readPlacePairs(write(text)); });
    }
    static constexpr const char* heading = "name,survey_x,survey_y,survey_z,x_m,y_m,z_m,deviation_m\n";
};

TEST_F(PairTables, WhatIsNoTableOfPairsIsRefusedWithItsLine) {
    const PlacePairTable sound = readPlacePairs(write(std::string(heading) + "a,1,2,3,4,5,6,0.02\n"));
    ASSERT_EQ(sound.pairs.size(), 1u);
    EXPECT_EQ(sound.pairs.front().deviation, 0.02);
    EXPECT_EQ(refusal("name,survey_x,survey_y,x_m,y_m,z_m\na,1,2,4,5,6\n"), "pairs.no_column");
    EXPECT_EQ(refusal(std::string(heading) + "a,1,two,3,4,5,6,0.02\n"), "pairs.no_number");
    EXPECT_EQ(refusal(std::string(heading) + "a,1,2,3,4,5,6,-0.02\n"), "pairs.deviation");
    constexpr std::size_t pairsMost = 10'000;
    std::string many = heading;
    for (std::size_t k = 0; k <= pairsMost; ++k) {
        many += "a,1,2,3,4,5,6,\n";
    }
    EXPECT_EQ(refusal(many), "pairs.too_many");
}

TEST_F(PairTables, APixelWithoutItsMeasuredPointIsRefused) {
    const std::string path = write("name,picture_x_px,picture_y_px\ncorner,10,20\n");
    const std::vector<NamedPoint> measured{{"gable", Vec3(1.0, 2.0, 3.0)}};
    EXPECT_EQ(idOfError([&] { readPointPairs(path, measured, [](const Vec3& at) { return at; }); }), "pairs.not_measured");
}

}  // namespace
}  // namespace rubble::io
