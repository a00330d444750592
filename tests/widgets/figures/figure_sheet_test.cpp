#include "widgets/figures/figure_sheet.h"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QFile>

#include <cmath>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/support/temporary_folder.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "widgets/figures/figure_file.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/framing.h"

namespace rubble::figures {
namespace {

using render::PaneContent;

render::PaneStatus statusAt(double time) {
    render::PaneStatus status;
    status.time = time;
    status.states = 122;
    status.fragments = 5;
    return status;
}

TEST(FigureCaption, NamesContentAndTime) {
    render::PaneStatus status = statusAt(1.68);
    EXPECT_EQ(captionBelow(0, PaneContent::Fe, status, 0.0).toStdString(), "a) Conventional FE result (t = 1.68 s, computed)");
    EXPECT_EQ(captionBelow(0, PaneContent::Fe, status, 1.0).toStdString(), "a) Conventional FE result (t = 0.68 s, computed)");
    status.interpolated = true;
    EXPECT_EQ(captionBelow(2, PaneContent::Fe, status, 0.0).toStdString(),
              "c) Conventional FE result (t = 1.68 s, computed, between two states)");
    EXPECT_EQ(captionBelow(1, PaneContent::Fragments, status, 0.0).toStdString(),
              "b) Fragments (t = 1.68 s, illustrative, not simulated)");
    status.simulated = true;
    status.kind = FrameKind::Simulated;
    EXPECT_EQ(captionBelow(3, PaneContent::Fragments, status, 0.0, "Final stage").toStdString(),
              "d) Final stage (t = 1.68 s, simulated)");
    EXPECT_EQ(captionBelow(3, PaneContent::Fragments, status, 0.0, "Final stage", 1234).toStdString(),
              "d) Final stage (t = 1.68 s, simulated, 1,234 outside the picture)");
    status.fragments = 0;
    EXPECT_EQ(captionBelow(0, PaneContent::Fragments, status, 0.0, "Original").toStdString(), "a) Original (t = 1.68 s, computed)")
        << "nothing has come off yet";
    status.fragments = 5;
    status.kind = FrameKind::Interpolated;
    EXPECT_EQ(captionBelow(1, PaneContent::Plan, status, 0.0).toStdString(),
              "b) Fragments in plan (t = 1.68 s, simulated, interpolated)");
}

TEST(FigureClass, TellsFeFromSimulatedFromIllustrative) {
    render::PaneStatus status = statusAt(1.0);
    EXPECT_EQ(shownAs(PaneContent::Fe, status), "FE");
    status.interpolated = true;
    EXPECT_EQ(shownAs(PaneContent::Fe, status), "FE, interpolated between two states");
    EXPECT_EQ(shownAs(PaneContent::Fragments, status), "illustrative");
    status.simulated = true;
    status.kind = FrameKind::Simulated;
    EXPECT_EQ(shownAs(PaneContent::Fragments, status), "simulated");
}

class Preset : public testing::Test {
protected:
    render::SceneData m_data = scenes::ballisticRun(scenes::collapsingWall(), 1.0);
    render::View m_view = render::defaultView(m_data, 800, 500);
    Sheet sheet(FigurePreset preset, QSize pixels = {1600, 1000}) const {
        PresetRequest request;
        request.preset = preset;
        request.end = 1.5;
        Sheet made = presetSheet(request, m_view, m_data);
        render::Framing framing(made.look);
        framing.add(m_data.fe->mesh().nodes, {}, Aabb(), 0.0);
        arrange(made, framing, pixels, 200.0, true, false);
        return made;
    }
};

TEST_F(Preset, PairsShowBothAtThreeInstantsFromOneCamera) {
    const Sheet pairs = sheet(FigurePreset::Pairs);
    ASSERT_EQ(pairs.panels.size(), 6u);
    EXPECT_TRUE(pairs.commonLegend);
    int fe = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        fe += pairs.panels[i].content == PaneContent::Fe;
        EXPECT_EQ(pairs.panels[i].view.cameras[0], pairs.panels[0].view.cameras[0]);
    }
    EXPECT_EQ(fe, 3);
    // Every FE picture has its fragments at the same time, beside it in the row below or right below.
    for (std::size_t i = 0; i < 6; ++i) {
        if (pairs.panels[i].content == PaneContent::Fe) {
            const std::size_t below = i + static_cast<std::size_t>(pairs.columns);
            ASSERT_LT(below, 6u);
            EXPECT_EQ(pairs.panels[below].content, PaneContent::Fragments);
            EXPECT_EQ(pairs.panels[below].view.time, pairs.panels[i].view.time);
        }
    }
}

TEST_F(Preset, EndSurroundingsAndStagesShowWhatTheirFiguresShow) {
    const Sheet end = sheet(FigurePreset::End);
    ASSERT_EQ(end.panels.size(), 2u);
    EXPECT_EQ(end.panels[0].view.time, 1.5);
    const Sheet around = sheet(FigurePreset::Surroundings);
    ASSERT_EQ(around.panels.size(), 1u);
    const Sheet stages = sheet(FigurePreset::Stages);
    ASSERT_EQ(stages.panels.size(), 4u);
    EXPECT_EQ(stages.panels[0].view.time, m_data.fe->times().front());
    EXPECT_EQ(stages.panels[3].view.time, 1.5);
    EXPECT_EQ(stages.panels[3].stage, "Final stage");
    EXPECT_LT(stages.panels[1].view.time, stages.panels[2].view.time);
}

TEST_F(Preset, HasMaterialsUnlessTheStyleOfAnalysisIsAskedFor) {
    for (const auto& [name, preset] : figurePresets) {
        for (const SheetPanel& panel : sheet(preset).panels) {
            EXPECT_EQ(panel.view.style, render::Style::Presentation) << name;
            EXPECT_TRUE(panel.view.shading && !panel.view.groundGrid) << name;
        }
        PresetRequest request;
        request.preset = preset;
        request.style = render::Style::Analysis;
        for (const SheetPanel& panel : presetSheet(request, m_view, m_data).panels) {
            EXPECT_EQ(panel.view.style, render::Style::Analysis) << name;
            EXPECT_EQ(panel.view.shading, m_view.shading) << name;
            EXPECT_EQ(panel.view.groundGrid, m_view.groundGrid) << name;
        }
    }
}

TEST_F(Preset, TakesTheInstantsItIsGivenAndNoOtherNumber) {
    PresetRequest request;
    request.times = {0.1, 0.2, 0.3};
    const Sheet pairs = presetSheet(request, m_view, m_data);
    EXPECT_EQ(pairs.panels.back().view.time, 0.3);
    request.times = {0.1};
    EXPECT_THROW(presetSheet(request, m_view, m_data), UsageError);
}

/// A bridge of 100 x 16 x 18 m, as a lattice of points.
std::vector<Vec3> longBridge() {
    std::vector<Vec3> points;
    for (int x = -50; x <= 50; x += 2) {
        for (const double y : {-8.0, 8.0}) {
            points.emplace_back(x, y, 18.0);
            points.emplace_back(x, y, 18.0 * std::abs(x) / 50.0 * 0.9);
        }
    }
    return points;
}

/// Least of the shares of width and height of a picture that points take.
double shareFilled(std::span<const Vec3> points, const render::Camera& camera, double aspect) {
    Eigen::AlignedBox2d box;
    for (const Vec3& point : points) {
        const auto place = render::project(camera, point, aspect);
        EXPECT_TRUE(place && place->u >= 0.0 && place->u <= 1.0 && place->v >= 0.0 && place->v <= 1.0) << point.transpose();
        if (place) {
            box.extend(Eigen::Vector2d(place->u, place->v));
        }
    }
    return box.sizes().minCoeff();
}

TEST(Arrange, AFigureWithoutAHeightIsFilledByWhatItShows) {
    const std::vector<Vec3> bridge = longBridge();
    for (const render::Preset look : {render::Preset::Side, render::Preset::Corner, render::Preset::Top}) {
        render::Framing framing(look);
        framing.add(bridge, bridge, Aabb(), 1.0);
        Sheet sheet;
        sheet.framed = true;
        sheet.look = look;
        sheet.choices = {1, 2};
        sheet.panels.resize(2);
        QSize pixels(1600, 0);
        arrange(sheet, framing, pixels, 200.0, true, false);
        EXPECT_GT(pixels.height(), 0);
        const QSize panel = layOutSheet(sheet.columns, sheet.rows(), legendOf(sheet), true, pixels, 200.0).panel;
        const double aspect = static_cast<double>(panel.width()) / panel.height();
        EXPECT_GT(shareFilled(bridge, sheet.panels[1].view.cameras[0], aspect), 0.9) << static_cast<int>(look);
        EXPECT_FALSE(sheet.framed) << "settled";
    }
}

TEST(Arrange, AGivenHeightIsKeptAndTheModelIsAsLargeAsItGoes) {
    const std::vector<Vec3> bridge = longBridge();
    render::Framing framing(render::Preset::Side);
    framing.add(bridge, bridge, Aabb(), 1.0);
    Sheet sheet;
    sheet.framed = true;
    sheet.choices = {2, 1};
    sheet.panels.resize(2);
    QSize pixels(1600, 900);
    arrange(sheet, framing, pixels, 200.0, true, false);
    EXPECT_EQ(pixels, QSize(1600, 900));
    EXPECT_EQ(sheet.columns, 1) << "one below the other a long bridge is larger";
    // Cameras that were chosen stay.
    Sheet own;
    own.panels.resize(1);
    own.panels[0].view.cameras[0].position = Vec3(1.0, 2.0, 3.0);
    const auto before = own.panels[0].view.cameras;
    QSize free(1600, 0);
    arrange(own, framing, free, 200.0, true, false);
    EXPECT_EQ(own.panels[0].view.cameras, before);
    EXPECT_GT(free.height(), 0);
}

// Figure 13: the debris is large in the picture, and the ground around it is seen to the sides, before and behind.
TEST(Arrange, DebrisInItsSurroundingsIsWhatIsFramed) {
    const std::vector<Vec3> bridge = longBridge();
    std::vector<Vec3> around;
    for (const double x : {-70.0, 70.0}) {
        for (const double y : {-11.2, 11.2}) {
            around.emplace_back(x, y, 16.2);  // at the height of what stands there
        }
    }
    for (const render::Preset look : {render::Preset::Corner, render::Preset::Top, render::Preset::Side}) {
        for (const QSize asked : {QSize(1600, 0), QSize(800, 600), QSize(1600, 1000)}) {
            SCOPED_TRACE(std::to_string(static_cast<int>(look)) + " at " + std::to_string(asked.height()));
            render::Framing framing(look);
            framing.add(bridge, bridge, Aabb(), 1.0);
            framing.widen(1.4);
            Sheet sheet;
            sheet.framed = true;
            sheet.look = look;
            sheet.panels.resize(1);
            QSize pixels = asked;
            arrange(sheet, framing, pixels, 200.0, true, false);
            const QSize panel = layOutSheet(sheet.columns, sheet.rows(), legendOf(sheet), true, pixels, 200.0).panel;
            const double aspect = static_cast<double>(panel.width()) / panel.height();
            const render::Camera& camera = sheet.panels[0].view.cameras[0];
            shareFilled(around, camera, aspect);
            shareFilled(bridge, camera, aspect);
            Eigen::AlignedBox2d seen;
            for (const Vec3& point : bridge) {
                const auto place = render::project(camera, point, aspect);
                ASSERT_TRUE(place);
                seen.extend(Eigen::Vector2d(place->u, place->v));
            }
            EXPECT_GT(seen.sizes().maxCoeff(), 0.55) << "it is what is shown";
            EXPECT_LT(seen.sizes().maxCoeff(), 0.92) << "with something around it";
        }
    }
}

TEST(Framing, LeavesOutTheFewThatLieFarOut) {
    std::vector<Vec3> points = longBridge();
    std::vector<Vec3> pile;
    for (int i = 0; i < 2000; ++i) {
        pile.emplace_back(-50.0 + 0.05 * i, 0.0, 1.0 + 0.001 * i);
    }
    points.insert(points.end(), pile.begin(), pile.end());
    render::Framing framing(render::Preset::Side);
    framing.add(points, pile, Aabb(), 1.0);
    const double filled = framing.aspect();
    pile.emplace_back(5000.0, 0.0, 1.0);
    points.push_back(pile.back());
    render::Framing stray(render::Preset::Side);
    stray.add(points, pile, Aabb(), 1.0);
    EXPECT_NEAR(stray.aspect(), filled, 0.01 * filled);
    // Where everything runs out, all of it is seen.
    for (int i = 0; i < 200; ++i) {
        pile.emplace_back(300.0 + i, 0.0, 1.0);
        points.push_back(pile.back());
    }
    render::Framing wide(render::Preset::Side);
    wide.add(points, pile, Aabb(), 1.0);
    EXPECT_GT(render::metresPerPixel(wide.camera(2.0), 100.0), 3.0 * render::metresPerPixel(stray.camera(2.0), 100.0));
}

TEST(SheetLayout, PanelsFillTheFigureWithoutOverlap) {
    const SheetLayout layout = layOutSheet(3, 2, SheetLegend::Foot, true, {1600, 1000}, 200.0);
    const QRect whole(0, 0, 1600, 1000);
    std::vector<QRect> places;
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 3; ++column) {
            const QRect place = layout.panelAt(column, row);
            EXPECT_TRUE(whole.contains(place));
            for (const QRect& other : places) {
                EXPECT_FALSE(place.intersects(other));
            }
            places.push_back(place);
        }
    }
    EXPECT_LE(places.back().bottom() + layout.caption + layout.legend + layout.provenance, 1000);
    EXPECT_DOUBLE_EQ(layout.text, 25.0);
}

