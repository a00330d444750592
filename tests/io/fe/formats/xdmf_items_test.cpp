#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/vtkhdf_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// How the values of one grid of XDMF stand in the text or beside it.
class XdmfItemsTest : public testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const std::string& grid) {
        writeContent(m_folder / "wall.xdmf", "<Xdmf><Domain><Grid>" + grid + "</Grid></Domain></Xdmf>");
        return openFe(m_folder / "wall.xdmf", {}, {}, Execution{});
    }
    std::string errorOf(const std::string& grid) {
        try {
            open(grid);
        } catch (const Error& error) {
            EXPECT_FALSE(error.remedy().empty());
            return error.what();
        }
        ADD_FAILURE() << grid << " was read";
        return {};
    }
    static std::vector<ElementShape> shapesOf(const FeResult& fe) { return fe.mesh().shapes; }

    TemporaryFolder m_folder;
};

std::string textItem(const std::string& dimensions, const std::string& values) {
    return "<DataItem Dimensions=\"" + dimensions + "\" Format=\"XML\">" + values + "</DataItem>";
}

std::string cells(const std::string& type, const std::string& item, const std::string& more = "") {
    return "<Topology TopologyType=\"" + type + "\" " + more + ">" + item + "</Topology>";
}

std::string points(const std::string& item, const std::string& type = "XYZ") {
    return "<Geometry GeometryType=\"" + type + "\">" + item + "</Geometry>";
}

/// Thirty points: 5 by 3 by 2.
std::string manyPoints() {
    std::string text;
    for (int n = 0; n < 30; ++n) {
        text += std::to_string(n % 5) + " " + std::to_string(n / 5 % 3) + " " + std::to_string(n / 15) + "\n";
    }
    return points(textItem("30 3", text));
}

std::string countedUpTo(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += std::to_string(i) + " ";
    }
    return text;
}

TEST_F(XdmfItemsTest, EveryTopologyIsKnownByItsName) {
    using enum ElementShape;
    const std::vector<std::pair<std::string, std::pair<int, ElementShape>>> all{{"Triangle", {3, Triangle}},
                                                                                {"Quadrilateral", {4, Quadrilateral}},
                                                                                {"Tetrahedron", {4, Tetrahedron}},
                                                                                {"Pyramid", {5, Pyramid}},
                                                                                {"Wedge", {6, Wedge}},
                                                                                {"Hexahedron", {8, Hexahedron}},
                                                                                {"Edge_3", {3, Beam}},
                                                                                {"Triangle_6", {6, Triangle}},
                                                                                {"Tri_6", {6, Triangle}},
                                                                                {"Quadrilateral_8", {8, Quadrilateral}},
                                                                                {"Quad_8", {8, Quadrilateral}},
                                                                                {"Quadrilateral_9", {9, Quadrilateral}},
                                                                                {"Tetrahedron_10", {10, Tetrahedron}},
                                                                                {"Tet_10", {10, Tetrahedron}},
                                                                                {"Pyramid_13", {13, Pyramid}},
                                                                                {"Wedge_15", {15, Wedge}},
                                                                                {"Wedge_18", {18, Wedge}},
                                                                                {"Hexahedron_20", {20, Hexahedron}},
                                                                                {"Hex_20", {20, Hexahedron}},
                                                                                {"Hexahedron_24", {24, Hexahedron}},
                                                                                {"HEXAHEDRON_27", {27, Hexahedron}}};
    for (const auto& [name, cell] : all) {
        const auto& [corners, shape] = cell;
        const std::string item = textItem("1 " + std::to_string(corners), countedUpTo(corners));
        EXPECT_THAT(shapesOf(*open(cells(name, item) + manyPoints())), ElementsAre(shape)) << name;
    }
    // Older texts say Type.
    EXPECT_THAT(shapesOf(*open("<Topology Type=\"Wedge\">" + textItem("6", countedUpTo(6)) + "</Topology>" + manyPoints())),
                ElementsAre(Wedge));
    EXPECT_THAT(shapesOf(*open(cells("Polyline", textItem("2 2", "0 1 1 2"), "NodesPerElement=\"2\"") + manyPoints())),
                ElementsAre(Beam, Beam));
    EXPECT_THAT(shapesOf(*open(cells("Polyline", textItem("1 3", "0 1 2"), "NodesPerElement=\"3\"") + manyPoints())),
                ElementsAre(Beam, Beam));
    EXPECT_THAT(shapesOf(*open(cells("Polygon", textItem("1 5", "0 1 6 10 5"), "NodesPerElement=\"5\"") + manyPoints())),
                ElementsAre(Quadrilateral, Triangle));
    EXPECT_THAT(errorOf(cells("3DRectMesh", textItem("1", "0")) + manyPoints()), HasSubstr("topology of type 3drectmesh"));
    EXPECT_THAT(errorOf("<Topology>" + textItem("1", "0") + "</Topology>" + manyPoints()), HasSubstr("topology of type (none)"));
}

