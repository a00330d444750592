#include "io/fe/opensees/mpco_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/opensees/mpco_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MpcoReader : public testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const std::string& name, const ImportSettings& settings = {}) {
        return openFe(m_folder / name, settings, {}, Execution{});
    }
    std::shared_ptr<const FeResult> open(const std::vector<MpcoStageRows>& stages, std::size_t dimensions = 3) {
        // The library does not write over a file that is still open here.
        const std::string name = "wall" + std::to_string(m_written++) + ".mpco";
        writeMpco(m_folder / name, stages, dimensions);
        return open(name);
    }
    static std::vector<std::size_t> active(const FeResult& fe) {
        std::vector<std::size_t> counts;
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            counts.push_back(fe.activity().activeCount(k));
        }
        return counts;
    }

    TemporaryFolder m_folder;
    int m_written = 0;
};

TEST_F(MpcoReader, AnElementThatANewStageLacksIsDead) {
    const auto fe = open(twoBricksMpco());
    EXPECT_EQ(fe->contents().format, "OpenSees MPCO");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.0, 2.0}));
    EXPECT_THAT(active(*fe), ElementsAre(2, 2, 1));
    EXPECT_EQ(fe->mesh().elementIds, (std::vector<std::int64_t>{1, 2}));
    EXPECT_EQ(fe->mesh().parts[0].name, "Brick");
    EXPECT_FALSE(fe->activity().active(2, idAt<ElementIndex>(1)));
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(fe->state(k)->positions[11].x(), 2.0 + 0.1 * static_cast<double>(k), 1e-12);
    }
    EXPECT_EQ(fe->contents().findings.count("fe.no_deaths"), 0);
}

TEST_F(MpcoReader, WhatIsNeverRemovedCanBeLookedAt) {
    std::vector<MpcoStageRows> stages = twoBricksMpco();
    stages[1].classes = stages[0].classes;
    const auto fe = open(stages);
    EXPECT_THAT(active(*fe), ElementsAre(2, 2, 2));
    EXPECT_EQ(fe->contents().findings.count("fe.no_deaths"), 2);
    writeContent(m_folder / "wall0.mpco.deaths.csv", "1,0.5\n");
    EXPECT_THAT(active(*open("wall0.mpco")), ElementsAre(2, 1, 1));
}

// Frames, shells and solids by their geometry, or by class and nodes; springs are no structure.
TEST_F(MpcoReader, ClassesAreKnownByGeometryAndNodes) {
    std::vector<MpcoStageRows> stages = twoBricksMpco();
    stages.resize(1);
    MpcoStageRows& stage = stages[0];
    stage.nodes.push_back(13);
    stage.places.insert(stage.places.end(), {0.0, 0.0, 0.0});
    stage.classes = {{"5-ElasticBeam3d[1:0]", 3, {21, 1, 7, 22, 1, 13}, 1},
                     {"73-ForceBeamColumn3d[1000:1]", 3, {23, 3, 9}, 1},
                     {"203-ASDShellQ4[201:0]", 5, {31, 1, 2, 5, 4}, 0},
                     {"53-ShellMITC4[201:0]", 5, {32, 7, 8, 11, 10}, 200},
                     {"204-ASDShellT3[102:0]", 4, {33, 1, 2, 4}, 100},
                     {"179-FourNodeTetrahedron[300:0]", 5, {41, 1, 2, 4, 7}, 300},
                     {"999-Unknown[0:0]", 5, {42, 1, 2, 4, 7}, 0},
                     {"1-Brick[0:0]", 9, {43, 1, 2, 5, 4, 7, 8, 11, 10}, 0},
                     {"19-ZeroLength[1:0]", 3, {51, 1, 13}, 1},
                     {"164-TwoNodeLink[0:0]", 3, {52, 1, 2}, 0},
                     {"1234-SevenNodes[0:0]", 8, {53, 1, 2, 3, 4, 5, 6, 7}, 0}};
    stage.fibres = {{23, 0.16}};
    const auto fe = open(stages);
    const Mesh& mesh = fe->mesh();
    std::vector<std::pair<std::int64_t, ElementShape>> shapes;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        shapes.emplace_back(mesh.elementIds[e], mesh.shapes[e]);
    }
    std::sort(shapes.begin(), shapes.end());
    using S = ElementShape;
    EXPECT_EQ(shapes, (std::vector<std::pair<std::int64_t, S>>{{21, S::Beam},
                                                               {23, S::Beam},
                                                               {31, S::Quadrilateral},
                                                               {32, S::Quadrilateral},
                                                               {33, S::Triangle},
                                                               {41, S::Tetrahedron},
                                                               {42, S::Tetrahedron},
                                                               {43, S::Hexahedron}}));
    EXPECT_EQ(fe->contents().findings.count("mpco.left_out"), 4) << "a beam without length, a spring, a link, an odd one";
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        if (mesh.elementIds[e] == 23) {
            EXPECT_NEAR(mesh.section[e], 0.16, 1e-15) << "the areas of its fibres";
        }
        if (mesh.elementIds[e] == 21) {
            EXPECT_TRUE(std::isnan(mesh.section[e]));
        }
    }
}

