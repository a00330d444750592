#include <gtest/gtest.h>

#include <QImage>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/movie.h"
#include "widgets/figures/offscreen_view.h"
#include "widgets/figures/palette.h"
#include "widgets/render/basics/camera.h"

namespace rubble::figures {
namespace {

/// Share of pixels in a part of a picture that are vermilion, lit or shaded.
double vermilion(const QImage& image, const QRect& part) {
    int count = 0;
    for (int y = part.top(); y <= part.bottom(); ++y) {
        for (int x = part.left(); x <= part.right(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += c.hsvSaturationF() > 0.7 && c.hsvHueF() < 0.1 && c.valueF() > 0.2;
        }
    }
    return static_cast<double>(count) / (part.width() * part.height());
}

double differentPixels(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            count += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue()) > 24;
        }
    }
    return static_cast<double>(count) / (a.width() * a.height());
}

class GlFigures : public testing::Test {
protected:
    static void SetUpTestSuite() { ensureGuiApplication(); }
    void SetUp() override {
        ASSERT_TRUE(displayAvailable()) << "run under xvfb-run";
        m_data = scenes::ballisticRun(scenes::collapsingWall(), 1.0);
        m_view = render::defaultView(m_data, 640, 400);
        m_view.layout = render::Layout::Beside;
        m_view.cameras[0] = render::refit(m_view.cameras[0], Aabb(Vec3(-1, -1, 0), Vec3(5, 2, 6)), 0.8);
        m_view.captions = m_view.legends = m_view.scaleBar = m_view.axes = false;
        m_view.time = 0.5;
        m_window.pixels = {640, 400};
        m_window.framed = false;
        m_window.dpi = 96;
    }
    render::SceneData m_data;
    render::View m_view;
    FigureStyle m_window;
};

/// Keeps the pictures of a movie.
class KeptPictures : public MovieTarget {
public:
    void add(const QImage& picture) override { pictures.push_back(picture); }
    void finish() override {}
    std::string path() const override { return {}; }

    std::vector<QImage> pictures;
};

TEST_F(GlFigures, AMovieHasItsCautionsOnEveryPicture) {
    Studio studio(m_data);
    KeptPictures plain, warned;
    makeMovie(studio, m_view, m_window, {0.2, 0.4, 10.0, 1.0}, plain, Execution());
    m_window.cautions = "tainted: 2 limits of health passed, and nobody vouches for the run";
    makeMovie(studio, m_view, m_window, {0.2, 0.4, 10.0, 1.0}, warned, Execution());
    ASSERT_EQ(warned.pictures.size(), 3U);
    const QColor amber = palette(render::Theme::Light).findingTint;
    for (std::size_t i = 0; i < warned.pictures.size(); ++i) {
        EXPECT_EQ(warned.pictures[i].size(), plain.pictures[i].size()) << "an encoder takes one size";
        EXPECT_EQ(warned.pictures[i].pixelColor(1, 398), amber);
        EXPECT_NE(plain.pictures[i].pixelColor(1, 398), amber);
        EXPECT_NE(warned.pictures[i].pixelColor(1, 2), amber);
    }
}

TEST_F(GlFigures, FragmentsAreVermilionAndOnlyInTheirPane) {
    Studio studio(m_data);
    const QImage picture = studio.picture(m_view, m_window);
    ASSERT_EQ(picture.size(), m_window.pixels);
    EXPECT_EQ(vermilion(picture, QRect(0, 0, 319, 400)), 0.0);
    EXPECT_GT(vermilion(picture, QRect(321, 0, 319, 400)), 0.01);
    m_view.time = 0.0;
    EXPECT_EQ(vermilion(studio.picture(m_view, m_window), QRect(0, 0, 640, 400)), 0.0);
    EXPECT_EQ(studio.status(render::PaneContent::Fe).active, 16u);
}

