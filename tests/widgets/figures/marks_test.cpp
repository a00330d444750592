#include "widgets/figures/marks.h"

#include <gtest/gtest.h>

#include <QRectF>

#include <numbers>

#include "widgets/render/basics/camera.h"

namespace rubble::figures {
namespace {

/// Where the axes stand beside something that takes a rectangle of the picture.
std::optional<Corner> cornerBeside(const QRectF& taken, int width = 800, int height = 400) {
    const render::Pane pane{render::PaneContent::Fragments, 0, 0, width, height};
    return axesCorner(pane, 13.0, [&](std::span<const std::array<double, 4>> squares) {
        std::vector<bool> covered;
        for (const auto& [left, top, right, bottom] : squares) {
            covered.push_back(taken.intersects(QRectF(QPointF(left, top), QPointF(right, bottom))));
        }
        return covered;
    });
}

TEST(AxesCorner, IsTheFirstThatCoversNothing) {
    EXPECT_EQ(cornerBeside({300, 0, 200, 400}), Corner::UpperRight) << "room at the sides";
    EXPECT_EQ(cornerBeside({0, 150, 800, 100}), Corner::UpperRight) << "room above and below";
    EXPECT_EQ(cornerBeside({0, 20, 800, 360}), std::nullopt) << "none is free";
    EXPECT_EQ(cornerBeside({}), Corner::UpperRight) << "nothing to cover";
    EXPECT_EQ(cornerBeside({0, 0, 800, 250}), Corner::LowerRight);
    EXPECT_EQ(cornerBeside({}, 800, 60), std::nullopt) << "too low for axes that can be read";
}

TEST(Looking, IsSaidByTheCompassWhereNorthIsKnown) {
    render::Camera camera;
    camera.focalPoint = Vec3::Zero();
    camera.position = Vec3(-10.0, -10.0, 2.0);
    camera.up = Vec3::UnitZ();
    EXPECT_EQ(lookingText(camera, 0.0).toStdString(), "looking north-east (45°)");
    // North lies 90° clockwise from y, along x.
    EXPECT_EQ(lookingText(camera, 0.5 * std::numbers::pi).toStdString(), "looking north-west (315°)");
    EXPECT_EQ(lookingText(camera, std::nullopt).toStdString(), "looking 45° from x towards y");
    camera.position = Vec3(0.0, -10.0, 0.0);
    EXPECT_EQ(lookingText(camera, 0.001).toStdString(), "looking north (0°)");
    camera.position = Vec3(0.0, 0.0, 10.0);
    camera.up = Vec3::UnitY();
    EXPECT_EQ(lookingText(camera, 0.0).toStdString(), "north is up");
    EXPECT_EQ(lookingText(camera, 0.5 * std::numbers::pi).toStdString(), "north 90° clockwise from up");
}

}  // namespace
}  // namespace rubble::figures
