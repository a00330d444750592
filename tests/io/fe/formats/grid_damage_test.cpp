#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "core/base/error.h"
#include "io/fe/ansys/rst_reader.h"
#include "io/fe/fe_reader.h"
#include "tests/support/finding_text.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Some files of a fixture, and the one that is damaged.
struct Damaged {
    std::string name;
    std::string folder;
    std::vector<std::string> files;
    std::string opened;
    std::string damaged;
};

void PrintTo(const Damaged& damaged, std::ostream* out) {
    *out << damaged.name;
}

class DamagedGrid : public testing::TestWithParam<Damaged> {
protected:
    void SetUp() override {
        for (const std::string& file : GetParam().files) {
            fs::copy_file(fixture(GetParam().folder + "/" + file), m_folder / file);
            fs::permissions(m_folder / file, fs::perms::owner_all);
        }
        m_bytes = wholeFile(m_folder / GetParam().damaged);
    }

    // Opens and reads everything; any error of ours will do.
    bool reads() {
        try {
            const auto fe = openFe(m_folder / GetParam().opened, {}, {}, Execution{});
            for (std::size_t k = 0; k < fe->stateCount(); ++k) {
                fe->state(k);
            }
            return true;
        } catch (const Error& error) {
            EXPECT_FALSE(error.remedy().empty()) << error.what();
            EXPECT_THAT(error.what(), HasSubstr(m_folder.path()));
            return false;
        }
    }

    TemporaryFolder m_folder;
    std::string m_bytes;
};

TEST_P(DamagedGrid, TheSoundOneIsRead) {
    EXPECT_TRUE(reads());
}

TEST_P(DamagedGrid, CutOffItIsRefused) {
    constexpr std::size_t cuts = 12;
    for (std::size_t i = 0; i < cuts; ++i) {
        writeContent(m_folder / GetParam().damaged, m_bytes.substr(0, m_bytes.size() * i / cuts));
        EXPECT_FALSE(reads()) << i << " of " << cuts;
    }
}

// Whatever a wrong byte does, it ends in a result or in an error of ours.
TEST_P(DamagedGrid, WrongBytesDoNoHarm) {
    for (std::size_t i = 0; i < 24; ++i) {
        std::string bytes = m_bytes;
        // Half of them within the header, the rest all over the file.
        const std::size_t range = i % 2 == 0 ? std::min<std::size_t>(bytes.size(), 2500) : bytes.size();
        bytes[(i * 7919 + 131) % range] ^= static_cast<char>(1 << i % 8);
        writeContent(m_folder / GetParam().damaged, bytes);
        reads();
    }
}

TEST_P(DamagedGrid, NothingIsPrinted) {
    writeContent(m_folder / GetParam().damaged, m_bytes.substr(0, m_bytes.size() / 2));
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    reads();
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

INSTANTIATE_TEST_SUITE_P(
    Formats, DamagedGrid,
    testing::Values(Damaged{"Vtu", "vtu-cells-removed", {"s000.vtu", "s001.vtu", "s002.vtu"}, "s000.vtu", "s001.vtu"},
                    Damaged{"VtkHdf", "vtkhdf", {"transient20.vtkhdf"}, "transient20.vtkhdf", "transient20.vtkhdf"},
                    Damaged{"Xdmf", "xdmf", {"proj.xdmf", "proj.h5"}, "proj.xdmf", "proj.xdmf"},
                    Damaged{"XdmfHeavy", "xdmf", {"proj.xdmf", "proj.h5"}, "proj.xdmf", "proj.h5"}),
    [](const testing::TestParamInfo<Damaged>& damaged) { return damaged.param.name; });

class GridTest : public testing::Test {
protected:
    // Two bricks, the second flagged dead where `dead`; or left out.
    static std::string legacy(double time, bool dead, bool leftOut, const std::string& flag) {
        const int cells = leftOut ? 1 : 2;
        std::string text =
            "# vtk DataFile Version 3.0\nsmall\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nTimeValue 1 1 double\n" +
            std::to_string(time) + "\nPOINTS 12 double\n";
        for (int n = 0; n < 12; ++n) {
            text += std::to_string(n % 3) + " " + std::to_string(n / 3 % 2) + " " + std::to_string(n / 6) + "\n";
        }
        text += "CELLS " + std::to_string(cells) + " " + std::to_string(9 * cells) + "\n8 0 1 4 3 6 7 10 9\n";
        text += leftOut ? "" : "8 1 2 5 4 7 8 11 10\n";
        text += "CELL_TYPES " + std::to_string(cells) + "\n12\n" + (leftOut ? "" : "12\n") + "CELL_DATA " + std::to_string(cells) +
                "\n";
        text += flag.empty() ? "SCALARS other int 1\nLOOKUP_TABLE default\n5\n"
                             : "SCALARS " + flag + " int 1\nLOOKUP_TABLE default\n1\n";
        return text + (leftOut ? "" : dead ? "0\n" : flag.empty() ? "5\n" : "1\n");
    }

    std::shared_ptr<const FeResult> open(const std::string& name, const ImportSettings& settings = {}) {
        return openFe(m_folder / name, settings, {}, Execution{});
    }

    TemporaryFolder m_folder;
};

TEST_F(GridTest, LegacyFilesOfANumberSeriesAreStatesByTheirTimes) {
    writeContent(m_folder / "wall_9.vtk", legacy(0.5, false, false, "STATUS"));
    writeContent(m_folder / "wall_10.vtk", legacy(1.5, true, false, "STATUS"));
    const auto fe = open("wall_10.vtk");
    EXPECT_EQ(fe->contents().format, "VTK legacy");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.5, 1.5}));
    EXPECT_EQ(fe->activity().activeCount(0), 2u);
    EXPECT_EQ(fe->activity().activeCount(1), 1u);
}

