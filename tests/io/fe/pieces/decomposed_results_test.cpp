#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/pieces/brick_row.h"
#include "tests/io/fe/results_in_folder.h"
#include "tests/support/exodus_builder.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::HasSubstr;
using Counts = std::vector<std::size_t>;

class DecomposedResult : public ResultsInFolder {
protected:
    static Counts dead(const FeResult& fe) {
        Counts counts;
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            counts.push_back(fe.mesh().elementCount() - fe.activity().activeCount(k));
        }
        return counts;
    }

    /// Two pieces of five bricks, of three states; the last brick dies at the second.
    void layPieces() {
        for (int k = 0; k < 3; ++k) {
            const std::string name = "s" + std::to_string(k);
            writeContent(m_folder / (name + "_0.vtu"), BrickRow{.bricks = {0, 1, 2, 3, 4}, .status = {1, 1, 1, 1, 1}}.vtu());
            writeContent(m_folder / (name + "_1.vtu"),
                         BrickRow{.bricks = {5, 6, 7, 8, 9}, .status = {1, 1, 1, 1, k == 0 ? 1 : 0}}.vtu());
            writeContent(m_folder / (name + ".pvtu"), pvtu({name + "_0.vtu", name + "_1.vtu"}));
        }
    }
};

TEST_F(DecomposedResult, APieceOpensTheWholeAndItsPointsAreJoined) {
    layPieces();
    for (const char* name : {"s0.pvtu", "s0_0.vtu", "s1_1.vtu"}) {
        const auto fe = open(name);
        EXPECT_EQ(fe->mesh().elementCount(), 10u) << name;
        EXPECT_EQ(fe->mesh().nodeCount(), 44u) << name;
        EXPECT_EQ(dead(*fe), (Counts{0, 1, 1})) << name;
        EXPECT_EQ(fe->contents().findings.count("pieces.doubled"), 4) << name;
        EXPECT_EQ(fe->contents().findings.count("fe.piece"), std::string(name) == "s0.pvtu" ? 0 : 1) << name;
    }
    ImportSettings settings;
    settings.onlyThisFile = true;
    EXPECT_EQ(open("s0_1.vtu", settings)->mesh().elementCount(), 5u);
    std::filesystem::remove(m_folder / "s1_1.vtu");
    EXPECT_THAT(errorOf("s0_0.vtu"), HasSubstr("s1_1.vtu, which is not there"));
}

TEST_F(DecomposedResult, AnIndexOfTimesMayNameIndicesOfPieces) {
    layPieces();
    writeContent(m_folder / "all.pvd", pvd({{"0", "0", "s0.pvtu"}, {"0.5", "0", "s1.pvtu"}, {"1", "0", "s2.pvtu"}}));
    for (const char* name : {"all.pvd", "s1.pvtu", "s2_1.vtu"}) {
        const auto fe = open(name);
        EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 0.5, 1.0})) << name;
        EXPECT_EQ(dead(*fe), (Counts{0, 1, 1})) << name;
    }
}

TEST_F(DecomposedResult, BlocksInBlocksAreOneState) {
    layPieces();
    std::filesystem::create_directory(m_folder / "blocks");
    writeContent(m_folder / "blocks/b_0.vtu", BrickRow{.bricks = {0, 1, 2}, .status = {1, 1, 0}}.vtu());
    writeContent(m_folder / "blocks/b_1.vtu", BrickRow{.bricks = {3, 4}}.vtu());
    writeContent(
        m_folder / "b.vtm",
        "<?xml version='1.0'?><VTKFile type='vtkMultiBlockDataSet'><vtkMultiBlockDataSet><Block index='0'><Block index='0'>"
        "<DataSet index='0' file='blocks/b_0.vtu'/></Block></Block><DataSet index='1' file='blocks\\b_1.vtu'/>"
        "</vtkMultiBlockDataSet></VTKFile>");
    for (const char* name : {"b.vtm", "blocks/b_0.vtu"}) {
        const auto fe = open(name);
        EXPECT_EQ(fe->mesh().elementCount(), 5u) << name;
        EXPECT_EQ(fe->mesh().nodeCount(), 24u) << name;
        EXPECT_EQ(fe->activity().activeCount(0), 4u) << "what a block lacks is not dead";
    }
}

