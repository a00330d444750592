#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/evidence/surveys/survey_comparison.h"
#include "tests/support/error_id.h"

namespace rubble {
namespace {

MapPiece heapBlock(double x0, double y0, double x1, double y1, double height, double turn = 0.0) {
    MapPiece piece;
    piece.centre = Vec3(0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.5 * height);
    piece.box.centre = piece.centre;
    piece.box.orientation = Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ()));
    piece.box.halfExtents = Vec3(0.5 * (x1 - x0), 0.5 * (y1 - y0), 0.5 * height);
    piece.mass = 1.0;
    piece.volume = (x1 - x0) * (y1 - y0) * height;
    return piece;
}

/// Heights at the middles of cells of half a metre, -30 to 30 m both ways.
Survey scanOf(const std::function<double(double, double)>& height) {
    Survey survey;
    survey.name = "scan.tif";
    SurveyHeights& h = survey.heights;
    h.x0 = h.y0 = -29.75;
    h.dx = h.dy = 0.5;
    h.nx = h.ny = 120;
    for (std::size_t j = 0; j < h.ny; ++j) {
        for (std::size_t i = 0; i < h.nx; ++i) {
            h.heights.push_back(height(h.x0 + 0.5 * static_cast<double>(i), h.y0 + 0.5 * static_cast<double>(j)));
        }
    }
    return survey;
}

bool inBox(double x, double y, double x0, double y0, double x1, double y1) {
    return x > x0 && x < x1 && y > y0 && y < y1;
}

Outline boxOutline(double x0, double y0, double x1, double y1) {
    return {{{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}}};
}

/// A heap of 20 x 6 m, 10 m high, as it is simulated.
class SurveyMeasures : public testing::Test {
protected:
    std::vector<MapPiece> m_pieces{heapBlock(-10.0, -3.0, 10.0, 3.0, 10.0)};
    SurveySettings m_settings;
    SurveyMeasures() { m_settings.cell = 0.25; }

    SurveyComparison compared(const Survey& survey) {
        const PieceRaster debris = rasterOf(m_pieces, m_settings.cell, SiteSurface{}, Execution());
        FineDebris fine;
        fine.cell =
            fineCellFor(survey, m_settings.cell, static_cast<double>(debris.cells.size()) * m_settings.cell * m_settings.cell);
        fine.raster = rasterOf(m_pieces, fine.cell, SiteSurface{}, Execution());
        return compareWithSurvey(debris, survey, SiteSurface{}, Eigen::Vector2d::Zero(), m_settings, Execution(), &fine);
    }
    static double heap(double x, double y) { return inBox(x, y, -10.0, -3.0, 10.0, 3.0) ? 10.0 : 0.0; }
    static double besides(double x, double y) {
        // A lorry and a tree.
        return inBox(x, y, 14.0, 8.0, 26.0, 10.5) ? 3.5 : std::hypot(x + 20.0, y - 15.0) < 5.0 ? 8.0 : 0.0;
    }
};

TEST_F(SurveyMeasures, EdgesAlongThePixelsOfASurveyHaveNoBias) {
    const SurveyComparison made = compared(scanOf(heap));
    EXPECT_NEAR(made.survey.area, 120.0, 1e-9);
    EXPECT_NEAR(made.survey.volume, 1200.0, 1e-6);
    EXPECT_EQ(made.iou, 1.0);
    ASSERT_TRUE(made.seen);
    EXPECT_EQ(made.seen->reachableIou, 1.0);
    EXPECT_EQ(made.seen->alikeIou, 1.0);
}

