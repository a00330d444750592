#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>

#include "io/fe/fe_reader.h"
#include "tests/io/fe/d3plot/d3plot_builder.h"
#include "tests/io/fe/formats/small_results.h"
#include "tests/io/fe/formats/vtkhdf_builder.h"
#include "tests/io/fe/med/med_builder.h"
#include "tests/io/fe/opensees/mpco_builder.h"
#include "tests/io/fe/pieces/brick_row.h"
#include "tests/io/fe/radioss/anim_builder.h"
#include "tests/support/exodus_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

/// A result of three states at whose third an element dies, and how it is written up to its second or third.
struct Growing {
    std::string name;
    std::string opened;                                                    ///< file
    std::function<void(const TemporaryFolder& folder, int states)> write;  ///< replaces what is there
    std::string last;                                                      ///< file of the third state alone; empty: there is none
};

void PrintTo(const Growing& growing, std::ostream* out) {
    *out << growing.name;
}

// Replaced as a whole: what is open keeps reading what it has opened.
void replace(const std::string& path, const std::function<void(const std::string& path)>& write) {
    write(path + ".next");
    std::filesystem::rename(path + ".next", path);
}

std::vector<double> timesUpTo(int states) {
    std::vector<double> times{0.0, 1.0, 2.0};
    times.resize(static_cast<std::size_t>(states));
    return times;
}

void growAnim(const TemporaryFolder& folder, int states) {
    AnimBuilder builder;
    builder.brickDeaths = {{1, 2.0}};
    builder.write(folder.path(), timesUpTo(states));
}

void growD3plot(const TemporaryFolder& folder, int states) {
    D3plotBuilder builder;
    builder.statesPerFile = 1;
    builder.times = timesUpTo(states);
    builder.deaths = {{1, 2}};
    builder.write(folder / "d3plot");
}

void growGrids(const TemporaryFolder& folder, int states) {
    for (int k = 0; k < states; ++k) {
        const BrickRow row{.bricks = {0, 1}, .status = {1, k < 2 ? 1 : 0}, .time = static_cast<double>(k)};
        writeContent(folder / ("wall_" + std::to_string(k) + ".vtu"), row.vtu());
    }
}

void growPvd(const TemporaryFolder& folder, int states) {
    growGrids(folder, states);
    std::vector<std::vector<std::string>> lines;
    for (int k = 0; k < states; ++k) {
        lines.push_back({std::to_string(k), "0", "wall_" + std::to_string(k) + ".vtu"});
    }
    writeContent(folder / "wall.pvd", pvd(lines));
}

// Entries of one time are the pieces of a state, each with an index of its own.
void growPieces(const TemporaryFolder& folder, int states) {
    std::vector<std::vector<std::string>> lines;
    for (int k = 0; k < states; ++k) {
        const std::string name = "wall_" + std::to_string(k);
        writeContent(folder / (name + "_0.vtu"), BrickRow{.bricks = {0}, .status = {1}}.vtu());
        writeContent(folder / (name + "_1.vtu"), BrickRow{.bricks = {1}, .status = {k < 2 ? 1 : 0}}.vtu());
        writeContent(folder / (name + ".pvtu"), pvtu({name + "_0.vtu", name + "_1.vtu"}));
        lines.push_back({std::to_string(k), "0", name + ".pvtu"});
    }
    writeContent(folder / "wall.pvd", pvd(lines));
}

void growSeriesFile(const TemporaryFolder& folder, int states) {
    growGrids(folder, states);
    std::string text = R"({"file-series-version":"1.0","files":[)";
    for (int k = 0; k < states; ++k) {
        text +=
            std::string(k > 0 ? "," : "") + R"({"name":"wall_)" + std::to_string(k) + R"(.vtu","time":)" + std::to_string(k) + "}";
    }
    writeContent(folder / "wall.vtu.series", text + "]}");
}

