#include "io/fe/med/med_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/med/med_builder.h"
#include "tests/support/finding_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MedReader : public testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const MedRows& rows, const ImportSettings& settings = {}) {
        // The library does not write over a file that is still open here.
        const std::string path = m_folder / ("wall" + std::to_string(m_written++) + ".rmed");
        writeMed(path, rows);
        return openFe(path, settings, {}, Execution{});
    }
    static std::vector<std::size_t> active(const FeResult& fe) {
        std::vector<std::size_t> counts;
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            counts.push_back(fe.activity().activeCount(k));
        }
        return counts;
    }
    // The two bricks without the field that tells what died.
    static MedRows bare() {
        MedRows rows = twoBricksMed();
        std::erase_if(rows.fields, [](const MedFieldRows& field) { return field.type != 0; });
        return rows;
    }

    TemporaryFolder m_folder;
    int m_written = 0;
};

TEST_F(MedReader, AnElementThatNoFieldHasValuesOnAnyMoreIsDead) {
    const auto fe = open(twoBricksMed());
    EXPECT_EQ(fe->contents().format, "MED");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.0, 2.0}));
    EXPECT_EQ(fe->mesh().elementIds, (std::vector<std::int64_t>{3, 4})) << "faces of the bricks are left out";
    EXPECT_THAT(active(*fe), ElementsAre(2, 2, 1));
    EXPECT_FALSE(fe->activity().active(2, idAt<ElementIndex>(1)));
    EXPECT_EQ(fe->mesh().parts[0].name, "PIER");
    EXPECT_EQ(fe->mesh().parts[1].name, "DECK");
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(fe->state(k)->positions[11].x(), 2.0 + 0.1 * static_cast<double>(k), 1e-12);
    }
    const Findings& findings = fe->contents().findings;
    EXPECT_EQ(findings.count("med.skin"), 2);
    EXPECT_EQ(findings.count("med.inferred"), 1);
    EXPECT_EQ(findings.count("fe.units_rivals"), 1);
    EXPECT_EQ(findings.list().size(), 3u) << "solids are numbered as MED numbers them";
}

TEST_F(MedReader, NodesThatTheDisplacementLeavesOutTakeTheirElementsWithThem) {
    MedRows rows = bare();
    MedFieldRows& last = rows.fields.back();
    last.profile = {1, 2, 4, 5, 7, 8, 10, 11};
    last.values.resize(24);
    const auto fe = open(rows);
    EXPECT_THAT(active(*fe), ElementsAre(2, 2, 1));
    EXPECT_EQ(fe->contents().findings.count("med.inferred"), 1);
    fe->state(2);
}

TEST_F(MedReader, AFieldOfActivityCountsByItsName) {
    MedRows rows = bare();
    for (int k = 0; k < 3; ++k) {
        rows.fields.push_back({"RESU____STATUS", {"X1"}, k, double(k), 308, {}, {1.0, k > 0 ? 0.0 : 1.0}, false});
    }
    const auto fe = open(rows);
    EXPECT_THAT(active(*fe), ElementsAre(2, 1, 1));
    EXPECT_THAT(fe->contents().activityFrom, HasSubstr("RESU____STATUS, 1 is active (by its name)"));
    for (MedFieldRows& field : rows.fields) {
        field.name = field.type != 0 ? "RESU____GONE" : field.name;
    }
    const auto unknown = open(rows);
    EXPECT_THAT(active(*unknown), ElementsAre(2, 2, 2));
    ASSERT_EQ(unknown->contents().findings.count("fe.no_deaths"), 2);
    EXPECT_THAT(remedyOf(unknown->contents().findings, "fe.no_deaths"), HasSubstr("\"RESU____GONE\""));
    ImportSettings settings;
    settings.statusVariable = "GONE";
    EXPECT_THAT(active(*open(rows, settings)), ElementsAre(2, 1, 1));
    settings.statusVariable = "NOTHING";
    EXPECT_THROW(open(rows, settings), UsageError);
}

