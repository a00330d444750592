#include "core/fragments/consistent_mass.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <vector>

#include "core/fe/components.h"
#include "tests/core/fragments/corner_columns.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

constexpr ElementShape solids[]{ElementShape::Hexahedron, ElementShape::Wedge, ElementShape::Pyramid, ElementShape::Tetrahedron};

/// M_ab of a hexahedron by the midpoint rule on n^3 cells extrapolated from n and 2n (Richardson): no Gauss points anywhere.
Eigen::Matrix<double, 8, 8> midpointMass(const Corners& x, int n) {
    constexpr int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    Eigen::Matrix<double, 8, 8> sum = Eigen::Matrix<double, 8, 8>::Zero();
    for (int cell = 0; cell < n * n * n; ++cell) {
        const Vec3 p((2.0 * (cell % n) + 1) / n - 1, (2.0 * (cell / n % n) + 1) / n - 1, (2.0 * (cell / n / n) + 1) / n - 1);
        Eigen::Matrix<double, 8, 1> shape;
        Eigen::Matrix<double, 8, 3> gradient;
        for (int a = 0; a < 8; ++a) {
            const Vec3 f(1 + sign[a][0] * p.x(), 1 + sign[a][1] * p.y(), 1 + sign[a][2] * p.z());
            shape[a] = f.prod() / 8;
            gradient.row(a) << sign[a][0] * f.y() * f.z() / 8, sign[a][1] * f.x() * f.z() / 8, sign[a][2] * f.x() * f.y() / 8;
        }
        sum += (x * gradient).determinant() * shape * shape.transpose() * 8.0 / (n * n * n);
    }
    return sum;
}

TEST(ConsistentMass, OfABoxIsTheTensorProductOfLines) {
    // A line's is m/6 [2 1; 1 2]; a box's entries are therefore m/216 times 8, 4, 2, 1 by the number of coordinates shared.
    const Corners box = cornerColumns({{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}});
    const ConsistentMass m = consistentMass(box, 216.0);
    EXPECT_NEAR(m.volume, 30.0, 1e-13);
    EXPECT_EQ(m.state, SolidState::Sound);
    for (int a = 0; a < 8; ++a) {
        for (int b = 0; b < 8; ++b) {
            const int shared = ((box.col(a) - box.col(b)).array() == 0.0).count();
            EXPECT_NEAR(m.matrix(a, b), std::pow(2.0, shared), 1e-12) << a << ", " << b;
        }
    }
}

