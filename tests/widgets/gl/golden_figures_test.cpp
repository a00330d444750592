#include <gtest/gtest.h>

#include <QFont>
#include <QGuiApplication>
#include <QPainter>

#include <cmath>

#include "core/evidence/surveys/survey_comparison.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/gl/golden_picture.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/figure_sheet.h"
#include "widgets/figures/map_picture.h"
#include "widgets/figures/survey_picture.h"

namespace rubble::figures {
namespace {

/// A hillside with a trench, as a terrain of 1 m.
std::shared_ptr<const TerrainGrid> hillside() {
    constexpr std::size_t n = 61;
    std::vector<double> heights;
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) {
            const double x = static_cast<double>(i) - 30.0;
            const double y = static_cast<double>(j) - 30.0;
            heights.push_back(-0.2 + 0.05 * y + 0.8 * std::sin(0.25 * x) * std::exp(-0.01 * y * y));
        }
    }
    return std::make_shared<TerrainGrid>(-30.0, -30.0, 1.0, n, n, heights);
}

/// A chequered picture of the ground, 16 x 16 m.
std::shared_ptr<const Orthophoto> chequers() {
    auto picture = std::make_shared<Orthophoto>();
    picture->x0 = picture->y0 = -8.0;
    picture->pixel = 0.25;
    picture->width = picture->height = 64;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) {
            const bool dark = (i / 8 + j / 8) % 2 == 0;
            for (const int c : {dark ? 70 : 180, dark ? 110 : 190, dark ? 60 : 140, 255}) {
                picture->rgba.push_back(static_cast<std::uint8_t>(c));
            }
        }
    }
    return picture;
}

