#include "core/evidence/surveys/pair_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/sequence.h"

namespace rubble {

namespace {

const Mat3 turnedPairs(Eigen::AngleAxisd(0.4, Vec3(0.1, -0.2, 1.0).normalized()));
const Vec3 shiftedPairs(120.0, -35.0, 4.0);
const std::vector<Vec3> pickedPlaces{{0.0, 0.0, 0.0}, {20.0, 1.0, 0.5}, {3.0, 15.0, 6.0}, {18.0, 16.0, 2.0}, {9.0, 7.0, 11.0}};
const Aabb wholeSite(Vec3(-10.0, -10.0, 0.0), Vec3(30.0, 30.0, 15.0));

/// The first pairs of the pickedPlaces, where the case has them moved.
std::vector<PlacePair> pairsOfPlaces(std::size_t count, double noise = 0.0, std::uint64_t seed = 1, double scale = 1.0) {
    Sequence numbers(seed);
    const auto error = [&] {
        // Sums of twelve are normal enough, with a deviation of 1.
        double sum = -6.0;
        for (int k = 0; k < 12; ++k) {
            sum += numbers.between(0.0, 1.0);
        }
        return noise * sum;
    };
    std::vector<PlacePair> pairs;
    for (std::size_t p = 0; p < count; ++p) {
        const Vec3 placed = turnedPairs * (scale * pickedPlaces[p]) + shiftedPairs + Vec3(error(), error(), error());
        pairs.push_back({"p" + std::to_string(p), pickedPlaces[p], placed});
    }
    return pairs;
}

std::string pairRefusal(const std::vector<PlacePair>& pairs) {
    try {
        fitPairs(pairs, wholeSite);
    } catch (const UsageError& error) {
        return error.message().id;
    }
    return "fitted";
}

TEST(PairFit, FindsTheMoveOfThreePairsAndMore) {
    for (const std::size_t count : {std::size_t{3}, pickedPlaces.size()}) {
        const PairFit fit = fitPairs(pairsOfPlaces(count), wholeSite);
        EXPECT_LT(fit.registration.pairsLeft, 1e-9);
        EXPECT_LT(*fit.registration.error, 1e-9);
        EXPECT_NEAR(fit.scale, 1.0, 1e-12);
        EXPECT_TRUE(fit.findings.empty());
        for (const Vec3& place : {Vec3(5.0, 5.0, 5.0), Vec3(-40.0, 12.0, 0.0)}) {
            EXPECT_LT((fit.registration(place) - (turnedPairs * place + shiftedPairs)).norm(), 1e-9);
            EXPECT_LT((fit.registration.back(fit.registration(place)) - place).norm(), 1e-9);
        }
    }
}

// The error that the residuals allow is what places are off by in truth, in the mean over many sets of pairs.
TEST(PairFit, ErrorIsWhatPlacesAreOffBy) {
    double squares = 0.0;
    double told = 0.0;
    constexpr int sets = 2000;
    for (int s = 0; s < sets; ++s) {
        const PairFit fit = fitPairs(pairsOfPlaces(pickedPlaces.size(), 0.02, static_cast<std::uint64_t>(s + 1)), wholeSite);
        told += *fit.registration.error * *fit.registration.error;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 place = wholeSite.corner(static_cast<Aabb::CornerType>(corner));
            // The pickedPlaces of the site are those of the case: what came there belongs elsewhere by the error.
            const Vec3 from = turnedPairs.transpose() * (place - shiftedPairs);
            squares += (fit.registration(from) - place).squaredNorm() / 24.0;
        }
    }
    EXPECT_NEAR(std::sqrt(told / sets), std::sqrt(squares / sets), 0.03 * std::sqrt(squares / sets));
}

// What all control points are off by together no residual shows: it is added as stated.
TEST(PairFit, WhatControlPointsAreOffByThemselvesEnters) {
    std::vector<PlacePair> pairs = pairsOfPlaces(5, 0.02, 7);
    const PairFit alone = fitPairs(pairs, wholeSite);
    EXPECT_FALSE(alone.registration.control);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        pairs[p].deviation = p < 2 ? 0.03 : 0.05;
    }
    const PairFit stated = fitPairs(pairs, wholeSite);
    const double control = std::sqrt((2 * 0.03 * 0.03 + 3 * 0.05 * 0.05) / 5.0);
    EXPECT_NEAR(stated.registration.control.value(), control, 1e-12);
    EXPECT_NEAR(*stated.registration.error, std::hypot(*alone.registration.error, control), 1e-12);
    EXPECT_EQ(stated.registration.shift, alone.registration.shift);
    EXPECT_EQ(stated.findings.count("pairs.control_partly"), 0);
    pairs[4].deviation.reset();
    const PairFit partly = fitPairs(pairs, wholeSite);
    EXPECT_EQ(partly.findings.count("pairs.control_partly"), 1);
    EXPECT_NEAR(partly.registration.control.value(), std::sqrt((2 * 0.03 * 0.03 + 2 * 0.05 * 0.05) / 4.0), 1e-12);
}

TEST(PairFit, SaysWhatSpeaksAgainstThePairs) {
    // Feet taken for metres.
    const PairFit feet = fitPairs(pairsOfPlaces(5, 0.0, 1, 0.3048), wholeSite);
    EXPECT_NEAR(feet.scale, 0.3048, 1e-9);
    EXPECT_EQ(feet.findings.count("pairs.scale"), 1);
    std::vector<PlacePair> pairs = pairsOfPlaces(5);
    pairs[2].placed.x() += 1.5;
    const PairFit bad = fitPairs(pairs, wholeSite);
    EXPECT_GE(bad.findings.count("pairs.residual"), 1);
    EXPECT_EQ(bad.findings.list().back().example, "p2");
    EXPECT_GT(*bad.registration.error, 0.3);
}

TEST(PairFit, RefusesWhatLeavesTheTurnOpen) {
    EXPECT_EQ(pairRefusal(pairsOfPlaces(2)), "pairs.few_places");
    std::vector<PlacePair> line = pairsOfPlaces(3);
    for (std::size_t p = 0; p < 3; ++p) {
        line[p].surveyed = Vec3(10.0 * static_cast<double>(p), 0.0, 0.0);
    }
    EXPECT_EQ(pairRefusal(line), "pairs.line");
    std::vector<PlacePair> none = pairsOfPlaces(3);
    none[1].placed.z() = std::nan("");
    EXPECT_EQ(pairRefusal(none), "pairs.no_place");
}

TEST(Registration, MovesOneAfterAnother) {
    Registration first;
    first.about = Vec3(3.0, 1.0, 0.0);
    first.turn = Vec3(0.0, 0.0, 0.3);
    first.shift = Vec3(1.0, 2.0, 3.0);
    first.pairs = 4;
    const Vec3 about(7.0, -2.0, 1.0);
    const Vec3 shift(0.1, 0.2, -0.3);
    const Registration both = movedOn(first, turnedPairs, about, shift);
    const Vec3 place(11.0, 12.0, 13.0);
    EXPECT_LT((both(place) - (about + shift + turnedPairs * (first(place) - about))).norm(), 1e-9);
    EXPECT_EQ(both.pairs, 4);
}

}  // namespace

}  // namespace rubble
