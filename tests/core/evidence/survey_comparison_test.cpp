#include "core/evidence/surveys/survey_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/evidence/surveys/survey_registration.h"
#include "tests/support/error_id.h"

namespace rubble {
namespace {

/// A block on the ground, seen by the map as one piece.
MapPiece block(double x0, double y0, double x1, double y1, double height, double ground = 0.0) {
    MapPiece piece;
    piece.centre = Vec3(0.5 * (x0 + x1), 0.5 * (y0 + y1), ground + 0.5 * height);
    piece.box.centre = piece.centre;
    piece.box.orientation = Quat::Identity();
    piece.box.halfExtents = Vec3(0.5 * (x1 - x0), 0.5 * (y1 - y0), 0.5 * height);
    piece.mass = 1.0;
    piece.volume = (x1 - x0) * (y1 - y0) * height;
    return piece;
}

PieceRaster rasterised(std::vector<MapPiece> pieces, double cell, const SiteSurface& ground = {}) {
    return rasterOf(pieces, cell, ground, Execution());
}

/// Heights every 0.125 m by a function, -20 to 20 m both ways.
Survey heightsOf(const std::function<double(double, double)>& height, double step = 0.125) {
    Survey survey;
    SurveyHeights& h = survey.heights;
    h.x0 = h.y0 = -20.0;
    h.dx = h.dy = step;
    h.nx = h.ny = static_cast<std::size_t>(40.0 / step) + 1;
    for (std::size_t j = 0; j < h.ny; ++j) {
        for (std::size_t i = 0; i < h.nx; ++i) {
            h.heights.push_back(height(h.x0 + step * static_cast<double>(i), h.y0 + step * static_cast<double>(j)));
        }
    }
    return survey;
}

Survey outlineOfRectangle(double x0, double y0, double x1, double y1) {
    Survey survey;
    survey.isFootprint = true;
    survey.footprint.polygons = {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}};
    return survey;
}

SurveyComparison compared(const PieceRaster& debris, const Survey& survey, const SurveySettings& settings,
                          const SiteSurface& ground = {}) {
    return compareWithSurvey(debris, survey, ground, Eigen::Vector2d::Zero(), settings, Execution());
}

TEST(SurveyComparison, TwoBlocksHaveTheirIouVolumeAndCentroids) {
    // 8 x 4 m and 2 m high against 6 x 4 m and 3 m high, 4 x 4 m in common.
    const SurveyComparison made =
        compared(rasterised({block(-4.0, -2.0, 4.0, 2.0, 2.0)}, 0.5), outlineOfRectangle(0.0, -2.0, 6.0, 2.0), SurveySettings());
    EXPECT_NEAR(made.iou, 16.0 / (32.0 + 24.0 - 16.0), 1e-12);
    EXPECT_NEAR(made.survey.area, 24.0, 1e-9);
    EXPECT_NEAR(made.simulated.area, 32.0, 1e-9);
    EXPECT_NEAR(made.survey.centroid.x(), 3.0, 1e-9);
    EXPECT_NEAR(made.simulated.centroid.x(), 0.0, 1e-9);
    EXPECT_NEAR(made.centroidDistance, 3.0, 1e-9);
    EXPECT_TRUE(std::isnan(made.survey.volume));
}

TEST(SurveyComparison, HeightsGiveVolumeAndDifference) {
    // A plateau of the survey between the nodes: edges on cell borders half a step outside the nodes that are high.
    const auto plateau = [](double x, double y) { return std::abs(x - 1.0) < 3.01 && std::abs(y) < 2.01 ? 3.0 : 0.0; };
    const SurveyComparison made =
        compared(rasterised({block(-4.0, -2.0, 4.0, 2.0, 2.0)}, 0.5), heightsOf(plateau), SurveySettings());
    // Interpolation adds a slope of one step around 6 x 4 m: its volume is 3 (24 + half the rim), of which the least height drops
    // none.
    EXPECT_NEAR(made.survey.volume, 3.0 * (6.0 + 0.125) * (4.0 + 0.125), 0.5);
    EXPECT_NEAR(made.simulated.volume, 64.0, 1e-9);
    const std::size_t inside = made.difference.index(-made.difference.low.i, -made.difference.low.j);
    EXPECT_NEAR(made.difference.values[inside], -1.0, 1e-9);
    EXPECT_EQ(made.unsurveyedArea, 0.0);
    EXPECT_TRUE(made.findings.empty());
}

TEST(SurveyComparison, TheSameDebrisAgreesWhole) {
    const auto dome = [](double x, double y) { return std::max(0.0, 3.0 - 0.1 * (x * x + y * y)); };
    PieceRaster debris;
    const Survey survey = heightsOf(dome);
    const CellGrid grid = surveyedOn(gridAround(survey, debris, 0.5, 0), survey, SiteSurface(), Vec3::Zero(), Execution());
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            if (const double height = grid.values[grid.index(column, row)]; height > 0.0) {
                debris.cells.push_back(grid.at(column, row));
                debris.height.push_back(height);
            }
        }
    }
    SurveySettings settings;
    settings.leastHeight = 0.0;
    const SurveyComparison made = compared(debris, survey, settings);
    EXPECT_EQ(made.iou, 1.0);
    EXPECT_NEAR(made.heightRms, 0.0, 1e-12);
    // Of a paraboloid half its base times its height.
    EXPECT_NEAR(made.survey.volume, 0.5 * M_PI * 30.0 * 3.0, 0.3);
    EXPECT_NEAR(made.simulated.volume, made.survey.volume, 1e-9);
}

