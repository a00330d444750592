#include "widgets/evidence/run_map_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/basics/map_view.h"
#include "widgets/basics/theme.h"
#include "widgets/figures/map_picture.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/sheets/map_contours.h"
#include "widgets/figures/sheets/map_window.h"
#include "widgets/figures/sheets/map_words.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

/// A heap of 20 by 10 cells of 0.5 m, 3 m high in the middle.
std::shared_ptr<const RunMap> heap() {
    auto made = std::make_shared<RunMap>();
    DebrisMap& map = made->map;
    map.time = 9.0;
    map.cell = 0.5;
    for (std::int32_t j = 0; j < 10; ++j) {
        for (std::int32_t i = 0; i < 20; ++i) {
            map.cells.push_back({j, i});
            const double height = std::max(0.0, 3.0 - 0.3 * std::hypot(i - 9.5, 2.0 * (j - 4.5)));
            map.layers[static_cast<std::size_t>(MapLayer::Height)].push_back(height);
            map.layers[static_cast<std::size_t>(MapLayer::Mass)].push_back(2000.0 * height);
        }
    }
    map.ledger.fragments = 1204;
    map.ledger.mass = 3.4e5;
    return made;
}

RunMapPanel::Content content() {
    RunMapPanel::Content content;
    content.map = heap();
    content.place.outlines = {{figures::MapOutline::Of::Structure, {{{2, 1}, {8, 1}, {8, 4}, {2, 4}}}},
                              {figures::MapOutline::Of::Evidence, {{{1, 1}, {9, 1}, {9, 4.5}, {1, 4.5}}}}};
    return content;
}

QImage drawn(RunMapPanel& panel) {
    return panel.findChild<MapView*>()->grab().toImage();
}

class RunMapPanelTest : public testing::Test {
protected:
    void SetUp() override {
        applyTheme(render::Theme::Light);
        panel.resize(520, 560);
        panel.setContent(content());
        panel.show();
        QObject::connect(&panel, &RunMapPanel::mapRequested, [this] { ++asked; });
        QObject::connect(&panel, &RunMapPanel::drawnChanged, [this] { ++changed; });
    }
    template <class Child>
    Child* child(const char* name) {
        return panel.findChild<Child*>(QLatin1String(name));
    }
    void click(const char* name) {
        auto* box = child<QCheckBox>(name);
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    }

    RunMapPanel panel;
    int asked = 0;
    int changed = 0;
};

TEST_F(RunMapPanelTest, WhatIsDrawnOverTheMapChangesAtOnce) {
    const QImage all = drawn(panel);
    click("mapStructure");
    const QImage without = drawn(panel);
    EXPECT_NE(all, without);
    EXPECT_EQ(panel.style().outlines.size(), 1U);
    click("mapEvidence");
    EXPECT_TRUE(panel.style().outlines.empty());
    EXPECT_NE(without, drawn(panel));
    EXPECT_EQ(asked, 0) << "no other map is needed";
    EXPECT_EQ(changed, 2);
}

TEST_F(RunMapPanelTest, ContoursAreChosenWithTheKeys) {
    const QImage none = drawn(panel);
    auto* contours = child<QComboBox>("mapContours");
    contours->setFocus();
    QTest::keyClick(contours, Qt::Key_Down);
    QTest::keyClick(contours, Qt::Key_Down);
    QTest::keyClick(contours, Qt::Key_Down);
    EXPECT_DOUBLE_EQ(panel.style().contours, 0.5);
    EXPECT_NE(drawn(panel), none);
}

TEST_F(RunMapPanelTest, NamesOfLayersAreReadWholeInANarrowPanel) {
    auto* layer = child<QComboBox>("mapLayer");
    int longest = 0;
    for (int i = 0; i < layer->count(); ++i) {
        longest = std::max(longest, layer->fontMetrics().horizontalAdvance(layer->itemText(i)));
    }
    panel.resize(panel.minimumSizeHint().width(), 700);
    QCoreApplication::processEvents();
    EXPECT_GT(layer->width(), longest);
    EXPECT_LE(panel.minimumSizeHint().width(), 400) << "it fits beside the views of a small window";
}

TEST_F(RunMapPanelTest, OtherCellsOrAnotherInstantAskForAnotherMap) {
    auto* cell = child<QLineEdit>("mapCell");
    cell->setFocus();
    cell->selectAll();
    QTest::keyClicks(cell, QStringLiteral("1.5"));
    QTest::keyClick(cell, Qt::Key_Return);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(panel.choice().cell, 1.5);
    auto* when = child<QComboBox>("mapWhen");
    when->setFocus();
    QTest::keyClick(when, Qt::Key_Down);
    EXPECT_EQ(asked, 2);
    EXPECT_FALSE(panel.choice().atEnd);
    click("mapLive");
    EXPECT_EQ(asked, 3);
    EXPECT_FALSE(panel.choice().live);
}