// Each cell has points of its own; a surface that parts later is no repetition.
TEST_F(DecomposedResult, PointsOfCellsAreJoinedUnlessTheyPart) {
    for (int k = 0; k < 2; ++k) {
        BrickRow row{.bricks = {0, 1, 2, 3}, .ownPoints = true, .status = {1, 1, 1, k == 0 ? 1 : 0}};
        writeContent(m_folder / ("s" + std::to_string(k) + ".vtu"), row.vtu());
        row.liftFrom = k == 0 ? 1e9 : 2.0;
        writeContent(m_folder / ("c" + std::to_string(k) + ".vtu"), row.vtu());
    }
    EXPECT_EQ(open("s0.vtu")->mesh().nodeCount(), 20u);
    const auto parted = open("c0.vtu");
    EXPECT_EQ(parted->mesh().nodeCount(), 24u);
    EXPECT_EQ(parted->contents().findings.count("pieces.parted"), 4);
    EXPECT_NEAR(parted->state(1)->positions[parted->mesh().cornersOf(idAt<ElementIndex>(2))[0]].z(), 0.5, 1e-12);
    EXPECT_NEAR(parted->state(1)->positions[parted->mesh().cornersOf(idAt<ElementIndex>(1))[4]].z(), 0.0, 1e-12);
}

TEST_F(DecomposedResult, CopiesOfAnotherPieceCountOnceAndAreNotDead) {
    for (const bool flagged : {true, false}) {
        for (const bool numbered : {true, false}) {
            BrickRow left{.bricks = {0, 1, 2, 3, 4, 5}, .ghosts = {0, 0, 0, 0, 0, 1}};
            BrickRow right{.bricks = {4, 5, 6, 7, 8, 9}, .ghosts = {1, 0, 0, 0, 0, 0}};
            if (flagged) {
                left.status = {1, 1, 1, 1, 0, 1};
                right.status = {0, 1, 1, 1, 1, 1};
            }
            if (numbered) {
                left.elements = {1, 2, 3, 4, 5, 6};
                right.elements = {5, 6, 7, 8, 9, 10};
                left.nodesBy = right.nodesBy = 1;
            }
            writeContent(m_folder / "g_0.vtu", left.vtu());
            writeContent(m_folder / "g_1.vtu", right.vtu());
            writeContent(m_folder / "g.pvtu", pvtu({"g_0.vtu", "g_1.vtu"}));
            const auto fe = open("g.pvtu");
            EXPECT_EQ(fe->mesh().elementCount(), 10u) << flagged << numbered;
            EXPECT_EQ(fe->mesh().nodeCount(), 44u) << flagged << numbered;
            EXPECT_EQ(dead(*fe), Counts{flagged ? 1u : 0u}) << flagged << numbered;
            EXPECT_EQ(fe->contents().findings.count("pieces.duplicates"), 2);
            EXPECT_EQ(fe->contents().findings.count("fe.number_twice"), 0);
        }
    }
}

TEST_F(DecomposedResult, NumbersThatCountWithinAPieceJoinNothing) {
    BrickRow left{.bricks = {0, 1}, .status = {1, 0}}, right{.bricks = {2, 3}, .status = {1, 1}};
    left.nodesBy = 1;
    right.nodesBy = 1 - 8;
    writeContent(m_folder / "p_0.vtu", left.vtu());
    writeContent(m_folder / "p_1.vtu", right.vtu());
    writeContent(m_folder / "p.pvtu", pvtu({"p_0.vtu", "p_1.vtu"}));
    const auto fe = open("p.pvtu");
    EXPECT_EQ(fe->mesh().nodeCount(), 20u);
    EXPECT_NEAR(fe->mesh().nodes[fe->mesh().cornersOf(idAt<ElementIndex>(3))[4]].x(), 4.0, 1e-12);
    EXPECT_EQ(fe->contents().findings.count("fe.node_number_twice"), 1);
}

