#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include "core/base/error.h"
#include "widgets/basics/number_field.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/photo_pairs.h"
#include "widgets/evidence/photo_view.h"

namespace rubble::widgets {
namespace {

PhotoView::Content contentOf(QSize size) {
    PhotoView::Content content;
    content.size = size;
    content.picture = QImage(size / 4, QImage::Format_RGB32);
    content.picture.fill(Qt::gray);
    content.title = QStringLiteral("a.jpg");
    return content;
}

class Photo : public testing::Test {
protected:
    void SetUp() override {
        m_view.resize(800, 600);
        m_view.setContent(contentOf({4000, 3000}));
        m_view.show();
    }
    void click(const QPointF& pixel, Qt::MouseButton button = Qt::LeftButton) {
        QTest::mouseClick(&m_view, button, {}, m_view.toWidget(pixel).toPoint());
    }
    PhotoView m_view;
};

TEST_F(Photo, PixelsAndPlacesAreInverseAtEveryZoom) {
    m_view.lookAt({1000.0, 2500.0});
    for (const QPointF& pixel : {QPointF(0, 0), QPointF(4000, 3000), QPointF(1234.5, 987.6)}) {
        const QPointF back = m_view.toPhotograph(m_view.toWidget(pixel));
        EXPECT_NEAR(back.x(), pixel.x(), 1e-6);
        EXPECT_NEAR(back.y(), pixel.y(), 1e-6);
    }
    m_view.fit();
    EXPECT_EQ(m_view.toWidget({0.0, 0.0}), QPointF(0.0, 0.0));
    EXPECT_EQ(m_view.toWidget({4000.0, 3000.0}), QPointF(800.0, 600.0));
}

TEST_F(Photo, AClickPlacesAPointOnlyWithTheTool) {
    QSignalSpy placed(&m_view, &PhotoView::pointPlaced);
    click({2000.0, 1500.0});
    EXPECT_EQ(placed.count(), 0);
    m_view.setTool(PhotoView::Tool::Point);
    click({2000.0, 1500.0});
    ASSERT_EQ(placed.count(), 1);
    EXPECT_NEAR(placed[0][0].toPointF().x(), 2000.0, 5.0);
}

TEST_F(Photo, TheKeyboardPlacesPointsToo) {
    QSignalSpy placed(&m_view, &PhotoView::pointPlaced);
    QSignalSpy left(&m_view, &PhotoView::toolLeft);
    m_view.setTool(PhotoView::Tool::Point);
    QTest::keyClick(&m_view, Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyClick(&m_view, Qt::Key_Up);
    QTest::keyClick(&m_view, Qt::Key_Return);
    ASSERT_EQ(placed.count(), 1);
    // Ten and one pixels of the screen are 50 and 5 of the photograph, from its middle.
    EXPECT_EQ(placed[0][0].toPointF(), QPointF(2050.0, 1495.0));
    QTest::keyClick(&m_view, Qt::Key_Escape);
    EXPECT_EQ(left.count(), 1);
}

TEST_F(Photo, ALoupeStandsBesideTheMouseWhilePointsArePicked) {
    PhotoView::Content content = contentOf({800, 600});
    content.picture = QImage(800, 600, QImage::Format_RGB32);
    content.picture.fill(Qt::gray);
    // A red spot of four pixels is sixteen wide in the loupe.
    for (int x = 398; x < 402; ++x) {
        for (int y = 298; y < 302; ++y) {
            content.picture.setPixelColor(x, y, Qt::red);
        }
    }
    m_view.setContent(content);
    QTest::mouseMove(&m_view, QPoint(380, 300));
    EXPECT_FALSE(m_view.loupe()) << "nothing is picked";
    m_view.setTool(PhotoView::Tool::Point);
    EXPECT_FALSE(m_view.loupe());
    QMouseEvent move(QEvent::MouseMove, QPointF(400, 300), m_view.mapToGlobal(QPointF(400, 300)), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&m_view, &move);
    ASSERT_TRUE(m_view.loupe());
    const QImage seen = m_view.grab().toImage();
    const QPoint middle = m_view.loupe()->toPoint();
    EXPECT_EQ(seen.pixelColor(middle + QPoint(5, 5)), QColor(Qt::red));
    EXPECT_EQ(seen.pixelColor(middle + QPoint(-6, 5)), QColor(Qt::red));
    EXPECT_NE(seen.pixelColor(middle + QPoint(14, 14)), QColor(Qt::red));
    for (const QPointF& corner : {QPointF(2, 2), QPointF(798, 2), QPointF(2, 598), QPointF(798, 598)}) {
        QMouseEvent there(QEvent::MouseMove, corner, m_view.mapToGlobal(corner), Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(&m_view, &there);
        ASSERT_TRUE(m_view.loupe());
        EXPECT_TRUE(m_view.rect().contains(m_view.loupe()->toPoint())) << "it stays within the picture";
    }
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&m_view, &leave);
    EXPECT_FALSE(m_view.loupe());
}

TEST_F(Photo, MasksAreDrawnCornerByCornerAndClosed) {
    QSignalSpy drawn(&m_view, &PhotoView::maskDrawn);
    m_view.setTool(PhotoView::Tool::Mask, MaskClass::Hidden);
    click({1000.0, 1000.0});
    click({2000.0, 1000.0});
    QTest::keyClick(&m_view, Qt::Key_Return);
    EXPECT_EQ(drawn.count(), 0) << "two corners enclose nothing";
    QTest::keyClick(&m_view, Qt::Key_Backspace);
    click({2000.0, 2000.0});
    click({1000.0, 2000.0});
    QTest::keyClick(&m_view, Qt::Key_Return);
    ASSERT_EQ(drawn.count(), 1);
    const auto mask = drawn[0][0].value<PhotoMask>();
    EXPECT_EQ(mask.kind, MaskClass::Hidden);
    EXPECT_GE(mask.corners.size(), 3u);
}

TEST_F(Photo, APointIsMovedByDraggingItsCross) {
    PhotoView::Content content = contentOf({4000, 3000});
    content.marks = {{QStringLiteral("pier"), {1000.0, 1000.0}, {}, true}};
    m_view.setContent(content);
    QSignalSpy moved(&m_view, &PhotoView::markMoved);
    const QPoint from = m_view.toWidget({1000.0, 1000.0}).toPoint();
    QTest::mousePress(&m_view, Qt::LeftButton, {}, from);
    QTest::mouseMove(&m_view, from + QPoint(20, 10));
    QTest::mouseRelease(&m_view, Qt::LeftButton, {}, from + QPoint(20, 10));
    ASSERT_EQ(moved.count(), 1);
    EXPECT_EQ(moved[0][0].toInt(), 0);
    EXPECT_NEAR(moved[0][1].toPointF().x(), 1100.0, 5.0);
}

TEST_F(Photo, TheSwipeShowsTheSimulationRightOfItsLine) {
    QImage red(400, 300, QImage::Format_RGB32);
    red.fill(Qt::red);
    m_view.setOverlay(red, QStringLiteral("simulation"));
    m_view.setShow(PhotoView::Show::Swipe);
    m_view.setSwipe(0.25);
    const QImage shown = m_view.grab().toImage().scaled(800, 600);
    EXPECT_EQ(QColor(shown.pixel(100, 500)), QColor(Qt::gray));
    EXPECT_EQ(QColor(shown.pixel(400, 500)), QColor(Qt::red));
    m_view.setShow(PhotoView::Show::Photograph);
    EXPECT_EQ(QColor(m_view.grab().toImage().scaled(800, 600).pixel(400, 500)), QColor(Qt::gray));
}

TEST(NumberField, TellsNumbersInRangeOnly) {
    NumberField field(QStringLiteral("focal length"));
    field.setRange(1.0, 100.0);
    std::vector<std::optional<double>> told;
    QObject::connect(&field, &NumberField::edited, [&](std::optional<double> number) { told.push_back(number); });
    const auto type = [&](const char* text) {
        field.selectAll();
        QTest::keyClicks(&field, QString::fromLatin1(text));
        QTest::keyClick(&field, Qt::Key_Return);
    };
    type("12.5");
    type("1000");
    EXPECT_TRUE(field.property("wrong").toBool());
    type("x");
    type("");
    EXPECT_EQ(told, (std::vector<std::optional<double>>{12.5}));
    field.setEmptyMeans(QStringLiteral("found"));
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Delete);
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(told.back(), std::nullopt);
}

CameraMatch matchOf(std::size_t pairs, std::size_t wrong) {
    CameraMatch match;
    match.used.assign(pairs, true);
    match.used[wrong] = false;
    match.residuals.assign(pairs, {0.6, 0.8});
    match.residuals[wrong] = {30.0, 40.0};
    match.found = {0, 1, 2, 3, 4, 5};
    match.covariance = 0.01 * Eigen::MatrixXd::Identity(6, 6);
    match.rms = 1.0;
    match.sigma = 0.9;
    match.freedom = 6;
    match.distance = 80.0;
    match.placeRadius = 0.4;
    match.turnRadius = 0.003;
    match.verdict = MatchVerdict::Good;
    return match;
}

TEST(PhotoPairs, AWrongPairIsPointedOutInWordsAndPairsAreDeleted) {
    PhotoPairs pairs;
    std::vector<PointPair> list{
        {"pier 1", {1.0, 2.0}, Vec3(1, 2, 3)}, {"pier 2", {3.0, 4.0}, Vec3(4, 5, 6)}, {"deck", {5.0, 6.0}, Vec3(7, 8, 9)}};
    const CameraMatch match = matchOf(3, 1);
    pairs.setContent(list, &match, 1);
    const auto* table = pairs.findChild<QTableWidget*>();
    EXPECT_EQ(table->item(0, 2)->text(), QStringLiteral("1.0"));
    EXPECT_TRUE(table->item(1, 2)->text().contains(QStringLiteral("wrong")));
    const auto* notice = pairs.findChild<Notice*>();
    EXPECT_TRUE(notice->text().contains(QStringLiteral("Point 2 (50 px) disagrees with the other 2")));
    std::vector<PointPair> after;
    QObject::connect(&pairs, &PhotoPairs::pairsEdited,
                     [&](const std::vector<PointPair>& edited, const Wording&) { after = edited; });
    QTest::keyClick(pairs.findChild<QTableWidget*>(), Qt::Key_Delete);
    ASSERT_EQ(after.size(), 2u);
    EXPECT_EQ(after[1].name, "deck");
    pairs.setContent(list, nullptr, 0);
    EXPECT_TRUE(notice->text().isEmpty());
}

TEST(EvidencePanel, TheTimeIsOpenOnlyWhereItCanBeTyped) {
    EvidencePanel panel;
    panel.resize(336, 900);
    EvidencePanel::Content content;
    content.available = true;
    content.names = QStringList{QStringLiteral("a.jpg")};
    content.chosen = 0;
    panel.setContent(content);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    QObject::connect(&panel, &EvidencePanel::photographEdited, &panel, [&](const Photograph& after) {
        content.photograph = after;
        panel.setContent(content);
    });
    NumberField* time = nullptr;
    NumberField* spread = nullptr;
    for (auto* field : panel.findChildren<NumberField*>()) {
        time = field->accessibleName() == QStringLiteral("Time of the photograph") ? field : time;
        spread = field->accessibleName() == QStringLiteral("Uncertainty of the time") ? field : spread;
    }
    ASSERT_TRUE(time != nullptr && spread != nullptr);
    EXPECT_FALSE(time->isEnabled() || spread->isEnabled());
    EXPECT_EQ(time->placeholderText(), QStringLiteral("at rest")) << "what it stands for is said in it";
    QCheckBox* atRest = nullptr;
    for (auto* box : panel.findChildren<QCheckBox*>()) {
        atRest = box->text() == QStringLiteral("when all lay at rest") ? box : atRest;
    }
    ASSERT_NE(atRest, nullptr);
    QTest::mouseClick(atRest, Qt::LeftButton, {}, QPoint(8, atRest->height() / 2));
    ASSERT_TRUE(time->isEnabled() && spread->isEnabled());
    EXPECT_TRUE(time->placeholderText().isEmpty());
    time->setFocus();
    time->selectAll();
    QTest::keyClicks(time, QStringLiteral("3.5"));
    QTest::keyClick(time, Qt::Key_Return);
    EXPECT_EQ(content.photograph.time, 3.5);
}

TEST(EvidencePanel, SaysTheVerdictAndTheAgreementInWordsAndFigures) {
    EvidencePanel panel;
    panel.resize(336, 900);
    EvidencePanel::Content content;
    content.available = true;
    content.names = QStringList{QStringLiteral("a.jpg")};
    content.chosen = 0;
    content.photograph.facts.width = 4000;
    content.photograph.facts.height = 3000;
    content.photograph.facts.focalLength35 = 36.0;
    content.photograph.pairs.resize(8);
    content.photograph.masks = {{MaskClass::Debris, {{0, 0}, {1, 0}, {1, 1}}}};
    content.match = matchOf(8, 2);
    content.match->camera.focal = 4000.0;
    auto made = std::make_shared<PhotoComparison>();
    made->iou = {0.812, 0.79, 0.031};
    made->edgeMetres = {0.91, 0.95, 0.12};
    made->edgePixels = {40.0, 42.0, 5.0};
    content.comparison = made;
    panel.setContent(content);
    QString all;
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        all += label->text() + u'\n';
    }
    for (const char* words : {"Good match", "0.79", "0.031", "0.91", "Point 3 (50 px)"}) {
        EXPECT_TRUE(all.contains(QString::fromUtf8(words))) << words;
    }
    QSignalSpy edited(&panel, &EvidencePanel::photographEdited);
    auto* masks = panel.findChild<QListWidget*>();
    ASSERT_EQ(masks->count(), 1);
    content.chosenMask = 0;
    panel.setContent(content);
    for (QPushButton* button : panel.findChildren<QPushButton*>()) {
        if (button->toolTip().contains(QStringLiteral("outline or mask"))) {
            button->click();
        }
    }
    ASSERT_EQ(edited.count(), 1);
    EXPECT_TRUE(edited[0][0].value<Photograph>().masks.empty());
    content.match.reset();
    content.noMatch = QStringLiteral("3 pairs are too few");
    content.remedy = QStringLiteral("Add pairs");
    panel.setContent(content);
    all.clear();
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        all += label->text();
    }
    EXPECT_TRUE(all.contains(QStringLiteral("3 pairs are too few")));
}

}  // namespace
}  // namespace rubble::widgets
