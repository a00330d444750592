#include "io/validation/set_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* definition = R"({"title": "Slides", "source": "made", "table": "slides.csv",
 "join": [{"table": "ends.csv", "on": "run"}],
 "columns": {"id": "run", "x_m": "x", "y_m": "y", "z_m": "z", "vx_m_s": "v", "vy_m_s": "y", "vz_m_s": "y",
             "measured_x_cm": "ends.x", "measured_y_m": "ends.y", "measured_z_m": "ends.z"},
 "constants": {"mass_kg": "500", "side_x_m": "1", "side_y_m": "1", "side_z_m": "0.2", "material": "stone"},
 "variants": [{"name": "blind", "words": "the table's", "parameters": []}],
 "criteria": [{"variant": "blind", "figure": "run_out_m.error", "low": -0.1, "high": 0.1}]})";

class SetFolder : public testing::Test {
protected:
    void SetUp() override {
        lay("set.json", definition);
        lay("LICENSE", "CC0 1.0\n");
        lay("README.md", "# Slides\n");
        lay("slides.csv", "run,x,y,z,v\na,0,0,0.1,3\nb,0,0,0.1,4\n");
        lay("ends.csv", "run,x,y,z\nb,150,0,0.1\na,90,0,0.1\n");
    }
    void lay(const std::string& name, const std::string& text) { std::ofstream(m_folder / name) << text; }
    ValidationSet read() { return readSet(setsIn(m_folder.path()).front(), Execution{}); }
    std::string refusal() {
        try {
            read();
        } catch (const Error& error) {
            EXPECT_FALSE(error.remedy().empty());
            return error.what();
        }
        return "";
    }
    TemporaryFolder m_folder;
};

TEST_F(SetFolder, TablesAreJoinedAndNamed) {
    const ValidationSet set = read();
    ASSERT_EQ(set.bodies.size(), 2u);
    EXPECT_EQ(set.licence, "CC0 1.0");
    EXPECT_DOUBLE_EQ(set.measured[0].place->x(), 0.9);
    EXPECT_DOUBLE_EQ(set.measured[1].place->x(), 1.5);
    EXPECT_DOUBLE_EQ(set.bodies[1].velocity.x(), 4.0);
    EXPECT_DOUBLE_EQ(set.bodies[0].mass, 500.0);
    EXPECT_EQ(set.criteria.size(), 1u);
    EXPECT_EQ(set.findings.count("validation.no_readme"), 0);
}

TEST_F(SetFolder, WhatIsDrawnHasADistributionAndASource) {
    std::string drawn = definition;
    const std::string none = R"("parameters": []})";
    const auto vary = [&](const std::string& distribution) {
        lay("set.json", std::string(drawn).replace(drawn.find(none), none.size(),
                                                   R"("parameters": [], "varied": [{"key": "friction", "distribution": ")" +
                                                       distribution + R"(", "source": "measured"}]})"));
    };
    vary("uniform:0.3:0.7");
    const ValidationSet set = read();
    ASSERT_EQ(set.variants[0].varied.size(), 1u);
    EXPECT_EQ(set.variants[0].varied[0].setting.key, "friction");
    EXPECT_DOUBLE_EQ(set.variants[0].varied[0].setting.second, 0.7);
    EXPECT_EQ(set.variants[0].varied[0].source, "measured");
    vary("uniform:0.7:0.3");
    EXPECT_FALSE(refusal().empty());
}

TEST_F(SetFolder, RepeatsAreThoseOfTheVariantThenOfTheSet) {
    const auto lain = [&](const std::string& ofSet, const std::string& ofVariant) {
        std::string text = definition;
        text.insert(text.find("\"words\""), ofVariant);
        lay("set.json", text.insert(1, ofSet));
    };
    lain("\"repeats\": 3, ", "\"repeats\": 64, ");
    EXPECT_EQ(read().repeats, 3);
    EXPECT_EQ(read().variants.front().repeats, 64);
    lain("", "");
    EXPECT_EQ(read().repeats, 1);
    EXPECT_FALSE(read().variants.front().repeats.has_value());
    for (const char* wrong : {"0", "-3", "1001"}) {
        lain(std::string("\"repeats\": ") + wrong + ", ", "");
        EXPECT_THAT(refusal(), HasSubstr("1 to 1,000"));
        lain("", std::string("\"repeats\": ") + wrong + ", ");
        EXPECT_THAT(refusal(), HasSubstr("1 to 1,000"));
    }
}