TEST_F(XdmfItemsTest, AMixedTopologyHasACodeBeforeEachCell) {
    using enum ElementShape;
    const std::string values =
        "1 2 28 29 "                // two vertices, which are no structure
        "2 2 0 1 2 3 1 2 3 "        // lines of two and of three nodes
        "3 5 0 1 6 10 5 "           // a polygon
        "4 0 1 5 5 0 1 6 5 "        // triangle, quadrilateral
        "6 0 1 5 15 7 0 1 6 5 15 "  // tetrahedron, pyramid
        "8 0 1 5 15 16 20 9 1 2 7 6 16 17 22 21 "
        "16 6 4 2 3 8 7 4 17 18 23 22 4 2 3 18 17 4 3 8 23 18 4 8 7 22 23 4 7 2 17 22 "  // a polyhedron: a brick
        "34 0 2 1 36 0 2 10 1 6 5 37 0 2 12 10 1 7 11 5 ";
    const auto count = std::count(values.begin(), values.end(), ' ');
    const auto fe = open(cells("Mixed", textItem(std::to_string(count), values), "NumberOfElements=\"13\"") + manyPoints());
    EXPECT_THAT(shapesOf(*fe), ElementsAre(Beam, Beam, Beam, Quadrilateral, Triangle, Triangle, Quadrilateral, Tetrahedron, Pyramid,
                                           Wedge, Hexahedron, Hexahedron, Beam, Triangle, Quadrilateral));
    EXPECT_EQ(fe->contents().findings.count("vtk.skipped_cell"), 1);
    EXPECT_THAT(errorOf(cells("Mixed", textItem("4", "9 0 1 2")) + manyPoints()), HasSubstr("ends inside a cell"));
    EXPECT_THAT(errorOf(cells("Mixed", textItem("2", "3 -1")) + manyPoints()), HasSubstr("ends inside a cell"));
    EXPECT_THAT(errorOf(cells("Mixed", textItem("5", "16 6 4 0 1")) + manyPoints()), HasSubstr("ends inside a polyhedron"));
    EXPECT_THAT(errorOf(cells("Mixed", textItem("6", "4 0 1 5 99 0")) + manyPoints()), HasSubstr("cell type 99 at entry 4"));
}

TEST_F(XdmfItemsTest, PointsInAPlaneHaveNoHeight) {
    const std::string square = points(textItem("4 2", "0 0 1 0 1 2 0 2"), "XY");
    const auto fe = open(cells("Quadrilateral", textItem("1 4", "0 1 2 3")) + square);
    ASSERT_EQ(fe->mesh().nodeCount(), 4u);
    EXPECT_EQ(fe->mesh().nodes[2], Vec3(1.0, 2.0, 0.0));
    EXPECT_THAT(errorOf(cells("Quadrilateral", textItem("1 4", "0 1 2 3")) + points(textItem("4", "0 1 2 3"), "VXVYVZ")),
                HasSubstr("geometry of type vxvyvz"));
    EXPECT_THAT(errorOf(cells("Quadrilateral", textItem("1 4", "0 1 2 3"))), HasSubstr("no geometry"));
}