// Two bricks as legacy VTK, with what the converter of OpenRadioss writes if it is asked for.
std::string legacyBricks(int state, bool converted) {
    const std::string alive = "1 " + std::to_string(state < 2 ? 1 : 0);
    const std::string time = std::to_string(state) + ".0";
    return "# vtk DataFile Version 3.0\nsmall\nASCII\nDATASET UNSTRUCTURED_GRID\n" +
           (converted ? "FIELD FieldData 2\nTIME 1 1 double\n" + time + "\nCYCLE 1 1 int\n" + std::to_string(state) + "\n"
                      : "FIELD FieldData 1\nTimeValue 1 1 double\n" + time + "\n") +
           "POINTS 12 float\n0 0 0 0 1 0 0 1 1 0 0 1 1 0 0 1 1 0 1 1 1 1 0 1 2 0 0 2 1 0 2 1 1 2 0 1\n\n"
           "CELLS 2 18\n8 0 4 5 1 3 7 6 2\n8 4 8 9 5 7 11 10 6\n\nCELL_TYPES 2\n12\n12\n\n" +
           (converted ? "POINT_DATA 12\nSCALARS NODE_ID int 1\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8 9 10 11 12\n" : "") +
           "CELL_DATA 2\n" +
           (converted ? "SCALARS ELEMENT_ID int 1\nLOOKUP_TABLE default\n1 2\nSCALARS PART_ID int 1\nLOOKUP_TABLE default\n1 1\n"
                        "SCALARS EROSION_STATUS int 1\nLOOKUP_TABLE default\n" +
                            alive + "\n"
                      : "SCALARS STATUS int 1\nLOOKUP_TABLE default\n" + alive + "\n");
}

void growLegacy(const TemporaryFolder& folder, int states) {
    for (int k = 0; k < states; ++k) {
        writeContent(folder / ("wall_" + std::to_string(k) + ".vtk"), legacyBricks(k, false));
    }
}

void growConverted(const TemporaryFolder& folder, int states) {
    for (int k = 0; k < states; ++k) {
        writeContent(folder / ("RUN_00" + std::to_string(k + 1) + ".vtk"), legacyBricks(k, true));
    }
}

// Of so many bricks that a state takes more room than HDF5 had set aside.
void growVtkHdf(const TemporaryFolder& folder, int states) {
    VtkHdfRows rows{.parts = {{}, {}}};
    for (int x = 0; x < 1000; ++x) {
        rows.parts[x < 500 ? 0 : 1].bricks.push_back(x);
    }
    for (int k = 0; k < states; ++k) {
        rows.status.emplace_back(1000, 1);
        rows.status.back().back() = k < 2 ? 1 : 0;
    }
    replace(folder / "wall.vtkhdf", [&](const std::string& path) { writeVtkHdf(path, rows); });
}

void growProcesses(const TemporaryFolder& folder, int states) {
    writeContent(folder / "wall0.rst", smallRst(states, {.bricks = {1}}));
    writeContent(folder / "wall1.rst", smallRst(states, {.bricks = {2}}));
    writeContent(folder / "wall0.rst.deaths.csv", "element,time\n2,2\n");
}

void growXdmf(const TemporaryFolder& folder, int states) {
    std::string text = "<Xdmf><Domain><Grid GridType=\"Collection\" CollectionType=\"Temporal\">";
    for (int k = 0; k < states; ++k) {
        text +=
            "<Grid><Time Value=\"" + std::to_string(k) +
            "\"/><Topology TopologyType=\"Hexahedron\" NumberOfElements=\"2\"><DataItem Dimensions=\"2 8\" Format=\"XML\">"
            "0 4 5 1 3 7 6 2 4 8 9 5 7 11 10 6</DataItem></Topology><Geometry GeometryType=\"XYZ\"><DataItem Dimensions=\"12 3\" "
            "Format=\"XML\">0 0 0 0 1 0 0 1 1 0 0 1 1 0 0 1 1 0 1 1 1 1 0 1 2 0 0 2 1 0 2 1 1 2 0 1</DataItem></Geometry>"
            "<Attribute Name=\"alive\" Center=\"Cell\"><DataItem Dimensions=\"2\" Format=\"XML\">1 " +
            std::string(k < 2 ? "1" : "0") + "</DataItem></Attribute></Grid>";
    }
    writeContent(folder / "wall.xdmf", text + "</Grid></Domain></Xdmf>");
}

