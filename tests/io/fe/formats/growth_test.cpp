#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/growing_results.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;

class Growth : public testing::TestWithParam<Growing> {
protected:
    std::shared_ptr<const FeResult> open() { return openFe(m_folder / GetParam().opened, {}, {}, Execution{}); }

    TemporaryFolder m_folder;
};

TEST_P(Growth, AStateThatComesIsNoticedAndItsDeathCounted) {
    GetParam().write(m_folder, 2, true);
    const auto before = open();
    EXPECT_EQ(before->stateCount(), 2u);
    EXPECT_FALSE(hasGrown(*before));
    GetParam().write(m_folder, 3, true);
    EXPECT_TRUE(hasGrown(*before));
    const auto after = open();
    const FeGrowth growth = growthBetween(*before, *after);
    EXPECT_EQ(growth.states, 1);
    EXPECT_EQ(growth.deaths, 1);
    EXPECT_GT(growth.bytes, 0);
    EXPECT_EQ(after->stateCount(), 3u);
    EXPECT_FALSE(hasGrown(*after));
    EXPECT_NE(after->contents().fingerprint, before->contents().fingerprint);
}

// HDF5 may write a state into room that it had set aside.
TEST_P(Growth, WhatIsWrittenInPlaceIsNoticed) {
    GetParam().write(m_folder, 2, true);
    const auto before = open();
    const std::string last = before->contents().files.back();
    std::filesystem::last_write_time(last, std::filesystem::last_write_time(last) + std::chrono::seconds(1));
    EXPECT_TRUE(hasGrown(*before));
    EXPECT_FALSE(hasGrown(*open()));
}

/// Those with a file for each state.
class GrowthByFiles : public Growth {};

// The analysis has made the file of its next state and written nothing into it.
TEST_P(GrowthByFiles, AnEmptyLastFileIsLeftOut) {
    GetParam().write(m_folder, 2, true);
    writeContent(m_folder / GetParam().last, "");
    const auto before = open();
    EXPECT_EQ(before->stateCount(), 2u);
    GetParam().write(m_folder, 3, true);
    EXPECT_TRUE(hasGrown(*before));
    EXPECT_EQ(growthBetween(*before, *open()).deaths, 1);
}

// Lost in copying, for one: the elements of that state are not dead, and the file is there and may be read.
TEST_P(GrowthByFiles, AnEmptyFileInTheMiddleIsNamed) {
    GetParam().write(m_folder, 3, true);
    std::string middle = GetParam().last;
    --middle[middle.find_last_of("23")];
    ASSERT_GT(std::filesystem::file_size(m_folder / middle), 0u) << middle;
    writeContent(m_folder / middle, "");
    try {
        const auto fe = open();
        EXPECT_EQ(fe->stateCount(), 2u);
        const auto& list = fe->contents().findings.list();
        EXPECT_TRUE(std::any_of(list.begin(), list.end(), [&](const Finding& finding) {
            return finding.example.starts_with(middle) && finding.what.id != "fe.unfinished";
        }));
    } catch (const ParseError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr(middle), AnyOf(HasSubstr(" is empty"), HasSubstr("ends after 0 bytes"))));
    }
}

std::vector<Growing> growingByFiles() {
    std::vector<Growing> all = allGrowing();
    std::erase_if(all, [](const Growing& growing) { return growing.last.empty(); });
    return all;
}

std::string nameOf(const testing::TestParamInfo<Growing>& growing) {
    return growing.param.name;
}

INSTANTIATE_TEST_SUITE_P(Formats, Growth, testing::ValuesIn(allGrowing()), nameOf);
INSTANTIATE_TEST_SUITE_P(Formats, GrowthByFiles, testing::ValuesIn(growingByFiles()), nameOf);

}  // namespace
}  // namespace rubble::io