TEST_F(DecomposedResult, TimesOfAnIndexThatComeAgain) {
    for (const char* name : {"s0", "s1", "s2", "r1", "r2"}) {
        const int gone = name[1] == '0' ? -1 : name[0] == 's' ? 3 : 5;
        BrickRow row{.bricks = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, .status = std::vector<int>(10, 1)};
        if (gone >= 0) {
            row.status[static_cast<std::size_t>(gone)] = 0;
        }
        writeContent(m_folder / (std::string(name) + ".vtu"), row.vtu());
    }
    writeContent(
        m_folder / "same.pvd",
        pvd({{"0", "0", "s0.vtu"}, {"0", "0", "s0.vtu"}, {"0", "0", "s0.vtu"}, {"1", "0", "s1.vtu"}, {"2", "0", "s2.vtu"}}));
    const auto same = open("same.pvd");
    EXPECT_EQ(same->mesh().elementCount(), 10u);
    EXPECT_EQ(dead(*same), (Counts{0, 1, 1}));
    EXPECT_EQ(same->contents().findings.count("vtk.listed_again"), 2);
    writeContent(
        m_folder / "same.pvd",
        pvd({{"0", "0", "s0.vtu"}, {"1", "0", "s1.vtu"}, {"2", "0", "s2.vtu"}, {"1", "0", "r1.vtu"}, {"2.5", "0", "r2.vtu"}}));
    const auto restart = open("same.pvd");
    EXPECT_EQ(restart->times(), (std::vector<double>{0.0, 1.0, 2.5}));
    EXPECT_EQ(dead(*restart), (Counts{0, 1, 1}));
    EXPECT_FALSE(restart->activity().active(1, idAt<ElementIndex>(5)));
    EXPECT_EQ(restart->contents().findings.count("fe.abandoned"), 2);
    // Pieces that all bear the part 0, and a list in the order of names.
    writeContent(m_folder / "h.vtu", BrickRow{.bricks = {10, 11}, .status = {1, 1}}.vtu());
    writeContent(m_folder / "same.pvd",
                 pvd({{"0", "0", "s0.vtu"}, {"0", "0", "h.vtu"}, {"10", "0", "s2.vtu"}, {"10", "0", "h.vtu"}}));
    EXPECT_EQ(open("same.pvd")->mesh().elementCount(), 12u);
}

std::string vtm(const std::vector<std::string>& files) {
    std::string text = "<?xml version='1.0'?><VTKFile type='vtkMultiBlockDataSet'><vtkMultiBlockDataSet>";
    for (std::size_t i = 0; i < files.size(); ++i) {
        text += "<Block index='" + std::to_string(i) + "'><DataSet index='0' file='" + files[i] + "'/></Block>";
    }
    return text + "</vtkMultiBlockDataSet></VTKFile>";
}

