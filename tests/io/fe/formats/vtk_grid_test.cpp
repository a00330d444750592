#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "core/base/error.h"
#include "io/fe/vtk/grid_file.h"
#include "io/fe/vtk/vtk_reader.h"
#include "tests/support/run_tests.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::HasSubstr;

template <class Array>
void addArray(vtkFieldData* data, const char* name, int components, vtkIdType tuples) {
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
    for (vtkIdType i = 0; i < tuples * components; ++i) {
        array->SetValue(i, static_cast<typename Array::ValueType>(1 + i % 100));
    }
    data->AddArray(array);
}

/// One cell of every kind that a structure is made of, over 40 points, with arrays of many types.
vtkSmartPointer<vtkUnstructuredGrid> everyKind() {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int p = 0; p < 40; ++p) {
        points->InsertNextPoint(p % 4 + 1e-7 * p, p / 4 % 3, p / 12 + 0.1);
    }
    grid->SetPoints(points);
    const std::vector<std::pair<int, std::vector<vtkIdType>>> cells{{12, {0, 1, 5, 4, 12, 13, 17, 16}},
                                                                    {10, {1, 2, 5, 13}},
                                                                    {13, {2, 3, 6, 14, 15, 18}},
                                                                    {14, {0, 1, 5, 4, 13}},
                                                                    {9, {2, 3, 7, 6}},
                                                                    {5, {20, 21, 25}},
                                                                    {3, {30, 31}}};
    for (const auto& [type, corners] : cells) {
        grid->InsertNextCell(type, static_cast<vtkIdType>(corners.size()), corners.data());
    }
    addArray<vtkDoubleArray>(grid->GetPointData(), "displacement", 3, 40);
    addArray<vtkFloatArray>(grid->GetPointData(), "pressure of pores", 1, 40);
    addArray<vtkIntArray>(grid->GetPointData(), "NODE_ID", 1, 40);
    addArray<vtkUnsignedCharArray>(grid->GetCellData(), "STATUS", 1, 7);
    addArray<vtkIdTypeArray>(grid->GetCellData(), "ELEMENT_ID", 1, 7);
    addArray<vtkFloatArray>(grid->GetCellData(), "stress", 6, 7);
    vtkNew<vtkDoubleArray> time;
    time->SetName("TimeValue");
    time->InsertNextValue(0.1);
    grid->GetFieldData()->AddArray(time);
    return grid;
}

void expectSameArrays(vtkFieldData* expected, const std::vector<GridArray>& found) {
    ASSERT_EQ(found.size(), static_cast<std::size_t>(expected->GetNumberOfArrays()));
    for (int a = 0; a < expected->GetNumberOfArrays(); ++a) {
        vtkDataArray* const array = expected->GetArray(a);
        const GridArray* const ours = findArray(found, array->GetName());
        ASSERT_NE(ours, nullptr) << array->GetName();
        ASSERT_EQ(ours->components, static_cast<std::size_t>(array->GetNumberOfComponents()));
        ASSERT_EQ(ours->values.size(), static_cast<std::size_t>(array->GetNumberOfValues())) << array->GetName();
        for (std::size_t i = 0; i < ours->values.size(); ++i) {
            const auto c = static_cast<int>(i % ours->components);
            ASSERT_EQ(ours->values[i], array->GetComponent(static_cast<vtkIdType>(i / ours->components), c)) << array->GetName();
        }
    }
}

// @param precision  of places: VTK writes six digits into legacy text
void expectSame(vtkUnstructuredGrid* expected, const Grid& found, double precision) {
    ASSERT_EQ(found.points.size(), static_cast<std::size_t>(expected->GetNumberOfPoints()));
    for (std::size_t p = 0; p < found.points.size(); ++p) {
        const double* const place = expected->GetPoint(static_cast<vtkIdType>(p));
        ASSERT_NEAR((found.points[p] - Vec3(place[0], place[1], place[2])).norm(), 0.0, precision);
    }
    ASSERT_EQ(found.cellCount(), static_cast<std::size_t>(expected->GetNumberOfCells()));
    ASSERT_EQ(found.offsets.size(), found.cellCount() + 1);
    for (std::size_t c = 0; c < found.cellCount(); ++c) {
        EXPECT_EQ(found.types[c], expected->GetCellType(static_cast<vtkIdType>(c)));
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        expected->GetCells()->GetCellAtId(static_cast<vtkIdType>(c), count, corners);
        const auto first = found.connectivity.begin() + found.offsets[c];
        EXPECT_EQ(std::vector<std::int64_t>(first, found.connectivity.begin() + found.offsets[c + 1]),
                  std::vector<std::int64_t>(corners, corners + count));
    }
    expectSameArrays(expected->GetPointData(), found.pointData);
    expectSameArrays(expected->GetCellData(), found.cellData);
    ASSERT_TRUE(found.time.has_value());
    EXPECT_EQ(*found.time, 0.1);
}