TEST_F(MpcoReader, PiecesOfAParallelAnalysisAreOneStructure) {
    std::vector<MpcoStageRows> left = twoBricksMpco(), right = left;
    for (MpcoStageRows& stage : left) {
        stage.classes[0].rows.resize(9);
    }
    right[0].classes[0].rows.erase(right[0].classes[0].rows.begin(), right[0].classes[0].rows.begin() + 9);
    right[1].classes.clear();
    right[0].nodes.erase(right[0].nodes.begin());
    right[0].places.erase(right[0].places.begin(), right[0].places.begin() + 3);
    writeMpco(m_folder / "wall.part-0.mpco", left);
    writeMpco(m_folder / "wall.part-1.mpco", right);
    for (const char* name : {"wall.part-0.mpco", "wall.part-1.mpco"}) {
        const auto fe = open(name);
        EXPECT_EQ(fe->contents().files.size(), 2u);
        EXPECT_THAT(active(*fe), ElementsAre(2, 2, 1));
        EXPECT_EQ(fe->mesh().nodeCount(), 12u) << "nodes on the border are one";
        EXPECT_NEAR(fe->state(1)->positions[2].x(), 2.1, 1e-12);
        EXPECT_EQ(fe->contents().findings.count("fe.piece"), 1);
    }
    ImportSettings alone;
    alone.onlyThisFile = true;
    const auto only = open("wall.part-1.mpco", alone);
    EXPECT_EQ(only->contents().files, std::vector<std::string>{m_folder / "wall.part-1.mpco"});
    EXPECT_EQ(only->mesh().elementIds, std::vector<std::int64_t>{2});
    EXPECT_THAT(active(*only), ElementsAre(1, 1, 0));
    EXPECT_EQ(only->contents().findings.count("mpco.one_piece"), 1);
    std::filesystem::rename(m_folder / "wall.part-1.mpco", m_folder / "wall.part-2.mpco");
    try {
        open("wall.part-0.mpco");
        FAIL();
    } catch (const WorldError& error) {
        EXPECT_THAT(error.what(), HasSubstr("wall.part-1.mpco"));
    }
    EXPECT_EQ(open("wall.part-0.mpco", alone)->mesh().elementIds, std::vector<std::int64_t>{1});
    std::filesystem::remove(m_folder / "wall.part-2.mpco");
    EXPECT_EQ(open("wall.part-0.mpco")->contents().findings.count("mpco.one_piece"), 1);
}

TEST_F(MpcoReader, AStateThatAPieceLacksIsLeftOut) {
    std::vector<MpcoStageRows> late = twoBricksMpco();
    writeMpco(m_folder / "wall.part-0.mpco", late);
    late[1].states.clear();
    writeMpco(m_folder / "wall.part-1.mpco", late);
    const auto fe = open("wall.part-0.mpco");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.0}));
    EXPECT_EQ(fe->contents().findings.count("mpco.piece_states"), 1);
}