// Two states of five bricks, of which one dies, whatever names their files once more.
TEST_F(DecomposedResult, AFileThatIsListedTwiceForAStateCountsOnceAndIsNamed) {
    for (int k = 0; k < 2; ++k) {
        const std::string name = "s" + std::to_string(k);
        writeContent(m_folder / (name + "_0.vtu"), BrickRow{.bricks = {0, 1, 2}, .status = {1, 1, 1}}.vtu());
        writeContent(m_folder / (name + "_1.vtu"), BrickRow{.bricks = {3, 4}, .status = {1, k == 0 ? 1 : 0}}.vtu());
        writeContent(m_folder / (name + ".pvtu"), pvtu({name + "_0.vtu", name + "_1.vtu", name + "_0.vtu"}));
        writeContent(m_folder / (name + ".vtm"), vtm({name + "_0.vtu", name + "_1.vtu", "./" + name + "_1.vtu", name + "_1.vtu"}));
        writeContent(m_folder / (name + "_whole.vtu"),
                     BrickRow{.bricks = {0, 1, 2, 3, 4}, .status = {1, 1, 1, 1, k == 0 ? 1 : 0}}.vtu());
    }
    writeContent(m_folder / "parts.pvd", pvd({{"0", "0", "s0_0.vtu"},
                                              {"0", "1", "s0_1.vtu"},
                                              {"0", "1", "./s0_1.vtu"},
                                              {"1", "0", "s1_0.vtu"},
                                              {"1", "1", "s1_1.vtu"},
                                              {"1", "2", "s1_1.vtu"}}));
    writeContent(m_folder / "mixed.pvd", pvd({{"0", "0", "s0.vtm"}, {"1", "0", "s1.vtm"}, {"1", "1", "s1_0.vtu"}}));
    writeContent(m_folder / "nested.vtm", vtm({"s0.vtm", "s0.pvtu", "s0.vtm"}));
    writeContent(m_folder / "s.vtu.series",
                 R"({"file-series-version":"1.0","files":[{"name":"s0_whole.vtu","time":0},{"name":"s0_whole.vtu","time":0},)"
                 R"({"name":"s1_whole.vtu","time":1}]})");
    const auto opens = [&](const std::string& name, const Counts& deaths, std::int64_t again, const std::string& example) {
        const auto fe = open(name);
        EXPECT_EQ(fe->mesh().elementCount(), 5u) << name;
        EXPECT_EQ(fe->mesh().nodeCount(), 24u) << name;
        EXPECT_EQ(dead(*fe), deaths) << name;
        EXPECT_EQ(fe->contents().findings.count("pieces.duplicates"), 0) << name;
        EXPECT_EQ(fe->contents().findings.count("vtk.listed_again"), again) << name;
        for (const Finding& finding : fe->contents().findings.list()) {
            EXPECT_TRUE(finding.what.id != "vtk.listed_again" || finding.example == example) << name << finding.example;
        }
    };
    opens("parts.pvd", {0, 1}, 2, "s0_1.vtu, listed 2 times");
    opens("mixed.pvd", {0, 1}, 5, "s0_1.vtu, listed 3 times");
    opens("nested.vtm", {0}, 6, "s0.vtm, listed 2 times");
    opens("s.vtu.series", {0, 1}, 1, "s0_whole.vtu, listed 2 times");
}

TEST_F(DecomposedResult, LooselyWrittenIndicesAreRead) {
    for (int k = 0; k < 3; ++k) {
        writeContent(m_folder / ("s" + std::to_string(k) + ".vtu"), BrickRow{.bricks = {0, 1}, .status = {1, k < 2 ? 1 : 0}}.vtu());
    }
    writeContent(m_folder / "loose.pvd",
                 pvd({{"+0.0", "0", ".\\s0.vtu"}, {" 1.0d+00", "0", "C:\\run\\s1.vtu"}, {"2.0 ", "0", "./s2.vtu"}}));
    for (const char* name : {"loose.pvd", "s2.vtu"}) {
        EXPECT_EQ(open(name)->times(), (std::vector<double>{0.0, 1.0, 2.0})) << name;
    }
}

// Nobody says that files are pieces: what lacks times may be, and the remedy says so.
TEST_F(DecomposedResult, PiecesWithoutTheirIndexAreThoughtOf) {
    writeContent(m_folder / "s0_0.vtu", BrickRow{.bricks = {0}}.vtu());
    writeContent(m_folder / "s0_1.vtu", BrickRow{.bricks = {0}}.vtu());
    const auto fe = open("s0_0.vtu");
    const auto& list = fe->contents().findings.list();
    const auto found =
        std::find_if(list.begin(), list.end(), [](const Finding& finding) { return finding.what.id == "vtk.no_times"; });
    ASSERT_NE(found, list.end());
    EXPECT_THAT(englishText(found->remedy), HasSubstr("if the files are pieces of one state, their .pvtu"));
}