// It is there and may be read, and it is no other kind of file.
TEST_F(GridTest, AnEmptyFirstFileIsNamed) {
    writeContent(m_folder / "wall_0.vtk", "");
    writeContent(m_folder / "wall_1.vtk", legacy(0.5, false, false, "STATUS"));
    writeContent(m_folder / "s000.vtu", "");
    writeContent(m_folder / "s001.vtu", wholeFile(fixture("vtu-cells-removed/s001.vtu")));
    for (const auto& [opened, first] : {std::pair{"wall_1.vtk", "wall_0.vtk"}, {"s001.vtu", "s000.vtu"}}) {
        try {
            open(opened);
            ADD_FAILURE() << opened;
        } catch (const ParseError& error) {
            EXPECT_THAT(error.what(), HasSubstr(std::string(first) + " is empty"));
        }
    }
}

TEST_F(GridTest, ALegacyFileThatEndsTooEarlyIsRefusedInSilence) {
    const std::string text = legacy(0.5, false, false, "STATUS");
    testing::internal::CaptureStderr();
    for (std::size_t length = text.find("POINTS") + 10; length + 2 < text.size(); length += 19) {
        writeContent(m_folder / "wall.vtk", text.substr(0, length));
        try {
            open("wall.vtk");
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("wall.vtk"));
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Without numbers of elements, cells are told by their points; without a flag, a missing one is dead.
TEST_F(GridTest, CellsWithoutNumbersAreMatchedByTheirPoints) {
    writeContent(m_folder / "wall.0.vtk", legacy(0.0, false, false, ""));
    writeContent(m_folder / "wall.1.vtk", legacy(1.0, false, true, ""));
    const auto fe = open("wall.0.vtk");
    EXPECT_EQ(fe->activity().activeCount(0), 2u);
    EXPECT_EQ(fe->activity().activeCount(1), 1u);
    EXPECT_THAT(fe->contents().activityFrom, HasSubstr("missing elements are dead"));
}

TEST_F(GridTest, WithoutFlagAndMissingCellsTheArraysAreListed) {
    writeContent(m_folder / "wall.0.vtk", legacy(0.0, false, false, ""));
    writeContent(m_folder / "wall.1.vtk", legacy(1.0, false, false, ""));
    const auto fe = open("wall.0.vtk");
    EXPECT_EQ(fe->activity().activeCount(1), 2u);
    ASSERT_EQ(fe->contents().findings.count("fe.no_deaths"), 2);
    EXPECT_THAT(remedyOf(fe->contents().findings, "fe.no_deaths"), HasSubstr("other"));
    ImportSettings settings;
    settings.statusVariable = "nonsense";
    EXPECT_THROW(open("wall.0.vtk", settings), UsageError);
}

TEST_F(GridTest, ALastFileThatIsStillBeingWrittenIsLeftOut) {
    for (const char* name : {"s000.vtu", "s001.vtu", "s002.vtu", "s003.vtu"}) {
        const std::string bytes = wholeFile(fixture(std::string("vtu-cells-removed/") + name));
        writeContent(m_folder / name, std::string(name) == "s003.vtu" ? bytes.substr(0, bytes.size() / 2) : bytes);
    }
    const auto fe = open("s001.vtu");
    EXPECT_EQ(fe->stateCount(), 3u);
    EXPECT_EQ(fe->contents().findings.count("fe.unfinished"), 1);
    EXPECT_EQ(fe->contents().findings.count("vtk.no_times"), 3);
    for (const char* name : {"seq.e", "seq.e-s0002", "seq.e-s0003"}) {
        const std::string bytes = wholeFile(fixture(std::string("exodus/") + name));
        writeContent(m_folder / name, std::string(name) == "seq.e-s0003" ? bytes.substr(0, bytes.size() / 2) : bytes);
    }
    const auto sequence = open("seq.e");
    EXPECT_EQ(sequence->contents().findings.count("fe.unfinished"), 1);
    EXPECT_LT(sequence->activity().activeCount(sequence->stateCount() - 1), 1004u);
}

TEST_F(GridTest, AMissingNumberIsSaid) {
    for (const int k : {0, 10, 20, 40, 50}) {
        writeContent(m_folder / ("wall_" + std::to_string(k) + ".vtk"), legacy(0.1 * k, k > 40, false, "STATUS"));
    }
    const auto fe = open("wall_20.vtk");
    EXPECT_EQ(fe->stateCount(), 5u);
    EXPECT_EQ(fe->contents().findings.count("fe.gap"), 1);
    writeContent(m_folder / "wall_30.vtk", legacy(3.0, false, false, "STATUS"));
    EXPECT_EQ(open("wall_20.vtk")->contents().findings.count("fe.gap"), 0);
    // Numbers of iterations come as they come.
    writeContent(m_folder / "wall_53.vtk", legacy(5.3, true, false, "STATUS"));
    EXPECT_EQ(open("wall_20.vtk")->contents().findings.count("fe.gap"), 0);
}

// The times stand in the index: without it a member would open with wrong ones.
TEST_F(GridTest, AMemberOfASeriesThatLacksAFileSaysWhich) {
    writeContent(m_folder / "wall_0.vtk", legacy(0.0, false, false, "STATUS"));
    writeContent(
        m_folder / "wall.vtk.series",
        "{\"file-series-version\": \"1.0\", \"files\": [{\"name\": \"wall_0.vtk\", \"time\": 0.0}, {\"name\": \"wall_1.vtk\", "
        "\"time\": 0.25}]}");
    try {
        open("wall_0.vtk");
        FAIL();
    } catch (const WorldError& error) {
        EXPECT_THAT(error.what(), HasSubstr("wall_1.vtk, which is not there"));
    }
    writeContent(m_folder / "wall_1.vtk", legacy(9.0, true, false, "STATUS"));
    EXPECT_EQ(open("wall_0.vtk")->times(), (std::vector<double>{0.0, 0.25}));
}

TEST_F(GridTest, AnIndexThatNamesAMissingFileSaysWhich) {
    writeContent(m_folder / "wall.pvd",
                 "<?xml version=\"1.0\"?><VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" "
                 "file=\"gone.vtu\"/></Collection></VTKFile>");
    try {
        open("wall.pvd");
        FAIL();
    } catch (const WorldError& error) {
        EXPECT_THAT(error.what(), HasSubstr("gone.vtu"));
    }
}

// A finding of the fuzzer: what lists nothing was compared with what the index beside it lists.
TEST_F(GridTest, AnIndexThatNamesNothingSaysSoBesideOneThatIsSound) {
    writeContent(m_folder / "left.vtk", legacy(0.0, false, true, "STATUS"));
    const std::string head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\">\n<Collection>\n",
                      tail = "</Collection>\n</VTKFile>\n";
    writeContent(m_folder / "sound.pvd", head + "<DataSet timestep=\"0.5\" file=\"left.vtk\"/>\n" + tail);
    writeContent(m_folder / "empty.pvd", head + tail);
    try {
        open("empty.pvd");
        FAIL();
    } catch (const ParseError& error) {
        EXPECT_THAT(error.what(), HasSubstr("empty.pvd"));
        EXPECT_THAT(error.what(), HasSubstr("it names no files"));
    }
    EXPECT_EQ(open("sound.pvd")->times(), (std::vector<double>{0.5}));
}

// Parts of one time are one state.
TEST_F(GridTest, PartsOfAnIndexMakeOneState) {
    writeContent(m_folder / "left.vtk", legacy(0.0, false, true, "STATUS"));
    writeContent(m_folder / "right0.vtk", legacy(0.0, false, false, "STATUS"));
    writeContent(m_folder / "right1.vtk", legacy(0.0, true, false, "STATUS"));
    std::string index = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\">\n<Collection>\n";
    for (const char* entry : {"0.25\" part=\"0\" file=\"left.vtk", "0.25\" part=\"1\" file=\"right0.vtk",
                              "0.5\" part=\"0\" file=\"left.vtk", "0.5\" part=\"1\" file=\"right1.vtk"}) {
        index += std::string("<DataSet timestep=\"") + entry + "\"/>\n";
    }
    writeContent(m_folder / "wall.pvd", index + "</Collection>\n</VTKFile>\n");
    const auto fe = open("wall.pvd");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.25, 0.5}));
    // Both parts hold the left brick.
    EXPECT_EQ(fe->mesh().elementCount(), 2u);
    EXPECT_EQ(fe->mesh().nodeCount(), 12u);
    EXPECT_EQ(fe->contents().findings.count("pieces.duplicates"), 1);
    EXPECT_EQ(fe->activity().activeCount(0), 2u);
    EXPECT_EQ(fe->activity().activeCount(1), 1u);
}

