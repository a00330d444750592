#include "core/evidence/photographs/camera_match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/error.h"
#include "tests/core/evidence/camera_scene.h"
#include "tests/support/run_tests.h"

namespace rubble {
namespace {

std::string refusalOf(const CameraScene& scene) {
    try {
        scene.match();
    } catch (const UsageError& error) {
        EXPECT_FALSE(error.remedy().empty());
        return error.message().id;
    }
    return "none";
}

TEST(CameraMatch, FindsTheCameraThatTookThePicture) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const CameraScene scene(seed, 8, 0.0);
        const CameraMatch match = scene.match();
        // Exact clicks: what is left is rounding of the least squares.
        EXPECT_LT((match.camera.place - scene.camera.place).norm(), 1e-5) << seed;
        EXPECT_LT(match.camera.toCamera.angularDistance(scene.camera.toCamera), 1e-6) << seed;
        EXPECT_LT(match.rms, 1e-4);
        EXPECT_TRUE(match.wrong().empty());
        EXPECT_EQ(match.verdict, MatchVerdict::Good);
    }
}

TEST(CameraMatch, FindsFocalLengthPrincipalPointAndDistortionToo) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        CameraScene scene(seed, 30, 0.0);
        scene.camera.principal = {2040.0, 1460.0};
        scene.camera.radial = {-0.12, 0.03};
        scene.retake(0.0);
        scene.known.focal.reset();
        scene.known.freePrincipal = true;
        scene.known.radialTerms = 2;
        const CameraMatch match = scene.match();
        EXPECT_NEAR(match.camera.focal, scene.camera.focal, 0.1) << seed;
        EXPECT_LT((match.camera.principal - scene.camera.principal).norm(), 0.1) << seed;
        EXPECT_LT((match.camera.radial - scene.camera.radial).norm(), 1e-3) << seed;
        EXPECT_EQ(match.found, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
    }
}

TEST(CameraMatch, WorksInTheCoordinatesOfACountry) {
    CameraScene scene(3, 12, 0.0);
    const Vec3 country(512345.0, 5712345.0, 87.0);
    for (PointPair& pair : scene.pairs) {
        pair.model += country;
    }
    EXPECT_LT((scene.match().camera.place - scene.camera.place - country).norm(), 1e-4);
}

std::uint64_t trialCount() {
    return sizedTo<std::uint64_t>(50, 200, 1000);
}

/// What the 95 % region and the stated spread are worth.
struct Trials {
    int inside = 0;
    int inBall = 0;  ///< within the radius that is stated
    int done = 0;
    std::vector<double> radii;   ///< m
    Vec3 square = Vec3::Zero();  ///< m2, sum of the squared errors of the place, camera axes
    Vec3 stated = Vec3::Zero();  ///< m2, sum of the stated variances