TEST_F(XdmfItemsTest, ItemsThatAreNotReadAreCalledByTheirKind) {
    const std::string hexahedron = cells("Hexahedron", textItem("1 8", countedUpTo(8)));
    for (const char* const kind : {"Function", "HyperSlab", "Coordinates", "Collection", "Tree"}) {
        const std::string item = std::string("<DataItem ItemType=\"") + kind + "\" Dimensions=\"30 3\" Function=\"$0 + $1\">" +
                                 textItem("30 3", "0") + textItem("30 3", "0") + "</DataItem>";
        EXPECT_THAT(errorOf(hexahedron + points(item)), HasSubstr(std::string("items of type ") + kind + " are not read"));
    }
    EXPECT_THAT(errorOf(hexahedron + points("<DataItem Dimensions=\"8 3\" Format=\"TIFF\">a.tif</DataItem>")),
                HasSubstr("items of format TIFF are not read"));
    EXPECT_THAT(errorOf(hexahedron + points(textItem("8 3", "0 0 0 1"))), HasSubstr("a list of 24 numbers ends after 4"));
    EXPECT_THAT(errorOf(hexahedron + points(textItem("8 x", "0"))), HasSubstr("the dimensions \"8 x\" make no sense"));
    EXPECT_THAT(errorOf(hexahedron + points(textItem("99999999999 99999999999", "0"))), HasSubstr("make no sense"));
    EXPECT_THAT(errorOf(hexahedron + points("<DataItem Dimensions=\"8 3\" Format=\"HDF\">points.h5</DataItem>")),
                HasSubstr("is not FILE:/TABLE"));
}

template <class T>
std::string bytesOf(const std::vector<T>& values, bool big) {
    std::string text;
    for (const T value : values) {
        auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if (big) {
            std::reverse(raw.begin(), raw.end());
        }
        text.append(raw.begin(), raw.end());
    }
    return text;
}

// Two bricks of which the second is dead; all values lie in one binary file behind a header of three bytes.
TEST_F(XdmfItemsTest, BinaryFilesHoldWholeNumbersAndRealsInEitherOrder) {
    const std::vector<std::int32_t> corners{0, 1, 4, 3, 6, 7, 10, 9, 1, 2, 5, 4, 7, 8, 11, 10}, alive{1, 0};
    std::vector<float> places;
    for (int n = 0; n < 12; ++n) {
        places.insert(places.end(), {float(n % 3), float(n / 3 % 2), float(n / 6)});
    }
    for (const bool big : {false, true}) {
        for (const bool wide : {false, true}) {
            const std::vector<std::int64_t> wideCorners(corners.begin(), corners.end()), wideAlive(alive.begin(), alive.end());
            const std::vector<double> widePlaces(places.begin(), places.end());
            const std::array<std::string, 3> parts{wide ? bytesOf(wideCorners, big) : bytesOf(corners, big),
                                                   wide ? bytesOf(widePlaces, big) : bytesOf(places, big),
                                                   wide ? bytesOf(wideAlive, big) : bytesOf(alive, big)};
            writeContent(m_folder / "wall.bin", "abc" + parts[0] + parts[1] + parts[2]);
            std::size_t seek = 3;
            const auto item = [&](std::size_t part, const std::string& type, const std::string& dimensions) {
                const std::string text = "<DataItem Format=\"Binary\" NumberType=\"" + type + "\" Precision=\"" +
                                         (wide ? "8" : "4") + "\" Endian=\"" + (big ? "Big" : "Native") + "\" Seek=\"" +
                                         std::to_string(seek) + "\" Dimensions=\"" + dimensions + "\"> wall.bin </DataItem>";
                seek += parts.at(part).size();
                return text;
            };
            const std::string topology = cells("Hexahedron", item(0, "Int", "2 8")), geometry = points(item(1, "Float", "12 3"));
            const std::string grid =
                topology + geometry + "<Attribute Name=\"alive\" Center=\"Cell\">" + item(2, "Int", "2") + "</Attribute>";
            const auto fe = open(grid);
            EXPECT_EQ(fe->mesh().elementCount(), 2u);
            EXPECT_EQ(fe->mesh().nodes[11], Vec3(2.0, 1.0, 1.0));
            EXPECT_EQ(fe->activity().activeCount(0), 1u);
            EXPECT_FALSE(fe->activity().active(0, idAt<ElementIndex>(1)));
            writeContent(m_folder / "wall.bin", "abc" + parts[0] + parts[1]);
            EXPECT_THAT(errorOf(grid), HasSubstr("wall.bin does not hold the 2 values"));
        }
    }
}