TEST_F(GlFigures, LeavingOutHiddenFacesChangesNoPicture) {
    for (const double time : {0.0, 0.25, 0.5, 0.9}) {
        m_view.time = time;
        Studio lean(m_data), full(m_data);
        full.setAllFaces(true);
        const QImage a = lean.picture(m_view, m_window), b = full.picture(m_view, m_window);
        // Pixels on an edge may round the other way; a hole or a wall too many would show as an area.
        EXPECT_LT(differentPixels(a, b), 0.002) << time;
        EXPECT_LT(lean.status(render::PaneContent::Fe).faces, full.status(render::PaneContent::Fe).faces);
    }
}

TEST_F(GlFigures, RepeatsBitForBit) {
    Studio one(m_data), two(m_data);
    one.picture(m_view, m_window);
    EXPECT_EQ(one.picture(m_view, m_window), two.picture(m_view, m_window));
}

TEST_F(GlFigures, CaptionsCoverOnlyTheirCorners) {
    Studio studio(m_data);
    const QImage bare = studio.picture(m_view, m_window);
    m_view.captions = true;
    const QImage captioned = studio.picture(m_view, m_window);
    EXPECT_NE(captioned.copy(0, 0, 300, 40), bare.copy(0, 0, 300, 40));
    EXPECT_EQ(captioned.copy(0, 60, 640, 340), bare.copy(0, 60, 640, 340));
    m_view.captions = false;
    m_view.scaleBar = true;
    const QImage scaled = studio.picture(m_view, m_window);
    EXPECT_EQ(scaled.copy(0, 0, 640, 300), bare.copy(0, 0, 640, 300));
    EXPECT_NE(scaled.copy(500, 340, 140, 60), bare.copy(500, 340, 140, 60));
}

TEST_F(GlFigures, FramedFiguresAreWhiteWithCaptionsBelow) {
    FigureStyle style;
    style.pixels = {900, 600};
    style.dpi = 150;
    style.provenance = "scene, 1a2b";
    m_view.captions = true;
    m_view.theme = render::Theme::Dark;  // a framed figure prints in its own theme
    Studio studio(m_data);
    const QImage figure = studio.picture(m_view, style);
    ASSERT_EQ(figure.size(), style.pixels);
    for (const QPoint corner : {QPoint(2, 2), QPoint(897, 2), QPoint(2, 597), QPoint(897, 597)}) {
        EXPECT_GT(figure.pixelColor(corner).lightness(), 240);
    }
    EXPECT_EQ(figure.dotsPerMeterX(), static_cast<int>(std::lround(150 / 0.0254)));
    EXPECT_EQ(figure.text("Description"), "scene, 1a2b");
    int dark = 0;  // ink of the caption line, 41 px high above the provenance line of 25 px
    for (int y = 600 - 25 - 41; y < 600 - 25; ++y) {
        for (int x = 0; x < 900; ++x) {
            dark += figure.pixelColor(x, y).lightness() < 100;
        }
    }
    EXPECT_GT(dark, 200);
}

TEST_F(GlFigures, ArrangementsAreFilledByWhatTheyShow) {
    Studio studio(m_data);
    for (const auto& [name, preset] : figurePresets) {
        PresetRequest request;
        request.preset = preset;
        request.end = 0.9;
        FigureStyle style;
        style.pixels = {800, 0};
        style.dpi = 100;
        const SheetPicture picture = studio.sheet(presetSheet(request, m_view, m_data), style);
        EXPECT_GT(picture.pixels().height(), 0) << name;
        const SheetPicture::Panel& last = picture.panels().back();
        EXPECT_FALSE(last.shown.caption.contains(QStringLiteral("outside"))) << name;
        Eigen::AlignedBox2d seen;
        for (const Vec3& point : studio.scene().shownPoints(last.shown.content)) {
            const auto place =
                render::project(last.view.cameras[0], point, static_cast<double>(last.place.width()) / last.place.height());
            ASSERT_TRUE(place);
            seen.extend(Eigen::Vector2d(place->u, place->v));
        }
        EXPECT_GE(seen.min().minCoeff(), 0.0) << name;
        EXPECT_LE(seen.max().maxCoeff(), 1.0) << name;
        // Others show more than their last picture does. A page is not higher than it should be, so one way may have room.
        if (preset == FigurePreset::End) {
            EXPECT_GT(seen.sizes().maxCoeff(), 0.85) << name;
        }
    }
}