    void add(const CameraScene& scene) {
        const CameraMatch match = scene.match();
        ++done;
        inBall += (match.camera.place - scene.camera.place).norm() <= match.placeRadius;
        radii.push_back(match.placeRadius);
        inside += match.holds(scene.camera);
        square += (match.camera.place - scene.camera.place).cwiseAbs2();
        stated += match.covariance.diagonal().head<3>();
    }
    double middleRadius() const {
        std::vector<double> sorted = radii;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
    void expectHonest() const {
        // Of 1,000 trials at 95 % the share inside has a standard deviation of 0.7 %, of 200 of 1.5 %: three of them are allowed.
        // A ratio of 1.3 is beyond three standard deviations of a spread from 50 trials.
        testing::Test::RecordProperty("inside", inside);
        EXPECT_NEAR(inside, 0.95 * done, 3.0 * std::sqrt(0.95 * 0.05 * done));
        for (int axis = 0; axis < 3; ++axis) {
            const double ratio = std::sqrt(square[axis] / stated[axis]);
            testing::Test::RecordProperty("spread_over_stated_" + std::to_string(axis), std::to_string(ratio));
            EXPECT_GT(ratio, 1.0 / 1.3) << axis;
            EXPECT_LT(ratio, 1.3) << axis;
        }
    }
};

TEST(CameraMatch, StatesItsUncertaintyHonestly) {
    Trials trials;
    for (std::uint64_t seed = 1; seed <= trialCount(); ++seed) {
        trials.add(CameraScene(seed, 12, 2.0));
    }
    trials.expectHonest();
}

TEST(CameraMatch, StatesItWithAFreeFocalLengthDistortionAndWrongPairsToo) {
    Trials trials;
    for (std::uint64_t seed = 1; seed <= trialCount(); ++seed) {
        CameraScene scene(seed, 20, 1.5);
        scene.camera.radial[0] = -0.08;
        scene.retake(1.5);
        scene.known.focal.reset();
        scene.known.radialTerms = 1;
        scene.pairs[4].picture += Eigen::Vector2d(180.0, -90.0);
        scene.pairs[11].picture += Eigen::Vector2d(-60.0, 75.0);
        trials.add(scene);
    }
    trials.expectHonest();
}

/// Lenses that there are: none, a phone, barrel and cushion.
const std::vector<Eigen::Vector2d>& lenses() {
    static const std::vector<Eigen::Vector2d> list{{0.0, 0.0}, {0.0885, -0.2324}, {-0.25, 0.08}, {0.15, 0.0}};
    return list;
}

Trials lensTrials(const Eigen::Vector2d& lens, std::size_t points, bool known, std::uint64_t count) {
    Trials trials;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        CameraScene scene(seed, points, 1.0);
        scene.camera.radial = lens;
        scene.retake(1.0);
        if (!known) {
            scene.known.focal.reset();
        }
        try {
            trials.add(scene);
        } catch (const UsageError&) {
            EXPECT_LT(points, 8u) << "few points may leave two cameras";
        }
    }
    return trials;
}

TEST(CameraMatch, AnUnknownLensWidensTheRegionAsFarAsItMust) {
    const auto count = sizedTo<std::uint64_t>(8, 24, 1000);
    const std::vector<std::size_t> sizes = wholeTests() ? std::vector<std::size_t>{6, 8, 20, 40} : std::vector<std::size_t>{6, 20};
    for (const Eigen::Vector2d& lens : lenses()) {
        for (const std::size_t points : sizes) {
            for (const bool known : {true, false}) {
                const Trials trials = lensTrials(lens, points, known, count);
                EXPECT_GE(trials.done, 0.85 * static_cast<double>(count));
                // At 95 % three standard deviations below: 82 % of 24, 93 % of 1,000. A ball about an ellipsoid holds more.
                EXPECT_GE(trials.inBall, 0.95 * trials.done - 3.0 * std::sqrt(0.95 * 0.05 * trials.done))
                    << lens.transpose() << ", points " << points << ", focal length known " << known;
            }
        }
    }
}

/// A phone on a quay: the distortion of its lens is real, and nobody said anything of it.
CameraScene phoneScene(std::uint64_t seed) {
    CameraScene scene(seed, 0, 0.0);
    scene.known.width = 3264;
    scene.known.height = 2448;
    scene.camera.principal = {1632.0, 1224.0};
    scene.camera.focal = 2839.0;
    scene.camera.radial = {0.0885, -0.2324};
    scene.camera.place = Vec3(25.0, -30.0, 8.0);
    scene.look(Vec3(0.0, 0.0, 3.0), 0.0);
    RandomNumbers& random = scene.random();
    while (scene.pairs.size() < 20) {
        const Vec3 point(random.between(-22.0, 22.0), random.between(-10.0, 25.0), random.between(0.0, 15.0));
        const auto place = scene.camera.project(point);
        const bool seen = place && (scene.camera.toCamera * (point - scene.camera.place)).z() > 5.0 && place->x() > 0.0 &&
                          place->x() < 3264.0 && place->y() > 0.0 && place->y() < 2448.0;
        if (seen) {
            scene.pairs.push_back({"P" + std::to_string(scene.pairs.size() + 1), *place + scene.noise(1.0), point});
        }
    }
    return scene;
}

