#include "io/fe/series/cell_shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "core/fe/components.h"
#include "io/fe/fe_reader.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

constexpr int polyhedron = 42;

double volumeOf(const std::vector<CellPiece>& pieces, const std::vector<Vec3>& points) {
    double volume = 0.0;
    for (const CellPiece& piece : pieces) {
        std::vector<Vec3> corners;
        for (const std::uint32_t corner : piece.corners) {
            corners.push_back(points[corner]);
        }
        volume += std::abs(elementVolume(piece.shape, corners, 1.0));
    }
    return volume;
}

std::vector<Vec3> prism(int sides, double height) {
    std::vector<Vec3> points;
    for (const double z : {0.0, height}) {
        for (int s = 0; s < sides; ++s) {
            const double angle = 2.0 * 3.14159265358979323846 * s / sides;
            points.emplace_back(std::cos(angle), std::sin(angle), z);
        }
    }
    return points;
}

double areaOf(int sides) {
    return 0.5 * sides * std::sin(2.0 * 3.14159265358979323846 / sides);
}

TEST(CellPieces, PrismsFillTheirVolume) {
    for (const int sides : {5, 6}) {
        const std::vector<Vec3> points = prism(sides, 2.0);
        const auto pieces = piecesOfVtkCell(sides + 10, points);
        EXPECT_EQ(pieces.size(), 2u);
        EXPECT_NEAR(volumeOf(pieces, points), 2.0 * areaOf(sides), 1e-12) << sides;
    }
}