TEST(ConsistentMass, OfATetrahedronIsOneTwentiethAndTwice) {
    // Closed form: m/20 (1 + delta_ab); gathered from the corners of the hexahedron that share a vertex.
    std::mt19937 random(3);
    const Corners own = cornerColumns(test::randomElement(ElementShape::Tetrahedron, random));
    const ConsistentMass m = consistentMass(asHexahedron(ElementShape::Tetrahedron, own), 20.0);
    const auto& map = hexahedronCorners(ElementShape::Tetrahedron);
    Eigen::Matrix4d gathered = Eigen::Matrix4d::Zero();
    for (int a = 0; a < 8; ++a) {
        for (int b = 0; b < 8; ++b) {
            gathered(map[a], map[b]) += m.matrix(a, b);
        }
    }
    EXPECT_LT((gathered - Eigen::Matrix4d::Ones() - Eigen::Matrix4d::Identity()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ConsistentMass, AgreesWithTheMidpointRuleOnDistortedHexahedra) {
    std::mt19937 random(7);
    for (int i = 0; i < 5; ++i) {
        const Corners x = cornerColumns(test::randomElement(ElementShape::Hexahedron, random, 1.0, 0.3));
        // The integrand is a quartic in each coordinate: the error of the midpoint rule has terms in h^2 and h^4 only.
        const Eigen::Matrix<double, 8, 8> a = midpointMass(x, 6), b = midpointMass(x, 12), c = midpointMass(x, 24);
        const Eigen::Matrix<double, 8, 8> ab = (4 * b - a) / 3, bc = (4 * c - b) / 3;
        const Eigen::Matrix<double, 8, 8> expected = (16 * bc - ab) / 15;
        const ConsistentMass m = consistentMass(x, expected.sum());
        // Cross terms leave an h^6; measured below 1e-7 of the largest entry.
        EXPECT_LT((m.matrix - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.maxCoeff());
        EXPECT_NEAR(m.volume, expected.sum(), 1e-6 * m.volume);
    }
}

TEST(ConsistentMass, SumsToTheMassAndIsPositive) {
    std::mt19937 random(11);
    for (int i = 0; i < 400; ++i) {
        const ElementShape shape = solids[i % 4];
        // From sound to wildly tangled.
        const Corners x = asHexahedron(shape, cornerColumns(test::randomElement(shape, random, 1.0, 0.01 * i)));
        const ConsistentMass m = consistentMass(x, 77.0);
        EXPECT_NEAR(m.matrix.sum(), 77.0, 1e-11);
        EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m.matrix).eigenvalues().minCoeff(), -1e-11);
        EXPECT_LT((m.matrix - m.matrix.transpose()).cwiseAbs().maxCoeff(), 1e-13);
    }
}

/// Volume by the divergence theorem over the bilinear faces.
double volumeFromFaces(ElementShape shape, const Corners& own) {
    double volume = 0.0;
    for (const auto& face : facesOf(shape)) {
        const auto corner = [&](int i) -> Vec3 { return own.col(face[i] < 0 ? face[2] : face[i]); };
        const Vec3 a = corner(0), b = corner(1), c = corner(2), d = corner(3);
        // Of the bilinear patch with the origin as apex: the mean of both ways to cut it into triangles.
        const auto tetrahedron = [](const Vec3& p, const Vec3& q, const Vec3& r) { return p.dot(q.cross(r)) / 6.0; };
        volume += 0.5 * (tetrahedron(a, b, c) + tetrahedron(a, c, d) + tetrahedron(a, b, d) + tetrahedron(b, c, d));
    }
    return volume;
}

TEST(ConsistentMass, VolumeAgreesWithTheFacesAndWithTheComponents) {
    std::mt19937 random(5);
    for (int i = 0; i < 400; ++i) {
        const ElementShape shape = solids[i % 4];
        const std::vector<Vec3> corners = test::randomElement(shape, random, 1.0, 0.3);
        const double volume = consistentMass(asHexahedron(shape, cornerColumns(corners)), 1.0).volume;
        EXPECT_NEAR(volume, elementVolume(shape, corners, 0.0), 1e-12) << shapeName(shape);
        // The faces are measured from the origin, up to 50 m away.
        EXPECT_NEAR(volume, volumeFromFaces(shape, cornerColumns(corners)), 1e-10) << shapeName(shape);
    }
}

TEST(ConsistentMass, TellsSoundMirroredTangledAndCollapsed) {
    std::mt19937 random(9);
    for (const ElementShape shape : solids) {
        const Corners own = cornerColumns(test::randomElement(shape, random));
        EXPECT_EQ(consistentMass(asHexahedron(shape, own), 1.0).state, SolidState::Sound);
        Corners mirrored = own;
        mirrored.row(1) *= -1.0;
        const ConsistentMass m = consistentMass(asHexahedron(shape, mirrored), 1.0);
        EXPECT_EQ(m.state, SolidState::Mirrored);
        EXPECT_LT(m.volume, 0.0);
        Corners flat = own;
        flat.row(2).setConstant(3.0);
        EXPECT_EQ(consistentMass(asHexahedron(shape, flat), 1.0).state, SolidState::Collapsed);
    }
    Corners bowTie = cornerColumns({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}});
    EXPECT_EQ(consistentMass(bowTie, 1.0).state, SolidState::Tangled);
    const ConsistentMass point = consistentMass(Corners::Constant(4.0), 6.0);
    EXPECT_EQ(point.state, SolidState::Collapsed);
    EXPECT_NEAR(point.matrix.sum(), 6.0, 1e-13);
}

}  // namespace
}  // namespace rubble
