#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "core/base/error.h"
#include "io/exports/exports.h"
#include "io/fe/vtk/hdf5_table.h"
#include "tests/io/run_over_fe.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;

/// A run with an island, written by both kinds.
class VtkHdfExport : public testing::Test {
protected:
    VtkHdfExport() {
        const std::size_t first = m_run.description.fragments->size();
        BodyRecord& body = m_run.bodies.back();
        body.cluster = noCluster;
        body.from = 0.6;
        m_run.islands.push_back({body.body, 6, body.atBirth, {idAt<ElementIndex>(first), idAt<ElementIndex>(first + 1)}});
        m_run.feed(*createRun(m_folder / "a.run.h5", m_run.origin));
        m_reader = openRun(m_folder / "a.run.h5");
        exportVtkHdf(m_path, *m_reader, *m_fe, Execution());
        exportSeries(m_folder / "a.pvd", *m_reader, *m_fe, Execution());
        pugi::xml_document index;
        index.load_file((m_folder / "a.pvd").c_str());
        for (const pugi::xml_node set : index.child("VTKFile").child("Collection")) {
            m_series[set.attribute("timestep").as_double()].emplace_back(set.attribute("part").as_int(),
                                                                         m_folder / set.attribute("file").value());
        }
    }

    /// One step as VTK's reader has it: the packaged one knows no time and takes the steps for pieces.
    vtkSmartPointer<vtkUnstructuredGrid> step(std::size_t s) const {
        vtkNew<vtkHDFReader> reader;
        // It says that the file's version is newer than itself.
        vtkObject::GlobalWarningDisplayOff();
        reader->SetFileName(m_path.c_str());
        reader->UpdatePiece(static_cast<int>(s), static_cast<int>(m_series.size()), 0);
        vtkObject::GlobalWarningDisplayOn();
        return vtkUnstructuredGrid::SafeDownCast(reader->GetOutput());
    }

    const TemporaryFolder m_folder;
    const std::string m_path = m_folder / "a.vtkhdf";
    std::shared_ptr<const FeResult> m_fe;
    SampleRun m_run = runOverFe(21, 40, m_fe);
    std::shared_ptr<RunReader> m_reader;
    std::map<double, std::vector<std::pair<int, std::string>>> m_series;  // parts of each instant
};

double value(vtkUnstructuredGrid& grid, const char* array, vtkIdType cell) {
    return grid.GetCellData()->GetArray(array)->GetTuple1(cell);
}

// Cell `at` of a step against cell `c` of a part of the series.
void expectCell(vtkUnstructuredGrid& step, vtkIdType at, vtkUnstructuredGrid& part, vtkIdType c, int number) {
    ASSERT_EQ(step.GetCellType(at), part.GetCellType(c));
    vtkPoints* points = step.GetCell(at)->GetPoints();
    const vtkIdType corners = points->GetNumberOfPoints();
    ASSERT_EQ(corners, part.GetCell(c)->GetNumberOfPoints());
    for (vtkIdType p = 0; p < corners; ++p) {
        std::array<double, 3> place{};
        points->GetPoint(p, place.data());
        const double* other = part.GetCell(c)->GetPoints()->GetPoint(p);
        EXPECT_TRUE(std::equal(place.begin(), place.end(), other)) << "cell " << at << " corner " << p;
    }
    EXPECT_EQ(value(step, "part", at), number);
    for (const char* array : {"element_id", "component"}) {
        EXPECT_EQ(value(step, array, at), value(part, array, c)) << array;
    }
    for (const char* array : {"fragment_id", "cluster_id"}) {
        EXPECT_EQ(value(step, array, at), number == 0 ? value(part, array, c) : -1.0) << array;
    }
    if (number == 0) {
        EXPECT_EQ(value(step, "speed", at), value(part, "speed", c));
    } else {
        EXPECT_TRUE(std::isnan(value(step, "speed", at)));
    }
}

