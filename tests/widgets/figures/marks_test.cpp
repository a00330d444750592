#include "widgets/figures/marks.h"

#include <gtest/gtest.h>

#include "widgets/render/basics/camera.h"

namespace rubble::figures {
namespace {

/// Where the axes stand if a box is seen by a camera that shows it whole.
std::optional<Corner> cornerFor(const Aabb& box, render::Preset look) {
    const render::Pane pane{render::PaneContent::Fragments, 0, 0, 800, 400};
    render::View view;
    view.cameras.fill(render::fitCamera(box, 2.0, look));
    return axesCorner(view, pane, box, 13.0);
}

TEST(AxesCorner, IsTheFirstThatCoversNothing) {
    const Vec3 zero = Vec3::Zero();
    EXPECT_EQ(cornerFor(Aabb(zero, Vec3(10.0, 10.0, 10.0)), render::Preset::Front), Corner::UpperRight) << "room at the sides";
    EXPECT_EQ(cornerFor(Aabb(zero, Vec3(100.0, 1.0, 10.0)), render::Preset::Front), Corner::UpperRight) << "room above and below";
    EXPECT_EQ(cornerFor(Aabb(zero, Vec3(20.0, 1.0, 10.0)), render::Preset::Front), std::nullopt) << "none is free";
    EXPECT_EQ(cornerFor(Aabb(), render::Preset::Front), Corner::UpperRight) << "nothing to cover";
    // Moved up in the picture, a long box leaves its foot free.
    const Aabb high(zero, Vec3(100.0, 1.0, 10.0));
    const render::Pane pane{render::PaneContent::Fragments, 0, 0, 800, 400};
    render::View view;
    view.cameras.fill(render::pan(render::fitCamera(high, 2.0, render::Preset::Front), 0.0, -150.0, 400.0));
    EXPECT_EQ(axesCorner(view, pane, high, 13.0), Corner::LowerRight);
}

}  // namespace
}  // namespace rubble::figures
