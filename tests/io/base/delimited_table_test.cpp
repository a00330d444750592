#include "io/base/delimited_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "core/base/error.h"
#include "io/fe/series/death_list.h"
#include "io/site/point_pairs.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::HasSubstr;

class DelimitedTableTest : public testing::Test {
protected:
    std::string table(const std::string& text) {
        writeContent(m_folder / "table.csv", text);
        return m_folder / "table.csv";
    }

    std::vector<std::tuple<std::int64_t, double, bool>> deaths(const std::string& text) {
        std::vector<std::tuple<std::int64_t, double, bool>> list;
        for (const DeathEntry& entry : readDeathList(table(text))) {
            list.emplace_back(entry.element, entry.time, entry.active);
        }
        return list;
    }

    template <class Read>
    std::string errorOf(const Read& read) {
        try {
            read();
        } catch (const Error& error) {
            return error.what();
        }
        ADD_FAILURE() << "it was read";
        return {};
    }

    std::string deathError(const std::string& text) {
        return errorOf([&] { deaths(text); });
    }

    TemporaryFolder m_folder;
};

using Death = std::tuple<std::int64_t, double, bool>;

TEST_F(DelimitedTableTest, DecimalCommasStandBetweenSemicolonsAndTabs) {
    const std::vector<Death> expected{{3, 0.5, false}, {2, 1.0, false}};
    for (const char* text :
         {"element;time\n2;1,0\n3;0,5\n", "2;1,0\r\n3;0,5\r\n", "element\ttime\n2\t1,0\n3\t0,5\n",
          "\xef\xbb\xbfsep=;\n2;1,0\n3;0,5\n", "element,time\n2,1.0\n3,0.5\n", "2 1.0\n3   0.5\n", "# by hand\n2, 1.0\n\n3, 0.5\n",
          "time;element\n1,0;2\n0,5;3\n", "\"element\",\"time\"\n\"2\",\"1.0\"\n3,.5\n", "element\n2 1\n3 0.5\n"}) {
        EXPECT_EQ(deaths(text), expected) << text;
    }
}

TEST_F(DelimitedTableTest, AStatusIsZeroOrOne) {
    EXPECT_EQ(deaths("2,1,0\n2,3,1\n"), (std::vector<Death>{{2, 1.0, false}, {2, 3.0, true}}));
    EXPECT_EQ(deaths("element;time;status\n2;1,5;0\n2;3;1\n"), (std::vector<Death>{{2, 1.5, false}, {2, 3.0, true}}));
    EXPECT_THAT(deathError("2,1,5\n"), HasSubstr("line 1"));
    EXPECT_THAT(deathError("element,time,status\n2,1,0.5\n"), HasSubstr("line 2"));
    EXPECT_THAT(deathError("2,1,-1\n"), HasSubstr("line 1"));
}

// A decimal comma among commas makes one field more than the heading has.
TEST_F(DelimitedTableTest, MoreFieldsThanTheHeadingNamesAreRefused) {
    EXPECT_THAT(deathError("element,time\n2,1,0\n3,0,5\n"), HasSubstr("line 2 has 3 fields"));
    EXPECT_THAT(deathError("2,1,0,5\n"), HasSubstr("4 fields"));
}

TEST_F(DelimitedTableTest, WhatIsNoNumberIsRefusedWithItsLine) {
    EXPECT_THAT(deathError("element,time\n2,half\n"), HasSubstr("line 2"));
    EXPECT_THAT(deathError("2.5,1\n"), HasSubstr("line 1"));
    EXPECT_THAT(deathError("2,nan\n"), HasSubstr("line 1"));
    EXPECT_THAT(deathError("2\n"), HasSubstr("line 1"));
    EXPECT_THAT(deathError("2;1.234,5\n"), HasSubstr("line 1"));
}

TEST_F(DelimitedTableTest, TwoDecimalSignsAreRefused) {
    EXPECT_THAT(deathError("element;time\n2;1,000\n3;0.5\n"), HasSubstr("line 3"));
}

TEST_F(DelimitedTableTest, WhatIsNoTextIsRefused) {
    EXPECT_THAT(deathError(std::string("2\0;\0", 4)), HasSubstr("no text"));
    EXPECT_THAT(errorOf([&] { readDelimitedTable(m_folder.path(), 100); }), HasSubstr("Cannot read"));
    EXPECT_THAT(errorOf([&] { readDelimitedTable(table("1,2\n3,4\n"), 4); }), HasSubstr("too large"));
}

TEST_F(DelimitedTableTest, PairsOfPointsAreReadAlike) {
    const std::vector<PointPair> expected = readPointPairs(table("name,picture_x_px,picture_y_px,x_m,y_m,z_m\nA,1.5,2,3,4,5\n"));
    const std::vector<PointPair> pairs = readPointPairs(table("picture_x_px;picture_y_px;x_m;y_m;z_m;name\n1,5;2;3;4;5,0;\"A\"\n"));
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].name, expected[0].name);
    EXPECT_EQ(pairs[0].picture, expected[0].picture);
    EXPECT_EQ(pairs[0].model, expected[0].model);
    EXPECT_THAT(errorOf([&] { readPointPairs(table("picture_x_px,picture_y_px,x_m,y_m,z_m\n1,5,2,3,4,5\n")); }),
                HasSubstr("line 2 has 6 fields"));
}

}  // namespace
}  // namespace rubble::io
