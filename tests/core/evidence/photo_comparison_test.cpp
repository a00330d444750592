#include "core/evidence/photographs/photo_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/evidence/camera_scene.h"
#include "tests/support/error_id.h"

namespace rubble {
namespace {

using Vec2 = Eigen::Vector2d;

/// A camera at the origin's south that looks north along y from a height of 0: x right, z up.
CameraModel northward(double focal) {
    CameraModel camera;
    camera.toCamera = Quat(Eigen::AngleAxisd(M_PI / 2.0, Vec3::UnitX()));
    camera.focal = focal;
    camera.principal = {400.0, 300.0};
    return camera;
}

/// An upright plate across the view at a distance [m].
void addPlate(SiteShape& site, SiteThing thing, double y, double x0, double x1, double z0, double z1) {
    site.add(thing, {x0, y, z0}, {x1, y, z0}, {x1, y, z1});
    site.add(thing, {x0, y, z0}, {x1, y, z1}, {x0, y, z1});
}

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

SilhouettePair emptyPair(int width, int height) {
    const std::vector<std::uint8_t> none(static_cast<std::size_t>(width * height), 0);
    return {width, height, none, none, none};
}

TEST(Silhouette, HalvesOfAPictureScoreAsByHand) {
    SilhouettePair pair = emptyPair(100, 40);
    for (std::size_t i = 0; i < pair.simulated.size(); ++i) {
        pair.simulated[i] = i % 100 < 50;
        pair.observed[i] = i % 100 < 60;
    }
    SilhouetteScore score = scoreOf(pair);
    EXPECT_DOUBLE_EQ(score.iou, 50.0 / 60.0);
    // Rims of the picture are no edges: only the two upright ones, ten pixels apart, are.
    EXPECT_DOUBLE_EQ(score.edgeDistance, 10.0);
    for (std::size_t i = 0; i < pair.left.size(); ++i) {
        pair.left[i] = i % 100 >= 50;
    }
    score = scoreOf(pair);
    EXPECT_DOUBLE_EQ(score.iou, 1.0);
    EXPECT_TRUE(std::isnan(score.edgeDistance));
}

TEST(Silhouette, EdgeDistanceIsThatOfBruteForce) {
    RandomNumbers random(3);
    for (int trial = 0; trial < 20; ++trial) {
        SilhouettePair pair = emptyPair(23, 17);
        const double share = random.between(0.02, 0.9);
        for (std::size_t i = 0; i < pair.simulated.size(); ++i) {
            pair.simulated[i] = random.between(0.0, 1.0) < share;
            pair.observed[i] = random.between(0.0, 1.0) < share;
            pair.left[i] = random.between(0.0, 1.0) < 0.1;
        }
        const auto edge = [&](const std::vector<std::uint8_t>& of) {
            std::vector<Vec2> points;
            for (int y = 0; y < pair.height; ++y) {
                for (int x = 0; x < pair.width; ++x) {
                    const auto at = [&](int u, int v) { return static_cast<std::size_t>(v * pair.width + u); };
                    bool open = false;
                    for (const auto& [u, v] :
                         {std::pair(x - 1, y), std::pair(x + 1, y), std::pair(x, y - 1), std::pair(x, y + 1)}) {
                        open = open || (u >= 0 && v >= 0 && u < pair.width && v < pair.height && of[at(u, v)] == 0 &&
                                        pair.left[at(u, v)] == 0);
                    }
                    if (of[at(x, y)] != 0 && pair.left[at(x, y)] == 0 && open) {
                        points.emplace_back(x, y);
                    }
                }
            }
            return points;
        };
        const auto mean = [](const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
            double sum = 0.0;
            for (const Vec2& a : from) {
                double least = 1e9;
                for (const Vec2& b : to) {
                    least = std::min(least, (a - b).norm());
                }
                sum += least;
            }
            return sum / static_cast<double>(from.size());
        };
        const auto a = edge(pair.simulated);
        const auto b = edge(pair.observed);
        if (!a.empty() && !b.empty()) {
            EXPECT_NEAR(scoreOf(pair).edgeDistance, 0.5 * (mean(a, b) + mean(b, a)), 1e-9);
        }
    }
}

TEST(SitePicture, APlateCoversWhatOpticsSays) {
    SiteShape site;
    addPlate(site, SiteThing::Debris, 20.0, -4.0, 4.0, -3.0, 3.0);
    const SitePicture picture = pictureOf(site, northward(800.0), 800, 600, 800);
    const auto debris = debrisIn(picture, false);
    // 8 m at 20 m with a focal length of 800 px: 320 px; 6 m: 240 px.
    EXPECT_EQ(std::count(debris.begin(), debris.end(), 1), 320 * 240);
    EXPECT_NEAR(picture.depths[picture.index(400, 300)], 20.0, 1e-4);
    EXPECT_EQ(picture.things[picture.index(239, 300)], SiteThing::Nothing);
    EXPECT_EQ(picture.things[picture.index(240, 300)], SiteThing::Debris);
}

TEST(SitePicture, WhatStandsInFrontHides) {
    SiteShape site;
    addPlate(site, SiteThing::Structure, 10.0, -10.0, 0.0, -10.0, 10.0);
    addPlate(site, SiteThing::Debris, 20.0, -4.0, 4.0, -3.0, 3.0);
    addPlate(site, SiteThing::FallenStructure, 15.0, 0.0, 3.0, -3.0, 3.0);
    const SitePicture picture = pictureOf(site, northward(800.0), 800, 600, 800);
    const auto count = [&](bool withFallen) {
        const auto debris = debrisIn(picture, withFallen);
        return std::count(debris.begin(), debris.end(), 1);
    };
    EXPECT_EQ(count(false), 0);         // 160 px of the plate are behind the structure, the rest behind what has fallen
    EXPECT_EQ(count(true), 160 * 320);  // 3 m at 15 m: 160 px; 6 m: 320 px
}

TEST(SitePicture, DistortionMovesCornersAndFoldsNothingBack) {
    CameraModel camera = northward(400.0);
    camera.radial = {-0.2, 0.0};
    SiteShape site;
    // Far off the axis the polynomial turns round; what lies there must not show up in the middle.
    addPlate(site, SiteThing::Debris, 10.0, 22.0, 24.0, -1.0, 1.0);
    const SitePicture picture = pictureOf(site, camera, 800, 600, 800);
    EXPECT_EQ(std::count(picture.things.begin(), picture.things.end(), SiteThing::Debris), 0);
    EXPECT_NEAR(distortionReach(camera), std::sqrt(1.0 / 0.6), 1e-12);

    SiteShape small;
    addPlate(small, SiteThing::Debris, 10.0, 5.0, 6.0, -0.5, 0.5);
    const SitePicture bent = pictureOf(small, camera, 800, 600, 800);
    double sum = 0.0;
    double count = 0.0;
    for (int y = 0; y < 600; ++y) {
        for (int x = 0; x < 800; ++x) {
            if (bent.things[bent.index(x, y)] == SiteThing::Debris) {
                sum += x + 0.5;
                count += 1.0;
            }
        }
    }
    // The middle of a small plate lies near where its middle is projected; without distortion it would be 12 px farther right.
    EXPECT_NEAR(sum / count, camera.project({5.5, 10.0, 0.0})->x(), 1.0);
    EXPECT_LT(sum / count, 400.0 + 400.0 * 0.55 - 10.0);
}

/// A match that is known to a standard deviation of place and turn.
CameraMatch matchOf(const CameraModel& camera, double place, double turn) {
    CameraMatch match;
    match.camera = camera;
    match.found = {0, 1, 2, 3, 4, 5};
    match.freedom = 10;
    match.covariance = Eigen::MatrixXd::Zero(6, 6);
    match.covariance.topLeftCorner<3, 3>() = place * place * Mat3::Identity();
    match.covariance.bottomRightCorner<3, 3>() = turn * turn * Mat3::Identity();
    return match;
}

TEST(PhotoComparison, DrawnCamerasSpreadAsTheMatchSays) {
    const CameraMatch match = matchOf(northward(800.0), 0.3, 0.002);
    Vec3 squares = Vec3::Zero();
    double turns = 0.0;
    constexpr int count = 20000;
    for (const CameraModel& camera : drawnCameras(match, count, 7)) {
        squares += (camera.place - match.camera.place).cwiseAbs2();
        const double angle = camera.toCamera.angularDistance(match.camera.toCamera);
        turns += angle * angle;
    }
    // Student's t with n degrees of freedom has the variance n / (n - 2).
    const double wider = 10.0 / 8.0;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(squares[axis] / count, 0.09 * wider, 0.05 * 0.09);
    }
    EXPECT_NEAR(turns / count, 3.0 * 4e-6 * wider, 0.05 * 12e-6);
    EXPECT_EQ(drawnCameras(match, 3, 7)[2].place, drawnCameras(match, 3, 7)[2].place);
}

class DrawnPlate : public testing::Test {
protected:
    void SetUp() override {
        addPlate(m_site, SiteThing::Debris, 20.0, -4.0, 4.0, -3.0, 3.0);
        m_photograph.facts.width = 800;
        m_photograph.facts.height = 600;
    }
    void draw(MaskClass kind, double x0, double y0, double x1, double y1) {
        m_photograph.masks.push_back({kind, rectangle(x0, y0, x1, y1)});
    }
    PhotoComparison compare(double place = 0.0, double turn = 0.0) const {
        return compareWithPhoto(m_site, m_photograph, matchOf(northward(800.0), place, turn), m_settings, Execution());
    }