TEST_F(RunMapPanelTest, CellsThatNobodyChoseAreShownWithTheirSizeAndComeBack) {
    RunMapPanel::Content sized = content();
    auto made = std::make_shared<RunMap>(*sized.map);
    made->map.cell = 0.025;
    made->cellFrom = 0.03;
    sized.map = made;
    panel.setContent(sized);
    auto* cell = child<QLineEdit>("mapCell");
    EXPECT_TRUE(cell->text().isEmpty());
    EXPECT_EQ(cell->placeholderText(), QStringLiteral("auto: 0.025"));
    bool told = false;
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        told = told || label->text().contains(QStringLiteral("cells of 0.025\u00A0m by a typical fragment of 0.030\u00A0m"));
    }
    EXPECT_TRUE(told);
    cell->setFocus();
    QTest::keyClicks(cell, QStringLiteral("0.002"));
    QTest::keyClick(cell, Qt::Key_Return);
    EXPECT_EQ(panel.choice().cell, 0.002) << "small models have small cells";
    cell->selectAll();
    QTest::keyClick(cell, Qt::Key_Backspace);
    QTest::keyClick(cell, Qt::Key_Return);
    EXPECT_EQ(panel.choice().cell, std::nullopt);
    EXPECT_EQ(asked, 2);
}

TEST_F(RunMapPanelTest, ALayerIsKeptWhereTheNextMapHasIt) {
    auto* layer = child<QComboBox>("mapLayer");
    ASSERT_EQ(layer->count(), 2);
    layer->setFocus();
    QTest::keyClick(layer, Qt::Key_Down);
    EXPECT_EQ(panel.choice().layer, MapLayer::Mass);
    panel.setContent(content());
    EXPECT_EQ(panel.choice().layer, MapLayer::Mass);
    EXPECT_EQ(layer->currentIndex(), 1);
}

TEST_F(RunMapPanelTest, CautionsStandOnAmberBelowTheMap) {
    const QImage without = drawn(panel);
    RunMapPanel::Content cautioned = content();
    cautioned.place.cautions = "12 of 40 bodies still move";
    panel.setContent(cautioned);
    EXPECT_NE(drawn(panel), without);
    EXPECT_TRUE(child<QFrame>("mapCautions")->isVisibleTo(&panel));
    const QImage amber = child<QFrame>("mapCautions")->grab().toImage();
    EXPECT_EQ(amber.pixelColor(amber.width() - 4, amber.height() / 2), figures::palette(render::Theme::Light).findingTint);
}

TEST_F(RunMapPanelTest, BesideThePointerStandThePlaceAndItsValue) {
    auto* map = panel.findChild<MapView*>();
    drawn(panel);
    figures::MapPlacing placing;
    figures::MapPictureStyle style = panel.style();
    style.cautions.clear();
    style.pixels = map->size();
    style.dpi = 96.0;
    style.theme = render::Theme::Light;
    style.shownUnits = true;
    figures::mapPicture(heap()->map, MapLayer::Height, style, &placing);
    EXPECT_LT((placing.at(placing.cells.bottomLeft()) - Eigen::Vector2d(0, 0)).norm(), 1.5) << "outlines may reach farther";
    const Eigen::Vector2d middle = placing.at(placing.cells.center());
    EXPECT_NEAR(middle.x(), 5.0, 1.0);
    QTest::mouseMove(map, placing.cells.center().toPoint());
    ASSERT_TRUE(QTest::qWaitFor([] { return QToolTip::isVisible(); }, 5000));
    EXPECT_TRUE(QToolTip::text().contains(QStringLiteral("Height: "))) << QToolTip::text().toStdString();
    const QString there = figures::placeWords(heap()->map, MapLayer::Mass, style, Eigen::Vector2d(4.8, 2.3));
    EXPECT_TRUE(there.startsWith(QStringLiteral("x 4.80, y 2.30 m"))) << there.toStdString();
    EXPECT_EQ(there.count(u'\n'), 2) << "mass and height: " << there.toStdString();
    EXPECT_TRUE(
        figures::placeWords(heap()->map, MapLayer::Mass, style, Eigen::Vector2d(40, 2)).contains(QStringLiteral("no debris")));
}

TEST_F(RunMapPanelTest, ContoursHaveNumbers) {
    EXPECT_EQ(figures::numberedEvery(0.25, 1.0), 1) << "few levels: each";
    EXPECT_EQ(figures::numberedEvery(0.25, 3.0), 4) << "whole metres";
    EXPECT_EQ(figures::numberedEvery(0.1, 3.0), 5);
    EXPECT_EQ(figures::numberedEvery(1.0, 12.0), 5);
    figures::MapPictureStyle style = content().place;
    const QImage plain = figures::mapPicture(heap()->map, MapLayer::Height, style);
    style.contours = 1.0;
    const QImage lines = figures::mapPicture(heap()->map, MapLayer::Height, style);
    // White behind numbers is nowhere else within the map.
    figures::MapPlacing placing;
    figures::mapPicture(heap()->map, MapLayer::Height, style, &placing);
    int white = 0;
    const QRect inside = placing.cells.toRect().adjusted(20, 20, -20, -20);
    for (int y = inside.top(); y < inside.bottom(); ++y) {
        for (int x = inside.left(); x < inside.right(); ++x) {
            white += qGray(lines.pixel(x, y)) > qGray(plain.pixel(x, y)) + 10 ? 1 : 0;
        }
    }
    EXPECT_GT(white, 100);
}