/// One way of VTK's writers to lay a grid down.
struct Way {
    std::string name;
    std::string file;
    std::function<void(vtkUnstructuredGrid* grid, const std::string& path)> write;
};

void PrintTo(const Way& way, std::ostream* out) {
    *out << way.name;
}

std::vector<Way> ways() {
    using Writer = vtkXMLUnstructuredGridWriter;
    std::vector<Way> list;
    for (const int packing : {Writer::NONE, Writer::ZLIB, Writer::LZ4, Writer::LZMA}) {
        for (int mode = Writer::Ascii; mode <= Writer::Appended + 1; ++mode) {
            for (const bool wide : {false, true}) {
                // Both byte orders, without doubling the rest.
                const bool big = wide == (mode == Writer::Appended);
                const std::string name = "Xml" + std::to_string(packing) + std::to_string(mode) + (wide ? "Wide" : "Narrow");
                list.push_back({name, "grid.vtu", [=](vtkUnstructuredGrid* grid, const std::string& path) {
                                    vtkNew<Writer> writer;
                                    writer->SetInputData(grid);
                                    writer->SetFileName(path.c_str());
                                    writer->SetDataMode(std::min(mode, static_cast<int>(Writer::Appended)));
                                    writer->SetEncodeAppendedData(mode > Writer::Appended);
                                    writer->SetCompressorType(packing);
                                    if (packing != Writer::NONE) {
                                        // Its default takes 64 MB for each block, to write and to read.
                                        writer->SetCompressionLevel(1);
                                    }
                                    wide ? writer->SetHeaderTypeToUInt64() : writer->SetHeaderTypeToUInt32();
                                    big ? writer->SetByteOrderToBigEndian() : writer->SetByteOrderToLittleEndian();
                                    // Several blocks an array, the last one smaller.
                                    writer->SetBlockSize(200);
                                    writer->Write();
                                }});
            }
        }
    }
    for (const bool binary : {false, true}) {
        for (const int version : {42, 51}) {
            list.push_back({std::string("Legacy") + (binary ? "Binary" : "Text") + std::to_string(version), "grid.vtk",
                            [=](vtkUnstructuredGrid* grid, const std::string& path) {
                                vtkNew<vtkUnstructuredGridWriter> writer;
                                writer->SetInputData(grid);
                                writer->SetFileName(path.c_str());
                                writer->SetFileVersion(version);
                                binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
                                writer->Write();
                            }});
        }
    }
    return list;
}

class VtkGridFile : public testing::TestWithParam<Way> {
protected:
    VtkGridFile() : m_path(m_folder / GetParam().file) { GetParam().write(m_grid, m_path); }

    TemporaryFolder m_folder;
    std::string m_path;
    vtkSmartPointer<vtkUnstructuredGrid> m_grid = everyKind();
};

TEST_P(VtkGridFile, HoldsWhatVtkWrote) {
    GridSelection everything;
    everything.everything = true;
    expectSame(m_grid, readGridFile(m_path, everything), GetParam().name.starts_with("LegacyText") ? 1e-5 : 1e-12);
    EXPECT_EQ(timeOfGridFile(m_path), 0.1);
}

TEST_P(VtkGridFile, GivesOnlyWhatIsAskedFor) {
    GridSelection selection;
    selection.points = false;
    selection.cells = false;
    selection.cellArrays = {"STATUS"};
    const Grid grid = readGridFile(m_path, selection);
    EXPECT_TRUE(grid.points.empty());
    EXPECT_TRUE(grid.types.empty());
    ASSERT_NE(findArray(grid.cellData, "STATUS"), nullptr);
    EXPECT_EQ(findArray(grid.cellData, "STATUS")->values.size(), 7u);
    ASSERT_NE(findArray(grid.pointData, "displacement"), nullptr);
    EXPECT_TRUE(findArray(grid.pointData, "displacement")->values.empty());
}