// Without times, lines are no states of one time that replace each other.
TEST_F(DecomposedResult, AnIndexWithoutTimesCountsItsStates) {
    for (int k = 0; k < 3; ++k) {
        const std::string name = "s" + std::to_string(k);
        const std::vector<int> bricks = k < 2 ? std::vector<int>{0, 1, 2} : std::vector<int>{0};
        writeContent(m_folder / (name + ".vtu"), BrickRow{.bricks = bricks}.vtu());
        writeContent(m_folder / (name + "_left.vtu"), BrickRow{.bricks = {0}, .status = {1}}.vtu());
        writeContent(m_folder / (name + "_right.vtu"), BrickRow{.bricks = {1}, .status = {k < 2 ? 1 : 0}}.vtu());
    }
    writeContent(m_folder / "whole.pvd", pvd({{"", "0", "s0.vtu"}, {"", "0", "s1.vtu"}, {"", "0", "s2.vtu"}}));
    const auto whole = open("whole.pvd");
    EXPECT_EQ(whole->times(), (std::vector<double>{0.0, 1.0, 2.0}));
    EXPECT_EQ(dead(*whole), (Counts{0, 0, 2}));
    EXPECT_EQ(whole->contents().findings.count("vtk.no_times"), 3);
    EXPECT_EQ(whole->contents().findings.count("fe.written_twice"), 0);
    for (const std::string part : {"0", "1"}) {
        std::vector<std::vector<std::string>> lines;
        for (const std::string name : {"s0", "s1", "s2"}) {
            lines.push_back({"", "0", name + "_left.vtu"});
            lines.push_back({"", part, name + "_right.vtu"});
        }
        writeContent(m_folder / "pieces.pvd", pvd(lines));
        const auto pieces = open("pieces.pvd");
        EXPECT_EQ(pieces->mesh().elementCount(), 2u) << part;
        EXPECT_EQ(dead(*pieces), (Counts{0, 0, 1})) << part;
    }
    writeContent(m_folder / "mixed.pvd", pvd({{"", "0", "s0.vtu"}, {"1", "0", "s1.vtu"}}));
    EXPECT_EQ(open("mixed.pvd")->times(), (std::vector<double>{0.0, 1.0}));
    writeContent(m_folder / "mixed.pvd", pvd({{"", "0", "s0.vtu"}, {"", "0", "s1.vtu"}, {"2", "0", "s2.vtu"}}));
    EXPECT_THAT(errorOf("mixed.pvd"), HasSubstr("some of its entries have a timestep"));
    // The files say what the index does not.
    for (int k = 0; k < 2; ++k) {
        writeContent(m_folder / ("s" + std::to_string(k) + ".vtu"), BrickRow{.bricks = {0, 1}, .time = 0.5 * k}.vtu());
    }
    writeContent(m_folder / "whole.pvd", pvd({{"", "0", "s0.vtu"}, {"", "0", "s1.vtu"}}));
    EXPECT_EQ(open("whole.pvd")->times(), (std::vector<double>{0.0, 0.5}));
}

TEST_F(DecomposedResult, AnEmptyLastFileIsLeftOut) {
    for (int k = 0; k < 2; ++k) {
        writeContent(m_folder / ("s" + std::to_string(k) + ".vtu"), BrickRow{.bricks = {0, 1}, .status = {1, k < 1 ? 1 : 0}}.vtu());
    }
    writeContent(m_folder / "s2.vtu", "");
    for (const char* name : {"s0.vtu", "s2.vtu"}) {
        const auto fe = open(name);
        EXPECT_EQ(dead(*fe), (Counts{0, 1})) << name;
        EXPECT_EQ(fe->contents().findings.count("fe.unfinished"), 1) << name;
    }
    writeContent(m_folder / "s2.vtu", BrickRow{.bricks = {0, 1}, .status = {0, 0}}.vtu());
    EXPECT_EQ(dead(*open("s0.vtu")), (Counts{0, 1, 2}));
}

TEST_F(DecomposedResult, VariantsOfOtherMeshesAreNoStates) {
    writeContent(m_folder / "v_1.vtu", BrickRow{.bricks = {0, 1, 2}, .status = {1, 1, 1}}.vtu());
    writeContent(m_folder / "v_2.vtu", BrickRow{.bricks = {0, 1, 2, 3}, .status = {1, 0, 1, 1}}.vtu());
    const auto second = open("v_2.vtu");
    EXPECT_EQ(second->stateCount(), 1u);
    EXPECT_EQ(second->mesh().elementCount(), 4u);
    EXPECT_EQ(second->contents().findings.count("fe.variants"), 1);
    EXPECT_FALSE(hasGrown(*second));
    EXPECT_NE(second->contents().fingerprint, open("v_1.vtu")->contents().fingerprint);
    writeContent(m_folder / "w_1.vtu", BrickRow{.bricks = {0, 1}, .status = {1, 1}}.vtu());
    writeContent(m_folder / "w_2.vtu", BrickRow{.bricks = {0, 1}, .status = {1, 0}}.vtu());
    const auto series = open("w_2.vtu");
    ASSERT_EQ(series->contents().findings.list().front().what.id, "vtk.no_times");
    EXPECT_EQ(series->contents().findings.list().front().example, "w_1.vtu, w_2.vtu");
    ImportSettings alone;
    alone.onlyThisFile = true;
    const auto only = open("w_2.vtu", alone);
    EXPECT_EQ(dead(*only), Counts{1});
    EXPECT_FALSE(hasGrown(*only));
}