TEST_F(RunMapPanelTest, APictureCountsInMetresInAllOfItWhateverIsShown) {
    figures::MapPictureStyle style = content().place;
    style.subject = "bridge";
    const std::shared_ptr<const RunMap> made = heap();
    const QImage inSi = figures::mapPicture(made->map, MapLayer::Height, style);
    figures::chooseUnits(figures::UnitSet::UsCustomary);
    const QImage inFeet = figures::mapPicture(made->map, MapLayer::Height, style);
    // On screen all of it counts in feet: colours have round steps there.
    style.shownUnits = true;
    const QImage shown = figures::mapPicture(made->map, MapLayer::Height, style);
    const double foot = 1.0 / 0.3048;
    const figures::MapRange range = figures::rangeOf(made->map.layer(MapLayer::Height), MapLayer::Height);
    EXPECT_EQ(figures::unitText(MapLayer::Height), QStringLiteral("ft"));
    EXPECT_EQ(figures::unitText(MapLayer::Mass), QStringLiteral("lb/ft²"));
    EXPECT_NEAR(figures::shownScale(MapLayer::Volume), foot, 1e-12);
    EXPECT_NEAR(figures::shownScale(MapLayer::Mass), 0.3048 * 0.3048 / 0.45359237, 1e-12);
    EXPECT_EQ(figures::coordinateUnit(style).name, QStringLiteral("ft"));
    style.system = "EPSG:25832";
    style.place.shift << 5e5, 5.7e6;
    EXPECT_EQ(figures::coordinateUnit(style).name, QStringLiteral("m")) << "coordinates of a system are what they are";
    figures::chooseUnits(figures::UnitSet::Si);
    EXPECT_EQ(inSi, inFeet) << "axes in metres beside cells in feet are two maps";
    EXPECT_NE(inSi, shown);
    const double step = foot * range.step;
    const double digits = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    EXPECT_TRUE(std::ranges::any_of(std::array{1.0, 2.0, 2.5, 5.0}, [&](double round) { return std::abs(digits - round) < 1e-6; }))
        << step << " ft";
}

TEST_F(RunMapPanelTest, LinesOfARunAndOfAnAreaAreToldFromWhatWasFound) {
    const auto made = heap();
    figures::MapPictureStyle style = content().place;
    const QImage found = figures::mapPicture(made->map, MapLayer::Height, style);
    style.outlines[1].of = figures::MapOutline::Of::Simulated;
    const QImage simulated = figures::mapPicture(made->map, MapLayer::Height, style);
    EXPECT_NE(found, simulated);
    style.outlines[1].of = figures::MapOutline::Of::Area;
    EXPECT_NE(simulated, figures::mapPicture(made->map, MapLayer::Height, style));
    EXPECT_NE(figures::outlineWords(figures::MapOutline::Of::Simulated), figures::outlineWords(figures::MapOutline::Of::Evidence));
    // Fallen live structure is debris too to whoever stands before it.
    DebrisMap map = made->map;
    EXPECT_FALSE(figures::debrisSums(map).contains(QStringLiteral("fallen live structure")));
    map.ledger.liveMass = 1.547e6;
    map.ledger.liveFootprintArea = 120.0;
    EXPECT_TRUE(figures::debrisSums(map).contains(QStringLiteral("fallen live structure beside them, moved farther than")));
}

TEST_F(RunMapPanelTest, WithoutAMapItSaysWhyAndOffersNothing) {
    RunMapPanel::Content none;
    none.why = QStringLiteral("Simulate first.");
    panel.setContent(none);
    EXPECT_FALSE(child<QPushButton>("saveMap")->isEnabled());
    EXPECT_FALSE(child<QToolButton>("mapOnGround")->isEnabled());
    EXPECT_FALSE(panel.findChild<MapView*>()->isVisible());
    QTest::qWait(50);  // until the rows lie where they belong
    EXPECT_LT(child<QCheckBox>("mapLive")->mapTo(&panel, QPoint()).y(), 140) << "the rows stay together";
    bool said = false;
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        said = said || (label->isVisible() && label->text().contains(QStringLiteral("Simulate first.")));
    }
    EXPECT_TRUE(said);
}

}  // namespace

}  // namespace rubble::widgets