TEST_F(GlFigures, WhereAPictureLooksStandsBelowWhereNorthIsKnown) {
    Studio studio(m_data);
    m_view.legends = m_view.axes = true;
    FigureStyle style;
    style.pixels = {800, 0};
    style.dpi = 100;
    style.north = 0.0;
    PresetRequest request;
    request.preset = FigurePreset::End;
    request.end = 0.9;
    const SheetPicture picture = studio.sheet(presetSheet(request, m_view, m_data), style);
    EXPECT_EQ(picture.panels()[0].legend.back().text.toStdString(), "looking north (0°)");
}

TEST_F(GlFigures, WritesPngAndSaysWhenItCannot) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "rubble_gl_figures";
    std::filesystem::create_directories(folder);
    const std::string path = (folder / "figure.png").string();
    writeFigure(path, m_view, m_data, m_window);
    EXPECT_EQ(QImage(QString::fromStdString(path)).size(), m_window.pixels);
    EXPECT_THROW(writeFigure((folder / "no" / "such" / "folder.png").string(), m_view, m_data, m_window), WorldError);
    std::filesystem::remove_all(folder);
    FigureStyle silly = m_window;
    silly.pixels = {0, 400};
    EXPECT_THROW(writeFigure(path, m_view, m_data, silly), UsageError);
    silly = m_window;
    silly.dpi = std::nan("");
    EXPECT_THROW(writeFigure(path, m_view, m_data, silly), UsageError);
}

TEST_F(GlFigures, PickFindsWhatThePictureShows) {
    Studio studio(m_data);
    const QImage picture = studio.picture(m_view, m_window);
    int agreed = 0, asked = 0;
    for (int y = 4; y < 398; y += 9) {
        for (int x = 324; x < 638; x += 9) {
            const bool red = vermilion(picture, QRect(x - 1, y - 1, 3, 3)) == 1.0;
            const bool none = vermilion(picture, QRect(x - 1, y - 1, 3, 3)) == 0.0;
            const auto pick = studio.scene().pick(x, y);
            if (red || none) {
                ++asked;
                agreed += red == (pick && pick->fragment);
            }
        }
    }
    EXPECT_GT(asked, 1000);
    EXPECT_EQ(agreed, asked);
}

TEST_F(GlFigures, LeavingOutFacesChangesNoPictureWithHiddenElementsToo) {
    m_view.hidden = {idAt<ElementIndex>(1), idAt<ElementIndex>(6), idAt<ElementIndex>(9)};
    for (const double time : {0.0, 0.25, 0.5, 0.9}) {
        m_view.time = time;
        Studio lean(m_data), full(m_data);
        full.setAllFaces(true);
        EXPECT_LT(differentPixels(lean.picture(m_view, m_window), full.picture(m_view, m_window)), 0.002) << time;
        EXPECT_EQ(lean.status(render::PaneContent::Fe).hidden, 3u);
    }
}

TEST_F(GlFigures, HidingAComponentTakesItOutOfBothPanes) {
    m_view.time = 0.9;
    Studio studio(m_data);
    EXPECT_GT(vermilion(studio.picture(m_view, m_window), QRect(321, 0, 319, 400)), 0.01);
    m_view.hiddenComponents = {"wall"};
    EXPECT_EQ(vermilion(studio.picture(m_view, m_window), QRect(0, 0, 640, 400)), 0.0);
    m_view.hiddenComponents = {"no such component"};
    EXPECT_GT(vermilion(studio.picture(m_view, m_window), QRect(321, 0, 319, 400)), 0.01);
}