/// Bricks of a row as Exodus files that processors wrote.
class Processors : public DecomposedResult {
protected:
    void lay(int processors, const std::string& base = "out.e", int longest = 3) {
        const int each = 4;
        for (int p = 0; p < processors; ++p) {
            ExodusBuilder builder;
            builder.addCubes(each, "row", 1);
            for (Vec3& node : builder.nodes) {
                node.x() += each * p;
            }
            for (std::size_t n = 0; n < builder.nodes.size(); ++n) {
                builder.nodeNumbers.push_back(
                    static_cast<int>(std::lround(4 * builder.nodes[n].x() + 2 * builder.nodes[n].y() + builder.nodes[n].z())) + 1);
            }
            for (int e = 0; e < each; ++e) {
                builder.elementNumbers.push_back(each * p + e + 1);
            }
            builder.times = {0.0, 0.5, 1.0};
            builder.times.resize(static_cast<std::size_t>(p + 1 == processors ? longest : 3));
            builder.addStillDisplacement();
            builder.element.emplace_back("STATUS", [p](std::size_t k, std::size_t e) { return p == 1 && e < k ? 0.0 : 1.0; });
            const std::string file = m_folder / (base + "." + std::to_string(processors) + "." + std::to_string(p));
            builder.write(file);
            int id = -1, dimension = -1;
            ASSERT_EQ(nc_open(file.c_str(), NC_WRITE, &id), NC_NOERR);
            nc_redef(id);
            nc_def_dim(id, "num_processors", static_cast<std::size_t>(processors), &dimension);
            nc_def_dim(id, "num_elems_global", static_cast<std::size_t>(each * processors), &dimension);
            ASSERT_EQ(nc_enddef(id), NC_NOERR);
            nc_close(id);
        }
    }
};

TEST_F(Processors, AllFilesAreOneResult) {
    lay(3);
    for (const char* name : {"out.e.3.0", "out.e.3.2", ""}) {
        const auto fe = open(name);
        EXPECT_EQ(fe->mesh().elementCount(), 12u) << name;
        EXPECT_EQ(fe->mesh().nodeCount(), 52u) << name;
        EXPECT_EQ(dead(*fe), (Counts{0, 1, 2})) << name;
    }
    EXPECT_EQ(open("out.e.3.1")->contents().findings.count("fe.piece"), 1);
}

TEST_F(Processors, AMissingOneIsNamed) {
    lay(3);
    std::filesystem::remove(m_folder / "out.e.3.1");
    EXPECT_THAT(errorOf("out.e.3.0"), HasSubstr("\"out.e.3.1\""));
    std::filesystem::rename(m_folder / "out.e.3.0", m_folder / "other.e");
    EXPECT_THAT(errorOf("other.e"), HasSubstr("holds 4 of 12 elements"));
}

TEST_F(Processors, AStateThatOneHasNotWrittenIsLeftOut) {
    lay(2, "out.e", 2);
    const auto fe = open("out.e.2.0");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 0.5}));
    EXPECT_EQ(fe->contents().findings.count("fe.unfinished"), 1);
}

