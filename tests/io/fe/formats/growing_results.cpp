#include "tests/io/fe/formats/growing_results.h"

#include <algorithm>
#include <filesystem>

#include "tests/io/fe/d3plot/d3plot_builder.h"
#include "tests/io/fe/formats/small_results.h"
#include "tests/io/fe/formats/vtkhdf_builder.h"
#include "tests/io/fe/med/med_builder.h"
#include "tests/io/fe/opensees/mpco_builder.h"
#include "tests/io/fe/pieces/brick_row.h"
#include "tests/io/fe/radioss/anim_builder.h"
#include "tests/support/exodus_builder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {

namespace {

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

// The files tell of every element whether it is deleted.
void growAnim(const TemporaryFolder& folder, int states, bool) {
    AnimBuilder builder;
    builder.brickDeaths = {{1, 2.0}};
    builder.write(folder.path(), timesUpTo(states));
}

void growD3plot(const TemporaryFolder& folder, int states, bool told) {
    D3plotBuilder builder;
    builder.statesPerFile = 1;
    builder.times = timesUpTo(states);
    builder.deletionOption = told ? 2 : 0;
    if (told) {
        builder.deaths = {{1, 2}};
    }
    builder.write(folder / "d3plot");
}

void growGrids(const TemporaryFolder& folder, int states, bool told) {
    for (int k = 0; k < states; ++k) {
        BrickRow row{.bricks = {0, 1}, .time = static_cast<double>(k)};
        if (told) {
            row.status = {1, k < 2 ? 1 : 0};
        }
        writeContent(folder / ("wall_" + std::to_string(k) + ".vtu"), row.vtu());
    }
}

void growPvd(const TemporaryFolder& folder, int states, bool told) {
    growGrids(folder, states, told);
    std::vector<std::vector<std::string>> lines;
    for (int k = 0; k < states; ++k) {
        lines.push_back({std::to_string(k), "0", "wall_" + std::to_string(k) + ".vtu"});
    }
    writeContent(folder / "wall.pvd", pvd(lines));
}

// Entries of one time are the pieces of a state, each with an index of its own.
void growPieces(const TemporaryFolder& folder, int states, bool told) {
    std::vector<std::vector<std::string>> lines;
    for (int k = 0; k < states; ++k) {
        const std::string name = "wall_" + std::to_string(k);
        BrickRow left{.bricks = {0}, .elements = {1}}, right{.bricks = {1}, .elements = {2}};
        if (told) {
            left.status = {1};
            right.status = {k < 2 ? 1 : 0};
        }
        writeContent(folder / (name + "_0.vtu"), left.vtu());
        writeContent(folder / (name + "_1.vtu"), right.vtu());
        writeContent(folder / (name + ".pvtu"), pvtu({name + "_0.vtu", name + "_1.vtu"}));
        lines.push_back({std::to_string(k), "0", name + ".pvtu"});
    }
    writeContent(folder / "wall.pvd", pvd(lines));
}

void growSeriesFile(const TemporaryFolder& folder, int states, bool told) {
    growGrids(folder, states, told);
    std::string text = R"({"file-series-version":"1.0","files":[)";
    for (int k = 0; k < states; ++k) {
        text +=
            std::string(k > 0 ? "," : "") + R"({"name":"wall_)" + std::to_string(k) + R"(.vtu","time":)" + std::to_string(k) + "}";
    }
    writeContent(folder / "wall.vtu.series", text + "]}");
}

enum class LegacyWriter : std::uint8_t { Plain, Silent, Converter };

// Two bricks as legacy VTK, with a flag or without, or with what the converter of OpenRadioss writes.
std::string legacyBricks(int state, LegacyWriter writer) {
    const bool converted = writer == LegacyWriter::Converter;
    const std::string alive = "1 " + std::to_string(state < 2 ? 1 : 0);
    const std::string time = std::to_string(state) + ".0";
    return "# vtk DataFile Version 3.0\nsmall\nASCII\nDATASET UNSTRUCTURED_GRID\n" +
           (converted ? "FIELD FieldData 2\nTIME 1 1 double\n" + time + "\nCYCLE 1 1 int\n" + std::to_string(state) + "\n"
                      : "FIELD FieldData 1\nTimeValue 1 1 double\n" + time + "\n") +
           "POINTS 12 float\n0 0 0 0 1 0 0 1 1 0 0 1 1 0 0 1 1 0 1 1 1 1 0 1 2 0 0 2 1 0 2 1 1 2 0 1\n\n"
           "CELLS 2 18\n8 0 4 5 1 3 7 6 2\n8 4 8 9 5 7 11 10 6\n\nCELL_TYPES 2\n12\n12\n\n" +
           (converted ? "POINT_DATA 12\nSCALARS NODE_ID int 1\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8 9 10 11 12\n" : "") +
           (writer == LegacyWriter::Silent ? "" : "CELL_DATA 2\n") +
           (writer == LegacyWriter::Silent ? ""
            : converted ? "SCALARS ELEMENT_ID int 1\nLOOKUP_TABLE default\n1 2\nSCALARS PART_ID int 1\nLOOKUP_TABLE default\n1 1\n"
                          "SCALARS EROSION_STATUS int 1\nLOOKUP_TABLE default\n" +
                              alive + "\n"
                        : "SCALARS STATUS int 1\nLOOKUP_TABLE default\n" + alive + "\n");
}

void growLegacy(const TemporaryFolder& folder, int states, bool told) {
    for (int k = 0; k < states; ++k) {
        writeContent(folder / ("wall_" + std::to_string(k) + ".vtk"),
                     legacyBricks(k, told ? LegacyWriter::Plain : LegacyWriter::Silent));
    }
}

void growConverted(const TemporaryFolder& folder, int states, bool) {
    for (int k = 0; k < states; ++k) {
        writeContent(folder / ("RUN_00" + std::to_string(k + 1) + ".vtk"), legacyBricks(k, LegacyWriter::Converter));
    }
}

// Of so many bricks that a state takes more room than HDF5 had set aside.
void growVtkHdf(const TemporaryFolder& folder, int states, bool told) {
    VtkHdfRows rows{.parts = {{}, {}}, .states = states, .recorded = !told};
    rows.parts.resize(told ? 2 : 1);
    for (int x = 0; x < 1000; ++x) {
        rows.parts[told && x >= 500 ? 1 : 0].bricks.push_back(x);
    }
    for (int k = 0; told && k < states; ++k) {
        rows.status.emplace_back(1000, 1);
        rows.status.back().back() = k < 2 ? 1 : 0;
    }
    replace(folder / "wall.vtkhdf", [&](const std::string& path) { writeVtkHdf(path, rows); });
}

// Results of Ansys never tell: their list does.
void growProcesses(const TemporaryFolder& folder, int states, bool told) {
    writeContent(folder / "wall0.rst", smallRst(states, {.bricks = {1}}));
    writeContent(folder / "wall1.rst", smallRst(states, {.bricks = {2}}));
    if (told) {
        writeContent(folder / "wall0.rst.deaths.csv", "element,time\n2,2\n");
    }
}

void growXdmf(const TemporaryFolder& folder, int states, bool told) {
    std::string text = "<Xdmf><Domain><Grid GridType=\"Collection\" CollectionType=\"Temporal\">";
    for (int k = 0; k < states; ++k) {
        text +=
            "<Grid><Time Value=\"" + std::to_string(k) +
            "\"/><Topology TopologyType=\"Hexahedron\" NumberOfElements=\"2\"><DataItem Dimensions=\"2 8\" Format=\"XML\">"
            "0 4 5 1 3 7 6 2 4 8 9 5 7 11 10 6</DataItem></Topology><Geometry GeometryType=\"XYZ\"><DataItem Dimensions=\"12 3\" "
            "Format=\"XML\">0 0 0 0 1 0 0 1 1 0 0 1 1 0 0 1 1 0 1 1 1 1 0 1 2 0 0 2 1 0 2 1 1 2 0 1</DataItem></Geometry>";
        if (told) {
            text += "<Attribute Name=\"alive\" Center=\"Cell\"><DataItem Dimensions=\"2\" Format=\"XML\">1 " +
                    std::string(k < 2 ? "1" : "0") + "</DataItem></Attribute>";
        }
        text += "</Grid>";
    }
    writeContent(folder / "wall.xdmf", text + "</Grid></Domain></Xdmf>");
}

void growCdb(const TemporaryFolder& folder, int states, bool) {
    for (int k = 0; k < states; ++k) {
        writeContent(folder / ("wall_" + std::to_string(k) + ".cdb"), smallCdb(k));
    }
}

// A single one has neither times nor displacements: both come from the list.
void writeOneCdb(const TemporaryFolder& folder, int, bool told) {
    writeContent(folder / "mesh.cdb", smallCdb(0));
    writeContent(folder / "mesh.mac", told ? "TIME,1\nSOLVE\nTIME,2\nEKILL,2\nSOLVE\n" : "");
    if (!told) {
        std::filesystem::remove(folder / "mesh.mac");
    }
}

void growRst(const TemporaryFolder& folder, int states, bool told) {
    writeContent(folder / "wall.rst", smallRst(states));
    if (told) {
        writeContent(folder / "wall.rst.deaths.csv", "element,time\n2,2\n");
    }
}

void growMed(const TemporaryFolder& folder, int states, bool told) {
    MedRows rows = twoBricksMed();
    std::erase_if(rows.fields, [&](const MedFieldRows& field) { return field.step >= states || (!told && field.type != 0); });
    replace(folder / "wall.rmed", [&](const std::string& path) { writeMed(path, rows); });
}

void growMpco(const TemporaryFolder& folder, int states, bool told) {
    std::vector<MpcoStageRows> stages = twoBricksMpco();
    stages.resize(static_cast<std::size_t>(states) - 1);
    stages.back().classes = told ? stages.back().classes : stages.front().classes;
    replace(folder / "wall.mpco", [&](const std::string& path) { writeMpco(path, stages); });
}

void growExodus(const TemporaryFolder& folder, int states, bool told) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.times = timesUpTo(states);
    if (told) {
        builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return e == 1 && k > 1 ? 0.0 : 1.0; });
    }
    replace(folder / "wall.e", [&](const std::string& path) { builder.write(path); });
}

