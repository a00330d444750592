#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/small_results.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class ForeignFilesTest : public testing::Test {
protected:
    std::string errorOf(const std::string& name, const std::string& content) {
        writeContent(m_folder / name, content);
        return errorOf(name);
    }

    std::string errorOf(const std::string& name) {
        try {
            openFe(m_folder / name, {}, {}, Execution{});
        } catch (const Error& error) {
            return englishText(error.message()) + " | " + englishText(error.remedy());
        }
        ADD_FAILURE() << name << " was read";
        return {};
    }

    TemporaryFolder m_folder;
};

TEST_F(ForeignFilesTest, FormatsThatAreNotReadAreNamedWithAWayOut) {
    using namespace std::string_literals;
    EXPECT_THAT(errorOf("job.odb", "HKSRD0\0\1\2\3"s), AllOf(HasSubstr("Abaqus"), HasSubstr("odb_to_fil.py")));
    EXPECT_THAT(errorOf("job.op2", "\4\0\0\0\3\0\0\0\4\0\0\0NASTRAN FORT TAPE ID CODE - "s), HasSubstr("Nastran"));
    EXPECT_THAT(errorOf("mesh.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"), HasSubstr("Gmsh"));
    EXPECT_THAT(errorOf("run.case", "FORMAT\ntype: ensight gold\nGEOMETRY\n"), HasSubstr("EnSight"));
    EXPECT_THAT(errorOf("run.unv", "    -1\n   164\n         1\n    -1\n"), HasSubstr("universal"));
    EXPECT_THAT(errorOf("run.res", "GiD Post Results File 1.0\n"), HasSubstr("GiD"));
    EXPECT_THAT(errorOf("run.zip", "PK\3\4 and more"), HasSubstr("Unpack"));
    EXPECT_THAT(errorOf("run.vtu", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n"),
                HasSubstr("git lfs pull"));
    EXPECT_THAT(errorOf("page.vtu", "\n<!DOCTYPE html>\n<html></html>\n"), HasSubstr("web page"));
    EXPECT_THAT(errorOf("notes", "nothing of the sort\n"), HasSubstr("it is a text"));
}

TEST_F(ForeignFilesTest, APipeIsNoResult) {
    ASSERT_EQ(mkfifo((m_folder / "pipe").c_str(), 0600), 0);
    EXPECT_THAT(errorOf("pipe"), HasSubstr("no regular file"));
    writeContent(m_folder / "small.frd", smallFrd());
    EXPECT_EQ(openFe(m_folder.path(), {}, {}, Execution{})->stateCount(), 3u);
}

// Element types stand in a block since 2023; blank lines may come first.
TEST_F(ForeignFilesTest, ACodedDatabaseMayBeginWithBlankLinesAndHaveABlockOfTypes) {
    const std::string text = smallCdb(0);
    const std::size_t type = text.find("ET,");
    ASSERT_NE(type, std::string::npos);
    const std::size_t end = text.find('\n', type) + 1;
    std::string block = text;
    block.replace(type, end - type, "ETBLOCK,        1,        1\n(2i9,19a9)\n        1      185        0        0\n       -1\n");
    for (const std::string& content : {"\n\r\n" + text, block, "\n" + block}) {
        writeContent(m_folder / "wall.cdb", content);
        EXPECT_EQ(openFe(m_folder / "wall.cdb", {}, {}, Execution{})->mesh().elementCount(), 2u) << content.substr(0, 200);
    }
    std::string without = text;
    without.erase(type, end - type);
    EXPECT_THAT(errorOf("wall.cdb", without), HasSubstr("does not say of which types"));
}

std::string emptyOrTwoLines(bool empty) {
    const auto array = [](const char* type, const char* name, const std::string& values, const char* components = "1") {
        return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + components +
               "\" format=\"ascii\">" + values + "</DataArray>";
    };
    return std::string("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"") + (empty ? "0" : "3") +
           "\" NumberOfCells=\"" + (empty ? "0" : "2") + "\"><PointData>" + array("Int64", "GlobalNodeId", empty ? "" : "7 8 9") +
           "</PointData><CellData>" + array("Int64", "GlobalIds", empty ? "" : "1 2") + "</CellData><Points>" +
           array("Float64", "Points", empty ? "" : "0 0 0 1 0 0 2 0 0", "3") + "</Points><Cells>" +
           array("Int64", "connectivity", empty ? "" : "0 1 1 2") + array("Int64", "offsets", empty ? "" : "2 4") +
           array("UInt8", "types", empty ? "" : "3 3") + "</Cells></Piece></UnstructuredGrid></VTKFile>";
}

// Writers that leave out what nobody uses leave nothing once all has gone.
TEST_F(ForeignFilesTest, AStateWithoutPointsHasLostEverything) {
    for (int k = 0; k < 3; ++k) {
        writeContent(m_folder / ("s" + std::to_string(k) + ".vtu"), emptyOrTwoLines(k == 2));
    }
    const auto fe = openFe(m_folder / "s0.vtu", {}, {}, Execution{});
    ASSERT_EQ(fe->stateCount(), 3u);
    EXPECT_EQ(fe->activity().activeCount(1), 2u);
    EXPECT_EQ(fe->activity().activeCount(2), 0u);
    EXPECT_EQ(fe->state(2)->positions, fe->mesh().nodes);
}

}  // namespace
}  // namespace rubble::io