TEST_F(SetFolder, WithoutLicenceItIsRefused) {
    fs::remove(m_folder / "LICENSE");
    EXPECT_THAT(refusal(), HasSubstr("no licence"));
    lay("COPYING.txt", "  \n");
    EXPECT_THAT(refusal(), HasSubstr("no licence"));
    lay("metadata.json", R"({"license": "ODbL"})");
    EXPECT_EQ(read().licence, "ODbL");
}

TEST_F(SetFolder, WithoutReadmeItIsAFinding) {
    fs::remove(m_folder / "README.md");
    EXPECT_EQ(read().findings.count("validation.no_readme"), 1);
}

TEST_F(SetFolder, WhatIsMissingIsNamed) {
    lay("ends.csv", "run,x,y,z\nb,150,0,0.1\n");
    EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("line 2"), HasSubstr("ends.csv")));
    lay("ends.csv", "run,x,y,z\nb,150,0,0.1\nb,150,0,0.1\n");
    EXPECT_THAT(refusal(), HasSubstr("line 3"));
    lay("ends.csv", "run,x,y\nb,150,0\na,1,1\n");
    EXPECT_THAT(refusal(), HasSubstr("no column ends.z"));
    fs::remove(m_folder / "ends.csv");
    EXPECT_THAT(refusal(), HasSubstr("ends.csv"));
    lay("set.json", "{\"title\": 3}");
    EXPECT_THAT(refusal(), HasSubstr("set.json"));
    fs::remove(m_folder / "set.json");
    EXPECT_THROW(setsIn(m_folder.path()), UsageError);
    EXPECT_THROW(setsIn(m_folder / "nowhere"), WorldError);
}

TEST_F(SetFolder, MeasuredPlacesFarFromTheGroundAreCounted) {
    lay("ends.csv", "run,x,y,z\nb,150,0,4.1\na,90,0,0.1\n");
    const ValidationSet set = read();
    ASSERT_EQ(set.findings.count("validation.far_from_ground"), 1);
    EXPECT_THAT(set.findings.list().back().example, HasSubstr("b (line 3)"));
}

TEST_F(SetFolder, BodiesBelowTheGroundAreRefused) {
    lay("slides.csv", "run,x,y,z,v\na,0,0,0.1,3\nb,0,0,-2,4\n");
    EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("b (line 3)"), HasSubstr("2 m")));
}

TEST(ShippedSet, EachIsReadWithItsLicence) {
    const std::vector<SetPlace> sets = setsIn(sourcePath("resources/validation"));
    ASSERT_EQ(sets.size(), 2u);
    for (const SetPlace& place : sets) {
        const ValidationSet set = readSet(place, Execution{});
        EXPECT_FALSE(set.licence.empty()) << place.id;
        EXPECT_EQ(set.findings.count("validation.no_readme"), 0) << place.id;
    }
    const ValidationSet board = readSet(sets[0], Execution{});
    EXPECT_EQ(board.bodies.size(), 285u);
    EXPECT_EQ(board.findings.count("validation.far_from_ground"), 0);
    const ValidationSet slope = readSet(sets[1], Execution{});
    EXPECT_EQ(slope.bodies.size(), 80u);
    EXPECT_NE(slope.terrain, nullptr);
    // Its terrain is a proxy of 5 m, and says so: some blocks were seen more than a metre above it.
    EXPECT_EQ(slope.findings.count("validation.far_from_ground"), 9);
    EXPECT_EQ(slope.findings.count("bodies.along_axes"), 0);
    EXPECT_EQ(slope.findings.count("validation.turned"), 80);
}

}  // namespace

}  // namespace rubble::io
