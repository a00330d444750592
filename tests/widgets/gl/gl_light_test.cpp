#include <gtest/gtest.h>

#include <QImage>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/offscreen_view.h"
#include "widgets/figures/palette.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/scene.h"

namespace rubble::figures {
namespace {

/// Share of white.
double lightness(const QColor& c) {
    return 0.2126 * c.redF() + 0.7152 * c.greenF() + 0.0722 * c.blueF();
}

/// Orange and its darker tones, as fragments have them in the analysis style.
int orangeIn(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += c.hsvSaturationF() > 0.6 && c.hsvHueF() < 0.14 && c.valueF() > 0.2 ? 1 : 0;
        }
    }
    return count;
}

/// The largest difference of a colour, of 255.
int farthest(const QImage& a, const QImage& b) {
    int most = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            most = std::max({most, std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
        }
    }
    return most;
}

class GlLight : public testing::Test {
protected:
    static void SetUpTestSuite() { ensureGuiApplication(); }
    void SetUp() override {
        ASSERT_TRUE(displayAvailable()) << "run under xvfb-run";
        m_data = scenes::ballisticRun(scenes::collapsingWall(), 1.0);
        m_view = render::defaultView(m_data, width, height);
        m_view.layout = render::Layout::FragmentsOnly;
        m_view.captions = m_view.legends = m_view.scaleBar = m_view.axes = m_view.groundGrid = false;
        m_view.cameras[0] = render::fitCamera(Aabb(Vec3(-3, -4, 0), Vec3(9, 6, 3)), aspect, render::Preset::Corner);
        m_view.time = 0.9;
        m_window.pixels = {width, height};
        m_window.framed = false;
        m_window.dpi = 96;
    }
    /// Lightness of the ground at a place [m], where nothing stands before it.
    double groundAt(const QImage& image, const Vec3& place) {
        const auto at = render::project(m_view.cameras[0], place, aspect);
        EXPECT_TRUE(at);
        return at ? lightness(image.pixelColor(static_cast<int>(at->u * width), static_cast<int>(at->v * height))) : 0.0;
    }
    static constexpr int width = 640;
    static constexpr int height = 400;
    static constexpr double aspect = 1.6;
    render::SceneData m_data;
    render::View m_view;
    FigureStyle m_window;
};

TEST_F(GlLight, TheGroundIsDarkerWhereTheModelStandsBetweenItAndTheSun) {
    Studio studio(m_data);
    m_view.time = 0.0;
    m_view.shadows = false;
    const QImage plain = studio.picture(m_view, m_window);
    m_view.shadows = true;
    const QImage lit = studio.picture(m_view, m_window);
    int darker = 0, lighter = 0;
    for (int y = 2; y < height; y += 4) {
        for (int x = 2; x < width; x += 4) {
            const auto ground = studio.scene().pick(x, y) ? std::nullopt : studio.scene().groundAt(x, y);
            if (!ground || std::abs(ground->x()) > 9.0 || std::abs(ground->y()) > 9.0) {
                continue;
            }
            const double change = lightness(lit.pixelColor(x, y)) / lightness(plain.pixelColor(x, y));
            darker += change < 0.75 ? 1 : 0;
            lighter += change > 1.02 ? 1 : 0;
        }
    }
    EXPECT_GT(darker, 60) << "the shadow";
    // A pixel on an edge of the model shares its colour, and the sides in the light of sun and fill are lighter.
    EXPECT_LE(lighter, 12) << "the ground is nowhere lighter than without";
    m_view.shadows = false;
    EXPECT_LE(farthest(studio.picture(m_view, m_window), plain), 1) << "and back again";
}

/// The plan looks from above: its lamp stands elsewhere than that of the panes beside it.
TEST_F(GlLight, APaneThatIsDrawnOnceMoreIsLitAsBefore) {
    m_view.layout = render::Layout::Four;
    for (const bool shadows : {false, true}) {
        Studio studio(m_data);
        m_view.shadows = shadows;
        const QImage first = studio.picture(m_view, m_window);
        EXPECT_EQ(studio.picture(m_view, m_window), first) << shadows;
        m_view.cameras[static_cast<std::size_t>(render::PaneContent::Plan)] =
            render::fitCamera(Aabb(Vec3(-4, -4, 0), Vec3(9, 6, 3)), aspect, render::Preset::Top);
        const QImage moved = studio.picture(m_view, m_window);
        EXPECT_EQ(moved.copy(0, 0, width / 2, height / 2), first.copy(0, 0, width / 2, height / 2))
            << "another pane's camera moved";
    }
}

