#include "core/analysis/debris/box_outline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/analysis/debris_scene.h"

namespace rubble {
namespace {

using analysis_scene::randomField;

OrientedBox turned(const Vec3& half, double angle, const Vec3& axis) {
    return {Vec3(3.0, -2.0, 1.0), Quat(Eigen::AngleAxisd(angle, axis.normalized())), half};
}

TEST(BoxOutline, OfAnUprightBoxIsItsBase) {
    const SmallPolygon outline = outlineOf(turned(Vec3(1.0, 0.5, 7.0), 0.0, Vec3::UnitZ()));
    EXPECT_EQ(outline.size, 4u);
    EXPECT_NEAR(outline.area(), 2.0, 1e-14);
}

TEST(BoxOutline, OfATiltedBoxHasTheAreaOfItsShadow) {
    // Area of the shadow: sum over the faces of area times the upward part of the normal.
    for (const DebrisFragment& lies : randomField(7, 200, 10.0).fragments) {
        const OrientedBox& box = lies.box;
        const Mat3 axes = box.orientation.toRotationMatrix();
        const Vec3& h = box.halfExtents;
        const double shadow = 4.0 * (h.y() * h.z() * std::abs(axes(2, 0)) + h.x() * h.z() * std::abs(axes(2, 1)) +
                                     h.x() * h.y() * std::abs(axes(2, 2)));
        EXPECT_NEAR(outlineOf(box).area(), shadow, 1e-12 * shadow);
    }
}

TEST(BoxOutline, HoldsTheShadowOfEveryCorner) {
    for (const DebrisFragment& lies : randomField(8, 100, 10.0).fragments) {
        const SmallPolygon outline = outlineOf(lies.box);
        for (int c = 0; c < 8; ++c) {
            const Vec3 sign(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1);
            const Eigen::Vector2d p = (lies.box.centre + lies.box.orientation * lies.box.halfExtents.cwiseProduct(sign)).head<2>();
            for (std::size_t k = 0; k < outline.size; ++k) {
                const Eigen::Vector2d along = outline.corners[(k + 1) % outline.size] - outline.corners[k];
                const Eigen::Vector2d to = p - outline.corners[k];
                EXPECT_GE(along.x() * to.y() - along.y() * to.x(), -1e-12);
            }
        }
    }
}

TEST(BoxOutline, WithoutExtentHasNoArea) {
    EXPECT_EQ(outlineOf(turned(Vec3::Zero(), 0.3, Vec3::UnitX())).area(), 0.0);
    EXPECT_EQ(outlineOf(turned(Vec3(0, 0, 1), 0.0, Vec3::UnitX())).area(), 0.0);
    EXPECT_EQ(outlineOf(turned(Vec3(1, 0, 1), 0.0, Vec3::UnitX())).area(), 0.0);
}

TEST(BoxOutline, IsCutLikeASheetOfPaper) {
    const SmallPolygon outline = outlineOf(turned(Vec3(1.0, 1.0, 1.0), 0.0, Vec3::UnitZ()));
    // The square reaches from 2 to 4 along x.
    EXPECT_NEAR(clipped(outline, 0, 2.5, 3.0).area(), 1.0, 1e-14);
    EXPECT_NEAR(clipped(outline, 0, -9.0, 9.0).area(), 4.0, 1e-14);
    EXPECT_NEAR(clipped(outline, 0, 4.0, 9.0).area(), 0.0, 1e-14);
    EXPECT_EQ(clipped(outline, 0, 5.0, 9.0).size, 0u);
    const SmallPolygon diamond = outlineOf(turned(Vec3(1.0, 1.0, 1.0), M_PI / 4.0, Vec3::UnitZ()));
    EXPECT_NEAR(clipped(diamond, 1, -2.0, 9.0).area(), 2.0, 1e-14) << "half of it";
}

TEST(BoxTop, OfAnUprightBoxIsLevel) {
    const BoxTop top(turned(Vec3(1.0, 0.5, 2.0), 0.0, Vec3::UnitZ()));
    EXPECT_DOUBLE_EQ(top.at(3.9, -1.6).value(), 3.0);
    EXPECT_FALSE(top.at(4.1, -2.0));
    EXPECT_FALSE(top.at(3.0, -1.4));
}

TEST(BoxTop, OfABoxOnItsEdgeIsARidge) {
    const BoxTop top(turned(Vec3(1.0, 1.0, 1.0), M_PI / 4.0, Vec3::UnitX()));
    EXPECT_NEAR(top.at(3.0, -2.0).value(), 1.0 + std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(top.at(3.0, -1.5).value(), 0.5 + std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace rubble
