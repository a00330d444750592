#include "core/evidence/photographs/camera_match.h"

#include <gtest/gtest.h>

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
    return sizedTo<std::uint64_t>(200, 1000);
}

/// What the 95 % region and the stated spread are worth.
struct Trials {
    int inside = 0;
    int done = 0;
    Vec3 square = Vec3::Zero();  ///< m2, sum of the squared errors of the place, camera axes
    Vec3 stated = Vec3::Zero();  ///< m2, sum of the stated variances

    void add(const CameraScene& scene) {
        const CameraMatch match = scene.match();
        ++done;
        inside += match.holds(scene.camera);
        square += (match.camera.place - scene.camera.place).cwiseAbs2();
        stated += match.covariance.diagonal().head<3>();
    }
    void expectHonest() const {
        // Of 1,000 trials at 95 % the share inside has a standard deviation of 0.7 %, of 200 of 1.5 %: three of them are allowed.
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