TEST_F(GridTest, PiecesOfAParallelFileMakeOneState) {
    for (int k = 0; k < 2; ++k) {
        const std::string number = std::to_string(k);
        fs::copy_file(fixture("vtu-status/s00" + std::to_string(2 * k) + ".vtu"), m_folder / ("piece_" + number + "_0.vtu"));
        writeContent(m_folder / ("slab_" + number + ".pvtu"),
                     "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\">\n"
                     "<PUnstructuredGrid><Piece Source=\"piece_" +
                         number + "_0.vtu\"/></PUnstructuredGrid></VTKFile>\n");
    }
    const auto fe = open("slab_0.pvtu");
    EXPECT_EQ(fe->stateCount(), 2u);
    EXPECT_EQ(fe->activity().activeCount(0), 1004u);
    EXPECT_EQ(fe->activity().activeCount(1), 996u);
}

TEST_F(GridTest, AFolderOpensAsTheSeriesThatItHolds) {
    EXPECT_EQ(openFe(fixture("vtu-status"), {}, {}, Execution{})->stateCount(), 16u);
    EXPECT_EQ(openFe(fixture("vtu-status/s007.vtu"), {}, {}, Execution{})->stateCount(), 16u);
}

TEST_F(GridTest, TablesOpenThroughTheTextThatNamesThem) {
    const auto fe = openFe(fixture("xdmf/proj.h5"), {}, {}, Execution{});
    EXPECT_EQ(fe->contents().format, "XDMF");
    EXPECT_EQ(fe->contents().sha256, openFe(fixture("xdmf/proj.xdmf"), {}, {}, Execution{})->contents().sha256);
    fs::copy_file(fixture("xdmf/proj.h5"), m_folder / "proj.h5");
    writeContent(m_folder / "other.xdmf", "<Xdmf><Domain/></Xdmf>");
    writeContent(m_folder / "broken.xmf", "<Xdmf><Domain");
    try {
        open("proj.h5");
        FAIL();
    } catch (const ParseError& error) {
        EXPECT_THAT(error.what(), HasSubstr(".xdmf"));
    }
    fs::copy_file(fixture("vtkhdf/transient20.vtkhdf"), m_folder / "grid.hdf");
    writeContent(m_folder / "grid.xdmf", "<Xdmf><DataItem Format=\"HDF\">grid.hdf:/VTKHDF/Points</DataItem></Xdmf>");
    EXPECT_EQ(open("grid.hdf")->contents().format, "VTKHDF");
}