void growCdb(const TemporaryFolder& folder, int states) {
    for (int k = 0; k < states; ++k) {
        writeContent(folder / ("wall_" + std::to_string(k) + ".cdb"), smallCdb(k));
    }
}

void growRst(const TemporaryFolder& folder, int states) {
    writeContent(folder / "wall.rst", smallRst(states));
    writeContent(folder / "wall.rst.deaths.csv", "element,time\n2,2\n");
}

void growMed(const TemporaryFolder& folder, int states) {
    MedRows rows = twoBricksMed();
    std::erase_if(rows.fields, [&](const MedFieldRows& field) { return field.step >= states; });
    replace(folder / "wall.rmed", [&](const std::string& path) { writeMed(path, rows); });
}

void growMpco(const TemporaryFolder& folder, int states) {
    std::vector<MpcoStageRows> stages = twoBricksMpco();
    stages.resize(static_cast<std::size_t>(states) - 1);
    replace(folder / "wall.mpco", [&](const std::string& path) { writeMpco(path, stages); });
}

void growExodus(const TemporaryFolder& folder, int states) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.times = timesUpTo(states);
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return e == 1 && k > 1 ? 0.0 : 1.0; });
    replace(folder / "wall.e", [&](const std::string& path) { builder.write(path); });
}

// A text of one file that ends within its third state.
std::function<void(const TemporaryFolder&, int)> cutAt(const std::string& name, const std::string& whole, std::size_t end) {
    return
        [=](const TemporaryFolder& folder, int states) { writeContent(folder / name, states < 3 ? whole.substr(0, end) : whole); };
}

std::vector<Growing> allGrowing() {
    const std::string fil = smallFil(), frd = smallFrd(), marc = smallMarc(true);
    return {{"Anim", "RUNA001", growAnim, "RUNA003"},
            {"D3plot", "d3plot", growD3plot, "d3plot03"},
            {"Grids", "wall_0.vtu", growGrids, "wall_2.vtu"},
            {"Pvd", "wall.pvd", growPvd, ""},
            {"Pieces", "wall.pvd", growPieces, ""},
            {"SeriesFile", "wall.vtu.series", growSeriesFile, ""},
            {"Legacy", "wall_0.vtk", growLegacy, "wall_2.vtk"},
            {"Converted", "RUN_001.vtk", growConverted, "RUN_003.vtk"},
            {"VtkHdf", "wall.vtkhdf", growVtkHdf, ""},
            {"Processes", "wall0.rst", growProcesses, ""},
            {"Xdmf", "wall.xdmf", growXdmf, ""},
            {"Cdb", "wall_0.cdb", growCdb, "wall_2.cdb"},
            {"Rst", "wall.rst", growRst, ""},
            {"Med", "wall.rmed", growMed, ""},
            {"Mpco", "wall.mpco", growMpco, ""},
            {"Exodus", "wall.e", growExodus, ""},
            {"Fil", "wall.fil", cutAt("wall.fil", fil, fil.size() - 400), ""},
            {"Frd", "wall.frd", cutAt("wall.frd", frd, frd.rfind("  100CL") + 200), ""},
            {"Marc", "wall.t19", cutAt("wall.t19", marc, marc.rfind("=beg=52401")), ""}};
}

class Growth : public testing::TestWithParam<Growing> {
protected:
    std::shared_ptr<const FeResult> open() { return openFe(m_folder / GetParam().opened, {}, {}, Execution{}); }

    TemporaryFolder m_folder;
};

TEST_P(Growth, AStateThatComesIsNoticedAndItsDeathCounted) {
    GetParam().write(m_folder, 2);
    const auto before = open();
    EXPECT_EQ(before->stateCount(), 2u);
    EXPECT_FALSE(hasGrown(*before));
    GetParam().write(m_folder, 3);
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
    GetParam().write(m_folder, 2);
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
    GetParam().write(m_folder, 2);
    writeContent(m_folder / GetParam().last, "");
    const auto before = open();
    EXPECT_EQ(before->stateCount(), 2u);
    GetParam().write(m_folder, 3);
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
