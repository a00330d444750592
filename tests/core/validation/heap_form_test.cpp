#include "core/validation/heap_form.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rubble {
namespace {

OrientedBox cubeAt(double x, double y = 0.0) {
    return {{x, y, 0.5}, Quat::Identity(), Vec3::Constant(0.5)};
}

TEST(HeapForm, TheDepositIsWhatHangsTogether) {
    const std::vector<OrientedBox> boxes{cubeAt(0.0), cubeAt(1.05), cubeAt(2.2), cubeAt(4.0), cubeAt(4.9, 3.0)};
    EXPECT_EQ(joinedBoxes(boxes, Vec3::Zero(), 0.1).size(), 2u);
    EXPECT_EQ(joinedBoxes(boxes, Vec3::Zero(), 0.2).size(), 3u);
    EXPECT_EQ(joinedBoxes(boxes, {4.9, 3.0, 0.0}, 0.2).size(), 1u) << "around another heart";
    EXPECT_TRUE(joinedBoxes({}, Vec3::Zero(), 0.2).empty());
}

TEST(HeapForm, TheSurfaceIsTheHighestBoxOfEachCell) {
    double volume = 0.0;
    HeapSurface({cubeAt(0.0), cubeAt(0.5)}, 3.0, 2.0).each([&](double, double, double top) {
        EXPECT_TRUE(top == -1.0 || std::abs(top - 1.0) < 1e-12);
        volume += top > 0.0 ? 0.05 * 0.05 * top : 0.0;
    });
    EXPECT_NEAR(volume, 1.5, 0.1) << "what overlaps counts once";
}

TEST(HeapForm, AProfileIsTheMeanByDistance) {
    HeapProfile profile(1.0);
    profile.add(0.2, 3.0);
    profile.add(0.7, 1.0);
    profile.add(2.5, 0.5);
    profile.add(2.5, -1.0);
    profile.finish();
    EXPECT_EQ(profile.height(), (std::vector<double>{2.0, 0.0, 0.25})) << "bare cells count as 0";
}

TEST(HeapForm, FrontAndPowerLawAreThoseOfClosedForms) {
    const auto sectorOf = [](const OrientedBox& box) { return static_cast<std::size_t>(box.centre.y() > 0.0); };
    const auto reachOf = [](const OrientedBox& box) { return box.centre.x(); };
    EXPECT_EQ(meanFront({cubeAt(1.0), cubeAt(3.0), cubeAt(7.0, 1.0)}, 2, sectorOf, reachOf), 5.0);
    const PowerLaw law = powerLawThrough({{1.0, 1.6}, {4.0, 3.2}, {16.0, 6.4}});
    EXPECT_NEAR(law.exponent, 0.5, 1e-12);
    EXPECT_NEAR(law.factor, 1.6, 1e-12);
    EXPECT_TRUE(std::isnan(powerLawThrough({{2.0, 1.0}}).exponent));
    EXPECT_EQ(factorApart(2.0, 8.0), 4.0);
    EXPECT_TRUE(std::isinf(factorApart(0.0, 8.0)));
}

}  // namespace
}  // namespace rubble