// A text of one file that ends within its third state.
std::function<void(const TemporaryFolder&, int, bool)> cutAt(const std::string& name, const std::string& whole, std::size_t end) {
    return [=](const TemporaryFolder& folder, int states, bool) {
        writeContent(folder / name, states < 3 ? whole.substr(0, end) : whole);
    };
}

void growFil(const TemporaryFolder& folder, int states, bool told) {
    const std::string fil = smallFil(told);
    cutAt("wall.fil", fil, fil.size() - 400)(folder, states, told);
}

}  // namespace

void PrintTo(const Growing& growing, std::ostream* out) {
    *out << growing.name;
}

std::vector<Growing> allGrowing() {
    using enum CutOff;
    const std::string frd = smallFrd(), marc = smallMarc(true);
    const auto growFrd = cutAt("wall.frd", frd, frd.rfind("  100CL") + 200);
    // Without a rewritten mesh the stress is what tells, and that is concluded.
    const auto growMarc = [marc](const TemporaryFolder& folder, int states, bool told) {
        const std::string text = told ? marc : smallMarc(false);
        cutAt("wall.t19", text, text.rfind("=beg=52401"))(folder, states, told);
    };
    return {
        {.name = "Anim", .opened = "RUNA001", .write = growAnim, .last = "RUNA003", .cut = "RUNA003", .mayBeSilent = false},
        {.name = "D3plot",
         .opened = "d3plot",
         .write = growD3plot,
         .last = "d3plot03",
         .cut = "d3plot03",
         .filled = 4 * D3plotBuilder().stateWords(),
         .dying = 102},
        {.name = "Grids", .opened = "wall_0.vtu", .write = growGrids, .last = "wall_2.vtu", .cut = "wall_2.vtu"},
        {.name = "Pvd", .opened = "wall.pvd", .write = growPvd, .cut = "wall_2.vtu"},
        {.name = "Pieces", .opened = "wall.pvd", .write = growPieces, .cut = "wall_2_1.vtu"},
        {.name = "SeriesFile", .opened = "wall.vtu.series", .write = growSeriesFile, .cut = "wall_2.vtu"},
        {.name = "Legacy", .opened = "wall_0.vtk", .write = growLegacy, .last = "wall_2.vtk", .cut = "wall_2.vtk"},
        {.name = "Converted",
         .opened = "RUN_001.vtk",
         .write = growConverted,
         .last = "RUN_003.vtk",
         .cut = "RUN_003.vtk",
         .mayBeSilent = false},
        {.name = "VtkHdf", .opened = "wall.vtkhdf", .write = growVtkHdf, .cut = "wall.vtkhdf", .cutOff = Refused},
        {.name = "Processes",
         .opened = "wall0.rst",
         .write = growProcesses,
         .cut = "wall1.rst",
         .cutOff = LastState,
         .tells = false},
        {.name = "Xdmf", .opened = "wall.xdmf", .write = growXdmf, .cut = "wall.xdmf", .cutOff = Refused},
        {.name = "Cdb", .opened = "wall_0.cdb", .write = growCdb, .last = "wall_2.cdb", .cut = "wall_2.cdb", .mayBeSilent = false},
        {.name = "Rst", .opened = "wall.rst", .write = growRst, .cut = "wall.rst", .cutOff = LastState, .tells = false},
        {.name = "Med", .opened = "wall.rmed", .write = growMed, .cut = "wall.rmed", .cutOff = Refused, .dying = 4, .tells = false},
        {.name = "Mpco", .opened = "wall.mpco", .write = growMpco, .cut = "wall.mpco", .cutOff = Refused},
        {.name = "Exodus", .opened = "wall.e", .write = growExodus, .cut = "wall.e", .cutOff = LastState},
        {.name = "Fil", .opened = "wall.fil", .write = growFil, .cut = "wall.fil", .cutOff = LastState},
        {.name = "Frd", .opened = "wall.frd", .write = growFrd, .cut = "wall.frd", .cutOff = LastState, .tells = false},
        {.name = "Marc", .opened = "wall.t19", .write = growMarc, .cut = "wall.t19", .cutOff = LastState}};
}

Growing oneCdb() {
    return {.name = "OneCdb", .opened = "mesh.cdb", .write = writeOneCdb};
}

}  // namespace rubble::io
