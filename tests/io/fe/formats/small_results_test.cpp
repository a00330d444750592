#include "tests/io/fe/formats/small_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

#include "core/base/error.h"
#include "io/fe/fe_format.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/results_in_folder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::HasSubstr;

/// A small result as text, and how to lay it down.
struct Small {
    std::string name;
    std::string file;
    std::string text;
    std::string second;  ///< another file beside it, and its text
    std::string secondText;
};

void PrintTo(const Small& small, std::ostream* out) {
    *out << small.name;
}

class SmallResult : public testing::TestWithParam<Small> {
protected:
    std::string lay(const std::string& text) {
        writeContent(m_folder / GetParam().file, text);
        if (!GetParam().second.empty()) {
            writeContent(m_folder / GetParam().second, GetParam().secondText);
        }
        return m_folder / GetParam().file;
    }

    // By its reader alone: what openFe() does besides takes most of the time and does not look at the content.
    void readWhole(const std::string& path) {
        const FileHead head = readHead(path);
        const auto formats = feFormats();
        const auto found =
            std::find_if(formats.begin(), formats.end(), [&](const FeFormat& format) { return format.recognises(head); });
        if (found == formats.end()) {
            openFe(path, {}, {}, Execution{});
            return;
        }
        FeResult::Contents contents = found->read(path, {}, Execution{});
        const auto& times = contents.times;
        if (std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return !(a < b); }) != times.end()) {
            openFe(path, {}, {}, Execution{});
            return;
        }
        const FeResult fe(std::move(contents));
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            fe.state(k);
        }
    }

    TemporaryFolder m_folder;
};

TEST_P(SmallResult, TheSecondBrickDiesAtTheThirdState) {
    const auto fe = openFe(lay(GetParam().text), {}, {}, Execution{});
    ASSERT_EQ(fe->stateCount(), 3u);
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.0, 2.0}));
    ASSERT_EQ(fe->mesh().elementIds, (std::vector<std::int64_t>{1, 2}));
    EXPECT_EQ(fe->activity().activeCount(0), 2u);
    EXPECT_EQ(fe->activity().activeCount(1), 2u);
    EXPECT_TRUE(fe->activity().active(2, idAt<ElementIndex>(0)));
    EXPECT_FALSE(fe->activity().active(2, idAt<ElementIndex>(1)));
}

TEST_P(SmallResult, NodesMove) {
    const auto fe = openFe(lay(GetParam().text), {}, {}, Execution{});
    for (const std::size_t k : {std::size_t{2}, std::size_t{0}, std::size_t{1}}) {
        const auto state = fe->state(k);
        const std::uint32_t corner = fe->mesh().cornersOf(idAt<ElementIndex>(0))[0];
        EXPECT_NEAR(state->positions[corner].x(), 0.1 * static_cast<double>(k), 1e-6) << k;
    }
}

// What was written up to there, or an error that names the file; nothing else.
TEST_P(SmallResult, CutOffAtEveryByteItIsReadOrRefused) {
    const std::string& text = GetParam().text;
    std::size_t read = 0, refused = 0;
    const std::string path = lay(text);
    for (std::size_t length = text.size(); length-- > 0;) {
        std::filesystem::resize_file(path, length);
        try {
            readWhole(path);
            ++read;
        } catch (const Error& error) {
            ++refused;
            ASSERT_FALSE(error.remedy().empty()) << error.what();
            ASSERT_THAT(error.what(), HasSubstr(m_folder.path())) << length;
        }
    }
    EXPECT_GT(refused, text.size() / 4);
    EXPECT_EQ(read + refused, text.size());
}

TEST_P(SmallResult, EveryDigitMayBeWrong) {
    const std::string& text = GetParam().text;
    const std::string path = lay(text);
    const auto overwrite = [&path](std::size_t at, char c) {
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(static_cast<std::streamoff>(at));
        file.put(c);
    };
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] < '0' || text[at] > '9') {
            continue;
        }
        overwrite(at, "9-x"[at % 3]);
        try {
            readWhole(path);
        } catch (const Error& error) {
            ASSERT_FALSE(error.message().empty());
        }
        overwrite(at, text[at]);
    }
}