TEST_F(GlLight, OrangeIsLeftToTheAnalysisStyle) {
    Studio studio(m_data);
    ASSERT_GT(orangeIn(studio.picture(m_view, m_window)), 500);
    const QImage before = studio.picture(m_view, m_window);
    m_view.style = render::Style::Presentation;
    EXPECT_EQ(orangeIn(studio.picture(m_view, m_window)), 0);
    m_view.style = render::Style::Analysis;
    EXPECT_EQ(studio.picture(m_view, m_window), before);
}

/// The sky stands around the model, and without perspective its near side lies before it.
TEST_F(GlLight, AParallelProjectionShowsTheModelToo) {
    Studio studio(m_data);
    const int seen = orangeIn(studio.picture(m_view, m_window));
    ASSERT_GT(seen, 500);
    m_view.cameras[0] = render::withProjection(m_view.cameras[0], true);
    EXPECT_GT(orangeIn(studio.picture(m_view, m_window)), seen / 2);
    m_view.cameras[0] = render::withProjection(m_view.cameras[0], false);
    EXPECT_GT(orangeIn(studio.picture(m_view, m_window)), seen / 2) << "and back again";
}

/// Ground from white snow, and water over it: at most 85 % of white, on a dark screen 60 %.
TEST_F(GlLight, SnowAndWaterDoNotGlare) {
    auto snow = std::make_shared<Orthophoto>();
    snow->x0 = snow->y0 = -40.0;
    snow->pixel = 10.0;
    snow->width = snow->height = 8;
    snow->rgba.assign(4 * 64, 255);
    for (const auto& [theme, most] : {std::pair(render::Theme::Light, 0.86), std::pair(render::Theme::Dark, 0.61)}) {
        for (const bool drowned : {false, true}) {
            m_data.orthophoto = snow;
            m_data.waterLevel = drowned ? std::optional(0.3) : std::nullopt;
            Studio studio(m_data);
            m_view.theme = theme;
            m_view.style = render::Style::Presentation;
            const QImage picture = studio.picture(m_view, m_window);
            double brightest = 0.0;
            for (int y = height / 2; y < height; y += 2) {
                for (int x = 0; x < width; x += 2) {
                    if (!studio.scene().pick(x, y)) {
                        brightest = std::max(brightest, lightness(picture.pixelColor(x, y)));
                    }
                }
            }
            EXPECT_LT(brightest, most) << drowned;
            EXPECT_GT(brightest, drowned ? 0.2 : 0.5) << "it still reads as snow";
        }
    }
}

/// Ground steps back so that what lies on it wins: from far above water below it came out on top of all land.
TEST_F(GlLight, WaterBelowTheGroundIsNotSeenFromFarAbove) {
    m_view.style = render::Style::Presentation;
    m_view.theme = render::Theme::Light;
    m_view.shadows = false;
    m_view.cameras[0] = render::fitCamera(Aabb(Vec3(-60, -40, 0), Vec3(60, 40, 3)), aspect, render::Preset::Top);
    const QImage dry = Studio(m_data).picture(m_view, m_window);
    m_data.waterLevel = -0.1;
    EXPECT_LE(farthest(Studio(m_data).picture(m_view, m_window), dry), 2);
    m_data.waterLevel = 0.5;
    EXPECT_GT(farthest(Studio(m_data).picture(m_view, m_window), dry), 10) << "above it is";
}

/// In print the analysis style leaves the paper white; the presentation style has ground.
TEST_F(GlLight, GroundReadsAsGroundInThePresentationStyle) {
    Studio studio(m_data);
    m_view.theme = render::Theme::Print;
    m_view.shadows = false;
    const Vec3 beside(-1.5, -2.5, 0.0);
    EXPECT_GT(groundAt(studio.picture(m_view, m_window), beside), 0.97);
    m_view.style = render::Style::Presentation;
    EXPECT_LT(groundAt(studio.picture(m_view, m_window), beside), 0.8);
}

/// From far off the ground begins long before what stands on it.
TEST_F(GlLight, GroundReachesTheFootOfATallPane) {
    Studio studio(m_data);
    m_view.theme = render::Theme::Light;
    m_view.style = render::Style::Presentation;
    m_view.shadows = false;
    m_view.cameras[0] = render::fitCamera(Aabb(Vec3(-3, -4, 0), Vec3(9, 6, 3)), 0.25, render::Preset::Front);
    m_window.pixels = {150, 600};
    const QImage tall = studio.picture(m_view, m_window);
    EXPECT_NEAR(lightness(tall.pixelColor(75, 594)), lightness(tall.pixelColor(75, 450)), 0.12);
}

}  // namespace
}  // namespace rubble::figures