// What stands on faces or on the grid is no value of nodes or cells; without a centre it is of nodes.
TEST_F(XdmfItemsTest, AttributesCountByTheirCentre) {
    const std::string brick = cells("Hexahedron", textItem("1 8", "0 1 6 5 15 16 21 20")) + manyPoints();
    const auto attribute = [](const std::string& name, const std::string& centre, const std::string& item) {
        return "<Attribute Name=\"" + name + "\"" + (centre.empty() ? "" : " Center=\"" + centre + "\"") + ">" + item +
               "</Attribute>";
    };
    EXPECT_EQ(open(brick + attribute("alive", "Grid", textItem("1", "0")))->contents().findings.count("fe.no_deaths"), 1);
    EXPECT_EQ(open(brick + attribute("alive", "Face", textItem("6", "0 0 0 0 0 0")))->activity().activeCount(0), 1u);
    EXPECT_EQ(open(brick + attribute("alive", "CELL", textItem("1 1", "0")))->activity().activeCount(0), 0u);
    std::string numbers;
    for (int n = 0; n < 30; ++n) {
        numbers += std::to_string(101 + n) + " ";
    }
    EXPECT_EQ(open(brick + attribute("NODE_ID", "", textItem("30", numbers)))->mesh().nodeIds.front(), 101);
}

// Writers put the numbers of elements into the tables and leave them out of the text.
TEST_F(XdmfItemsTest, NumbersBesideTheConnectivityAreFound) {
    const auto item = [](const std::string& table, const std::string& dimensions) {
        return "<DataItem Format=\"HDF\" Dimensions=\"" + dimensions + "\">numbers.h5:" + table + "</DataItem>";
    };
    {
        const Hdf5Handle file = createTables(m_folder / "numbers.h5");
        putTable(file.get(), "/mesh/corners", std::vector<int>{0, 1, 6, 5, 15, 16, 21, 20, 1, 2, 7, 6, 16, 17, 22, 21}, 8);
        putTable(file.get(), "/mesh/element_id", std::vector<int>{70, 90});
        putTable(file.get(), "/other/corners", std::vector<int>{0, 1, 6, 5, 15, 16, 21, 20}, 8);
        putTable(file.get(), "/other/element_id", std::vector<int>{70, 90});
    }
    EXPECT_THAT(open(cells("Hexahedron", item("/mesh/corners", "2 8")) + manyPoints())->mesh().elementIds, ElementsAre(70, 90));
    EXPECT_THAT(open(cells("Hexahedron", item("/other/corners", "1 8")) + manyPoints())->mesh().elementIds, ElementsAre(1));
    EXPECT_THAT(errorOf(cells("Hexahedron", item("/mesh/corners", "3 8")) + manyPoints()), HasSubstr("16 values instead of 24"));
}

}  // namespace
}  // namespace rubble::io
