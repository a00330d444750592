#include "core/evidence/site_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace rubble {

namespace {

/// A ramp of debris from 0 to 3 m over 10 m of x, 8 m wide, on level ground at 1 m.
SiteShape rampOnGround() {
    SiteShape site;
    const auto quad = [&](SiteThing thing, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        site.add(thing, a, b, c);
        site.add(thing, a, c, d);
    };
    quad(SiteThing::Debris, {0, -4, 1}, {10, -4, 4}, {10, 4, 4}, {0, 4, 1});
    quad(SiteThing::Ground, {-20, -20, 1}, {20, -20, 1}, {20, 20, 1}, {-20, 20, 1});
    return site;
}

SiteSurface groundAtOne() {
    SiteSurface ground;
    ground.levelHeight = 1.0;
    return ground;
}

SiteSection cutRamp(const SectionLine& line, const std::vector<Vec3>& measured) {
    const SiteShape site = rampOnGround();
    const SurfaceTree tree(site.points, site.triangles);
    return siteSection(site, tree, groundAtOne(), line, std::vector<MeasuredSet>{{"survey", measured}}, Execution());
}

/// Points every 5 cm along x at a height above the ramp.
std::vector<Vec3> pointsAlong(double lift, double y = 0.0) {
    std::vector<Vec3> points;
    for (double x = -4.975; x < 15.0; x += 0.05) {
        const double ramp = x > 0.0 && x < 10.0 ? 1.0 + 0.3 * x : 1.0;
        points.emplace_back(x, y, ramp + lift);
    }
    return points;
}

const SectionLine sectionAlongX{{-5.0, 0.0}, {15.0, 0.0}, 1.0, 0.5};

TEST(SiteSection, ProfileIsTheHighestSurface) {
    const SiteSection made = cutRamp(sectionAlongX, {});
    ASSERT_EQ(made.steps.size(), 40u);
    EXPECT_NEAR(made.steps[0].simulated, 1.0, 1e-9);
    EXPECT_EQ(made.steps[0].thing, SiteThing::Ground);
    // Middle of the step from 4 to 4.5 m of x.
    const SectionStep& middle = made.steps[18];
    EXPECT_NEAR(middle.along, 9.25, 1e-12);
    EXPECT_NEAR(middle.simulated, 1.0 + 0.3 * 4.25, 1e-9);
    EXPECT_EQ(middle.thing, SiteThing::Debris);
    EXPECT_NEAR(middle.ground, 1.0, 1e-12);
    EXPECT_TRUE(std::isnan(middle.measured));
    EXPECT_TRUE(std::isnan(made.agreement.mean)) << "nothing was measured, which is no difference of 0";
}

TEST(SiteSection, AreaIsThatOfTheTriangleOnPaper) {
    const SiteSection made = cutRamp(sectionAlongX, pointsAlong(0.0));
    EXPECT_EQ(made.agreement.compared, 400);
    EXPECT_NEAR(made.agreement.rms, 0.0, 1e-9);
    EXPECT_NEAR(made.simulatedArea, 0.5 * 10.0 * 3.0, 1e-6);
    EXPECT_NEAR(made.measuredArea, made.simulatedArea, 1e-9);
    EXPECT_NEAR(made.covered, 20.0, 1e-9);
    const SiteSection lifted = cutRamp(sectionAlongX, pointsAlong(0.2));
    EXPECT_NEAR(lifted.agreement.mean, -0.2, 1e-9) << "the simulation lies below what was measured";
    EXPECT_NEAR(lifted.agreement.rms, 0.2, 1e-9);
    EXPECT_NEAR(lifted.measuredArea - lifted.simulatedArea, 0.2 * 20.0, 1e-6);
}

TEST(SiteSection, OnlyWhatLiesWithinTheWidthCounts) {
    EXPECT_EQ(cutRamp(sectionAlongX, pointsAlong(0.0, 0.6)).points.size(), 0u);
    const SiteSection near = cutRamp(sectionAlongX, pointsAlong(0.0, 0.4));
    EXPECT_EQ(near.points.size(), 400u);
    EXPECT_NEAR(near.points.front().across, 0.4, 1e-9) << "to the left";
    // Beyond the site nothing is met, and nothing is compared.
    SectionLine far = sectionAlongX;
    far.from.x() = -40.0;
    const SiteSection made = cutRamp(far, {Vec3(-30.0, 0.0, 1.0), Vec3(-10.0, 0.0, 1.5)});
    EXPECT_EQ(made.points.size(), 2u);
    EXPECT_EQ(made.agreement.compared, 1);
    EXPECT_NEAR(made.agreement.mean, -0.5, 1e-9);
    EXPECT_NEAR(made.measuredArea, 0.5 * 0.5, 1e-6) << "both areas are of the same places";
}

TEST(SiteSection, EachSetAgreesByItself) {
    const SiteShape site = rampOnGround();
    const SurfaceTree tree(site.points, site.triangles);
    const std::vector<MeasuredSet> sets{
        {"cloud", pointsAlong(0.2)}, {"beside", {Vec3(0.0, 9.0, 1.0)}}, {"station", {Vec3(-1.0, 0.0, 0.9), Vec3(-2.0, 0.0, 0.9)}}};
    const SiteSection made = siteSection(site, tree, groundAtOne(), sectionAlongX, sets, Execution());
    ASSERT_EQ(made.sources.size(), 3u);
    EXPECT_EQ(made.sources[0].name, "cloud");
    EXPECT_NEAR(made.sources[0].agreement.mean, -0.2, 1e-9);
    EXPECT_EQ(made.sources[1].agreement.points, 0);
    EXPECT_TRUE(std::isnan(made.sources[1].agreement.mean));
    EXPECT_EQ(made.sources[2].agreement.compared, 2);
    EXPECT_NEAR(made.sources[2].agreement.mean, 0.1, 1e-9);
    EXPECT_EQ(made.agreement.points, 402);
    EXPECT_NEAR(made.agreement.mean, (400.0 * -0.2 + 2.0 * 0.1) / 402.0, 1e-9);
    // Each point says whose it is, though all stand along the line.
    const auto station = std::count_if(made.points.begin(), made.points.end(), [](const SectionPoint& p) { return p.source == 2; });
    EXPECT_EQ(station, 2);
}

TEST(SiteSection, ALineGoesAlongWhatWasMeasured) {
    SectionLine usual;
    usual.width = 2.0;
    usual.step = 0.5;
    // From north-east to south-west, with one place beside: the line begins in the west.
    const std::vector<MeasuredSet> sets{{"station", {Vec3(9, 12, 1), Vec3(6, 8, 2), Vec3(3, 4, 1)}},
                                        {"more", {Vec3(0, 0, 3), Vec3(-3, -4, 1)}}};
    const SectionLine line = lineAlong(sets, usual);
    EXPECT_LT((line.from - Eigen::Vector2d(-3.6, -4.8)).norm(), 1e-9) << "half a width beyond the outermost";
    EXPECT_LT((line.to - Eigen::Vector2d(9.6, 12.8)).norm(), 1e-9);
    EXPECT_EQ(line.width, 2.0);
    EXPECT_EQ(line.step, 0.5);
    // Far from the origin it is as exact as coordinates are.
    const Vec3 far(4.5e6, 5.1e6, 0.0);
    const std::vector<MeasuredSet> there{{"station", {far + Vec3(0, 30, 0), far, far + Vec3(0, 10, 0)}}};
    const SectionLine north = lineAlong(there, usual);
    EXPECT_NEAR(north.from.y(), 5.1e6 - 1.0, 1e-6);
    EXPECT_NEAR(north.to.y(), 5.1e6 + 31.0, 1e-6);
    EXPECT_NEAR(north.to.x(), 4.5e6, 1e-6);
    EXPECT_THROW(lineAlong(std::vector<MeasuredSet>{{"one", {Vec3(1, 2, 3), Vec3(1, 2, 9)}}}, usual), UsageError);
    EXPECT_THROW(lineAlong({}, usual), UsageError);
}

TEST(SiteSection, ALineOfNoLengthIsRefused) {
    SectionLine none = sectionAlongX;
    none.to = none.from;
    EXPECT_THROW(cutRamp(none, {}), UsageError);
    SectionLine fine = sectionAlongX;
    fine.step = 1e-5;
    EXPECT_THROW(cutRamp(fine, {}), UsageError);
}

}  // namespace

}  // namespace rubble
