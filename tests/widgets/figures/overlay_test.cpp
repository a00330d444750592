#include "widgets/figures/overlay/overlay.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "tests/widgets/scenes/released_slab.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"

namespace rubble::figures {
namespace {

TEST(NumberText, GroupsThousandsAndNamesUnits) {
    EXPECT_EQ(countText(49561), "49,561");
    EXPECT_EQ(timeText(5.7602), "5.76 s");
    EXPECT_EQ(timeText(-0.0001), "0.00 s");
    EXPECT_EQ(lengthText(25), "25 m");
    EXPECT_EQ(lengthText(0.5), "0.5 m");
    EXPECT_EQ(lengthText(2000), "2 km");
}

TEST(ScaleBar, LengthIsRoundAndFits) {
    for (double scale = 1e-4; scale < 1e3; scale *= 1.37) {
        const double length = roundLength(scale, 100.0);
        EXPECT_LE(length, 100.0 * scale * (1 + 1e-12));
        EXPECT_GT(length, 100.0 * scale / 2.6);
        const double mantissa = length / std::pow(10.0, std::floor(std::log10(length * (1 + 1e-12))));
        EXPECT_TRUE(std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 || std::abs(mantissa - 5) < 1e-9) << length;
    }
    EXPECT_EQ(roundLength(0.0, 100.0), 0.0);
    EXPECT_EQ(roundLength(std::nan(""), 100.0), 0.0);
}

TEST(Caption, SaysWhatIsShown) {
    render::PaneStatus status;
    status.states = 121;
    status.state = 71;
    status.time = 5.76;
    EXPECT_EQ(captionText(render::PaneContent::Fe, status),
              QStringLiteral("Conventional FE result · t = 5.76 s, state 71 of 0–120"));
    status.interpolated = true;
    EXPECT_EQ(captionText(render::PaneContent::Fe, status),
              QStringLiteral("Conventional FE result · t = 5.76 s, interpolated after state 71 of 0–120"));
    status.simulated = true;
    status.kind = FrameKind::Simulated;
    EXPECT_EQ(captionText(render::PaneContent::Fragments, status), QStringLiteral("Fragments · t = 5.76 s, simulated"));
    status.waitsForRun = true;
    EXPECT_EQ(captionText(render::PaneContent::Fragments, status), QStringLiteral("Fragments · t = 5.76 s, simulated so far"));
    EXPECT_EQ(captionText(render::PaneContent::Fe, {}), QStringLiteral("Conventional FE result"));
}

class Legends : public testing::Test {
protected:
    Overlay overlayFor(render::ColourBy colourBy, render::PaneContent content = render::PaneContent::Fragments) {
        m_view.colourBy = colourBy;
        m_view.time = m_time;
        m_scene.update(m_view, 1280, 800);
        for (const render::Pane& pane : render::panesOf(m_view.layout, 1280, 800)) {
            if (pane.content == content) {
                return makeOverlay(m_view, m_scene, pane);
            }
        }
        return {};
    }
    void SetUp() override {
        const auto data = scenes::ballisticRun(scenes::collapsingWall(), 1.0);
        m_scene.setData(data);
        m_scene.setColours(sceneColours(render::Theme::Light));
        m_view = render::defaultView(data, 1280, 800);
    }
    render::Scene m_scene;
    render::View m_view;
    double m_time = 0.5;  // s
};

TEST_F(Legends, FragmentsThatTheFeResultStillHasAreCounted) {
    FragmentSettings joined;
    joined.birthWindow = 0.5;
    m_scene.setData(scenes::ballisticRun(scenes::collapsingWall(), 1.0, true, joined));
    // Half of the wall dies at 0.4 s; the window hands it over with the other half.
    m_time = 0.3;
    const Overlay early = overlayFor(render::ColourBy::Highlight);
    ASSERT_EQ(early.legend.size(), 3u);
    EXPECT_EQ(early.legend[0].text, "fragments 12");
    EXPECT_EQ(early.legend[1].text, "born before the FE result deletes them: 6");
    EXPECT_EQ(overlayFor(render::ColourBy::Highlight, render::PaneContent::Fe).legend[0].text, "active 10 of 16 elements");
    m_time = 0.5;
    EXPECT_EQ(overlayFor(render::ColourBy::Highlight).legend.size(), 2u) << "both views have the same deaths again";
}

TEST_F(Legends, CountWhatTheViewShows) {
    const Overlay fragments = overlayFor(render::ColourBy::Highlight);
    ASSERT_EQ(fragments.legend.size(), 2u);
    EXPECT_EQ(fragments.legend[0].text, "fragments 12");
    EXPECT_EQ(fragments.legend[0].colour, palette(render::Theme::Light).fragment);
    EXPECT_EQ(fragments.legend[1].text, "active structure 4");
    const Overlay fe = overlayFor(render::ColourBy::Highlight, render::PaneContent::Fe);
    ASSERT_EQ(fe.legend.size(), 1u);
    EXPECT_EQ(fe.legend[0].text, "active 4 of 16 elements");
}

TEST_F(Legends, MaterialsAreNamedInTheirColoursInBothViews) {
    m_view.style = render::Style::Presentation;
    for (const render::PaneContent content : {render::PaneContent::Fe, render::PaneContent::Fragments}) {
        const Overlay overlay = overlayFor(render::ColourBy::Highlight, content);
        ASSERT_GE(overlay.legend.size(), 2u);
        EXPECT_EQ(overlay.legend.back().text, QStringLiteral("masonry (assumed)"));
        EXPECT_TRUE(overlay.legend.back().colour.isValid());
        for (std::size_t i = 0; i + 1 < overlay.legend.size(); ++i) {
            EXPECT_FALSE(overlay.legend[i].colour.isValid()) << "a colour that is not in the view";
        }
    }
    auto data = m_scene.data();
    for (const Component& component : data.components->list) {
        data.givenMaterials.insert(component.name);
    }
    m_scene.setData(data);
    EXPECT_EQ(overlayFor(render::ColourBy::Highlight).legend.back().text, QStringLiteral("masonry")) << "somebody has named it";
}

TEST_F(Legends, ReleasedStructureIsCountedApart) {
    scenes::ReleasedSlab run;
    run.runToFeEnd();
    run.release();
    m_scene.setData(run.data);
    const Overlay fragments = overlayFor(render::ColourBy::Highlight);
    ASSERT_EQ(fragments.legend.size(), 3u);
    EXPECT_EQ(fragments.legend[1].text, "active structure 3");
    EXPECT_EQ(fragments.legend[2].text, "loose structure 6");
    EXPECT_EQ(fragments.legend[2].colour, palette(render::Theme::Light).released);
    EXPECT_EQ(overlayFor(render::ColourBy::Highlight, render::PaneContent::Fe).legend[0].text, "active 9 of 10 elements");
    // In the look of its material it has no colour of its own, and a legend must not promise one.
    render::View view;
    EXPECT_EQ(commonLegend(view, m_scene.data(), true).size(), 3u);
    view.style = render::Style::Presentation;
    for (const LegendEntry& entry : commonLegend(view, m_scene.data(), true)) {
        EXPECT_TRUE(entry.text.contains(QStringLiteral("assumed"))) << "materials alone: " << entry.text.toStdString();
    }
    EXPECT_FALSE(commonLegend(view, m_scene.data(), true).empty());
}

TEST_F(Legends, EveryColouringExplainsItself) {
    EXPECT_EQ(overlayFor(render::ColourBy::Component).legend[0].text, QStringLiteral("wall · 12"));
    EXPECT_NE(overlayFor(render::ColourBy::Cluster).legend[0].text.indexOf("clusters"), -1);
    const Overlay birth = overlayFor(render::ColourBy::BirthTime);
    ASSERT_EQ(birth.bars.size(), 1u);
    EXPECT_EQ(birth.bars[0].low, "0.20 s");
    EXPECT_EQ(birth.bars[0].high, "0.40 s");
    const Overlay speed = overlayFor(render::ColourBy::Speed);
    ASSERT_EQ(speed.bars.size(), 1u);
    EXPECT_EQ(speed.bars[0].low, "0 m/s");
    EXPECT_EQ(speed.bars[0].high, QString("%1 m/s").arg(m_scene.speedTop()));
}

TEST_F(Legends, ErrorsAreCountedByTheirSteps) {
    EXPECT_TRUE(overlayFor(render::ColourBy::Error).legend[0].text.contains(QStringLiteral("no reference")));
    auto data = scenes::ballisticRun(scenes::collapsingWall(), 1.0);
    data.reference = data.trajectory;
    m_scene.setData(data);
    const Overlay overlay = overlayFor(render::ColourBy::Error);
    const std::size_t steps = m_view.errorSteps.size();
    ASSERT_EQ(overlay.legend.size(), 1 + steps + 1 + 1) << "title, steps, beyond the last, active structure";
    EXPECT_EQ(overlay.legend[1].text, QStringLiteral("≤ 0.1 m · 12")) << "a run is at no distance from itself";
    EXPECT_EQ(overlay.legend[1].colour, errorColour(0.0));
    EXPECT_EQ(overlay.legend[steps + 1].text, QStringLiteral("over 3 m · 0"));
    EXPECT_EQ(overlay.legend[steps + 1].colour, errorColour(1.0));
}

TEST_F(Legends, IslandsAreNamedAndCountedInTheirColours) {
    EXPECT_EQ(overlayFor(render::ColourBy::Island, render::PaneContent::Fe).legend.back().text,
              QStringLiteral("loose islands are not known yet"));
    // A slab of six elements in the air, and seven smaller ones beside it.
    std::vector<scenes::Block> blocks(8);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        blocks[i].low = Vec3(10.0 * static_cast<double>(i), 0, 50);
        blocks[i].velocity = Vec3(0, 0, -2);
    }
    blocks[0].size = Vec3(3, 2, 1);
    blocks[0].cells = {3, 2, 1};
    const auto fe = scenes::makeScene(blocks, 8, 0.1);
    auto data = scenes::withoutRun(fe);
    data.loose = std::make_shared<const LooseStructure>(looseStructure(*fe, fe->activity(), {true, 0.0, nullptr}, Execution()));
    m_scene.setData(data);
    const Overlay overlay = overlayFor(render::ColourBy::Island, render::PaneContent::Fe);
    ASSERT_EQ(overlay.legend.size(), 1u + 2u + 5u + 1u);
    EXPECT_EQ(overlay.legend[0].text, QStringLiteral("active 13 of 13 elements"));
    EXPECT_FALSE(overlay.legend[0].colour.isValid());
    EXPECT_EQ(overlay.legend[1].text, QStringLiteral("not loose"));
    EXPECT_EQ(overlay.legend[1].colour, palette(render::Theme::Light).structure);
    EXPECT_EQ(overlay.legend[2].text, QStringLiteral("in loose islands 13"));
    EXPECT_EQ(overlay.legend[3].text, QStringLiteral("island 1 · 6"));
    EXPECT_EQ(overlay.legend[4].text, QStringLiteral("island 2 · 1"));
    EXPECT_TRUE(overlay.legend[4].colour.isValid());
    EXPECT_NE(overlay.legend[3].colour, overlay.legend[4].colour);
    EXPECT_EQ(overlay.legend.back().text, QStringLiteral("smaller islands: 3"));
    render::View view;
    view.colourBy = render::ColourBy::Island;
    EXPECT_EQ(commonLegend(view, m_scene.data(), true).back().text, QStringLiteral("each loose island in a colour of its own"));
}

TEST_F(Legends, WhatTheViewSwitchesOffIsGone) {
    m_view.captions = m_view.legends = m_view.scaleBar = false;
    const Overlay overlay = overlayFor(render::ColourBy::BirthTime);
    EXPECT_TRUE(overlay.caption.isEmpty());
    EXPECT_TRUE(overlay.legend.empty());
    EXPECT_TRUE(overlay.bars.empty());
    EXPECT_EQ(overlay.metresPerPixel, 0.0);
}

TEST_F(Legends, TellThatAMovingViewIsSimplified) {
    m_scene.setData(scenes::ballisticRun(scenes::collapsingWall(200, 110), 0.7));
    m_view = render::defaultView(m_scene.data(), 1280, 800);
    const auto told = [&] {
        const Overlay overlay = overlayFor(render::ColourBy::BirthTime);
        return overlay.moving.startsWith(QStringLiteral("simplified while moving")) ? 1 : 0;
    };
    EXPECT_EQ(told(), 0);
    const auto full = m_scene.pick(640, 200);
    m_scene.setSimplified(true);
    EXPECT_EQ(told(), 1);
    // What is picked is what is there, not what is drawn meanwhile.
    const auto less = m_scene.pick(640, 200);
    ASSERT_EQ(less.has_value(), full.has_value());
    if (full) {
        EXPECT_EQ(less->element, full->element);
        EXPECT_EQ(less->position, full->position);
    }
    m_view.legends = false;
    EXPECT_EQ(told(), 1) << "said even where legends are off";
    m_scene.setSimplified(true, 0.5);
    EXPECT_EQ(told(), 1) << "in one line";
    EXPECT_TRUE(overlayFor(render::ColourBy::BirthTime).moving.endsWith(QStringLiteral(", resolution 50 %")));
    m_scene.setSimplified(false);
    EXPECT_EQ(told(), 0);
}

TEST_F(Legends, PointsOfACloudSayHowManyTheyAreAndWhatTheirColoursSay) {
    auto points = std::make_shared<render::SitePoints>();
    points->name = "scan.las";
    points->shown = 1'500;
    points->all = 2'000'000;
    points->scale = render::SitePoints::Scale::Height;
    points->low = 10.0;
    points->high = 30.0;
    const auto lines = [&] {
        render::SceneData data = m_scene.data();
        data.points = points;
        m_scene.setData(data);
        QStringList texts;
        for (const LegendEntry& entry : overlayFor(render::ColourBy::Highlight).legend) {
            texts << entry.text;
        }
        return texts;
    };
    EXPECT_FALSE(lines().contains(QStringLiteral("scan.las: 1,500 of 2,000,000 points"))) << "the view does not draw them";
    m_view.cloud = "survey-1";
    EXPECT_TRUE(lines().contains(QStringLiteral("scan.las: 1,500 of 2,000,000 points")));
    EXPECT_TRUE(lines().contains(QStringLiteral("z = 20 m")));
    points = std::make_shared<render::SitePoints>(*points);
    points->scale = render::SitePoints::Scale::Distance;
    points->low = -0.5;
    points->high = 1.25;
    points->detection = 0.0421;
    points->unknown = 7;
    points->time = 3.0;
    QStringList told = lines();
    EXPECT_TRUE(told.contains(QStringLiteral("from scan.las to the site at t = 3.00 s: 1,500 of 2,000,000 places")));
    EXPECT_TRUE(told.contains(QStringLiteral("simulated site above, up to 1.3 m")));
    EXPECT_TRUE(told.contains(QStringLiteral("below, up to 0.5 m")));
    EXPECT_TRUE(told.contains(QStringLiteral("level of detection not known · 7")));
    EXPECT_TRUE(told.contains(QStringLiteral("within the level of detection, 0.043 m in the median")));
    const QString unknownError = QStringLiteral("without the registration's error: not known");
    EXPECT_TRUE(told.contains(unknownError));
    points = std::make_shared<render::SitePoints>(*points);
    points->registered = true;
    EXPECT_TRUE(lines().contains(QStringLiteral("within the level of detection, 0.043 m in the median")));
    EXPECT_FALSE(lines().contains(unknownError));
}

TEST_F(Legends, ALegendThatNeedsLinesStandsInTheStripThatIsKeptForIt) {
    ensureGuiApplication();
    // A pane as narrow as one of two beside each other at 1280 x 800.
    const render::Pane pane{render::PaneContent::Fragments, 0, 0, 300, 400};
    constexpr double textHeight = 13.0;
    for (const render::ColourBy by : {render::ColourBy::Highlight, render::ColourBy::Component, render::ColourBy::Error}) {
        overlayFor(by);
        const Overlay longest = longestOverlay(m_view, m_scene, pane);
        const double room = overlayRoom(longest, pane.width, textHeight);
        EXPECT_GE(longest.legend.size(), makeOverlay(m_view, m_scene, pane).legend.size());
        QImage picture(pane.width, pane.height, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paintOverlay(painter, makeOverlay(m_view, m_scene, pane), pane, render::Theme::Light, textHeight);
        painter.end();
        int covered = 0;
        for (int y = static_cast<int>(room); y < pane.height - static_cast<int>(room); ++y) {
            for (int x = 0; x < pane.width; ++x) {
                covered += qAlpha(picture.pixel(x, y)) > 0 ? 1 : 0;
            }
        }
        EXPECT_EQ(covered, 0) << "coloured by " << static_cast<int>(by);
    }
}

TEST_F(Legends, InANarrowPaneTheInstantIsReadAndTheLegendStandsOverTheScaleBar) {
    ensureGuiApplication();
    constexpr double textHeight = 13.0;
    Overlay overlay;
    overlay.caption = QStringLiteral("Conventional FE result · t = 5.50 s, state 69 of 122");
    const double oneLine = overlayRoom(overlay, 900, textHeight);
    EXPECT_GT(overlayRoom(overlay, 225, textHeight), 1.5 * oneLine) << "name and instant in a line each";
    EXPECT_GT(overlayRoom(overlay, 140, textHeight), 2.5 * oneLine) << "nothing is cut off where that takes more lines";
    overlay.caption = QStringLiteral("No run of another scenario is chosen");
    EXPECT_GT(overlayRoom(overlay, 160, textHeight), 1.5 * oneLine);
    overlay.metresPerPixel = 1.0;
    for (int i = 0; i < 8; ++i) {
        overlay.legend.push_back({QColor(), QStringLiteral("arch ring %1 · 4,536").arg(i)});
    }
    const double narrow = overlayRoom(overlay, 300, textHeight);
    overlay.metresPerPixel = 0.0;
    const double whole = overlayRoom(overlay, 300, textHeight);
    EXPECT_LT(narrow, whole + 4.0 * textHeight) << "no taller than beside no scale bar, and that bar";
    EXPECT_GT(narrow, whole);
    // One entry that beside the bar would be cut off.
    overlay.caption.clear();
    overlay.legend = {{QColor(), QStringLiteral("13 more components · 27,640")}};
    const double free = overlayRoom(overlay, 225, textHeight);
    overlay.metresPerPixel = 1.0;
    EXPECT_GT(overlayRoom(overlay, 225, textHeight), free + textHeight);
    overlay.metresPerPixel = 0.0;
    EXPECT_GT(overlayRoom(overlay, 140, textHeight), free + textHeight) << "broken rather than cut: its count stands at the end";
}

TEST_F(Legends, AnEmptySceneSaysOnlyWhatWouldBeThere) {
    m_scene.setData({});
    const Overlay overlay = overlayFor(render::ColourBy::Speed);
    EXPECT_EQ(overlay.caption, "Fragments");
    EXPECT_TRUE(overlay.legend.empty());
}

TEST_F(Legends, SpeedScaleCoversAFallFromTheTop) {
    const double height = m_scene.bounds().sizes().z();
    EXPECT_GE(m_scene.speedTop(), std::sqrt(2 * standardGravity * height));
    EXPECT_LE(m_scene.speedTop(), 2.0 * std::sqrt(2 * standardGravity * height));
}

}  // namespace
}  // namespace rubble::figures
