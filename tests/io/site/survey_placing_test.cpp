#include "io/site/surveys/survey_placing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/error_id.h"

namespace rubble::io {

namespace {

double surveyHill(double x, double y) {
    return 0.05 * x - 0.03 * y + 2.0 * std::exp(-(x * x + y * y) / 200.0);
}

/// A survey that shows the hill once it is moved by a registration: its heights are those that the way back gives.
SurveyInput misplacedSurvey(const Registration& registration, double step) {
    SurveyInput input;
    SurveyHeights& heights = input.survey.heights;
    heights.x0 = heights.y0 = -60.0;
    heights.dx = heights.dy = step;
    heights.nx = heights.ny = static_cast<std::size_t>(120.0 / step) + 1;
    for (std::size_t j = 0; j < heights.ny; ++j) {
        for (std::size_t i = 0; i < heights.nx; ++i) {
            const double x = heights.x0 + step * static_cast<double>(i);
            const double y = heights.y0 + step * static_cast<double>(j);
            double z = 0.0;
            // Along the survey's own vertical until the moved place lies on the hill.
            for (int k = 0; k < 50; ++k) {
                const Vec3 moved = registration(Vec3(x, y, z));
                z -= moved.z() - surveyHill(moved.x(), moved.y());
            }
            heights.heights.push_back(z);
        }
    }
    return input;
}

double apartFromHill(const SurveyInput& input) {
    double most = 0.0;
    for (double x = -15.0; x <= 15.0; x += 0.7) {
        for (double y = -15.0; y <= 15.0; y += 0.7) {
            const double off = std::abs(input.survey.heights.at(x, y) - surveyHill(x, y));
            most = std::isnan(off) ? 1e9 : std::max(most, off);
        }
    }
    return most;
}

Registration movedBy(const Vec3& turn) {
    Registration registration;
    registration.about = Vec3(5.0, -3.0, 1.0);
    registration.turn = turn;
    registration.shift = Vec3(3.25, -7.5, 0.8);
    registration.pairs = 3;
    registration.error = 0.02;
    return registration;
}

TEST(SurveyPlacing, AShiftKeepsRowsAndColumns) {
    const Registration registration = movedBy(Vec3::Zero());
    SurveyInput input = misplacedSurvey(registration, 0.5);
    placeSurvey(input, registration);
    EXPECT_FALSE(input.survey.heights.lattice);
    EXPECT_LT(apartFromHill(input), 0.002) << "of interpolation alone";
    EXPECT_EQ(input.findings.count("survey.placed"), 1);
}

TEST(SurveyPlacing, ATurnAndATiltComeBackToTheHill) {
    for (const Vec3& turn : {Vec3(0.0, 0.0, 0.6), Vec3(0.004, -0.003, 0.6), Vec3(0.0, 0.0, -2.5)}) {
        const Registration registration = movedBy(turn);
        SurveyInput input = misplacedSurvey(registration, 0.5);
        EXPECT_GT(apartFromHill(input), 0.3);
        placeSurvey(input, registration);
        ASSERT_TRUE(input.survey.heights.lattice);
        // A tilt of 0.005 moves heights of 4 m by 2 cm in plan, on slopes of a tenth.
        EXPECT_LT(apartFromHill(input), 0.004) << turn.transpose();
        EXPECT_EQ(input.findings.count("survey.tilted"), 0);
        // Moved on, the lattice is moved itself, and back.
        Registration on;
        on.turn = Vec3(0.0, 0.0, 0.2);
        on.shift = Vec3(1.0, 1.0, 0.0);
        placeSurvey(input, on);
        EXPECT_GT(apartFromHill(input), 0.02);
        Registration back;
        back.turn = -on.turn;
        back.shift = back.about + on.rotation().transpose() * (-on.shift);
        placeSurvey(input, back);
        EXPECT_LT(apartFromHill(input), 0.004);
    }
    SurveyInput steep = misplacedSurvey(movedBy(Vec3(0.2, 0.0, 0.0)), 0.5);
    placeSurvey(steep, movedBy(Vec3(0.2, 0.0, 0.0)));
    EXPECT_EQ(steep.findings.count("survey.tilted"), 1);
}

TEST(SurveyPlacing, OutlinesAreMovedInPlan) {
    SurveyInput input;
    input.survey.isFootprint = true;
    input.survey.footprint.polygons = {{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}}}};
    Registration registration = movedBy(Vec3(0.0, 0.0, 0.5));
    registration.error.reset();
    placeSurvey(input, registration);
    const Vec3 corner = registration(Vec3(4.0, 0.0, 0.0));
    EXPECT_LT((input.survey.footprint.polygons[0][0][1] - corner.head<2>()).norm(), 1e-12);
    EXPECT_EQ(input.findings.count("survey.placed_unknown"), 1);
}

TEST(SurveyPlacing, WhatNobodyMeasuredIsNotSaidToBeLeft) {
    SurveyInput input = misplacedSurvey(movedBy(Vec3::Zero()), 0.5);
    Registration stated = movedBy(Vec3::Zero());
    stated.pairs = 0;
    placeSurvey(input, stated);
    ASSERT_EQ(input.findings.list().size(), 1u);
    EXPECT_EQ(
        englishText(input.findings.list().front().what),
        "the registration of the case moves it by 8.213 m and turns it by 0 degrees, and does not say by what it was found; a "
        "place is known to 0.02 m");
}

TEST(SurveyPlacing, HeightsAboveTheGroundAreRefused) {
    SurveyInput input = misplacedSurvey(movedBy(Vec3::Zero()), 5.0);
    input.survey.heights.aboveGround = true;
    EXPECT_EQ(idOfError([&] { placeSurvey(input, movedBy(Vec3::Zero())); }), "survey.placed_map");
}

}  // namespace

}  // namespace rubble::io
