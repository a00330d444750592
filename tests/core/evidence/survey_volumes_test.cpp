#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/unknown.h"
#include "core/evidence/surveys/survey_measures.h"

namespace rubble {
namespace {

constexpr double pi = std::numbers::pi;

/// Heights every 10 cm over a square of 20 m, held against level ground; no debris is simulated.
SurveyComparison surveyed(const std::function<double(double, double)>& height, const SurveySettings& settings) {
    Survey survey;
    survey.name = "surface";
    SurveyHeights& h = survey.heights;
    h.x0 = h.y0 = -9.95;
    h.dx = h.dy = 0.1;
    h.nx = h.ny = 200;
    for (std::size_t j = 0; j < h.ny; ++j) {
        for (std::size_t i = 0; i < h.nx; ++i) {
            h.heights.push_back(height(h.x0 + 0.1 * static_cast<double>(i), h.y0 + 0.1 * static_cast<double>(j)));
        }
    }
    return compareWithSurvey(PieceRaster(), survey, SiteSurface(), Eigen::Vector2d::Zero(), settings, Execution());
}

SurveySettings fine(double noise) {
    SurveySettings settings;
    settings.cell = 0.1;
    settings.noise = noise;
    settings.groundNoise = 0.0;
    return settings;
}

SurveyVolumes volumes(const std::function<double(double, double)>& height, double noise = 0.0) {
    return surveyed(height, fine(noise)).volumes;
}

// A height stands for its pixel, so the square is 20 m wide.
constexpr double side = 20.0;

TEST(SurveyVolumes, OfPlanesAreThoseOfPaper) {
    const SurveyVolumes level = volumes([](double, double) { return 0.3; });
    EXPECT_NEAR(level.fill, 0.3 * side * side, 1e-6);
    EXPECT_EQ(level.cut, 0.0);
    const SurveyVolumes sunk = volumes([](double, double) { return -0.3; });
    EXPECT_NEAR(sunk.net(), -level.net(), 1e-9);
    // Over x from 0 to L a slope s holds s L^2 / 2 to each metre across.
    const SurveyVolumes tilted = volumes([](double x, double) { return 0.2 * x; });
    EXPECT_NEAR(tilted.fill, 0.2 * 10.0 * 10.0 / 2.0 * side, 1e-6);
    EXPECT_NEAR(tilted.fill, tilted.cut, 1e-6);
    EXPECT_NEAR(tilted.net(), 0.0, 1e-6);
}

TEST(SurveyVolumes, OfADomeAndAConeAreThoseOfPaper) {
    const double radius = 8.0;
    const double height = 3.0;
    const SurveyVolumes dome =
        volumes([&](double x, double y) { return std::max(0.0, height * (1.0 - (x * x + y * y) / (radius * radius))); });
    EXPECT_NEAR(dome.fill, 0.5 * pi * radius * radius * height, 0.001 * dome.fill);
    const auto cone = [&](double x, double y) { return std::max(0.0, height * (1.0 - std::hypot(x, y) / radius)); };
    EXPECT_NEAR(volumes(cone).fill, pi * radius * radius * height / 3.0, 0.001 * dome.fill);
    // Up to where it is as high as the level of detection: the integral of h (1 - r / R) 2 pi r from 0 to a = R (1 - d / h).
    const double detection = 0.5;
    const SurveyVolumes cut = volumes(cone, detection / 1.96);
    const double a = radius * (1.0 - detection / height);
    const double counted = 2.0 * pi * height * (a * a / 2.0 - a * a * a / (3.0 * radius));
    EXPECT_NEAR(cut.fill, counted, 0.003 * counted);
    EXPECT_NEAR(cut.undetected(), pi * radius * radius * height / 3.0 - counted, 0.003 * counted);
}

TEST(SurveyVolumes, WhatIsBelowTheLevelOfDetectionIsToldByFillAndCut) {
    // The level of detection is 1.96 times 0.1 m: 0.15 m over a quarter and -0.1 m over another do not count.
    const SurveyVolumes made =
        volumes([](double x, double y) { return x < 0.0 && y < 0.0 ? 0.15
                                                : x < 0.0          ? -0.1
                                                : y < 0.0          ? 1.0
                                                                   : -0.5; }, 0.1);
    EXPECT_NEAR(made.fill, 100.0, 1e-6);
    EXPECT_NEAR(made.cut, 50.0, 1e-6);
    EXPECT_NEAR(made.undetectedFill, 15.0, 1e-6);
    EXPECT_NEAR(made.undetectedCut, 10.0, 1e-6);
    EXPECT_NEAR(made.undetected(), 25.0, 1e-6);
    EXPECT_NEAR(made.undetectedNet(), 5.0, 1e-6);
}

TEST(SurveyVolumes, OfASurfaceAgainstItselfAreNone) {
    Survey survey;
    SurveyHeights& h = survey.heights;
    h.x0 = h.y0 = -9.95;
    h.dx = h.dy = 0.1;
    h.nx = h.ny = 200;
    for (std::size_t k = 0; k < h.nx * h.ny; ++k) {
        h.heights.push_back(std::sin(0.05 * static_cast<double>(k % h.nx)) + 0.01 * static_cast<double>(k / h.nx));
    }
    survey.ground = h;
    SiteSurface ground;
    ground.terrain = std::make_shared<const TerrainGrid>(h);
    const SurveyComparison made =
        compareWithSurvey(PieceRaster(), survey, ground, Eigen::Vector2d::Zero(), fine(0.01), Execution());
    EXPECT_EQ(made.volumes.fill, 0.0);
    EXPECT_EQ(made.volumes.cut, 0.0);
    EXPECT_NEAR(made.volumes.undetected(), 0.0, 1e-9);
    EXPECT_EQ(made.volumes.netError.random, 0.0) << "no cell counts";
}

/// A comparison of so many cells of a square metre, each 1 m above the ground.
SurveyComparison cells(std::size_t count, double deviation, std::optional<double> offset) {
    SurveyComparison made;
    made.settings.cell = 1.0;
    made.settings.offsetError = offset;
    made.noise.source = SurveyNoise::Source::Stated;
    made.noise.deviation = deviation;
    made.noise.correlation = unknown;
    made.surveyedCells.values.assign(count, 1.0);
    made.compared.assign(count, 1);
    return made;
}

TEST(SurveyVolumes, RandomErrorsGrowWithTheRootAndSystematicOnesWithTheNumberOfCells) {
    const SurveyVolumes one = volumesOf(cells(100, 0.05, 0.02));
    const SurveyVolumes four = volumesOf(cells(400, 0.05, 0.02));
    EXPECT_NEAR(one.netError.random, 1.96 * 0.05 * std::sqrt(100.0), 1e-9);
    EXPECT_NEAR(four.netError.random, 2.0 * one.netError.random, 1e-9);
    EXPECT_NEAR(one.netError.systematic, 1.96 * 0.02 * 100.0, 1e-9);
    EXPECT_NEAR(four.netError.systematic, 4.0 * one.netError.systematic, 1e-9);
    // Cells above and below the ground take their parts.
    SurveyComparison both = cells(400, 0.05, 0.02);
    std::fill_n(both.surveyedCells.values.begin(), 100, -1.0);
    const SurveyVolumes parted = volumesOf(both);
    EXPECT_NEAR(parted.cutError.random, one.fillError.random, 1e-9);
    EXPECT_NEAR(parted.cutError.systematic, one.fillError.systematic, 1e-9);
    EXPECT_NEAR(parted.netError.random, four.netError.random, 1e-9);
    EXPECT_NEAR(std::hypot(parted.cutError.random, parted.fillError.random), parted.netError.random, 1e-9);
}

TEST(SurveyVolumes, WhatNobodyStatedIsNotKnown) {
    SurveyComparison made = cells(100, 0.05, std::nullopt);
    EXPECT_TRUE(std::isnan(volumesOf(made).netError.systematic));
    EXPECT_GT(volumesOf(made).netError.random, 0.0);
    made.noise.source = SurveyNoise::Source::Unknown;
    made.noise.deviation = 0.0;
    EXPECT_TRUE(std::isnan(volumesOf(made).fillError.random));
    made.settings.offsetError = 0.0;
    EXPECT_EQ(volumesOf(made).netError.systematic, 0.0) << "stated to be none";
}

}  // namespace
}  // namespace rubble