TEST(SurveyComparison, RunOutIsByDirection) {
    const PieceRaster debris = rasterised({block(-1.0, -1.0, 1.0, 1.0, 1.0), block(9.0, -0.5, 10.0, 0.5, 1.0)}, 0.5);
    const SurveyComparison made = compared(debris, outlineOfRectangle(-0.5, 0.0, 0.5, 6.0), SurveySettings());
    EXPECT_NEAR(made.simulated.runOut[0], 9.75, 0.3);  // east
    EXPECT_NEAR(made.survey.runOut[2], 5.75, 0.3);     // north
    EXPECT_LT(made.survey.runOut[6], 0.1);             // south
    EXPECT_EQ(sectorName(0, 8), "E");
    EXPECT_EQ(sectorName(2, 8), "N");
    EXPECT_EQ(sectorName(1, 4), "0 deg");
}

TEST(SurveyComparison, WhatWasNotSurveyedIsLeftOutAndSaid) {
    Survey survey = heightsOf([](double x, double) { return x > 0.0 ? std::nan("") : 0.0; });
    const SurveyComparison made = compared(rasterised({block(-4.0, -2.0, 4.0, 2.0, 2.0)}, 0.5), survey, SurveySettings());
    EXPECT_NEAR(made.simulated.area + made.unsurveyedArea, 32.0, 1e-9);
    EXPECT_NEAR(made.unsurveyedArea, 16.0, 2.1);
    EXPECT_EQ(made.findings.count("survey.beyond"), 1);
    EXPECT_EQ(made.iou, 0.0);
}

TEST(SurveyComparison, TheGroundIsTakenOff) {
    // A slope of 10 % with debris 1 m high on it.
    std::vector<double> heights;
    for (int j = 0; j <= 40; ++j) {
        for (int i = 0; i <= 40; ++i) {
            heights.push_back(0.1 * (i - 20));
        }
    }
    SiteSurface ground;
    ground.terrain = std::make_shared<TerrainGrid>(-20.0, -20.0, 1.0, 41, 41, heights);
    const Survey survey =
        heightsOf([](double x, double y) { return 0.1 * x + (std::abs(x) < 2.0 && std::abs(y) < 2.0 ? 1.0 : 0.0); });
    const SurveyComparison made = compared(PieceRaster(), survey, SurveySettings(), ground);
    EXPECT_NEAR(made.survey.volume, 16.0, 1.1);
    EXPECT_NEAR(made.survey.centroid.norm(), 0.0, 0.1);
}

TEST(SurveyRegistration, FindsAShiftOfTheDebris) {
    const auto ridge = [](double x, double y) { return std::max(0.0, 2.5 - 0.5 * std::hypot(x, 0.5 * y)); };
    PieceRaster debris;
    const Survey here = heightsOf(ridge);
    const CellGrid grid = surveyedOn(gridAround(here, debris, 0.5, 0), here, SiteSurface(), Vec3::Zero(), Execution());
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            if (const double height = grid.values[grid.index(column, row)]; height > 0.0) {
                debris.cells.push_back(grid.at(column, row));
                debris.height.push_back(height);
            }
        }
    }
    const Survey there = heightsOf([&](double x, double y) { return ridge(x - 1.3, y + 0.8); });
    SurveySettings settings;
    settings.fit = SurveyFit::Debris;
    const SurveyComparison made = compared(debris, there, settings);
    EXPECT_NEAR(made.shift.by.x(), -1.3, 0.05);
    EXPECT_NEAR(made.shift.by.y(), 0.8, 0.05);
    EXPECT_LT(made.shift.after, 0.25 * made.shift.before);
    EXPECT_GT(made.iou, 0.97);
    settings.fit = SurveyFit::None;
    EXPECT_LT(compared(debris, there, settings).iou, 0.8);
}

TEST(SurveyRegistration, FindsAShiftByTheGroundBesideTheDebris) {
    const auto hills = [](double x, double y) { return 2.0 * std::sin(0.3 * x) + 1.5 * std::cos(0.25 * y + 0.1 * x); };
    std::vector<double> heights;
    for (int j = 0; j <= 200; ++j) {
        for (int i = 0; i <= 200; ++i) {
            heights.push_back(hills(-25.0 + 0.25 * i, -25.0 + 0.25 * j));
        }
    }
    SiteSurface ground;
    ground.terrain = std::make_shared<TerrainGrid>(-25.0, -25.0, 0.25, 201, 201, heights);
    // The survey lies 0.9 m too far east, 0.6 m too far south and 0.35 m too high; its debris is none of the fit's business.
    const Survey survey = heightsOf([&](double x, double y) {
        const double debris = std::abs(x - 3.0) < 2.0 && std::abs(y) < 3.0 ? 1.5 : 0.0;
        return hills(x - 0.9, y + 0.6) + 0.35 + debris;
    });
    SurveySettings settings;
    settings.fit = SurveyFit::Ground;
    const SurveyComparison made = compared(rasterised({block(-6.0, -3.0, -2.0, 3.0, 1.5)}, 0.5, ground), survey, settings, ground);
    EXPECT_TRUE(made.shift.planKnown);
    EXPECT_NEAR(made.shift.by.x(), -0.9, 0.05);
    EXPECT_NEAR(made.shift.by.y(), 0.6, 0.05);
    EXPECT_NEAR(made.shift.by.z(), -0.35, 0.02);
    EXPECT_NEAR(made.survey.volume, 1.5 * 24.0, 3.0);
}