// What a solver that was killed leaves behind.
TEST_F(Processors, ACutOffLastStateIsLeftOut) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return e < k ? 0.0 : 1.0; });
    builder.write(m_folder / "base.e");
    const auto size = std::filesystem::file_size(m_folder / "base.e");
    std::filesystem::resize_file(m_folder / "base.e", size - 4);
    const auto fe = open("base.e");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 0.5, 1.0}));
    EXPECT_EQ(dead(*fe), (Counts{0, 1, 2}));
    EXPECT_EQ(fe->contents().findings.count("fe.unfinished"), 1);
    writeContent(m_folder / "base.e-s002", "");
    EXPECT_EQ(open("base.e")->contents().findings.count("fe.unfinished"), 2);
}

TEST_F(Processors, StatesWrittenTwiceAndAbandonedAreCounted) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.times = {0.0, 0.5, 0.5, 1.0, 1.5, 0.75};
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return k == 2 && e == 0 ? 0.0 : 1.0; });
    builder.write(m_folder / "twice.e");
    const auto fe = open("twice.e");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 0.5, 0.75}));
    EXPECT_EQ(dead(*fe), (Counts{0, 1, 0}));
    EXPECT_EQ(fe->contents().findings.count("fe.written_twice"), 1);
    EXPECT_EQ(fe->contents().findings.count("fe.abandoned"), 2);
}

// A distributed analysis of Ansys says how many nodes its model has.
TEST_F(DecomposedResult, AMissingProcessOfAnsysIsNamed) {
    std::string bytes = wholeFile(sourcePath("tests/fuzz/corpus/rst/small.rst"));
    constexpr std::size_t header = 105, modelNodes = 48;
    const std::int32_t nodes = 20;
    std::memcpy(bytes.data() + 4 * (header + modelNodes), &nodes, sizeof nodes);
    writeContent(m_folder / "file0.rst", bytes);
    writeContent(m_folder / "file2.rst", bytes);
    EXPECT_THAT(errorOf("file2.rst"), HasSubstr("2 files hold 12 of 20 nodes; not there: file1.rst"));
}

// libMesh numbers anew what is left: brick 2 dies, whatever the numbers of the later file say.
TEST_F(Processors, ElementsAreToldApartByTheirPlaces) {
    for (const bool nodesToo : {false, true}) {
        ExodusBuilder builder;
        builder.addCubes(5, "row", 1);
        builder.times = {0.0};
        builder.addStillDisplacement();
        builder.write(m_folder / "renum.e");
        ExodusBuilder later = builder;
        later.times = {1.0};
        later.blocks[0].nodes.erase(later.blocks[0].nodes.begin(), later.blocks[0].nodes.begin() + 8);
        if (nodesToo) {
            // The four nodes at x = 0 go too.
            std::vector<int> number(later.nodes.size() + 1, 0);
            std::vector<Vec3> left;
            for (std::size_t n = 0; n < later.nodes.size(); ++n) {
                if (later.nodes[n].x() > 0.5) {
                    left.push_back(later.nodes[n]);
                    number[n + 1] = static_cast<int>(left.size());
                }
            }
            later.nodes = left;
            for (int& node : later.blocks[0].nodes) {
                node = number[static_cast<std::size_t>(node)];
            }
        }
        later.write(m_folder / "renum.e-s002");
        const auto fe = open("renum.e");
        EXPECT_EQ(fe->mesh().elementCount(), 5u) << nodesToo;
        EXPECT_EQ(dead(*fe), (Counts{0, 1})) << nodesToo;
        EXPECT_FALSE(fe->activity().active(1, idAt<ElementIndex>(0))) << nodesToo;
        EXPECT_EQ(fe->contents().findings.count("fe.renumbered"), 4) << nodesToo;
    }
}

TEST_F(DecomposedResult, ANumberWithOtherPointsIsAnotherCell) {
    BrickRow row{.bricks = {0, 1, 2, 3}, .elements = {1, 2, 3, 4}};
    row.nodesBy = 1;
    writeContent(m_folder / "s0.vtu", row.vtu());
    row.bricks = {0, 2, 3};
    row.elements = {1, 2, 3};
    writeContent(m_folder / "s1.vtu", row.vtu());
    const auto fe = open("s0.vtu");
    EXPECT_EQ(dead(*fe), (Counts{0, 1}));
    EXPECT_FALSE(fe->activity().active(1, idAt<ElementIndex>(1)));
}

}  // namespace
}  // namespace rubble::io