TEST_F(VtkHdfExport, VtkFindsEveryStepAsTheSeriesHasIt) {
    ASSERT_GE(m_series.size(), 7u + 8u);
    std::size_t s = 0, released = 0;
    for (const auto& [time, parts] : m_series) {
        const auto grid = step(s++);
        ASSERT_NE(grid, nullptr);
        expectFragments(*grid, m_run, *m_reader, time);
        vtkIdType cell = 0;
        for (const auto& [number, file] : parts) {
            vtkNew<vtkXMLUnstructuredGridReader> reader;
            reader->SetFileName(file.c_str());
            reader->Update();
            vtkUnstructuredGrid& part = *reader->GetOutput();
            ASSERT_LE(cell + part.GetNumberOfCells(), grid->GetNumberOfCells());
            for (vtkIdType c = 0; c < part.GetNumberOfCells(); ++c) {
                expectCell(*grid, cell++, part, c, number);
            }
            released += number == 2;
        }
        EXPECT_EQ(cell, grid->GetNumberOfCells()) << time;
    }
    EXPECT_GE(released, 9u);
}

TEST_F(VtkHdfExport, NamesOfComponentsAndPartsGoWithIt) {
    const auto grid = step(0);
    const auto names = [&](const char* array) {
        std::vector<std::string> texts;
        const auto strings = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(array));
        for (vtkIdType i = 0; strings != nullptr && i < strings->GetNumberOfValues(); ++i) {
            texts.push_back(strings->GetValue(i));
        }
        return texts;
    };
    EXPECT_EQ(names("component_names"), m_reader->componentNames());
    EXPECT_THAT(names("part_names"), testing::ElementsAre("fragments", "structure", "released"));
    std::ifstream in(m_path + ".provenance.json");
    EXPECT_EQ(nlohmann::json::parse(in)["trajectory_hash"], m_run.result.trajectoryHash.hex());
}

// "VTKHDF format specification", Temporal Data: what readers with time rest on.
TEST_F(VtkHdfExport, StepsKeepTheRulesOfTheFormat) {
    const Hdf5Table file(m_path);
    const std::string root = "/VTKHDF";
    EXPECT_EQ(file.text(root, "Type"), "UnstructuredGrid");
    EXPECT_EQ(file.number(root, "Version"), 2);
    const std::uint64_t steps = m_series.size();
    EXPECT_EQ(file.number(root + "/Steps", "NSteps"), static_cast<std::int64_t>(steps));
    const auto list = [&](const std::string& name) {
        const std::string full = root + "/" + name;
        EXPECT_EQ(file.shape(full).rows, steps) << name;
        return file.integers(full, 0, steps);
    };
    const std::vector<double> times = file.reals(root + "/Steps/Values", 0, steps);
    const auto points = list("NumberOfPoints"), cells = list("NumberOfCells"), entries = list("NumberOfConnectivityIds");
    const auto partOffsets = list("Steps/PartOffsets"), partCounts = list("Steps/NumberOfParts");
    const auto pointOffsets = list("Steps/PointOffsets"), cellOffsets = list("Steps/CellOffsets");
    const auto entryOffsets = list("Steps/ConnectivityIdOffsets");
    const std::vector<std::string> arrays = file.tablesIn(root + "/CellData");
    EXPECT_EQ(arrays, file.tablesIn(root + "/Steps/CellDataOffsets"));
    EXPECT_THAT(arrays, testing::ElementsAre("cluster_id", "component", "element_id", "fragment_id", "part", "speed"));
    std::int64_t point = 0, cell = 0, entry = 0;
    auto instant = m_series.begin();
    for (std::size_t s = 0; s < steps; ++s, ++instant) {
        EXPECT_EQ(times[s], instant->first);
        EXPECT_EQ(partOffsets[s], static_cast<std::int64_t>(s));
        EXPECT_EQ(partCounts[s], 1);
        EXPECT_EQ(pointOffsets[s], point);
        EXPECT_EQ(cellOffsets[s], cell);
        EXPECT_EQ(entryOffsets[s], entry);
        for (const std::string& array : arrays) {
            EXPECT_EQ(list("Steps/CellDataOffsets/" + array)[s], cell) << array;
        }
        const auto offsets =
            file.integers(root + "/Offsets", static_cast<std::uint64_t>(cell) + s, static_cast<std::uint64_t>(cells[s]) + 1);
        EXPECT_EQ(offsets.front(), 0);
        EXPECT_EQ(offsets.back(), entries[s]);
        EXPECT_TRUE(std::is_sorted(offsets.begin(), offsets.end()));
        const auto corners =
            file.integers(root + "/Connectivity", static_cast<std::uint64_t>(entry), static_cast<std::uint64_t>(entries[s]));
        EXPECT_GE(*std::min_element(corners.begin(), corners.end()), 0);
        EXPECT_EQ(*std::max_element(corners.begin(), corners.end()), points[s] - 1) << "every point is a corner of a cell";
        point += points[s];
        cell += cells[s];
        entry += entries[s];
    }
    const auto rows = [&](const std::string& name) { return static_cast<std::int64_t>(file.shape(root + "/" + name).rows); };
    EXPECT_EQ(rows("Points"), point);
    EXPECT_EQ(file.shape(root + "/Points").columns, 3u);
    EXPECT_EQ(rows("Connectivity"), entry);
    EXPECT_EQ(rows("Types"), cell);
    EXPECT_EQ(rows("Offsets"), cell + static_cast<std::int64_t>(steps));
    for (const std::string& array : arrays) {
        EXPECT_EQ(rows("CellData/" + array), cell) << array;
    }
    for (const char* names : {"component_names", "part_names"}) {
        const auto sizes = file.integers(root + "/Steps/FieldDataSizes/" + names, 0, steps);
        ASSERT_EQ(sizes.size(), 2 * steps) << "components and tuples of each step";
        EXPECT_EQ(sizes[0], 1);
        EXPECT_EQ(sizes[1], static_cast<std::int64_t>(std::string(names) == "part_names" ? 3 : m_reader->componentNames().size()));
        EXPECT_EQ(list(std::string("Steps/FieldDataOffsets/") + names), std::vector<std::int64_t>(steps, 0));
    }
}

