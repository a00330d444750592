#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/growing_results.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

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