/// A figure whose scene is a grey picture: what is around it needs no GL.
SheetPicture paintedFigure() {
    SheetPicture picture({900, 500}, layOutSheet(1, 1, SheetLegend::None, true, {900, 500}, 150.0));
    SheetPicture::Panel panel;
    panel.place = layOutSheet(1, 1, SheetLegend::None, true, {900, 500}, 150.0).panelAt(0, 0);
    panel.picture = QImage(panel.place.size(), QImage::Format_RGB32);
    panel.picture.fill(Qt::gray);
    panel.shown.caption = QStringLiteral("a) Conventional FE result (t = 1.68 s, computed)");
    picture.add(panel);
    picture.setFoot({}, {}, QStringLiteral("FE 1a2b"));
    return picture;
}

TEST(SheetLegend, StandsBelowThePictureAndCoversNothing) {
    ensureGuiApplication();
    const QSize pixels(900, 500);
    const SheetLayout layout = layOutSheet(1, 1, SheetLegend::Below, false, pixels, 150.0);
    SheetPicture::Panel panel;
    panel.place = layout.panelAt(0, 0);
    panel.picture = QImage(panel.place.size(), QImage::Format_RGB32);
    panel.picture.fill(Qt::gray);
    panel.shown.caption = QStringLiteral("a) Fragments");
    panel.overlay.legend = {{QColor(200, 80, 20), QStringLiteral("fragments 9,643"), false}};
    takeMarksBelow(panel, layout);
    EXPECT_TRUE(panel.overlay.legend.empty());
    SheetPicture figure(pixels, layout);
    figure.add(panel);
    const QImage image = figure.image();
    SheetPicture bare(pixels, layout);
    SheetPicture::Panel without = panel;
    without.legend.clear();
    bare.add(without);
    EXPECT_EQ(image.copy(panel.place), bare.image().copy(panel.place));
    int ink = 0;
    for (int y = panel.place.bottom() + 1; y <= panel.place.bottom() + layout.key; ++y) {
        for (int x = 0; x < pixels.width(); ++x) {
            ink += image.pixelColor(x, y) == QColor(200, 80, 20);
        }
    }
    EXPECT_GT(ink, 30);
    // The scale bar stands beside it, clear of picture and legend.
    panel.overlay.metresPerPixel = 0.01;
    takeMarksBelow(panel, layout);
    EXPECT_EQ(panel.overlay.metresPerPixel, 0.0);
    SheetPicture scaled(pixels, layout);
    scaled.add(panel);
    const QImage withBar = scaled.image();
    EXPECT_EQ(withBar.copy(panel.place), bare.image().copy(panel.place));
    const QRect end(pixels.width() - 150, panel.place.bottom() + 1, 150, layout.key);
    EXPECT_NE(withBar.copy(end), image.copy(end));
    panel.metresPerPixel = 0.0;
    // A legend that would be too small to be read in a line stays over the picture.
    panel.overlay.legend.assign(12, {QColor(200, 80, 20), QStringLiteral("a component with a long name · 12,345"), false});
    panel.legend.clear();
    takeMarksBelow(panel, layout);
    EXPECT_TRUE(panel.legend.empty());
    EXPECT_EQ(panel.overlay.legend.size(), 12u);
}

