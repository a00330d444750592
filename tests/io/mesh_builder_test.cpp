#include "io/fe/mesh_builder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/fe/components.h"

namespace rubble::io {

namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

MeshBuilder cube() {
    MeshBuilder builder("file.x");
    builder.setNodes({1, 2, 3, 4, 5, 6, 7, 8},
                     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
    builder.addPart("block", 7);
    return builder;
}

double volumeOf(const Mesh& mesh, std::size_t e) {
    std::vector<Vec3> corners;
    for (const std::uint32_t node : mesh.cornersOf(idAt<ElementIndex>(e))) {
        corners.push_back(mesh.nodes[node]);
    }
    return elementVolume(mesh.shapes[e], corners, mesh.section[e]);
}

// A hexahedron with repeated corners is the same solid by the exact rule, whatever corners were given twice.
TEST(MeshBuilder, RepeatedCornersMakeTheSolidThatTheyAre) {
    struct Case {
        std::vector<std::int64_t> corners;
        ElementShape shape;
        double volume;
    };
    const std::vector<Case> cases{
        {{0, 1, 2, 3, 4, 5, 6, 7}, ElementShape::Hexahedron, 1.0},
        {{0, 1, 2, 2, 4, 5, 6, 6}, ElementShape::Wedge, 0.5},  // one edge of the lower and of the upper face
        {{0, 1, 2, 3, 4, 4, 7, 7}, ElementShape::Wedge, 0.5},  // the upper face is an edge
        {{0, 1, 5, 4, 3, 2, 2, 3}, ElementShape::Wedge, 0.5},  // the same, lying
        {{0, 1, 2, 3, 6, 6, 6, 6}, ElementShape::Pyramid, 1.0 / 3.0},
        {{4, 4, 4, 4, 0, 1, 2, 3}, ElementShape::Pyramid, 1.0 / 3.0},
        {{0, 1, 2, 2, 6, 6, 6, 6}, ElementShape::Tetrahedron, 1.0 / 6.0},
        {{0, 2, 1, 1, 5, 5, 5, 5}, ElementShape::Tetrahedron, 1.0 / 6.0},
        {{0, 1, 2, 3, 4, 5, 6, 6}, ElementShape::Hexahedron, 0.75},  // seven corners have no shape of their own; faces bend
    };
    for (const Case& test : cases) {
        MeshBuilder builder = cube();
        builder.addSolid(1, 0, test.corners);
        Findings findings;
        const Mesh mesh = builder.finish(findings);
        EXPECT_EQ(mesh.shapes[0], test.shape) << ::testing::PrintToString(test.corners);
        EXPECT_NEAR(volumeOf(mesh, 0), test.volume, 1e-12) << ::testing::PrintToString(test.corners);
    }
}

TEST(MeshBuilder, ShellsOfThreeCornersAndReversedSolids) {
    MeshBuilder builder = cube();
    builder.addShell(1, 0, std::vector<std::int64_t>{0, 1, 2, 2}, 0.5);
    builder.addShell(2, 0, std::vector<std::int64_t>{0, 1, 2, 3}, unknown);
    builder.addSolid(3, 0, std::vector<std::int64_t>{4, 5, 6, 7, 0, 1, 2, 3});
    Findings findings;
    const Mesh mesh = builder.finish(findings);
    EXPECT_THAT(mesh.shapes, ElementsAre(ElementShape::Triangle, ElementShape::Quadrilateral, ElementShape::Hexahedron));
    EXPECT_NEAR(volumeOf(mesh, 0), 0.25, 1e-15);
    EXPECT_TRUE(std::isnan(mesh.section[1]));
    EXPECT_NEAR(volumeOf(mesh, 2), 1.0, 1e-12) << "turned";
    EXPECT_EQ(findings.count("fe.reversed"), 1);
}

TEST(MeshBuilder, PartsHaveNamesOfTheirOwnAndElements) {
    MeshBuilder builder = cube();
    const std::uint32_t twice = builder.addPart("block", 8), nameless = builder.addPart("", 9);
    builder.addPart("empty", 10);
    builder.addBeam(1, nameless, std::vector<std::int64_t>{0, 6}, 0.1);
    builder.addBeam(2, twice, std::vector<std::int64_t>{0, 6}, 0.1);
    builder.addBeam(3, 0, std::vector<std::int64_t>{0, 6}, 0.1);
    Findings findings;
    const Mesh mesh = builder.finish(findings);
    ASSERT_EQ(mesh.parts.size(), 3u);
    EXPECT_EQ(mesh.parts[0].name, "block");
    EXPECT_EQ(mesh.parts[1].name, "block (8)");
    EXPECT_EQ(mesh.parts[2].name, "part 9");
    EXPECT_THAT(mesh.part, ElementsAre(2, 1, 0));
    EXPECT_EQ(findings.count("fe.name_twice"), 1);
}

TEST(MeshBuilder, NodesThatDoNotExistAndPlacesThatAreNone) {
    MeshBuilder builder = cube();
    for (const std::int64_t node : {-1, 8}) {
        try {
            builder.addBeam(17, 0, std::vector<std::int64_t>{0, node}, 1.0);
            FAIL();
        } catch (const ParseError& error) {
            EXPECT_THAT(error.what(), AllOf(HasSubstr("file.x"), HasSubstr("element 17"), HasSubstr("of 8")));
        }
    }
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e30}) {
        MeshBuilder other("file.x");
        other.setNodes({1, 2, 3}, {{0, 0, 0}, {1, 0, 0}, {bad, 0, 0}});
        other.addPart("tie", 1);
        other.addBeam(1, 0, std::vector<std::int64_t>{0, 1}, 1.0);
        Findings findings;
        MeshBuilder used = other;
        EXPECT_EQ(other.finish(findings).nodeCount(), 3u);
        EXPECT_EQ(findings.count("fe.stray_node"), 1);
        used.addBeam(2, 0, std::vector<std::int64_t>{1, 2}, 1.0);
        EXPECT_THROW(used.finish(findings), ParseError);
    }
}

TEST(MeshBuilder, DensitiesOfFilesThatCountInOtherUnits) {
    Findings findings;
    const auto si = [&](double value, double metres) { return densityInSi(value, metres, findings, "p"); };
    EXPECT_DOUBLE_EQ(si(7.85e-9, 0.001), 7850.0) << "t/mm3";
    EXPECT_DOUBLE_EQ(si(2.4e-6, 0.001), 2400.0) << "kg/mm3";
    EXPECT_NEAR(si(2.4e-3, 0.001), 2400.0, 1e-9) << "g/mm3";
    EXPECT_NEAR(si(18.62, 0.01), 18620.0, 1e-9) << "g/cm3";
    EXPECT_EQ(si(2400.0, 0.001), 2400.0) << "kg/m3 in a file of millimetres";
    EXPECT_EQ(si(2.4, 1.0), 2.4) << "metres are taken at their word";
    EXPECT_EQ(si(-1.0, 0.001), -1.0);
    EXPECT_EQ(findings.count("fe.density_unit"), 4);
}

}  // namespace

}  // namespace rubble::io