std::shared_ptr<const std::vector<SiteMesh>> wall() {
    SiteMesh mesh;
    mesh.name = "wall";
    mesh.points = {{-8.0, 6.0, -1.0}, {8.0, 6.0, -1.0}, {8.0, 6.0, 4.0}, {-8.0, 6.0, 4.0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return std::make_shared<std::vector<SiteMesh>>(1, mesh);
}

class Golden : public testing::Test {
protected:
    static void SetUpTestSuite() {
        ensureGuiApplication();
        QGuiApplication::setFont(QFont(QStringLiteral("DejaVu Sans")));
    }
    void SetUp() override {
        ASSERT_TRUE(displayAvailable()) << "run under xvfb-run";
        m_data = scenes::ballisticRun(scenes::collapsingWall(), 1.5);
        m_style.pixels = {640, 400};
        m_style.dpi = 90.0;
        m_style.provenance = "FE 0123456789abcdef, run fedcba9876543210, build";
    }
    QImage preset(FigurePreset which) {
        PresetRequest request;
        request.preset = which;
        request.end = 1.5;
        Studio studio(m_data);
        const render::View view = render::defaultView(m_data, m_style.pixels.width(), m_style.pixels.height());
        return studio.sheet(presetSheet(request, view, m_data), m_style).image();
    }
    render::SceneData m_data;
    FigureStyle m_style;
};

TEST_F(Golden, PairsAsInFigure11) {
    expectGolden(preset(FigurePreset::Pairs), "figure-11");
}

TEST_F(Golden, TheEndAsInFigure12) {
    expectGolden(preset(FigurePreset::End), "figure-12");
}

TEST_F(Golden, DebrisWithinItsSurroundingsAsInFigure13) {
    m_data.terrain = hillside();
    m_data.orthophoto = chequers();
    m_data.surroundings = wall();
    m_data.waterLevel = -0.6;
    expectGolden(preset(FigurePreset::Surroundings), "figure-13");
}

TEST_F(Golden, StagesAsInFigure14) {
    expectGolden(preset(FigurePreset::Stages), "figure-14");
}

/// Debris in a ring, heavier to the east, and a fallen slab beside it.
DebrisMap ringMap() {
    DebrisMap map;
    map.cell = 0.5;
    auto& mass = map.layers[static_cast<std::size_t>(MapLayer::Mass)];
    for (int j = -20; j < 20; ++j) {
        for (int i = -20; i < 20; ++i) {
            const double distance = std::hypot(i + 0.5, j + 0.5);
            if (distance > 6.0 && distance < 18.0) {
                map.cells.push_back({j, i});
                mass.push_back(400.0 + 15.0 * i);
            }
        }
    }
    return map;
}

MapPictureStyle mapStyle() {
    MapPictureStyle style;
    style.pixels = {640, 400};
    style.dpi = 90.0;
    style.place.shift = {691000.0, 5335000.0};
    style.system = "EPSG:25832";
    style.provenance = "run fedcba9876543210, build";
    return style;
}

TEST_F(Golden, AMapHasLegendScaleBarAndArrow) {
    expectGolden(mapPicture(ringMap(), MapLayer::Mass, mapStyle()), "map");
}

TEST_F(Golden, ADifferenceMapHasItsOutlinesAndLegend) {
    MapPiece piece;
    piece.centre = Vec3(0.0, 0.0, 1.0);
    piece.box = {piece.centre, Quat::Identity(), Vec3(4.0, 3.0, 1.0)};
    piece.mass = 1.0;
    piece.volume = 96.0;
    Survey survey;
    SurveyHeights& h = survey.heights;
    h.x0 = h.y0 = -15.0;
    h.dx = h.dy = 0.25;
    h.nx = h.ny = 121;
    for (std::size_t j = 0; j < h.ny; ++j) {
        for (std::size_t i = 0; i < h.nx; ++i) {
            const double x = h.x0 + 0.25 * static_cast<double>(i) - 1.5;
            const double y = h.y0 + 0.25 * static_cast<double>(j);
            h.heights.push_back(std::max(0.0, 3.0 - 0.1 * (x * x + y * y)));
        }
    }
    const SiteSurface ground;
    const SurveyComparison made = compareWithSurvey(rasterOf(std::vector{piece}, 0.5, ground, Execution()), survey, ground,
                                                    Eigen::Vector2d::Zero(), SurveySettings(), Execution());
    SurveyPictureStyle style;
    style.pixels = {640, 400};
    style.textPixels = 11.0;
    expectGolden(surveyPicture(made, style), "survey-difference");
}

/// The measure itself: what anti-aliasing does passes, what a reader would miss does not.
TEST_F(Golden, TheToleranceLetsEdgesMoveAndNothingElse) {
    const auto drawn = [](double shift, const QString& word, bool square) {
        QImage image(640, 400, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(Qt::black, 1.3));
        painter.drawLine(QPointF(20.0, 30.0 + shift), QPointF(600.0, 300.0 + shift));
        painter.setBrush(QColor(0xd5, 0x5e, 0x00));
        painter.drawEllipse(QPointF(300.0 + shift, 200.0), 60.0, 40.0);
        painter.drawText(QPointF(40.0, 370.0), word);
        if (square) {
            painter.fillRect(QRectF(500.0, 350.0, 9.0, 9.0), QColor(0xd5, 0x5e, 0x00));
        }
        return image;
    };
    const QImage reference = drawn(0.0, QStringLiteral("fragments 9,643"), true);
    EXPECT_LE(differenceOf(drawn(0.5, QStringLiteral("fragments 9,643"), true), reference).share, mostOff);
    EXPECT_GT(differenceOf(drawn(0.0, QStringLiteral("fragments 9,643"), false), reference).share, mostOff)
        << "a square is missing";
    EXPECT_GT(differenceOf(drawn(0.0, QString(), true), reference).share, mostOff) << "a word is missing";
    EXPECT_GT(differenceOf(drawn(3.0, QStringLiteral("fragments 9,643"), true), reference).share, mostOff) << "lines lie elsewhere";
    EXPECT_FALSE(differenceOf(reference.copy(0, 0, 639, 400), reference).sameSize);
    // And in a figure: a map without its coordinate system differs from its reference.
    MapPictureStyle local = mapStyle();
    local.system.clear();
    local.place = SiteFit();
    const QImage map = mapPicture(ringMap(), MapLayer::Mass, mapStyle());
    EXPECT_GT(differenceOf(mapPicture(ringMap(), MapLayer::Mass, local), map).share, mostOff);
}

}  // namespace
}  // namespace rubble::figures