QByteArray contentOf(const std::string& path) {
    QFile file(QString::fromStdString(path));
    file.open(QIODevice::ReadOnly);
    return file.readAll();
}

TEST(SheetFile, TextOfSvgAndPdfStaysTextAndTheProvenanceIsInside) {
    ensureGuiApplication();
    const io::TemporaryFolder folder;
    FigureStyle style;
    style.pixels = {900, 500};
    style.dpi = 150.0;
    style.provenance = "a < b & c.exo";
    const std::string metadata = R"({"rubble_provenance":1,"kind":"figure","note":"a < b & \"c\""})";
    for (const char* ending : {"svg", "pdf", "png"}) {
        const std::string path = folder / (std::string("f.") + ending);
        writeSheet(path, paintedFigure(), style, metadata);
        const QByteArray content = contentOf(path);
        if (QLatin1String(ending) != QLatin1String("png")) {
            EXPECT_TRUE(content.contains(metadata.c_str())) << ending;
        } else {
            EXPECT_EQ(QImage(QString::fromStdString(path)).text("Rubble-Provenance").toStdString(), metadata);
        }
    }
    EXPECT_TRUE(contentOf(folder / "f.svg").contains("Conventional FE result"));
    EXPECT_TRUE(contentOf(folder / "f.svg").contains("<desc>a &lt; b &amp; c.exo</desc>"));
    EXPECT_TRUE(contentOf(folder / "f.pdf").startsWith("%PDF"));
    EXPECT_THROW(writeSheet(folder / "f.tiff", paintedFigure(), style, metadata), UsageError);
    EXPECT_THROW(writeSheet(folder / "none/f.pdf", paintedFigure(), style, metadata), WorldError);
}

}  // namespace
}  // namespace rubble::figures