TEST_F(GlFigures, ACutTakesAwayItsSideAndPicksAgree) {
    Studio studio(m_data);
    m_view.clip = render::ClipPlane{Vec3(2.5, 0, 0), Vec3::UnitX()};
    const QImage picture = studio.picture(m_view, m_window);
    const auto pane = render::panesOf(m_view.layout, 640, 400)[1];
    int asked = 0, agreed = 0;
    for (int y = 4; y < 398; y += 7) {
        for (int x = 324; x < 638; x += 7) {
            const double share = vermilion(picture, QRect(x - 1, y - 1, 3, 3));
            const auto pick = studio.scene().pick(x, y);
            if (share == 1.0 || share == 0.0) {
                ++asked;
                agreed += (share == 1.0) == (pick && pick->fragment);
            }
            EXPECT_TRUE(!pick || pick->position.x() <= 2.5 + 1e-6);
        }
    }
    EXPECT_GT(asked, 1500);
    // The plane cuts single pixels of triangles that a ray through their middle just misses.
    EXPECT_GE(agreed, asked - 2);
    const auto cut = studio.scene().elementsIn(pane, 320, 0, 640, 400);
    m_view.clip.reset();
    studio.picture(m_view, m_window);
    EXPECT_GT(studio.scene().elementsIn(pane, 320, 0, 640, 400).size(), cut.size());
}

TEST_F(GlFigures, PresentationShowsNoVermilionAndGrainOnSurfaces) {
    Studio studio(m_data);
    m_view.time = 0.9;
    const QImage plain = studio.picture(m_view, m_window);
    m_view.style = render::Style::Presentation;
    const QImage shown = studio.picture(m_view, m_window);
    EXPECT_EQ(vermilion(shown, QRect(0, 0, 640, 400)), 0.0);
    EXPECT_GT(differentPixels(plain, shown), 0.01);
    m_view.time = 0.0;
    std::set<QRgb> tones;
    const QImage standing = studio.picture(m_view, m_window);
    // One face of a block in plain grey has one tone; with its grain it has many.
    for (int y = 180; y < 230; ++y) {
        for (int x = 120; x < 200; ++x) {
            tones.insert(standing.pixel(x, y));
        }
    }
    EXPECT_GT(tones.size(), 40u);
    m_view.style = render::Style::Analysis;
    m_view.time = 0.9;
    EXPECT_EQ(studio.picture(m_view, m_window), plain) << "and back again to the bit";
}

TEST_F(GlFigures, ShadingDarkensAndLeavesNothingBehind) {
    Studio studio(m_data);
    const QImage plain = studio.picture(m_view, m_window);
    m_view.shading = true;
    const QImage shaded = studio.picture(m_view, m_window);
    EXPECT_GT(differentPixels(plain, shaded), 0.002);
    m_view.shading = false;
    EXPECT_EQ(studio.picture(m_view, m_window), plain);
}

/// Ground at a flat angle falls away as fast as what lies behind an edge.
TEST_F(GlFigures, ShadingFadesTowardsTheHorizon) {
    Studio studio(m_data);
    m_view.layout = render::Layout::FeOnly;
    m_view.cameras[0].position = Vec3(2, -14, 2);
    m_view.cameras[0].focalPoint = Vec3(2, 0, 2);
    const QImage plain = studio.picture(m_view, m_window);
    m_view.shading = true;
    const QImage shaded = studio.picture(m_view, m_window);
    EXPECT_GT(differentPixels(plain, shaded), 0.001) << "the wall has its outline";
    // The horizon runs through the middle; the wall stands there in the middle third.
    EXPECT_EQ(differentPixels(plain.copy(0, 0, 160, 212), shaded.copy(0, 0, 160, 212)), 0.0);
    EXPECT_EQ(differentPixels(plain.copy(480, 0, 160, 212), shaded.copy(480, 0, 160, 212)), 0.0);
}

