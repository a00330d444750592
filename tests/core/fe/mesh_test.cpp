#include "core/fe/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "core/fe/components.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

using test::allShapes;
using test::randomElement;

// Volume enclosed by the faces of a solid, by the divergence theorem. A bilinear face counts as the mean of its two triangulations,
// which is exact for it.
double enclosedVolume(ElementShape shape, const std::vector<Vec3>& x) {
    const auto cone = [](const Vec3& a, const Vec3& b, const Vec3& c) { return a.dot(b.cross(c)) / 6.0; };
    double volume = 0.0;
    for (const auto& face : facesOf(shape)) {
        const auto at = [&](std::size_t i) { return x[static_cast<std::size_t>(face[i])]; };
        if (face[3] < 0) {
            volume += cone(at(0), at(1), at(2));
        } else {
            volume += 0.5 * (cone(at(0), at(1), at(2)) + cone(at(0), at(2), at(3)) + cone(at(0), at(1), at(3)) +
                             cone(at(1), at(2), at(3)));
        }
    }
    return volume;
}

TEST(Mesh, FacesOfSolidsCloseWithEveryEdgeRunBothWays) {
    for (const ElementShape shape : allShapes) {
        if (!isSolid(shape)) {
            continue;
        }
        std::map<std::pair<int, int>, int> edges;
        for (const auto& face : facesOf(shape)) {
            const int n = face[3] < 0 ? 3 : 4;
            for (int i = 0; i < n; ++i) {
                ++edges[{face[static_cast<std::size_t>(i)], face[static_cast<std::size_t>((i + 1) % n)]}];
            }
        }
        for (const auto& [edge, times] : edges) {
            EXPECT_EQ(times, 1) << shapeName(shape);
            EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << shapeName(shape) << " " << edge.first << "-" << edge.second;
        }
    }
}

TEST(Mesh, ShellsHaveOneFaceAndBeamsNone) {
    EXPECT_EQ(facesOf(ElementShape::Quadrilateral).size(), 1u);
    EXPECT_EQ(facesOf(ElementShape::Triangle).size(), 1u);
    EXPECT_TRUE(facesOf(ElementShape::Beam).empty());
    EXPECT_EQ(cornerCount(ElementShape::Pyramid), 5);
    EXPECT_EQ(shapeName(ElementShape::Wedge), "wedge");
}

TEST(ElementVolume, EqualsWhatItsFacesEnclose) {
    std::mt19937 random(1);
    for (const ElementShape shape : allShapes) {
        for (int i = 0; isSolid(shape) && i < 200; ++i) {
            const std::vector<Vec3> x = randomElement(shape, random);
            // Both are sums of some hundred products of numbers near 1.
            EXPECT_NEAR(elementVolume(shape, x, 0.0), enclosedVolume(shape, x), 1e-13 * (1.0 + x[0].cwiseAbs().maxCoeff()))
                << shapeName(shape);
            EXPECT_GT(elementVolume(shape, x, 0.0), 0.0) << shapeName(shape);
        }
    }
}

TEST(ElementVolume, MirroredSolidsAreNegative) {
    std::mt19937 random(2);
    for (const ElementShape shape : allShapes) {
        std::vector<Vec3> x = randomElement(shape, random);
        const double volume = elementVolume(shape, x, 0.3);
        for (Vec3& corner : x) {
            corner.x() = -corner.x();
        }
        EXPECT_NEAR(elementVolume(shape, x, 0.3), isSolid(shape) ? -volume : volume, 1e-13);
    }
}

TEST(ElementVolume, ShellsAndBeamsUseTheirSection) {
    const std::vector<Vec3> square{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}};
    EXPECT_NEAR(elementVolume(ElementShape::Quadrilateral, square, 0.25), 1.5, 1e-15);
    // A quadrilateral whose last corner is its third is a triangle.
    const std::vector<Vec3> degenerate{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {2, 3, 0}};
    EXPECT_NEAR(elementVolume(ElementShape::Quadrilateral, degenerate, 0.25), 0.75, 1e-15);
    EXPECT_NEAR(elementVolume(ElementShape::Triangle, std::span(square).first(3), 0.25), 0.75, 1e-15);
    EXPECT_NEAR(elementVolume(ElementShape::Beam, std::vector<Vec3>{{0, 0, 0}, {3, 4, 0}}, 0.04), 0.2, 1e-15);
}

TEST(ElementVolume, DegenerateHexahedraAreWedgesAndTetrahedra) {
    std::mt19937 random(3);
    const std::vector<Vec3> w = randomElement(ElementShape::Wedge, random);
    const std::vector<Vec3> asHexahedron{w[0], w[1], w[2], w[2], w[3], w[4], w[5], w[5]};
    EXPECT_NEAR(elementVolume(ElementShape::Hexahedron, asHexahedron, 0.0), elementVolume(ElementShape::Wedge, w, 0.0), 1e-14);
    const std::vector<Vec3> t = randomElement(ElementShape::Tetrahedron, random);
    const std::vector<Vec3> collapsed{t[0], t[1], t[2], t[2], t[3], t[3], t[3], t[3]};
    EXPECT_NEAR(elementVolume(ElementShape::Hexahedron, collapsed, 0.0), elementVolume(ElementShape::Tetrahedron, t, 0.0), 1e-14);
}

}  // namespace
}  // namespace rubble
