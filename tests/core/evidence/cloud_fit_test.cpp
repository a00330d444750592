#include "core/evidence/clouds/cloud_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/sequence.h"

namespace rubble {

namespace {

/// Ground that rolls, and a wall on either side of a corner: nothing about its place is open.
std::vector<Vec3> site(std::uint64_t seed, double noise) {
    Sequence numbers(seed);
    const auto error = [&] { return noise * (numbers.between(-1, 1) + numbers.between(-1, 1) + numbers.between(-1, 1)); };
    std::vector<Vec3> places;
    for (int k = 0; k < 40'000; ++k) {
        const double x = numbers.between(-10, 10);
        const double y = numbers.between(-10, 10);
        places.emplace_back(x, y, 0.3 * std::sin(0.5 * x) + 0.2 * std::cos(0.4 * y) + error());
    }
    for (int k = 0; k < 8'000; ++k) {
        places.emplace_back(-10.5 + error(), numbers.between(-10, 10), numbers.between(0, 4));
        places.emplace_back(numbers.between(-10, 10), 10.5 + error(), numbers.between(0, 4));
    }
    return places;
}

const Mat3 turned(Eigen::AngleAxisd(0.01, Vec3(0.2, -0.1, 1.0).normalized()));
const Vec3 shifted(0.12, -0.08, 0.06);

/// A cloud as it lies when it is out of place: what brings it back is the inverse of this.
std::vector<Vec3> misplaced(std::vector<Vec3> places) {
    for (Vec3& place : places) {
        place = turned * place + shifted;
    }
    return places;
}

/// How far the fit leaves places from where they were, at most.
double leftOver(const CloudFit& fit, const std::vector<Vec3>& was, const std::vector<Vec3>& misplaced) {
    double most = 0.0;
    for (std::size_t k = 0; k < was.size(); ++k) {
        most = std::max(most, (fit(misplaced[k]) - was[k]).norm());
    }
    return most;
}

TEST(CloudFit, FindsTheMoveThatWasMade) {
    const PointIndex first(site(1, 0.005), 0.5);
    const std::vector<Vec3> was = site(2, 0.005);
    const std::vector<Vec3> cloud = misplaced(was);
    const CloudFit fit = fitCloud(first, cloud, {0.5}, Execution());
    EXPECT_TRUE(fit.settled);
    EXPECT_LT(leftOver(fit, was, cloud), 0.003);
    EXPECT_NEAR(fit.angle(), 0.01, 2e-4);
    EXPECT_GT(fit.before, 0.03);
    EXPECT_LT(fit.after, 0.01);
    EXPECT_GE(fit.errorAt(fit.about), fit.error);
    EXPECT_GE(fit.errorAt(fit.about), fit.shiftError.maxCoeff());
    EXPECT_GT(fit.errorAt(Vec3(1e5, 0.0, 0.0)), 0.5 * 1e5 * fit.turnError.maxCoeff()) << "a turn tells the more, the farther away";
    EXPECT_GT(fit.pairs, 1000);
    EXPECT_LT(fit.error, 0.003);
    EXPECT_EQ(fitCloud(first, cloud, {0.5}, Execution().withThreads(1)).shift, fit.shift);
}

TEST(CloudFit, WhatMovedIsTrimmed) {
    const PointIndex first(site(1, 0.005), 0.5);
    std::vector<Vec3> was = site(2, 0.005);
    std::vector<Vec3> cloud = was;
    for (Vec3& place : cloud) {
        // A sixth of the ground was dug away by 0.3 m.
        if (place.x() > 2.0 && place.y() < -2.0 && place.z() < 1.0) {
            place.z() -= 0.3;
        }
    }
    const CloudFit fit = fitCloud(first, misplaced(cloud), {0.5, 0.7}, Execution());
    EXPECT_LT(leftOver(fit, was, misplaced(was)), 0.01);
}

TEST(CloudFit, AFewWallsBringItInAcross) {
    // Nearly level ground says nothing of the way across, and the walls are a twentieth of all: at first all of them lie farther
    // off than four fifths of the pairs.
    const auto square = [](std::uint64_t seed) {
        Sequence numbers(seed);
        std::vector<Vec3> places;
        for (int k = 0; k < 60'000; ++k) {
            const double x = numbers.between(-20, 20);
            places.emplace_back(x, numbers.between(-20, 20), 0.02 * std::sin(0.3 * x) + 0.003 * numbers.between(-1, 1));
        }
        for (int k = 0; k < 1'500; ++k) {
            places.emplace_back(-20.5 + 0.003 * numbers.between(-1, 1), numbers.between(-6, 6), numbers.between(0, 4));
            places.emplace_back(numbers.between(-6, 6), 20.5 + 0.003 * numbers.between(-1, 1), numbers.between(0, 4));
        }
        return places;
    };
    const std::vector<Vec3> was = square(2);
    std::vector<Vec3> cloud = was;
    for (Vec3& place : cloud) {
        place += Vec3(0.15, -0.12, 0.05);
    }
    const CloudFit fit = fitCloud(PointIndex(square(1), 0.5), cloud, {0.5}, Execution());
    EXPECT_TRUE(fit.settled);
    EXPECT_LT(leftOver(fit, was, cloud), 0.01);
}

TEST(CloudFit, ItsErrorIsThatOfManyTrials) {
    const PointIndex first(site(1, 0.02), 0.5);
    Vec3 squares = Vec3::Zero();
    Vec3 stated = Vec3::Zero();
    constexpr int trials = 12;
    for (std::uint64_t seed = 2; seed < 2 + trials; ++seed) {
        const std::vector<Vec3> was = site(seed, 0.02);
        const CloudFit fit = fitCloud(first, was, {0.5, 0.9}, Execution());
        squares += fit.shift.cwiseAbs2();
        stated += fit.shiftError / trials;
    }
    const Vec3 found = (squares / trials).cwiseSqrt();
    for (int axis = 0; axis < 3; ++axis) {
        // The planes of the first cloud have an error of their own, the same in all trials.
        EXPECT_LT(found[axis], 3.0 * stated[axis]) << axis;
        EXPECT_GT(found[axis], 0.2 * stated[axis]) << axis;
    }
}

TEST(CloudFit, SaysWhatIsOpen) {
    Sequence numbers(3);
    std::vector<Vec3> level;
    for (int k = 0; k < 20'000; ++k) {
        level.emplace_back(numbers.between(-10, 10), numbers.between(-10, 10), 0.001 * numbers.between(-1, 1));
    }
    const PointIndex first(level, 0.5);
    EXPECT_THROW(fitCloud(first, level, {0.5}, Execution()), UsageError) << "a plane slides along itself";
    EXPECT_THROW(fitCloud(first, {Vec3(0, 0, 50)}, {0.5}, Execution()), UsageError);
}

/// Why a fit of a site to itself is refused. @param floor  it has a level ground; @param bearings  of what its walls look to,
/// degrees
Message whyOpen(bool floor, const std::vector<double>& bearings, double height) {
    Sequence numbers(4);
    const auto noise = [&] { return 0.001 * numbers.between(-1, 1); };
    std::vector<Vec3> places;
    for (int k = 0; k < 12'000 && floor; ++k) {
        places.emplace_back(numbers.between(-10, 10), numbers.between(-10, 10), noise());
    }
    for (const double bearing : bearings) {
        const double angle = bearing * std::numbers::pi / 180.0;
        const Vec3 out(std::sin(angle), std::cos(angle), 0.0);
        const Vec3 along(out.y(), -out.x(), 0.0);
        for (int k = 0; k < 4'000; ++k) {
            places.push_back((12.0 + noise()) * out + numbers.between(-6, 6) * along + Vec3(0, 0, numbers.between(0.5, height)));
        }
    }
    try {
        fitCloud(PointIndex(places, 0.5), places, {0.5}, Execution());
    } catch (const UsageError& error) {
        return error.message();
    }
    return {};
}

TEST(CloudFit, NamesTheWayThatIsOpen) {
    // Two abutments that face each other stand on a street: along them nothing holds the cloud.
    const Message along = whyOpen(true, {30.0, 210.0}, 4.0);
    EXPECT_EQ(along.id, "fit.open_shift");
    EXPECT_EQ(
        englishText(along),
        "What did not move leaves a shift along the bearing of 120° (from the y axis towards x) open: no surface looks that way");
    EXPECT_EQ(whyOpen(true, {}, 4.0).id, "fit.open_level");
    EXPECT_EQ(whyOpen(false, {30.0, 210.0}, 4.0).id, "fit.open_more") << "two walls that face each other hold three ways of six";
    // Walls alone say nothing of their height.
    EXPECT_EQ(whyOpen(false, {0.0, 90.0, 180.0, 270.0}, 4.0).id, "fit.open_up");
    EXPECT_EQ(whyOpen(true, {0.0, 90.0}, 4.0).id, "") << "a corner on a street is held everywhere";
}

/// Rolling ground of 300 m by 250 m, in strips from west to east.
std::vector<Vec3> strips(double stepX, double stepY) {
    std::vector<Vec3> places;
    for (double x = 0.1; x < 300.0; x += stepX) {
        for (double y = 0.1; y < 250.0; y += stepY) {
            places.emplace_back(x, y, 2.0 * std::sin(0.2 * x) + 1.5 * std::cos(0.25 * y));
        }
    }
    return places;
}

TEST(CloudFit, TakesPointsFromEverywhereOfAFileThatGoesStripByStrip) {
    const PointIndex first(strips(0.3, 0.3), 0.5);
    // 300,000 cubes of the radius: the first 200,000 of them end at x = 200 m.
    const std::vector<Vec3> cloud = strips(0.5, 0.5);
    const CloudFit fit = fitCloud(first, cloud, {0.5, 0.8, 1}, Execution());
    EXPECT_GT(fit.cube, 0.5);
    EXPECT_LT(fit.cube, 1.0);
    EXPECT_NEAR(fit.about.x(), 150.0, 2.0) << "the middle of all, not of the first strips";
    EXPECT_GT(fit.pairs, 100'000) << "no fewer than they have to be";
    const CloudFit some = fitCloud(first, {cloud.begin(), cloud.begin() + 60'000}, {0.5, 0.8, 1}, Execution());
    EXPECT_EQ(some.cube, 0.5) << "so many fit";
}

}  // namespace

}  // namespace rubble
