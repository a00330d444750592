#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "io/base/hdf5_handle.h"
#include "io/fe/fe_reader.h"
#include "io/fe/vtk/vtkhdf_reader.h"
#include "io/fe/xdmf/xdmf_reader.h"
#include "tests/io/fe/formats/vtkhdf_builder.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

using ::testing::HasSubstr;

/// Two bricks of which the second dies at the second of two states, in formats that keep their values in HDF5.
class CutTables : public testing::Test {
protected:
    static constexpr int nodes = 12;

    static std::vector<double> places() {
        std::vector<double> values;
        for (int n = 0; n < nodes; ++n) {
            values.insert(values.end(), {double(n % 3), double(n / 3 % 2), double(n / 6)});
        }
        return values;
    }
    static std::vector<int> corners() { return {0, 1, 4, 3, 6, 7, 10, 9, 1, 2, 5, 4, 7, 8, 11, 10}; }

    // Values in a file of tables beside it, or in the text itself.
    static std::string xdmf(const std::string& tables) {
        const auto item = [&](const std::string& name, const std::string& extent, const auto& values) {
            std::string text = "<DataItem Dimensions=\"" + extent + "\" NumberType=\"" +
                               (std::is_same_v<std::decay_t<decltype(values[0])>, double> ? "Float" : "Int") + "\" Format=\"";
            if (!tables.empty()) {
                return text + "HDF\">" + tables + ":/" + name + "</DataItem>";
            }
            text += "XML\">";
            for (const auto value : values) {
                text += std::to_string(value) + " ";
            }
            return text + "</DataItem>";
        };
        std::string text = "<Xdmf><Domain><Grid GridType=\"Collection\" CollectionType=\"Temporal\">";
        for (int k = 0; k < 2; ++k) {
            text += "<Grid><Time Value=\"" + std::to_string(k) +
                    "\"/><Topology TopologyType=\"Hexahedron\" NumberOfElements=\"2\">" + item("corners", "2 8", corners()) +
                    "</Topology><Geometry GeometryType=\"XYZ\">" + item("places", "12 3", places()) +
                    "</Geometry><Attribute Name=\"STATUS\" Center=\"Cell\">" +
                    item("status" + std::to_string(k), "2", std::vector<int>{1, 1 - k}) + "</Attribute></Grid>";
        }
        return text + "</Grid></Domain></Xdmf>";
    }

    static void writeTables(const std::string& path) {
        const Hdf5Handle file = createTables(path);
        putTable(file.get(), "/corners", corners(), 8);
        putTable(file.get(), "/places", places(), 3);
        putTable(file.get(), "/status0", std::vector<int>{1, 1});
        putTable(file.get(), "/status1", std::vector<int>{1, 0});
    }

    using Read = FeResult::Contents (*)(const std::string& path, const ImportSettings& settings, const Execution& execution);

    // Opens what is sound, then with a file cut off at every byte: by its reader alone, since what openFe() does besides takes most
    // of the time.
    void expectRefusalAtEveryByte(const std::string& opened, const std::string& cut, Read read) {
        const auto whole = openFe(opened, {}, {}, Execution{});
        EXPECT_EQ(whole->times(), (std::vector<double>{0.0, 1.0}));
        EXPECT_EQ(whole->activity().activeCount(0), 2u);
        EXPECT_EQ(whole->activity().activeCount(1), 1u);
        ::testing::internal::CaptureStderr();
        for (std::size_t size = std::filesystem::file_size(cut); size-- > 0;) {
            std::filesystem::resize_file(cut, size);
            try {
                read(opened, {}, Execution{});
                ADD_FAILURE() << "read at byte " << size;
            } catch (const Error& error) {
                EXPECT_FALSE(error.remedy().empty()) << error.what();
                EXPECT_THAT(error.what(), HasSubstr(m_folder.path())) << size;
            }
        }
        EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "libraries do not speak to the user";
    }

    TemporaryFolder m_folder;
};

TEST_F(CutTables, VtkHdfIsRefusedAtEveryByte) {
    writeVtkHdf(m_folder / "small.vtkhdf", {.parts = {{.bricks = {0, 1}}}, .status = {{1, 1}, {1, 0}}});
    expectRefusalAtEveryByte(m_folder / "small.vtkhdf", m_folder / "small.vtkhdf", readVtkHdf);
}