TEST_P(VtkGridFile, CutOffAtEveryByteItIsReadOrRefused) {
    const std::string bytes = wholeFile(m_path);
    const bool legacy = GetParam().file.ends_with(".vtk");
    // Legacy files end with their last array: what is cut off behind a section cannot be seen.
    const std::size_t whole = legacy ? bytes.size() : bytes.rfind("</VTKFile>") + 10;
    GridSelection everything;
    everything.everything = true;
    // Every byte with the whole tests, else every fifth.
    const std::size_t stride = sizedTo<std::size_t>(5, 1);
    for (std::size_t length = bytes.size() - 1; length >= stride; length -= stride) {
        std::filesystem::resize_file(m_path, length);
        try {
            readGridFile(m_path, everything);
            EXPECT_TRUE(legacy || length >= whole) << length;
        } catch (const Error& error) {
            EXPECT_LT(length, whole);
            ASSERT_FALSE(error.remedy().empty()) << error.what();
            ASSERT_THAT(error.what(), HasSubstr(m_path)) << length;
        }
    }
}

TEST_P(VtkGridFile, EveryByteMayBeWrong) {
    const std::string bytes = wholeFile(m_path);
    for (std::size_t i = 0; i < bytes.size(); i += sizedTo<std::size_t>(35, 7)) {
        std::fstream file(m_path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(static_cast<std::streamoff>(i));
        file.put(static_cast<char>(bytes[i] ^ (1 << i % 8)));
        file.close();
        try {
            const FeResult fe(readVtk(m_path, {}, Execution{}));
            fe.state(0);
        } catch (const Error& error) {
            ASSERT_THAT(error.what(), HasSubstr(m_folder.path())) << i;
        }
        std::ofstream(m_path, std::ios::binary | std::ios::trunc) << bytes;
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, VtkGridFile, testing::ValuesIn(ways()),
                         [](const testing::TestParamInfo<Way>& way) { return way.param.name; });

class GridSizes : public testing::Test {
protected:
    std::string errorOf(const std::string& file, const std::string& text) {
        std::ofstream(m_folder / file, std::ios::binary) << text;
        GridSelection everything;
        everything.everything = true;
        try {
            readGridFile(m_folder / file, everything);
        } catch (const ParseError& error) {
            return error.what();
        }
        return "";
    }

    TemporaryFolder m_folder;
};

// Counts are held against the file before memory is taken.
TEST_F(GridSizes, LargerThanTheFileAreRefused) {
    const std::string head = "# vtk DataFile Version 3.0\nsmall\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    const std::string bytes = "# vtk DataFile Version 3.0\nsmall\nBINARY\nDATASET UNSTRUCTURED_GRID\n";
    for (const std::string count : {"1000", "9000000000", "6148914691236517206", "18446744073709551615"}) {
        EXPECT_THAT(errorOf("points.vtk", head + "POINTS " + count + " double\n0 0 0\n"), HasSubstr("within the points")) << count;
        EXPECT_THAT(errorOf("points.vtk", bytes + "POINTS " + count + " double\n0 0 0\n"), HasSubstr("within the points")) << count;
        EXPECT_THAT(errorOf("cells.vtk", head + "POINTS 1 double\n0 0 0\nCELLS " + count + " " + count + "\n1 0\n"),
                    HasSubstr("within the cells"))
            << count;
        EXPECT_THAT(errorOf("field.vtk", head + "FIELD f 1\nTimeValue " + count + " " + count + " double\n1\n"),
                    HasSubstr("within TimeValue"))
            << count;
    }
    EXPECT_THAT(errorOf("points.vtk", head + "POINTS 99999999999999999999 double\n"), HasSubstr("is no number of points"));
    const auto xml = [](const std::string& counts, const std::string& array) {
        return "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
               "compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid><Piece " +
               counts + "><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" " + array +
               "</DataArray></Points><Cells/></Piece></UnstructuredGrid></VTKFile>";
    };
    const std::string huge = "NumberOfPoints=\"9223372036854775807\" NumberOfCells=\"0\"";
    EXPECT_THAT(errorOf("a.vtu", xml(huge, "format=\"ascii\">0 0 0")), HasSubstr("3 values instead of 9223372036854775807"));
    EXPECT_THAT(errorOf("a.vtu", xml("NumberOfPoints=\"-1\"", "format=\"ascii\">")), HasSubstr("NumberOfPoints"));
    // Blocks: 2^40 of them, of 2^40 bytes.
    EXPECT_THAT(errorOf("a.vtu", xml(huge, "format=\"binary\">AAAAAAABAAAAAAAAAAEAAAAAAAAAAAAA")), HasSubstr("blocks of"));
    // One block of 2^31 - 1 bytes, packed into 8.
    EXPECT_THAT(errorOf("a.vtu", xml(huge, "format=\"binary\">AQAAAAAAAAD///9/AAAAAAAAAAAAAAAACAAAAAAAAAA=AAAAAAAAAAA=")),
                HasSubstr("2147483647 bytes"));
}

}  // namespace
}  // namespace rubble::io