TEST_F(GridTest, AStaticVtkHdfIsOneState) {
    const auto fe = openFe(fixture("vtkhdf/static10.vtkhdf"), {}, {}, Execution{});
    EXPECT_EQ(fe->contents().format, "VTKHDF");
    EXPECT_EQ(fe->stateCount(), 1u);
    EXPECT_EQ(fe->mesh().elementCount(), 1004u);
    EXPECT_EQ(fe->mesh().nodeCount(), 2340u);
    EXPECT_EQ(fe->activity().activeCount(0), 1004u - 222u);
}

// A wall of 24 bricks of which a step takes out two and the next two more: CalculiX 2.20, as text and binary.
TEST_F(GridTest, TheWallOfCalculixLosesWhatItsDeckSays) {
    for (const char* file : {"calculix/wall.frd", "calculix/wallbin.frd"}) {
        const auto fe = openFe(fixture(file), {}, {}, Execution{});
        ASSERT_EQ(fe->times(), (std::vector<double>{1.0, 2.0, 3.0})) << file;
        EXPECT_EQ(fe->activity().activeCount(0), 24u);
        EXPECT_EQ(fe->activity().activeCount(1), 22u);
        EXPECT_EQ(fe->activity().activeCount(2), 20u);
        EXPECT_FALSE(fe->activity().active(1, idAt<ElementIndex>(2)));
        EXPECT_DOUBLE_EQ(fe->mesh().density[0], 2400.0);
    }
    // The two files hold the same displacements, one of them in single precision.
    const auto text = openFe(fixture("calculix/wall.frd"), {}, {}, Execution{});
    const auto binary = openFe(fixture("calculix/wallbin.frd"), {}, {}, Execution{});
    for (std::size_t n = 0; n < text->mesh().nodeCount(); ++n) {
        EXPECT_LT((text->state(1)->positions[n] - binary->state(1)->positions[n]).norm(), 1e-7) << n;
    }
}