std::vector<Small> allSmall() {
    return {{"Fil", "small.fil", smallFil(), "", ""},
            {"FrdByNodes", "small.frd", smallFrd(), "", ""},
            {"FrdByDeck", "small.frd", smallFrd(), "small.inp", smallDeck()},
            {"MarcRemoved", "small.t19", smallMarc(true), "", ""},
            {"MarcKept", "small.t19", smallMarc(false), "", ""}};
}

INSTANTIATE_TEST_SUITE_P(Formats, SmallResult, testing::ValuesIn(allSmall()),
                         [](const testing::TestParamInfo<Small>& small) { return small.param.name; });

TEST_F(ResultsInFolder, DatabasesOfANumberSeriesAreStates) {
    for (int k = 0; k < 3; ++k) {
        writeContent(m_folder / ("wall_" + std::to_string(k) + ".cdb"), smallCdb(k));
    }
    const auto fe = open("wall_1.cdb");
    ASSERT_EQ(fe->stateCount(), 3u);
    EXPECT_EQ(fe->activity().activeCount(1), 2u);
    EXPECT_EQ(fe->activity().activeCount(2), 1u);
    EXPECT_DOUBLE_EQ(fe->mesh().density[0], 2400.0);
    EXPECT_NEAR(fe->state(2)->positions[0].x(), 0.2, 1e-12);
}

TEST_F(ResultsInFolder, ADatabaseCutOffAtEveryByteIsReadOrRefused) {
    const std::string text = smallCdb(0);
    writeContent(m_folder / "wall.mac", "TIME,1\nEKILL,2\nSOLVE\n");
    writeContent(m_folder / "wall.cdb", text);
    for (std::size_t length = text.size(); length-- > 0;) {
        std::filesystem::resize_file(m_folder / "wall.cdb", length);
        try {
            open("wall.cdb");
        } catch (const Error& error) {
            ASSERT_THAT(error.what(), HasSubstr("wall.cdb")) << length;
        }
    }
}

TEST_F(ResultsInFolder, KillsOfAMacroAreDeaths) {
    writeContent(m_folder / "wall.cdb", smallCdb(0));
    writeContent(m_folder / "wall.mac",
                 "! comment\nTIME,1\nSOLVE\nTIME,2.5\nEKILL,2\nEKILL,WALL\nSOLVE\nTIME,4\nEALIVE,2\nSOLVE\n");
    const auto fe = open("wall.cdb");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.0, 2.5, 4.0}));
    EXPECT_EQ(fe->activity().activeCount(1), 2u);
    EXPECT_EQ(fe->activity().activeCount(2), 1u);
    EXPECT_EQ(fe->activity().activeCount(3), 2u);
    EXPECT_EQ(fe->contents().findings.count("cdb.kill_name"), 1);
}

TEST_F(ResultsInFolder, AListOfDeathsCountsWhereTheFileSaysNothing) {
    writeContent(m_folder / "wall.cdb", smallCdb(0));
    EXPECT_EQ(open("wall.cdb")->contents().findings.count("fe.no_deaths"), 2);
    writeContent(m_folder / "wall.cdb.deaths.csv", "element,time\n2,1.5\n77,2\n");
    const auto fe = open("wall.cdb");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.5, 2.0}));
    EXPECT_FALSE(fe->activity().active(1, idAt<ElementIndex>(1)));
    EXPECT_DOUBLE_EQ(fe->contents().deathTime[1], 1.5);
    EXPECT_TRUE(std::isnan(fe->contents().deathTime[0]));
    EXPECT_EQ(fe->contents().findings.count("fe.death_list.unknown"), 1);
    writeContent(m_folder / "wall.cdb.deaths.csv", "element,time\n2,soon\n");
    EXPECT_THAT(errorOf("wall.cdb"), HasSubstr("line 2"));
}

