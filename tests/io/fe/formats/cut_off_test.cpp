#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/growing_results.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

using ::testing::HasSubstr;

/// Results of three states whose end is missing: a disk that was full, a solver that was killed, a copy that broke off.
class CutOffResult : public testing::TestWithParam<Growing> {
protected:
    std::shared_ptr<const FeResult> open() { return openFe(m_folder / GetParam().opened, {}, {}, Execution{}); }
    std::string cutFile() { return m_folder / GetParam().cut; }

    /// Lengths that the file is cut off at: within its last state.
    std::vector<std::uintmax_t> lengths() {
        std::uintmax_t from = 0;
        if (GetParam().cutOff == CutOff::LastState) {
            GetParam().write(m_folder, 2, true);
            from = std::filesystem::file_size(cutFile());
        }
        GetParam().write(m_folder, 3, true);
        const std::uintmax_t size = GetParam().filled > 0 ? GetParam().filled : std::filesystem::file_size(cutFile());
        std::vector<std::uintmax_t> list;
        for (const unsigned tenths : {1U, 3U, 5U, 7U}) {
            list.push_back(from + (size - from) * tenths / 10);
        }
        return list;
    }

    TemporaryFolder m_folder;
};

class CutOffLastState : public CutOffResult {};

TEST_P(CutOffLastState, WhatIsWholeIsReadAndTheRestIsNamed) {
    for (const std::uintmax_t length : lengths()) {
        GetParam().write(m_folder, 3, true);
        std::filesystem::resize_file(cutFile(), length);
        const auto fe = open();
        EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.0})) << length;
        EXPECT_EQ(fe->activity().activeCount(1), fe->mesh().elementCount()) << length;
        std::int64_t count = 0;
        for (const Finding& finding : fe->contents().findings.list()) {
            if (finding.what.id == "fe.unfinished" || finding.what.id == "anim.incomplete" ||
                finding.what.id == "d3plot.incomplete") {
                count += finding.count;
                EXPECT_THAT(finding.example, HasSubstr(GetParam().cut)) << length;
                EXPECT_FALSE(englishText(finding.remedy).empty());
            }
        }
        EXPECT_EQ(count, 1) << length;
    }
}

class CutOffFile : public CutOffResult {};

// HDF5 opens nothing that is cut off, and XML has no end: the file is called by its name.
TEST_P(CutOffFile, IsRefusedAndNamed) {
    for (const std::uintmax_t length : lengths()) {
        GetParam().write(m_folder, 3, true);
        std::filesystem::resize_file(cutFile(), length);
        try {
            open();
            ADD_FAILURE() << "read at byte " << length;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(GetParam().cut)) << length;
            EXPECT_FALSE(error.remedy().empty()) << length;
        }
    }
}

std::vector<Growing> cutOff(bool refused) {
    std::vector<Growing> all = allGrowing();
    std::erase_if(all, [refused](const Growing& growing) { return (growing.cutOff == CutOff::Refused) != refused; });
    return all;
}

std::string nameOfCutOff(const testing::TestParamInfo<Growing>& growing) {
    return growing.param.name;
}

INSTANTIATE_TEST_SUITE_P(Formats, CutOffLastState, testing::ValuesIn(cutOff(false)), nameOfCutOff);
INSTANTIATE_TEST_SUITE_P(Formats, CutOffFile, testing::ValuesIn(cutOff(true)), nameOfCutOff);

}  // namespace
}  // namespace rubble::io