TEST_F(CutTables, XdmfIsRefusedAtEveryByteOfItsText) {
    std::ofstream(m_folder / "small.xdmf") << xdmf("");
    expectRefusalAtEveryByte(m_folder / "small.xdmf", m_folder / "small.xdmf", readXdmf);
}

// The text may name a state before its tables are written.
TEST_F(CutTables, ALastStateWithoutItsTablesIsLeftOut) {
    writeTables(m_folder / "small.h5");
    std::ofstream(m_folder / "small.xdmf") << xdmf("small.h5");
    {
        const Hdf5Handle file(H5Fopen((m_folder / "small.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
        ASSERT_GE(H5Ldelete(file.get(), "/status1", H5P_DEFAULT), 0);
    }
    const auto fe = openFe(m_folder / "small.xdmf", {}, {}, Execution{});
    EXPECT_EQ(fe->times(), std::vector<double>{0.0});
    EXPECT_EQ(fe->contents().findings.count("fe.unfinished"), 1);
}

// The tables of a format may end before what its last state has, or lie in a file a state of which the last is cut off.
TEST_F(CutTables, ALastStateWhoseValuesEndTooEarlyIsLeftOut) {
    writeVtkHdf(m_folder / "small.vtkhdf", {.parts = {{.bricks = {0, 1}}}, .status = {{1, 1}, {1, 0}, {1}}});
    const auto grids = openFe(m_folder / "small.vtkhdf", {}, {}, Execution{});
    EXPECT_EQ(grids->times(), (std::vector<double>{0.0, 1.0}));
    EXPECT_EQ(grids->activity().activeCount(1), 1u);
    EXPECT_EQ(grids->contents().findings.count("fe.unfinished"), 1);
    writeTables(m_folder / "small.h5");
    writeTables(m_folder / "last.h5");
    std::string text = xdmf("small.h5");
    text.replace(text.rfind("small.h5"), 8, "last.h5");
    std::ofstream(m_folder / "small.xdmf") << text;
    EXPECT_EQ(openFe(m_folder / "small.xdmf", {}, {}, Execution{})->times(), (std::vector<double>{0.0, 1.0}));
    std::filesystem::resize_file(m_folder / "last.h5", std::filesystem::file_size(m_folder / "last.h5") / 2);
    const auto fe = openFe(m_folder / "small.xdmf", {}, {}, Execution{});
    EXPECT_EQ(fe->times(), std::vector<double>{0.0});
    EXPECT_EQ(fe->contents().findings.count("fe.unfinished"), 1);
}

// Old writers leave out the slash before a table, and a text that was moved still says where its tables were.
TEST_F(CutTables, TablesAreFoundByOtherSpellingsOfTheirPlace) {
    writeTables(m_folder / "small.h5");
    const std::string usual = xdmf("small.h5");
    std::string noSlash = usual;
    for (std::size_t at = 0; (at = noSlash.find(".h5:/", at)) != std::string::npos;) {
        noSlash.erase(at + 4, 1);
    }
    ASSERT_NE(noSlash, usual);
    for (const std::string& text : {usual, noSlash, xdmf("/gone/with/the/machine/small.h5"), xdmf("C:\\runs\\small.h5")}) {
        std::ofstream(m_folder / "small.xdmf") << text;
        const auto fe = openFe(m_folder / "small.xdmf", {}, {}, Execution{});
        EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.0}));
        EXPECT_EQ(fe->activity().activeCount(0), 2u);
        EXPECT_EQ(fe->activity().activeCount(1), 1u);
        EXPECT_EQ(fe->contents().files.size(), 2u);
    }
}

TEST_F(CutTables, XdmfIsRefusedAtEveryByteOfItsTables) {
    writeTables(m_folder / "small.h5");
    std::ofstream(m_folder / "small.xdmf") << xdmf("small.h5");
    expectRefusalAtEveryByte(m_folder / "small.xdmf", m_folder / "small.h5", readXdmf);
}

}  // namespace
}  // namespace rubble::io