// What is only concluded gives way to what somebody states; what the file says does not.
TEST_F(ResultsInFolder, AListOfDeathsCountsBeforeWhatIsConcluded) {
    writeContent(m_folder / "small.frd", smallFrd());
    writeContent(m_folder / "small.t19", smallMarc(false));
    writeContent(m_folder / "small.fil", smallFil());
    for (const char* name : {"small.frd", "small.t19", "small.fil"}) {
        const bool told = std::string(name) == "small.fil";
        writeContent(m_folder / (std::string(name) + ".deaths.csv"), "1,0.5\n");
        const auto fe = open(name);
        EXPECT_EQ(fe->activity().active(1, idAt<ElementIndex>(0)), told) << name;
        EXPECT_EQ(fe->activity().active(2, idAt<ElementIndex>(1)), !told) << name;
        EXPECT_EQ(fe->contents().findings.count("fe.death_list.unused"), told ? 1 : 0) << name;
        EXPECT_EQ(fe->contents().files.size(), 2u) << name;
    }
}

TEST_F(ResultsInFolder, TheDeckGivesDensityAndParts) {
    writeContent(m_folder / "small.fil", smallFil());
    writeContent(m_folder / "small.inp", smallDeck());
    const auto fe = open("small.fil");
    EXPECT_DOUBLE_EQ(fe->mesh().density[0], 2400.0);
    EXPECT_EQ(fe->mesh().parts[0].name, "WALL");
    EXPECT_EQ(fe->contents().files.size(), 2u);
}

// Counts that no file of that size can hold are refused before anything is made for them.
TEST_F(ResultsInFolder, CountsBeyondTheFileAreRefused) {
    std::string frd = smallFrd();
    frd.replace(frd.find("          12"), 12, "  2000000000");
    writeContent(m_folder / "huge.frd", frd);
    EXPECT_THAT(errorOf("huge.frd"), HasSubstr("more than the file can hold"));
    std::string marc = smallMarc(true);
    marc.replace(marc.find("           12"), 13, "    900000000");
    writeContent(m_folder / "huge.t19", marc);
    EXPECT_THAT(errorOf("huge.t19"), HasSubstr("more than the file can hold"));
    std::string fil = smallFil();
    fil.replace(fil.find("*I 19"), 5, "*I 39");
    writeContent(m_folder / "huge.fil", fil);
    EXPECT_THAT(errorOf("huge.fil"), HasSubstr("huge.fil"));
}

TEST_F(ResultsInFolder, AStateThatIsStillBeingWrittenIsLeftOut) {
    const std::string text = smallMarc(true);
    writeContent(m_folder / "small.t19", text.substr(0, text.rfind("=beg=52401")));
    const auto marc = open("small.t19");
    EXPECT_EQ(marc->stateCount(), 2u);
    EXPECT_EQ(marc->contents().findings.count("fe.unfinished"), 1);
    // Within the nodes of its last state, in the middle of a number.
    writeContent(m_folder / "small.t19", text.substr(0, text.rfind("=end=") - 200));
    EXPECT_EQ(open("small.t19")->stateCount(), 2u);
    for (int k = 0; k < 3; ++k) {
        const std::string cdb = smallCdb(k);
        writeContent(m_folder / ("wall_" + std::to_string(k) + ".cdb"), k == 2 ? cdb.substr(0, cdb.size() / 2) : cdb);
    }
    EXPECT_EQ(open("wall_0.cdb")->stateCount(), 2u);
    EXPECT_EQ(open("wall_2.cdb")->contents().findings.count("fe.unfinished"), 1);
    writeContent(m_folder / "wall_1.cdb", smallCdb(1).substr(0, 300));
    EXPECT_THAT(errorOf("wall_0.cdb"), HasSubstr("wall_1.cdb"));
    const std::string fil = smallFil();
    writeContent(m_folder / "small.fil", fil.substr(0, fil.size() - 400));
    const auto fe = open("small.fil");
    EXPECT_EQ(fe->stateCount(), 2u);
    EXPECT_EQ(fe->contents().findings.count("fe.unfinished"), 1);
}

}  // namespace
}  // namespace rubble::io
