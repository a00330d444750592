#include "core/fragments/solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/fe/components.h"
#include "tests/core/fragments/corner_columns.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

constexpr double ratio = 0.025;
constexpr double least = 0.005;

Corners brick(const Vec3& size) {
    const double x = size.x(), y = size.y(), z = size.z();
    return cornerColumns({{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z}});
}

SoundSolid sound(const MovingSolid& solid, const Mat3& axes) {
    const ConsistentMass m = consistentMass(asHexahedron(solid.shape, solid.positions), 1.0);
    return soundSolid(solid, m.state, m.volume, axes, ratio, least);
}

double volumeOf(const SoundSolid& solid) {
    return consistentMass(asHexahedron(solid.shape, solid.corners), 1.0).volume;
}

/// How far the corners of a solid reach beyond its box, and how much of the box they leave empty along its axes.
std::pair<double, double> boxMisfit(const SoundSolid& solid) {
    const auto local = (solid.box.orientation.toRotationMatrix().transpose() *
                        (solid.corners.leftCols(cornerCount(solid.shape)).colwise() - solid.box.centre))
                           .eval();
    const Vec3 reach = local.rowwise().maxCoeff();
    const Vec3 back = -local.rowwise().minCoeff();
    return {std::max((reach - solid.box.halfExtents).maxCoeff(), (back - solid.box.halfExtents).maxCoeff()),
            std::max((solid.box.halfExtents - reach).maxCoeff(), (solid.box.halfExtents - back).maxCoeff())};
}

TEST(Solids, ShellsAndBeamsAreExtrudedToTheirVolume) {
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        for (const ElementShape shape : {ElementShape::Triangle, ElementShape::Beam}) {
            const std::vector<Vec3> corners = test::randomElement(shape, random, 2.0);
            const MovingSolid solid = solidOf(shape, cornerColumns(corners), Corners::Zero(), 0.04);
            EXPECT_EQ(solid.shape, shape == ElementShape::Triangle ? ElementShape::Wedge : ElementShape::Hexahedron);
            EXPECT_NEAR(consistentMass(asHexahedron(solid.shape, solid.positions), 1.0).volume, elementVolume(shape, corners, 0.04),
                        1e-12);
        }
        std::vector<Vec3> flat = test::randomElement(ElementShape::Quadrilateral, random, 2.0, 0.0);
        flat[2] += 0.2 * (flat[1] - flat[0]) - 0.1 * (flat[3] - flat[0]);
        const MovingSolid solid = solidOf(ElementShape::Quadrilateral, cornerColumns(flat), Corners::Zero(), 0.1);
        EXPECT_EQ(solid.shape, ElementShape::Hexahedron);
        EXPECT_NEAR(consistentMass(asHexahedron(solid.shape, solid.positions), 1.0).volume,
                    elementVolume(ElementShape::Quadrilateral, flat, 0.1), 1e-12);
    }
}

TEST(Solids, ExtrusionsMoveRigidlyWithTheirElement) {
    std::mt19937 random(2);
    for (const ElementShape shape : {ElementShape::Quadrilateral, ElementShape::Triangle, ElementShape::Beam}) {
        const std::vector<Vec3> corners = test::randomElement(shape, random);
        Vec3 w = test::randomVector(random, 2.0);
        if (shape == ElementShape::Beam) {  // a beam cannot show its spin about its own axis
            const Vec3 axis = (corners[1] - corners[0]).normalized();
            w -= axis * axis.dot(w);
        }
        Corners velocities = Corners::Zero();
        for (std::size_t a = 0; a < corners.size(); ++a) {
            velocities.col(static_cast<Eigen::Index>(a)) = Vec3(1, 2, 3) + w.cross(corners[a]);
        }
        const MovingSolid solid = solidOf(shape, cornerColumns(corners), velocities, 0.3);
        for (int a = 0; a < cornerCount(solid.shape); ++a) {
            EXPECT_LT((solid.velocities.col(a) - Vec3(1, 2, 3) - w.cross(Vec3(solid.positions.col(a)))).norm(), 1e-12)
                << shapeName(shape);
        }
    }
}

TEST(Solids, ExtrusionRateIsTheRateOfTheExtrusion) {
    // Against central differences of the extrusion itself, in a motion that is anything but rigid.
    std::mt19937 random(3);
    for (const ElementShape shape : {ElementShape::Quadrilateral, ElementShape::Triangle}) {
        const Corners x = cornerColumns(test::randomElement(shape, random));
        Corners v = Corners::Zero();
        for (int a = 0; a < cornerCount(shape); ++a) {
            v.col(a) = test::randomVector(random, 1.0);
        }
        const double h = 1e-6;
        const MovingSolid before = solidOf(shape, x - h * v, v, 0.2), after = solidOf(shape, x + h * v, v, 0.2);
        const MovingSolid now = solidOf(shape, x, v, 0.2);
        // Truncation h^2, rounding 1e-15 * 50 m / h.
        EXPECT_LT(((after.positions - before.positions) / (2 * h) - now.velocities).cwiseAbs().maxCoeff(), 1e-7);
    }
}