TEST(CameraMatch, APhoneWithoutItsDistortionIsFoundInNineOfTenDraws) {
    for (const bool known : {true, false}) {
        Trials trials;
        for (std::uint64_t seed = 1; seed <= sizedTo<std::uint64_t>(60, 60, 1000); ++seed) {
            CameraScene scene = phoneScene(seed);
            scene.known.focal = known ? std::optional<double>(2839.0) : std::nullopt;
            trials.add(scene);
        }
        EXPECT_GE(trials.inBall, 0.9 * trials.done) << "focal length known " << known;
        // It stays a region that says something: at 40 m the error of such clicks is some centimetres.
        EXPECT_LT(trials.middleRadius(), 1.0) << known;
        testing::Test::RecordProperty(known ? "inside_known_focal" : "inside_free_focal", trials.inBall);
    }
}

TEST(CameraMatch, ALensWithoutDistortionCostsLittle) {
    const auto count = sizedTo<std::uint64_t>(10, 40, 1000);
    const Trials trials = lensTrials({0.0, 0.0}, 20, true, count);
    Trials told;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        CameraScene scene(seed, 20, 1.0);
        scene.known.radialTerms = 0;
        told.add(scene);
    }
    EXPECT_LT(trials.middleRadius(), 3.0 * told.middleRadius());
    EXPECT_GT(trials.middleRadius(), told.middleRadius());
}

TEST(CameraMatch, ALensOtherThanWasSaidTakesTheVerdict) {
    int told = 0;
    constexpr int count = 40;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        CameraScene scene(seed, 20, 0.0);
        scene.known.radialTerms = 0;
        scene.camera.radial = {-0.2, 0.0};
        scene.retake(1.0);
        const CameraMatch match = scene.match();
        const bool said = match.findings.count("camera.lens_doubted") > 0;
        told += said;
        EXPECT_FALSE(said && match.verdict == MatchVerdict::Good) << seed;
    }
    EXPECT_GE(told, count * 9 / 10);
    int alarms = 0;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        CameraScene scene(seed, 20, 1.0);
        scene.known.radialTerms = 0;
        alarms += !scene.match().findings.empty();
    }
    EXPECT_LE(alarms, 3) << "one in a hundred";
}

TEST(CameraMatch, AFocalLengthOtherThanWasSaidTakesTheVerdict) {
    int told = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CameraScene scene(seed, 20, 1.0);
        scene.known.focal = 1.1 * scene.camera.focal;
        const CameraMatch match = scene.match();
        told += match.findings.count("camera.focal_doubted") > 0;
        EXPECT_TRUE(match.findings.empty() || match.verdict != MatchVerdict::Good);
    }
    EXPECT_GE(told, 18);
}

TEST(CameraMatch, SaysThatPointsInARingOrInTheMiddleDoNotTellTheLens) {
    const auto taken = [](double nearest, double farthest, std::size_t points) {
        CameraScene scene(21, 600, 0.0);
        scene.camera.radial = {-0.1, 0.0};
        scene.retake(0.5);
        std::erase_if(scene.pairs, [&](const PointPair& pair) {
            const double share = (pair.picture - scene.camera.principal).norm() / 2500.0;
            return share < nearest || share > farthest;
        });
        scene.pairs.resize(std::min(scene.pairs.size(), points));
        scene.known.focal.reset();
        return scene.match();
    };
    const CameraMatch ring = taken(0.4, 0.47, 15);
    EXPECT_EQ(ring.findings.count("camera.lens_untold"), 1);
    EXPECT_EQ(taken(0.0, 0.25, 15).findings.count("camera.lens_untold"), 1);
    EXPECT_EQ(taken(0.0, 1.0, 60).findings.count("camera.lens_untold"), 0);
}