TEST_F(VtkHdfExport, ACancelKeepsWhatWasThere) {
    const auto before = fs::file_size(m_path);
    const Execution execution;
    const auto cancelling = makeFe(m_run, 5, 7, [&execution](std::size_t state) {
        if (state == 3) {
            execution.cancel();
        }
    });
    EXPECT_THROW(exportVtkHdf(m_path, *m_reader, *cancelling, execution), Cancelled);
    EXPECT_EQ(fs::file_size(m_path), before);
    EXPECT_EQ(step(0)->GetNumberOfCells(), static_cast<vtkIdType>(m_fe->mesh().elementCount()));
    for (const auto& entry : fs::directory_iterator(m_folder.path())) {
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
    }
}

TEST_F(VtkHdfExport, AFullDiskOrNoFolderIsSaidAndLeavesNothing) {
    const auto saidOf = [&](const std::string& path) -> std::string {
        try {
            exportVtkHdf(path, *m_reader, *m_fe, Execution());
        } catch (const WorldError& error) {
            return englishText(error.message());
        }
        return {};
    };
    {
        const FileSizeLimit limit(100'000);
        EXPECT_THAT(saidOf(m_folder / "full.vtkhdf"), testing::AllOf(testing::HasSubstr("full.vtkhdf: File too large")));
    }
    EXPECT_THAT(saidOf(m_folder / "no/folder/f.vtkhdf"), testing::HasSubstr("f.vtkhdf: No such file or directory"));
    for (const auto& entry : fs::directory_iterator(m_folder.path())) {
        EXPECT_THAT(entry.path().filename().string(), testing::Not(testing::HasSubstr("full"))) << "nothing is left";
    }
    // The library goes on working.
    exportVtkHdf(m_folder / "after.vtkhdf", *m_reader, *m_fe, Execution());
    EXPECT_EQ(fs::file_size(m_folder / "after.vtkhdf"), fs::file_size(m_path));
}

TEST_F(VtkHdfExport, TheFeFileOfAnotherRunIsRefused) {
    const SampleRun smaller = makeSampleRun(16, 2, 4);
    EXPECT_THROW(exportVtkHdf(m_folder / "b.vtkhdf", *m_reader, *makeFe(smaller, 0, 7), Execution()), UsageError);
    EXPECT_FALSE(fs::exists(m_folder / "b.vtkhdf"));
}

}  // namespace
}  // namespace rubble::io