TEST(Solids, NearestRotationUndoesAnyStretch) {
    std::mt19937 random(4);
    for (int i = 0; i < 200; ++i) {
        const Mat3 rotation = test::randomRotation(random), axes = test::randomRotation(random);
        const Vec3 stretch(0.2 + 0.01 * i, 1.0, 2.0);
        const Mat3 found = nearestRotation(rotation * axes * stretch.asDiagonal() * axes.transpose());
        EXPECT_LT((found - rotation).cwiseAbs().maxCoeff(), 1e-13);
    }
}

TEST(Solids, NearestRotationIsARotationWhateverTheMatrix) {
    std::mt19937 random(5);
    std::vector<Mat3> matrices{Mat3::Zero(),
                               -Mat3::Identity(),
                               Vec3(1, 1, 0).asDiagonal(),
                               Vec3(1, 0, 0).asDiagonal(),
                               Mat3::Ones(),
                               Vec3(1e150, 1e-150, 1).asDiagonal(),
                               1e-200 * Mat3::Identity(),
                               Mat3::Constant(1e100)};
    for (int i = 0; i < 100; ++i) {
        matrices.push_back(Mat3::NullaryExpr([&] { return test::randomVector(random, 1.0).x(); }));
    }
    for (const Mat3& matrix : matrices) {
        const Mat3 r = nearestRotation(matrix);
        EXPECT_LT((r * r.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-12) << matrix;
        EXPECT_NEAR(r.determinant(), 1.0, 1e-12) << matrix;
    }
}

TEST(Solids, BoxOfATurnedAndStretchedBrickIsTheBrick) {
    std::mt19937 random(6);
    for (int i = 0; i < 100; ++i) {
        const Vec3 size(0.7, 1.3, 2.1);
        const Mat3 turn = test::randomRotation(random);
        const Vec3 place = test::randomVector(random, 100.0);
        const Corners atRest = brick(size);
        const Vec3 strain(1.1, 0.9, 1.02);
        MovingSolid solid;
        solid.positions = (turn * strain.asDiagonal() * atRest).colwise() + place;
        const SoundSolid result = sound(solid, boxAxes(atRest, solid.positions));
        EXPECT_LT((result.box.halfExtents - 0.5 * size.cwiseProduct(strain)).norm(), 1e-12);
        EXPECT_LT((result.box.centre - solid.positions.rowwise().mean()).norm(), 1e-12);
        EXPECT_LT((result.box.orientation.toRotationMatrix() - turn).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_FALSE(result.thickened || result.boxed);
        EXPECT_EQ(result.corners, solid.positions);
    }
}

TEST(Solids, BoxOfAShearedBrickLiesAlongItsFaces) {
    // Sheared along x by half its height: base 2 x 1, height 1; the box along the base is 2.5 x 1 x 1.
    Corners sheared = brick(Vec3(2, 1, 1));
    sheared.row(0) += 0.5 * sheared.row(2);
    std::mt19937 random(12);
    const Mat3 turn = test::randomRotation(random);
    const Corners turned = turn * sheared;
    const OrientedBox box = boxAround(turned, 8, boxAxes(sheared, turned));
    EXPECT_NEAR(box.volume(), 2.5, 1e-12);
    EXPECT_NEAR(box.halfExtents.maxCoeff(), 1.25, 1e-12);
}

TEST(Solids, BoxesAreTightAroundEveryShape) {
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        for (const ElementShape shape : test::allShapes) {
            const std::vector<Vec3> corners = test::randomElement(shape, random);
            const MovingSolid solid = solidOf(shape, cornerColumns(corners), Corners::Zero(), 0.2);
            const Corners x = asHexahedron(solid.shape, solid.positions);
            const SoundSolid result = sound(solid, boxAxes(x, x));
            EXPECT_FALSE(result.boxed) << shapeName(shape);
            const auto [beyond, empty] = boxMisfit(result);
            EXPECT_LT(beyond, 1e-12);
            EXPECT_LT(empty, 1e-12);
        }
    }
}

TEST(Solids, UnmirroringTurnsTheVolumeRound) {
    std::mt19937 random(8);
    for (const ElementShape shape :
         {ElementShape::Hexahedron, ElementShape::Wedge, ElementShape::Pyramid, ElementShape::Tetrahedron}) {
        Corners own = cornerColumns(test::randomElement(shape, random));
        const double volume = consistentMass(asHexahedron(shape, own), 1.0).volume;
        own.row(0) *= -1.0;
        const SoundSolid result = sound({shape, own, Corners::Zero()}, Mat3::Identity());
        EXPECT_FALSE(result.boxed);
        EXPECT_EQ(result.shape, shape);
        EXPECT_NEAR(volumeOf(result), volume, 1e-12);
    }
}

TEST(Solids, ThinOnesAreStretchedToTheMinimumAndKeepTheirShape) {
    // 1 m wide, 2 m long, 1 mm thick: the minimum half extent is 2.5 % of 1 m.
    MovingSolid plate;
    plate.positions = brick(Vec3(1, 2, 0.001));
    const SoundSolid thick = sound(plate, Mat3::Identity());
    EXPECT_TRUE(thick.thickened);
    EXPECT_FALSE(thick.boxed);
    EXPECT_LT((thick.box.halfExtents - Vec3(0.5, 1.0, 0.025)).norm(), 1e-12);
    EXPECT_NEAR(volumeOf(thick), 1.0 * 2.0 * 0.05, 1e-12);

    const MovingSolid sheet =
        solidOf(ElementShape::Triangle, cornerColumns({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), Corners::Zero(), 0.002);
    const SoundSolid wedge = sound(sheet, Mat3::Identity());
    EXPECT_EQ(wedge.shape, ElementShape::Wedge);
    EXPECT_NEAR(volumeOf(wedge), 0.5 * 0.025, 1e-12);

    // Below 20 cm the 5 mm rule.
    MovingSolid chip;
    chip.positions = brick(Vec3(0.1, 0.1, 0.001));
    EXPECT_NEAR(sound(chip, Mat3::Identity()).box.halfExtents.z(), 0.005, 1e-15);
}

TEST(Solids, MinimumThicknessItselfIsNotThickened) {
    std::mt19937 random(9);
    for (int i = 0; i < 50; ++i) {
        const Mat3 turn = test::randomRotation(random);
        MovingSolid plate;
        plate.positions = (turn * brick(Vec3(2, 2, 0.05))).colwise() + Vec3(50, 0, 0);
        EXPECT_FALSE(sound(plate, turn).thickened);
    }
}

TEST(Solids, FoldedAndCollapsedOnesBecomeASoundBox) {
    std::mt19937 random(10);
    const Mat3 turn = test::randomRotation(random);
    Corners oblique = brick(Vec3(1, 2, 3));
    oblique.row(2) = oblique.row(0) + oblique.row(1);  // all in a plane that is oblique to the axes
    Corners line = brick(Vec3(1, 0, 0));
    Corners speck = Corners::Constant(3.0);
    const Corners bowTie = cornerColumns({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}});
    for (const Corners& x : {oblique, line, speck, bowTie}) {
        MovingSolid solid;
        solid.positions = turn * x;
        const SoundSolid box = sound(solid, turn);
        EXPECT_TRUE(box.boxed);
        EXPECT_EQ(box.shape, ElementShape::Hexahedron);
        const ConsistentMass m = consistentMass(box.corners, 1.0);
        EXPECT_EQ(m.state, SolidState::Sound);
        EXPECT_NEAR(m.volume, box.box.volume(), 1e-12);
        EXPECT_GE(box.box.halfExtents.minCoeff(), least);
        EXPECT_GE(box.box.halfExtents.minCoeff(), ratio * box.box.halfExtents.maxCoeff() * (1.0 - 1e-12));
        // Every corner of the element lies in the box.
        const auto local =
            (box.box.orientation.toRotationMatrix().transpose() * (solid.positions.colwise() - box.box.centre)).eval();
        EXPECT_LT((local.cwiseAbs().colwise() - box.box.halfExtents).maxCoeff(), 1e-12);
    }
    // The oblique plane's box lies along the plane, not along the element's old axes.
    MovingSolid plane;
    plane.positions = oblique;
    EXPECT_LT(sound(plane, Mat3::Identity()).box.volume(), 0.2 * boxAround(oblique, 8, Mat3::Identity()).volume());
}

TEST(Solids, DegenerateReferenceStillGivesAxes) {
    const Corners flat = brick(Vec3(1, 1, 0));
    const Mat3 axes = boxAxes(flat, brick(Vec3(1, 2, 3)));
    EXPECT_LT((axes - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_NEAR(boxAxes(Corners::Zero(), Corners::Zero()).determinant(), 1.0, 1e-12);
    // A bar without length and a sheet without area.
    for (const ElementShape shape : {ElementShape::Beam, ElementShape::Triangle, ElementShape::Quadrilateral}) {
        const MovingSolid solid = solidOf(shape, Corners::Constant(2.0), Corners::Zero(), 0.01);
        EXPECT_TRUE(solid.positions.allFinite() && solid.velocities.allFinite());
        EXPECT_GE(sound(solid, Mat3::Identity()).box.halfExtents.minCoeff(), least);
    }
}

}  // namespace
}  // namespace rubble