TEST(CameraMatch, PointsOutWrongPairs) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        CameraScene scene(seed, 12, 1.5);
        std::swap(scene.pairs[2].picture, scene.pairs[7].picture);
        scene.pairs[9].picture.y() += 40.0;
        // Two points may lie beside each other in the picture: exchanged they are no worse than a click.
        const double apart = (scene.pairs[2].picture - scene.pairs[7].picture).norm();
        const std::vector<std::size_t> wrong = scene.match().wrong();
        const std::set<std::size_t> found(wrong.begin(), wrong.end());
        EXPECT_TRUE(found.contains(9)) << seed;
        if (apart > 40.0) {
            EXPECT_TRUE(found.contains(2) && found.contains(7)) << seed;
        }
        EXPECT_LE(wrong.size(), 4u) << seed << ": an honest pair in ten thousand lies beyond four deviations, not several";
    }
}

TEST(CameraMatch, DoesNotDependOnTheOrderOfFewPairs) {
    CameraScene scene(17, 9, 1.0);
    const CameraMatch first = scene.match();
    std::reverse(scene.pairs.begin(), scene.pairs.end());
    const CameraMatch second = scene.match();
    EXPECT_LT((first.camera.place - second.camera.place).norm(), 1e-5);
    const CameraMatch again = scene.match();
    EXPECT_EQ(second.camera.place, again.camera.place) << "and repeats to the bit";
}

TEST(CameraMatch, RefusesTooFewPairs) {
    CameraScene scene(5, 3, 0.0);
    EXPECT_EQ(refusalOf(scene), "camera.too_few");
    scene = CameraScene(5, 4, 0.0);
    scene.known.focal.reset();
    EXPECT_EQ(refusalOf(scene), "camera.too_few");
    scene.pairs.clear();
    EXPECT_EQ(refusalOf(scene), "camera.too_few");
}

TEST(CameraMatch, RefusesPointsOnALineOrInAPlane) {
    CameraScene line(6, 10, 0.0);
    for (std::size_t k = 0; k < line.pairs.size(); ++k) {
        line.pairs[k].model = Vec3(-10.0 + 2.0 * static_cast<double>(k), 0.0, 5.0);
    }
    line.retake(0.5);
    EXPECT_EQ(refusalOf(line), "camera.on_a_line");
    CameraScene plane(6, 10, 0.0);
    for (PointPair& pair : plane.pairs) {
        pair.model.y() = 0.0;
    }
    plane.retake(0.5);
    EXPECT_EQ(refusalOf(plane), "none") << "with a known focal length a plane will do, seen at an angle";
    plane.known.focal.reset();
    EXPECT_EQ(refusalOf(plane), "camera.in_a_plane");
}

TEST(CameraMatch, RefusesPairsThatAreAllWrong) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CameraScene scene(seed, 10, 0.0);
        for (PointPair& pair : scene.pairs) {
            pair.picture = {scene.random().between(0.0, 4000.0), scene.random().between(0.0, 3000.0)};
        }
        EXPECT_EQ(refusalOf(scene), "camera.no_agreement") << seed;
    }
}

TEST(CameraMatch, RefusesNumbersThatAreNone) {
    CameraScene scene(8, 10, 0.0);
    scene.pairs[3].model.z() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusalOf(scene), "camera.not_a_number");
    scene = CameraScene(8, 10, 0.0);
    scene.known.focal = -1.0;
    EXPECT_EQ(refusalOf(scene), "camera.settings");
    scene.known = {};
    EXPECT_EQ(refusalOf(scene), "camera.settings");
    const Execution cancelled;
    cancelled.cancel();
    EXPECT_THROW(matchCamera(CameraScene(8, 10, 0.0).pairs, CameraScene(8, 10, 0.0).known, cancelled), Cancelled);
}

}  // namespace
}  // namespace rubble