TEST_F(MedReader, AListOfDeathsCountsBeforeWhatIsConcluded) {
    writeContent(m_folder / "wall0.rmed.deaths.csv", "3,1\n");
    const auto fe = open(twoBricksMed());
    EXPECT_THAT(active(*fe), ElementsAre(2, 1, 1));
    EXPECT_FALSE(fe->activity().active(1, idAt<ElementIndex>(0)));
    EXPECT_EQ(fe->contents().files.size(), 2u);
}

TEST_F(MedReader, EveryTypeOfCellIsKnownByItsCorners) {
    MedRows rows;
    // A cube, and for each type as many nodes as it has: the corners first, as MED numbers them.
    const std::vector<std::vector<double>> cube{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0},
                                                {0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
    const auto block = [&](int type, const std::vector<int>& corners) {
        MedBlockRows one{type, {}, {}, {}};
        for (int n = 0; n < type % 100; ++n) {
            const auto at = static_cast<std::size_t>(n) < corners.size()
                                ? cube[static_cast<std::size_t>(corners[static_cast<std::size_t>(n)])]
                                : std::vector<double>{0.5, 0.5, 0.5};
            const double shift = 3.0 * static_cast<double>(rows.blocks.size());
            rows.places.insert(rows.places.end(), {at[0] + shift, at[1], at[2]});
            one.nodes.push_back(static_cast<int>(rows.places.size() / 3));
        }
        rows.blocks.push_back(one);
    };
    const std::vector<int> tetra{0, 1, 3, 4}, pyramid{0, 1, 2, 3, 4}, wedge{0, 1, 3, 4, 5, 7}, hexa{0, 1, 2, 3, 4, 5, 6, 7};
    const std::vector<int> quad{0, 1, 2, 3}, triangle{0, 1, 2}, line{0, 1};
    for (const int type : {102, 103, 104}) {
        block(type, line);
    }
    for (const int type : {203, 206, 207}) {
        block(type, triangle);
    }
    for (const int type : {204, 208, 209}) {
        block(type, quad);
    }
    for (const auto& [type, corners] : std::vector<std::pair<int, std::vector<int>>>{{304, tetra},
                                                                                     {310, tetra},
                                                                                     {305, pyramid},
                                                                                     {313, pyramid},
                                                                                     {306, wedge},
                                                                                     {315, wedge},
                                                                                     {318, wedge},
                                                                                     {308, hexa},
                                                                                     {320, hexa},
                                                                                     {327, hexa}}) {
        block(type, corners);
    }
    block(1, {0});
    rows.fields = {{"RESU____DEPL", {"DX", "DY", "DZ"}, 1, 1.0, 0, {}, std::vector<double>(rows.places.size(), 0.0), false}};
    const auto fe = open(rows);
    const Mesh& mesh = fe->mesh();
    std::map<ElementShape, int> counts;
    for (const ElementShape shape : mesh.shapes) {
        ++counts[shape];
    }
    using S = ElementShape;
    EXPECT_EQ(counts, (std::map<S, int>{{S::Beam, 3},
                                        {S::Triangle, 3},
                                        {S::Quadrilateral, 3},
                                        {S::Tetrahedron, 2},
                                        {S::Pyramid, 2},
                                        {S::Wedge, 3},
                                        {S::Hexahedron, 3}}));
    EXPECT_EQ(fe->contents().findings.count("med.skipped_cell"), 1);
    for (const Finding& finding : fe->contents().findings.list()) {
        EXPECT_THAT(finding.what.id, testing::AnyOf("med.skipped_cell", "fe.no_deaths", "pieces.doubled", "fe.units_rivals"))
            << "no solid is inside out";
    }
}

TEST_F(MedReader, PointsNeedNoNumbersWhereAllElementsHaveThem) {
    MedRows rows = twoBricksMed();
    int number = 70;
    for (MedBlockRows& block : rows.blocks) {
        block.numbers.clear();
        for (std::size_t c = 0; c < block.nodes.size() / static_cast<std::size_t>(block.type % 100); ++c) {
            block.numbers.push_back(number++);
        }
    }
    const std::size_t bricks = rows.blocks.front().type == 308 ? 0 : rows.blocks.size() - 1;
    ASSERT_EQ(rows.blocks[bricks].type, 308);
    rows.blocks.push_back({1, {1}, {}, {}});
    const auto fe = open(rows);
    EXPECT_EQ(fe->mesh().elementIds,
              std::vector<std::int64_t>(rows.blocks[bricks].numbers.begin(), rows.blocks[bricks].numbers.end()));
    EXPECT_EQ(fe->contents().findings.count("med.skipped_cell"), 1);
}

TEST_F(MedReader, WithoutADisplacementTheFieldsAreOffered) {
    MedRows rows = bare();
    for (MedFieldRows& field : rows.fields) {
        field.name = "RESU____TEMP";
    }
    try {
        open(rows);
        FAIL();
    } catch (const ParseError& error) {
        EXPECT_THAT(englishText(error.remedy()), HasSubstr("\"RESU____TEMP\""));
    }
    ImportSettings settings;
    settings.displacement = "TEMP";
    EXPECT_NEAR(open(rows, settings)->state(2)->positions[0].x(), 0.2, 1e-12);
    settings.displacement = "none";
    EXPECT_EQ(open(rows, settings)->state(2)->positions[0].x(), 0.0);
}

TEST_F(MedReader, OfSeveralResultsTheOneWithMostStatesIsReadAndTheOthersAreNamed) {
    MedRows rows = bare();
    rows.fields.push_back({"OTHER___DEPL", {"DX", "DY", "DZ"}, 0, 0.0, 0, {}, std::vector<double>(36, 9.0), false});
    const auto fe = open(rows);
    EXPECT_EQ(fe->stateCount(), 3u);
    EXPECT_EQ(fe->contents().findings.count("med.results"), 1);
    ImportSettings settings;
    settings.displacement = "OTHER___DEPL";
    EXPECT_EQ(open(rows, settings)->stateCount(), 1u);
}

TEST_F(MedReader, CutOffItIsRefusedAndWrongBytesDoNoHarm) {
    writeMed(m_folder / "wall.rmed", twoBricksMed());
    const std::string bytes = wholeFile(m_folder / "wall.rmed");
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const auto reads = [&](const std::string& content) {
        writeContent(m_folder / "wall.rmed", content);
        try {
            const FeResult fe(readMed(m_folder / "wall.rmed", {}, Execution{}));
            for (std::size_t k = 0; k < fe.stateCount(); ++k) {
                fe.state(k);
            }
            return true;
        } catch (const Error& error) {
            EXPECT_FALSE(error.remedy().empty()) << error.what();
            EXPECT_THAT(error.what(), HasSubstr("wall.rmed"));
            return false;
        }
    };
    EXPECT_TRUE(reads(bytes));
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_FALSE(reads(bytes.substr(0, bytes.size() * i / 40))) << i;
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "libraries do not speak to the user";
    for (std::size_t i = 0; i < 120; ++i) {
        std::string wrong = bytes;
        wrong[(i * 7919 + 131) % wrong.size()] ^= static_cast<char>(1 << i % 8);
        reads(wrong);
    }
}

// The HDF5 that libmed brings keeps what a damaged file left open, and would complain of it when the program ends.
TEST_F(MedReader, ADamagedFileLeavesNoWordAtTheEndOfTheProgram) {
    writeMed(m_folder / "wall.rmed", twoBricksMed());
    const std::string bytes = wholeFile(m_folder / "wall.rmed");
    const auto touchDamaged = [&] {
        for (std::size_t i = 0; i < 120; ++i) {
            std::string wrong = bytes;
            wrong[(i * 7919 + 131) % wrong.size()] ^= static_cast<char>(1 << i % 8);
            writeContent(m_folder / "wrong.rmed", wrong);
            touchMed(m_folder / "wrong.rmed");
        }
    };
    EXPECT_EXIT((touchDamaged(), std::exit(0)), testing::ExitedWithCode(0), testing::Not(HasSubstr("infinite loop")));
}

}  // namespace
}  // namespace rubble::io