TEST_F(GlFigures, FourPanesShowFourThings) {
    Studio studio(m_data);
    m_view.layout = render::Layout::Four;
    const QImage four = studio.picture(m_view, m_window);
    EXPECT_EQ(vermilion(four, QRect(0, 0, 319, 199)), 0.0) << "FE";
    for (const QRect& pane : {QRect(321, 0, 319, 199), QRect(0, 201, 319, 199), QRect(321, 201, 319, 199)}) {
        EXPECT_GT(vermilion(four, pane), 0.002);
    }
    const QImage fragments = four.copy(321, 0, 319, 199);
    const QImage overlay = four.copy(0, 201, 319, 199);
    EXPECT_GT(differentPixels(fragments, overlay), 0.003) << "the outline of the intact structure";
}

TEST_F(GlFigures, AMeasuredLengthIsDrawnInEveryPane) {
    Studio studio(m_data);
    const QImage bare = studio.picture(m_view, m_window);
    m_view.measurements = {{Vec3(0, 0, 0), Vec3(4, 0, 3), false}};
    const QImage marked = studio.picture(m_view, m_window);
    for (const QRect& pane : {QRect(0, 0, 319, 400), QRect(321, 0, 319, 400)}) {
        EXPECT_GT(differentPixels(bare.copy(pane), marked.copy(pane)), 0.004);
    }
    m_view.measurements.clear();
    m_view.path = {Vec3(0, 0, 5), Vec3(2, 0, 4), Vec3(3, 0, 0)};
    const QImage way = studio.picture(m_view, m_window);
    EXPECT_EQ(way.copy(0, 0, 319, 400), bare.copy(0, 0, 319, 400)) << "no way in the FE view";
    EXPECT_GT(differentPixels(bare.copy(321, 0, 319, 400), way.copy(321, 0, 319, 400)), 0.002);
}

TEST_F(GlFigures, SelectionIsDrawnInTheAccent) {
    Studio studio(m_data);
    m_view.time = 0.0;
    const QImage before = studio.picture(m_view, m_window);
    m_view.selection = {idAt<ElementIndex>(0), idAt<ElementIndex>(1)};
    const QImage after = studio.picture(m_view, m_window);
    int blue = 0;
    for (int y = 0; y < 400; ++y) {
        for (int x = 0; x < 640; ++x) {
            const QColor c = after.pixelColor(x, y);
            blue += c.blue() > c.red() + 60 && before.pixel(x, y) != after.pixel(x, y);
        }
    }
    EXPECT_GT(blue, 200);
}

TEST_F(GlFigures, AnEmptySceneIsAPictureToo) {
    Studio studio({});
    const QImage picture = studio.picture(render::View{}, m_window);
    EXPECT_EQ(picture.size(), m_window.pixels);
    EXPECT_FALSE(studio.scene().pick(100, 100));
}

TEST_F(GlFigures, WithoutADisplayTheErrorNamesTheRemedy) {
    const std::string display = std::getenv("DISPLAY");
    for (const char* broken : {"", ":987"}) {
        setenv("DISPLAY", broken, 1);
        EXPECT_FALSE(displayAvailable());
        try {
            Studio studio(m_data);
            ADD_FAILURE() << "no error";
        } catch (const WorldError& error) {
            EXPECT_NE(std::string(error.what()).find("xvfb"), std::string::npos);
        }
    }
    setenv("DISPLAY", display.c_str(), 1);
}

TEST_F(GlFigures, TheViewForMeasuringDrawsWhatAFigureShows) {
    OffscreenView view(m_data, 640, 400);
    Studio studio(m_data);
    m_view.layout = render::defaultView(m_data, 640, 400).layout;
    for (const double time : {0.1, 0.5, 0.9}) {
        view.draw(time);
        m_view.time = time;
        studio.picture(m_view, m_window);
        for (const render::PaneContent pane : {render::PaneContent::Fe, render::PaneContent::Fragments}) {
            EXPECT_EQ(view.status(pane).time, studio.status(pane).time);
            EXPECT_EQ(view.status(pane).faces, studio.status(pane).faces);
            EXPECT_EQ(view.status(pane).fragments, studio.status(pane).fragments);
        }
        EXPECT_GT(view.status(render::PaneContent::Fragments).faces, 0u);
    }
    EXPECT_FALSE(view.renderer().empty());
}

}  // namespace
}  // namespace rubble::figures