    SiteShape m_site;
    Photograph m_photograph;
    ComparisonSettings m_settings{.cameras = 24};
};

TEST_F(DrawnPlate, ScoresAsByHand) {
    // The plate covers 240 to 560 by 180 to 420; drawn 16 px to the right.
    draw(MaskClass::Debris, 256.0, 180.0, 576.0, 420.0);
    const PhotoComparison made = compare();
    EXPECT_NEAR(made.iou.best, 304.0 / 336.0, 1e-12);
    EXPECT_NEAR(made.iou.spread, 0.0, 1e-12);
    EXPECT_NEAR(made.distance, 20.0, 1e-4);
    EXPECT_NEAR(made.pixelMetres, 20.0 / 800.0, 1e-6);
    EXPECT_NEAR(made.edgeMetres.best, made.edgePixels.best * 0.025, 1e-6);
    // Upright edges are 16 px off, level ones nowhere but at their ends.
    EXPECT_GT(made.edgePixels.best, 0.9 * 16.0 * 240.0 / 560.0);
    EXPECT_LT(made.edgePixels.best, 16.0);
    ASSERT_EQ(made.outlines.size(), 1u);
    EXPECT_EQ(made.outlines[0].size(), 4u);
    EXPECT_EQ(made.words.id, "photo.agreement");
    // Nothing that was drawn counts any more: there is one edge at most.
    draw(MaskClass::Hidden, 400.0, 0.0, 800.0, 600.0);
    m_photograph.masks.front().corners = rectangle(500.0, 180.0, 576.0, 420.0);
    EXPECT_EQ(compare().words.id, "photo.no_edges");
}

TEST_F(DrawnPlate, WhatIsHiddenOrMovedDoesNotCountAndWhatIsNoDebrisDoes) {
    draw(MaskClass::Debris, 240.0, 180.0, 600.0, 420.0);
    EXPECT_NEAR(compare().iou.best, 320.0 / 360.0, 1e-12);
    draw(MaskClass::Hidden, 500.0, 0.0, 800.0, 600.0);
    EXPECT_NEAR(compare().iou.best, 1.0, 1e-12);
    m_photograph.masks.back().kind = MaskClass::Moved;
    EXPECT_NEAR(compare().iou.best, 1.0, 1e-12);
    m_photograph.masks.back() = {MaskClass::NotDebris, rectangle(560.0, 0.0, 800.0, 600.0)};
    EXPECT_NEAR(compare().iou.best, 1.0, 1e-12);
    m_photograph.masks.back().corners = rectangle(480.0, 0.0, 800.0, 600.0);
    EXPECT_NEAR(compare().iou.best, 240.0 / 320.0, 1e-12);
}

TEST_F(DrawnPlate, TheUncertaintyOfThePoseComesIntoTheScore) {
    draw(MaskClass::Debris, 240.0, 180.0, 560.0, 420.0);
    const PhotoComparison sure = compare(0.001, 1e-6);
    const PhotoComparison unsure = compare(0.0, 0.01);
    EXPECT_GT(sure.iou.mean, 0.99);
    // A turn of 0.01 rad moves the plate by 8 px: the overlap falls by about 2 x 8 / 320 for each axis it is turned about.
    EXPECT_LT(unsure.iou.mean, 0.95);
    EXPECT_GT(unsure.iou.mean, 0.80);
    EXPECT_GT(unsure.iou.spread, 0.01);
    EXPECT_EQ(unsure.iou.mean,
              compareWithPhoto(m_site, m_photograph, matchOf(northward(800.0), 0.0, 0.01), m_settings, Execution().withThreads(1))
                  .iou.mean);
}

TEST_F(DrawnPlate, WithoutAnOutlineThereIsNothingToCompare) {
    EXPECT_EQ(idOfError([&] { compare(); }), "photo.no_outline");
    draw(MaskClass::Debris, 240.0, 180.0, 560.0, 420.0);
    draw(MaskClass::Hidden, 0.0, 0.0, 800.0, 600.0);
    EXPECT_EQ(idOfError([&] { compare(); }), "photo.nothing_counts");
}

// The whole way: points clicked with an error of 2 px, one of them wrong, a lens with distortion, the outline as the camera saw it.
TEST(PhotoComparison, ASyntheticPhotographOfKnownDebrisAgrees) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        CameraScene scene(seed, 16, 0.0);
        scene.camera.radial = {-0.08, 0.0};
        scene.known.radialTerms = 1;
        scene.known.focal.reset();
        scene.retake(2.0);
        scene.pairs[3].picture += Vec2(90.0, -120.0);
        const CameraMatch match = scene.match();
        EXPECT_FALSE(match.used[3]);
        SiteShape site;
        addPlate(site, SiteThing::Debris, 0.0, -10.0, 8.0, 0.0, 3.0);
        addPlate(site, SiteThing::Debris, 2.0, -6.0, 4.0, 0.0, 6.0);
        Photograph photograph;
        photograph.facts.width = scene.known.width;
        photograph.facts.height = scene.known.height;
        const SitePicture seen = pictureOf(site, scene.camera, 4000, 3000, 4000);
        for (const auto& ring : outlinesOf(seen, debrisIn(seen, true))) {
            photograph.masks.push_back({MaskClass::Debris, ring});
        }
        const PhotoComparison made = compareWithPhoto(site, photograph, match, {.longestSide = 500, .cameras = 8}, Execution());
        EXPECT_GT(made.iou.best, 0.97) << seed;
        EXPECT_LT(made.edgeMetres.best, 0.2) << seed;
        EXPECT_NEAR(made.iou.best, made.iou.mean, 0.02) << seed;
    }
}

}  // namespace
}  // namespace rubble