TEST(SurveyRegistration, LevelGroundGivesOnlyHeights) {
    const Survey survey = heightsOf([](double, double) { return 0.4; });
    SurveySettings settings;
    settings.fit = SurveyFit::Ground;
    const SurveyComparison made = compared(rasterised({block(-4.0, -2.0, 4.0, 2.0, 2.0)}, 0.5), survey, settings);
    EXPECT_FALSE(made.shift.planKnown);
    EXPECT_NEAR(made.shift.by.z(), -0.4, 1e-6);
    EXPECT_EQ(made.findings.count("survey.level"), 1);
    EXPECT_EQ(made.survey.area, 0.0);
}

TEST(SurveyComparison, RefusesWhatHasNoSense) {
    SurveySettings settings;
    settings.cell = 0.0;
    const Survey square = outlineOfRectangle(0, 0, 1, 1);
    const auto refusal = [&](const Survey& survey) { return idOfError([&] { compared(PieceRaster(), survey, settings); }); };
    EXPECT_EQ(refusal(square), "survey.cell");
    settings = SurveySettings();
    settings.fit = SurveyFit::Ground;
    EXPECT_EQ(refusal(square), "survey.footprint_ground");
    Survey above = heightsOf([](double, double) { return 0.0; });
    above.heights.aboveGround = true;
    EXPECT_EQ(refusal(above), "survey.above_ground");
    settings.fit = SurveyFit::Debris;
    EXPECT_EQ(refusal(heightsOf([](double, double) { return 0.0; })), "survey.no_debris");
    settings.fit = SurveyFit::None;
    settings.cell = 1e-6;
    EXPECT_EQ(refusal(square), "survey.too_large");
    settings.cell = 0.5;
    for (const auto spoil : {+[](SurveySettings& of) { of.leastHeight = -1.0; }, +[](SurveySettings& of) { of.sectors = 361; },
                             +[](SurveySettings& of) { of.noise = std::nan(""); }}) {
        const SurveySettings sound = settings;
        spoil(settings);
        EXPECT_EQ(refusal(square), "survey.settings");
        settings = sound;
    }
    EXPECT_EQ(refusal(heightsOf([](double, double) { return std::nan(""); })), "survey.elsewhere");
}

TEST(SurveyRegistration, WithoutGroundBesideTheDebrisThereIsNothingToFitTo) {
    const Survey survey = heightsOf([](double x, double y) { return std::hypot(x, y) < 3.0 ? 1.0 : std::nan(""); });
    SurveySettings settings;
    settings.fit = SurveyFit::Ground;
    const PieceRaster debris = rasterised({block(-4.0, -4.0, 4.0, 4.0, 2.0)}, 0.5);
    EXPECT_EQ(idOfError([&] { compared(debris, survey, settings); }), "survey.no_ground");
}

TEST(SurveyRegistration, AShiftAsFarAsWasLookedIsSaid) {
    const PieceRaster debris = rasterised({block(-4.0, -2.0, 4.0, 2.0, 2.0)}, 0.5);
    SurveySettings settings;
    settings.fit = SurveyFit::Debris;
    settings.shiftMost = 2.0;
    const SurveyComparison made = compared(debris, outlineOfRectangle(0.0, -2.0, 8.0, 2.0), settings);
    EXPECT_EQ(made.findings.count("survey.at_limit"), 1);
}

TEST(SurveyComparison, SaysWhichSideHoldsFallenStructure) {
    const PieceRaster debris = rasterised({block(-4.0, -2.0, 4.0, 2.0, 2.0)}, 0.5);
    SurveySettings settings;
    const auto words = [&](bool with, std::optional<bool> shown) {
        settings.withFallen = with;
        settings.showsFallen = shown;
        return compared(debris, outlineOfRectangle(0, 0, 1, 1), settings).words.id;
    };
    EXPECT_EQ(words(true, std::nullopt), "survey.words.with");
    EXPECT_EQ(words(false, std::nullopt), "survey.words.without");
    EXPECT_EQ(words(true, true), "survey.words.both");
    EXPECT_EQ(words(true, false), "survey.words.simulated_only");
    EXPECT_EQ(words(false, true), "survey.words.surveyed_only");
    EXPECT_EQ(words(false, false), "survey.words.neither");
}

}  // namespace
}  // namespace rubble