// What the analysis was writing when it ended: a table of fewer nodes.
TEST_F(MpcoReader, ALastStateThatIsNotWholeIsLeftOut) {
    std::vector<MpcoStageRows> stages = twoBricksMpco();
    stages[1].states.emplace_back(3, 3.0);
    stages[1].cutState = 3;
    const auto fe = open(stages);
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.0, 2.0}));
    EXPECT_THAT(active(*fe), ElementsAre(2, 2, 1));
    EXPECT_EQ(fe->contents().findings.count("fe.unfinished"), 1);
}

// Gravity first, then loadConst -time 0: what lies before does not count, and what was lost with it is said.
TEST_F(MpcoReader, WhereTheClockIsSetBackTheLaterStatesCount) {
    std::vector<MpcoStageRows> stages = twoBricksMpco();
    stages[0].states = {{0, 0.0}, {1, 0.5}, {2, 1.0}};
    stages[1].states = {{3, 0.25}, {4, 0.75}};
    const auto fe = open(stages);
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 0.25, 0.75}));
    EXPECT_THAT(active(*fe), ElementsAre(2, 1, 1));
    stages[1].states = {{3, 0.0}, {4, 0.75}};
    const auto second = open(stages);
    EXPECT_EQ(second->times(), (std::vector<double>{0.0, 0.75}));
    EXPECT_THAT(active(*second), ElementsAre(1, 1));
    EXPECT_EQ(second->contents().findings.count("mpco.lost"), 1);
}

TEST_F(MpcoReader, AFrameInAPlaneIsReadAndSaid) {
    MpcoStageRows stage;
    stage.nodes = {1, 2, 3};
    stage.places = {0.0, 0.0, 0.0, 3.0, 4.0, 3.0};
    stage.classes = {{"3-ElasticBeam2d[1:0]", 3, {1, 1, 2, 2, 2, 3}, 1}};
    stage.states = {{0, 0.0}, {1, 1.0}};
    const auto fe = open({stage}, 2);
    EXPECT_EQ(fe->mesh().elementCount(), 2u);
    EXPECT_EQ(fe->mesh().nodes[1], Vec3(0.0, 3.0, 0.0));
    EXPECT_EQ(fe->contents().findings.count("fe.plane"), 1);
}

TEST_F(MpcoReader, WithoutDisplacementsItSaysWhatThereIs) {
    writeMpco(m_folder / "wall.mpco", twoBricksMpco(), 3, "REACTION_FORCE");
    try {
        open("wall.mpco");
        FAIL();
    } catch (const ParseError& error) {
        EXPECT_THAT(englishText(error.remedy()), HasSubstr("\"REACTION_FORCE\""));
    }
    ImportSettings settings;
    settings.displacement = "none";
    EXPECT_EQ(open("wall.mpco", settings)->times(), (std::vector<double>{0.0, 2.0}));
    settings.displacement = "VELOCITY";
    EXPECT_THROW(open("wall.mpco", settings), UsageError);
}

TEST_F(MpcoReader, CutOffItIsRefusedAndWrongBytesDoNoHarm) {
    writeMpco(m_folder / "wall.mpco", twoBricksMpco());
    const std::string bytes = wholeFile(m_folder / "wall.mpco");
    testing::internal::CaptureStderr();
    const auto reads = [&](const std::string& content) {
        writeContent(m_folder / "wall.mpco", content);
        try {
            const FeResult fe(readMpco(m_folder / "wall.mpco", {}, Execution{}));
            for (std::size_t k = 0; k < fe.stateCount(); ++k) {
                fe.state(k);
            }
            return true;
        } catch (const Error& error) {
            EXPECT_FALSE(error.remedy().empty()) << error.what();
            EXPECT_THAT(error.what(), HasSubstr("wall.mpco"));
            return false;
        }
    };
    EXPECT_TRUE(reads(bytes));
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_FALSE(reads(bytes.substr(0, bytes.size() * i / 40))) << i;
    }
    for (std::size_t i = 0; i < 120; ++i) {
        std::string wrong = bytes;
        wrong[(i * 7919 + 131) % wrong.size()] ^= static_cast<char>(1 << i % 8);
        reads(wrong);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace rubble::io