TEST_F(SurveyMeasures, APerfectSimulationReachesWhatItWouldBeSurveyedAs) {
    // The heap lies turned: pixels that its edges cut count whole or not at all.
    constexpr double turn = 0.5;
    m_pieces = {heapBlock(-10.0, -3.0, 10.0, 3.0, 10.0, turn)};
    const auto turned = [&](double x, double y) {
        return heap(std::cos(turn) * x + std::sin(turn) * y, -std::sin(turn) * x + std::cos(turn) * y);
    };
    const SurveyComparison made = compared(scanOf(turned));
    EXPECT_LT(made.iou, 0.95);
    ASSERT_TRUE(made.seen);
    EXPECT_NEAR(made.seen->area, made.survey.area, 0.05 * made.survey.area);
    EXPECT_NEAR(made.seen->reachableIou, made.iou, 0.03);
    EXPECT_GT(made.seen->alikeIou, 0.93) << "what an edge makes of a pixel is not known to the last part of it";
    EXPECT_GT(made.seen->alikeIou, made.iou);
    // A survey of less debris is told from that.
    const SurveyComparison less = compared(scanOf([&](double x, double y) { return x > 0.0 ? turned(x, y) : 0.0; }));
    EXPECT_NEAR(less.seen->reachableIou, made.seen->reachableIou, 1e-12);
    EXPECT_NEAR(less.seen->alikeIou, 0.5, 0.05);
}

TEST_F(SurveyMeasures, AnOutlineIsReachedAsItsCellsCanShowIt) {
    Survey outline;
    outline.isFootprint = true;
    outline.footprint = boxOutline(-10.0, -3.0, 10.0, 3.0);
    const SurveyComparison made = compared(outline);
    ASSERT_TRUE(made.seen);
    EXPECT_NEAR(made.seen->reachableIou, 1.0, 1e-12);
    EXPECT_NEAR(made.seen->area, 120.0, 1e-9);
    EXPECT_TRUE(std::isnan(made.seen->volume));
}

TEST_F(SurveyMeasures, WhatLiesFarFromAllDebrisIsSaid) {
    const Survey survey = scanOf([](double x, double y) { return std::max(heap(x, y), besides(x, y)); });
    const SurveyComparison made = compared(survey);
    EXPECT_EQ(made.apart.patches, 2);
    EXPECT_NEAR(made.apart.volume, 12.0 * 2.5 * 3.5 + M_PI * 25.0 * 8.0, 40.0);
    EXPECT_NEAR(made.apart.nearest, std::hypot(4.0, 5.0), 0.6);
    EXPECT_EQ(made.findings.count("survey.apart"), 2);
    EXPECT_EQ(compared(scanOf(heap)).findings.count("survey.apart"), 0);
}

TEST_F(SurveyMeasures, OnlyWhatLiesInTheAreaAndIsNotLeftOutIsCompared) {
    const Survey survey = scanOf([](double x, double y) { return std::max(heap(x, y), besides(x, y)); });
    m_settings.scope.area = boxOutline(-14.0, -8.0, 28.0, 12.0);
    m_settings.scope.leftOut = boxOutline(13.0, 7.0, 27.0, 11.5);
    const SurveyComparison made = compared(survey);
    const SurveyComparison alone = [&] {
        m_settings.scope = {};
        return compared(scanOf(heap));
    }();
    EXPECT_NEAR(made.survey.area, alone.survey.area, 1e-9);
    EXPECT_NEAR(made.survey.volume, alone.survey.volume, 1e-6);
    EXPECT_EQ(made.iou, alone.iou);
    EXPECT_EQ(made.apart.patches, 0);
    EXPECT_NEAR(made.leftOut.surveyedVolume, 12.0 * 2.5 * 3.5 + M_PI * 25.0 * 8.0, 40.0);
    EXPECT_EQ(made.leftOut.simulatedArea, 0.0);
    EXPECT_NEAR(made.leftOut.comparedArea, 42.0 * 20.0 - 14.0 * 4.5, 1e-9);
}