// A static analysis by Ansys: 81 nodes, 12 bricks of 20 nodes, the displacements packed by windows.
TEST_F(GridTest, AnAnsysResultIsReadWithAListOfDeaths) {
    fs::copy_file(fixture("ansys/static.rst"), m_folder / "static.rst");
    EXPECT_GT(open("static.rst")->contents().findings.count("fe.no_deaths"), 0);
    writeContent(m_folder / "static.rst.deaths.csv", "5,0.5\n");
    const auto fe = open("static.rst");
    EXPECT_EQ(fe->times(), (std::vector<double>{1.0}));
    EXPECT_EQ(fe->mesh().nodeCount(), 81u);
    ASSERT_GT(fe->mesh().elementCount(), 7u);
    EXPECT_EQ(fe->mesh().elementIds[0], 5);
    EXPECT_EQ(fe->mesh().shapes[0], ElementShape::Hexahedron);
    EXPECT_TRUE(fe->mesh().nodes[0].isApprox(Vec3(0.015, 0.045, 0.015), 1e-12));
    EXPECT_FALSE(fe->activity().active(0, idAt<ElementIndex>(0)));
    EXPECT_EQ(fe->activity().activeCount(0), fe->mesh().elementCount() - 1);
    // The first values of the set, as they stand in the file.
    EXPECT_NEAR(fe->state(0)->positions[0].x() - 0.015, 0.0, 1e-15);
    EXPECT_NEAR(fe->state(0)->positions[0].y() - 0.045, -6.935659752417679e-09, 1e-16);
    const std::string bytes = wholeFile(m_folder / "static.rst");
    for (std::size_t i = 0; i < 64; ++i) {
        writeContent(m_folder / "static.rst", bytes.substr(0, bytes.size() * i / 64));
        try {
            const auto cut = open("static.rst");
            cut->state(0);
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("static.rst"));
        }
    }
}

TEST_F(GridTest, ASmallAnsysResultCutOffAtEveryByteIsReadOrRefused) {
    const std::string bytes = wholeFile(sourcePath("tests/fuzz/corpus/rst/small.rst"));
    writeContent(m_folder / "small.rst", bytes);
    writeContent(m_folder / "small.rst.deaths.csv", "element,time\n2,1.5\n");
    const auto fe = open("small.rst");
    EXPECT_EQ(fe->times(), (std::vector<double>{1.0, 2.0}));
    EXPECT_EQ(fe->activity().activeCount(0), 2u);
    EXPECT_EQ(fe->activity().activeCount(1), 1u);
    EXPECT_NEAR(fe->state(0)->positions[0].x(), 0.1, 1e-15);
    EXPECT_NEAR(fe->state(1)->positions[0].x(), 0.2, 1e-15) << "a window of one value repeated";
    for (std::size_t length = bytes.size(); length-- > 0;) {
        fs::resize_file(m_folder / "small.rst", length);
        try {
            const FeResult cut(readRst(m_folder / "small.rst", {}, Execution{}));
            for (std::size_t k = 0; k < cut.stateCount(); ++k) {
                cut.state(k);
            }
        } catch (const Error& error) {
            ASSERT_THAT(error.what(), HasSubstr("small.rst")) << length;
        }
    }
}

}  // namespace
}  // namespace rubble::io