// Whatever the order of its points, a body of a known shape is one solid.
TEST(CellPieces, PolyhedraOfKnownShapesAreOneSolid) {
    const std::vector<Vec3> cube{{1, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {0, 0, 1}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}};
    const std::vector<Vec3> wedge{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 1}, {0, 1, 1}};
    const std::vector<Vec3> pyramid{{0.5, 0.5, 1}, {0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Vec3> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto one = [](const std::vector<Vec3>& points, ElementShape shape, double volume) {
        const auto pieces = piecesOfVtkCell(polyhedron, points);
        ASSERT_EQ(pieces.size(), 1u);
        EXPECT_EQ(pieces[0].shape, shape);
        EXPECT_NEAR(volumeOf(pieces, points), volume, 1e-12);
    };
    one(cube, ElementShape::Hexahedron, 1.0);
    one(wedge, ElementShape::Wedge, 0.5);
    one(pyramid, ElementShape::Pyramid, 1.0 / 3.0);
    one(tetrahedron, ElementShape::Tetrahedron, 1.0 / 6.0);
    std::vector<Vec3> far = cube;
    for (Vec3& point : far) {
        point = (0.1 * point + Vec3(100, 50, 30)).cast<float>().cast<double>();
    }
    EXPECT_EQ(piecesOfVtkCell(polyhedron, far).size(), 1u);
}

TEST(CellPieces, OtherPolyhedraAreTakenApartWithoutGaps) {
    for (const int sides : {5, 6, 9}) {
        const std::vector<Vec3> points = prism(sides, 1.5);
        const auto pieces = piecesOfVtkCell(polyhedron, points);
        EXPECT_GT(pieces.size(), 1u);
        EXPECT_NEAR(volumeOf(pieces, points), 1.5 * areaOf(sides), 1e-9) << sides;
    }
    const std::vector<Vec3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const auto pieces = piecesOfVtkCell(polyhedron, octahedron);
    EXPECT_NEAR(volumeOf(pieces, octahedron), 4.0 / 3.0, 1e-12);
    std::set<std::uint32_t> used;
    for (const CellPiece& piece : pieces) {
        used.insert(piece.corners.begin(), piece.corners.end());
    }
    EXPECT_EQ(used.size(), 6u);
}

TEST(CellPieces, FlatAndLargeBodiesHaveNoPieces) {
    EXPECT_TRUE(piecesOfVtkCell(polyhedron, prism(4, 0.0)).empty());
    EXPECT_TRUE(piecesOfVtkCell(polyhedron, std::vector<Vec3>(3, Vec3::Zero())).empty());
    EXPECT_TRUE(piecesOfVtkCell(polyhedron, prism(40, 1.0)).empty());
}

TEST(CellPieces, PolylinesAndPolygonsAreBeamsAndShells) {
    const std::vector<Vec3> five{{0, 0, 0}, {1, 0, 0}, {1.5, 1, 0}, {0.5, 1.5, 0}, {-0.5, 1, 0}};
    EXPECT_EQ(piecesOfVtkCell(4, five).size(), 4u);
    EXPECT_NEAR(volumeOf(piecesOfVtkCell(7, five), five), 2.0, 1e-12);
    EXPECT_EQ(piecesOfVtkCell(6, five).size(), 3u);
}

TEST(CellPieces, HigherOrdersAreKnownByTheirCornersAndNamed) {
    using enum ElementShape;
    const std::array<ElementShape, 7> shapes{Beam, Triangle, Quadrilateral, Tetrahedron, Hexahedron, Wedge, Pyramid};
    for (int i = 0; i < 7; ++i) {
        EXPECT_EQ(shapeOfVtkCell(68 + i), shapes[static_cast<std::size_t>(i)]);
        EXPECT_EQ(shapeOfVtkCell(75 + i), shapes[static_cast<std::size_t>(i)]);
    }
    EXPECT_EQ(nameOfVtkCell(72), "Lagrange hexahedron");
    EXPECT_EQ(nameOfVtkCell(80), "Bezier wedge");
    EXPECT_EQ(nameOfVtkCell(1), "vertex");
    EXPECT_EQ(nameOfVtkCell(200), "type 200");
}

class CellKindsTest : public testing::Test {
protected:
    // Two hexagonal prisms, or the polyhedra of their points, that share a side. The second dies.
    std::shared_ptr<const FeResult> open(int type, bool faces, const std::string& numbers = "10 20") {
        for (int k = 0; k < 2; ++k) {
            std::string text = "# vtk DataFile Version 3.0\nprisms\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 20 double\n";
            const double side = std::sqrt(3.0) / 2.0;
            for (const double z : {0.0, 1.0}) {
                for (const auto& [x, y] : {std::pair{0.5, -side},
                                           {1.0, 0.0},
                                           {0.5, side},
                                           {-0.5, side},
                                           {-1.0, 0.0},
                                           {-0.5, -side},
                                           {2.0, 0.0},
                                           {2.5, side},
                                           {2.0, 2 * side},
                                           {1.0, 2 * side}}) {
                    text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
                }
            }
            const std::vector<std::vector<int>> bases{{0, 1, 2, 3, 4, 5}, {1, 6, 7, 8, 9, 2}};
            std::string cells;
            std::size_t words = 0;
            for (const std::vector<int>& base : bases) {
                std::vector<int> list = faces ? facesOf(base) : pointsOf(base);
                cells += std::to_string(list.size());
                for (const int word : list) {
                    cells += " " + std::to_string(word);
                }
                cells += "\n";
                words += list.size() + 1;
            }
            text += "CELLS 2 " + std::to_string(words) + "\n" + cells + "CELL_TYPES 2\n" + std::to_string(type) + "\n" +
                    std::to_string(type) + "\nCELL_DATA 2\nSCALARS alive int\nLOOKUP_TABLE default\n1 " + (k == 0 ? "1" : "0") +
                    "\nSCALARS ELEMENT_ID int\nLOOKUP_TABLE default\n" + numbers + "\n";
            writeContent(m_folder / ("prisms_" + std::to_string(k) + ".vtk"), text);
        }
        return openFe(m_folder / "prisms_0.vtk", {}, {}, Execution{});
    }

    static std::vector<int> pointsOf(const std::vector<int>& base) {
        std::vector<int> list = base;
        for (const int point : base) {
            list.push_back(point + 10);
        }
        return list;
    }

    static std::vector<int> facesOf(const std::vector<int>& base) {
        std::vector<int> list{8, 6};
        list.insert(list.end(), base.begin(), base.end());
        list.push_back(6);
        for (const int point : base) {
            list.push_back(point + 10);
        }
        for (std::size_t s = 0; s < 6; ++s) {
            const int a = base[s], b = base[(s + 1) % 6];
            for (const int word : {4, a, b, b + 10, a + 10}) {
                list.push_back(word);
            }
        }
        return list;
    }

    TemporaryFolder m_folder;
};

TEST_F(CellKindsTest, PrismsAndPolyhedraDieWhole) {
    for (const auto& [type, faces] : {std::pair{16, false}, {42, true}, {42, false}}) {
        const auto fe = open(type, faces);
        const Mesh& mesh = fe->mesh();
        double standing = 0.0, dead = 0.0;
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            std::vector<Vec3> corners;
            for (const std::uint32_t node : mesh.cornersOf(idAt<ElementIndex>(e))) {
                corners.push_back(mesh.nodes[node]);
            }
            const double volume = std::abs(elementVolume(mesh.shapes[e], corners, 1.0));
            EXPECT_TRUE(fe->activity().active(0, idAt<ElementIndex>(e)));
            (fe->activity().active(1, idAt<ElementIndex>(e)) ? standing : dead) += volume;
            EXPECT_EQ(mesh.elementIds[e], fe->activity().active(1, idAt<ElementIndex>(e)) ? 10 : 20);
        }
        EXPECT_NEAR(standing, areaOf(6), 1e-5) << type << faces;
        EXPECT_NEAR(dead, areaOf(6), 1e-5) << type << faces;
        EXPECT_EQ(fe->contents().findings.count("vtk.taken_apart"), 2);
    }
}

TEST_F(CellKindsTest, PiecesOfOneCellHaveItsNumberByRight) {
    for (const auto& [type, faces] : {std::pair{16, false}, {42, true}, {42, false}}) {
        EXPECT_EQ(open(type, faces)->contents().findings.count("fe.number_twice"), 0) << type << faces;
        const auto twice = open(type, faces, "10 10");
        EXPECT_EQ(twice->contents().findings.count("fe.number_twice"), 1) << type << faces;
        EXPECT_EQ(2 * twice->activity().activeCount(1), twice->mesh().elementCount()) << type << faces;
    }
}

}  // namespace
}  // namespace rubble::io