TEST_F(SurveyMeasures, AnAreaThatMissesIsRefusedOrSaid) {
    const Survey survey = scanOf(heap);
    m_settings.scope.area = boxOutline(500.0, 500.0, 510.0, 510.0);
    EXPECT_EQ(idOfError([&] { compared(survey); }), "survey.area_elsewhere");
    m_settings.scope.area = boxOutline(12.0, 12.0, 20.0, 20.0);
    const SurveyComparison made = compared(survey);
    EXPECT_EQ(made.findings.count("survey.area_misses"), 1);
    EXPECT_NEAR(made.leftOut.simulatedArea, 120.0, 1e-9);
    m_settings.scope.area = {};
    m_settings.scope.leftOut = boxOutline(-40.0, -40.0, 40.0, 40.0);
    EXPECT_EQ(idOfError([&] { compared(survey); }), "survey.area_elsewhere");
}

TEST_F(SurveyMeasures, CutFillAndNetStandApart) {
    // A pit of 4 x 4 m, 2 m deep, beside the heap.
    const SurveyComparison made =
        compared(scanOf([](double x, double y) { return inBox(x, y, -2.0, 10.0, 2.0, 14.0) ? -2.0 : heap(x, y); }));
    EXPECT_NEAR(made.volumes.fill, 1200.0, 1.0);
    EXPECT_NEAR(made.volumes.cut, 32.0, 0.1);
    EXPECT_NEAR(made.volumes.net(), 1168.0, 1.0);
    EXPECT_NEAR(made.survey.volume, 1200.0, 5.0) << "what lies below the ground is no debris";
}

TEST_F(SurveyMeasures, NoiseIsEstimatedAndWhatMayBeNoiseDoesNotCount) {
    std::mt19937 random(7);
    const auto gauss = [&] {
        double sum = -6.0;
        for (int k = 0; k < 12; ++k) {
            sum += static_cast<double>(random()) / 4294967296.0;
        }
        return sum;
    };
    // Cells of the survey's own size keep its noise.
    m_settings.cell = 0.5;
    const SurveyComparison made = compared(scanOf([&](double x, double y) { return heap(x, y) + 0.3 * gauss(); }));
    EXPECT_EQ(made.noise.source, SurveyNoise::Source::Estimated);
    EXPECT_NEAR(made.noise.deviation, 0.3, 0.02) << "some 10,000 cells";
    EXPECT_NEAR(made.noise.offset, 0.0, 0.03);
    EXPECT_LT(made.noise.correlation, 1.0);
    EXPECT_EQ(made.least, std::max(0.2, made.noise.detection()));
    EXPECT_EQ(made.findings.count("survey.detection"), 1);
    EXPECT_NEAR(made.volumes.fill, 1200.0, 200.0);
    EXPECT_GT(made.volumes.netError.random, 0.0);
    // Stated by the user it is taken as that.
    m_settings.noise = 0.04;
    m_settings.groundNoise = 0.03;
    const SurveyComparison stated = compared(scanOf(heap));
    EXPECT_EQ(stated.noise.source, SurveyNoise::Source::Stated);
    EXPECT_NEAR(stated.noise.deviation, 0.05, 1e-12);
    EXPECT_EQ(stated.least, 0.2);
}

TEST_F(SurveyMeasures, NoiseThatHangsTogetherHasItsLengthAndWeighsMore) {
    // Waves of 24 m: cells far apart agree.
    const auto waves = [](double x, double y) { return heap(x, y) + 0.05 * std::sin(x * M_PI / 12.0) * std::cos(y * M_PI / 12.0); };
    m_settings.cell = 0.5;
    const SurveyComparison made = compared(scanOf(waves));
    EXPECT_GT(made.noise.correlation, 2.0);
    EXPECT_LT(made.noise.correlation, 8.0);
    EXPECT_GT(made.volumes.netError.random, 1.96 * made.noise.deviation * std::sqrt(120.0 * 10.0));
}

TEST_F(SurveyMeasures, ASurveyOfAnotherHeightIsSaid) {
    const SurveyComparison made = compared(scanOf([](double x, double y) { return heap(x, y) + 1.5; }));
    EXPECT_NEAR(made.noise.offset, 1.5, 1e-9);
    EXPECT_EQ(made.findings.count("survey.offset"), 1);
}

}  // namespace
}  // namespace rubble
