#include <QImage>
#include <QMouseEvent>
#include <QTemporaryDir>

#include "app/gui/evidence/evidence_display.h"
#include "tests/app/gui/workbench.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/point_marks.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

class PointMarksTest : public FreshWorkbench {
protected:
    void SetUp() override {
        FreshWorkbench::SetUp();
        if (HasFatalFailure()) {
            return;
        }
        openArch();
        const QString path = m_folder.filePath(QStringLiteral("site.png"));
        QImage picture(800, 600, QImage::Format_RGB32);
        picture.fill(Qt::lightGray);
        ASSERT_TRUE(picture.save(path));
        window->rooms().evidence->add({path});
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return !session->document().theCase().photographs.empty() && window->rooms().evidence->settled(); }, patience));
        QTest::keyClick(window, Qt::Key_A, Qt::ShiftModifier);
        ASSERT_TRUE(QTest::qWaitFor([&] { return page().model().isVisible() && page().model().width() > 100; }, patience));
    }
    widgets::EvidencePage& page() { return *window->findChild<widgets::EvidencePage*>(); }
    void hover(QWidget& over, const QPointF& at) {
        QMouseEvent move(QEvent::MouseMove, at, over.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(&over, &move);
    }
    /// A place of the model's widget where there is some of the model.
    QPoint onTheModel() {
        page().model().picture();
        for (int y = 20; y < page().model().height() - 20; y += 3) {
            for (int x = 20; x < page().model().width() - 20; x += 3) {
                const auto hit = page().model().hitAt(QPointF(x, y));
                if (hit && hit->pick && hit->node) {
                    return {x, y};
                }
            }
        }
        ADD_FAILURE() << "the model is not in its view";
        return {};
    }
    QTemporaryDir m_folder;
};

TEST_F(PointMarksTest, APairIsMarkedInPhotographAndModelAlike) {
    EXPECT_TRUE(page().modelMarks().content().marks.empty());
    QTest::mouseClick(&page().photo(), Qt::LeftButton, {}, page().photo().toWidget({300, 200}).toPoint());
    EXPECT_TRUE(page().photo().content().pending);
    const QPoint there = onTheModel();
    QTest::mouseClick(&page().model(), Qt::LeftButton, {}, there);
    ASSERT_EQ(page().photo().content().marks.size(), 1U);
    ASSERT_EQ(page().modelMarks().content().marks.size(), 1U);
    EXPECT_FALSE(page().photo().content().pending);
    const auto seen = page().modelMarks().placeOf(page().modelMarks().content().marks.front().place);
    ASSERT_TRUE(seen);
    // A node near the click was caught.
    EXPECT_LT((*seen - QPointF(there)).manhattanLength(), 24.0);
    session->document().undoStack().undo();
    EXPECT_TRUE(page().modelMarks().content().marks.empty()) << "the mark goes with its pair";
}

TEST_F(PointMarksTest, TheFirstClickMayBeInTheModelAndIsMarkedThere) {
    QTest::mouseClick(&page().model(), Qt::LeftButton, {}, onTheModel());
    EXPECT_TRUE(page().modelMarks().content().pending);
    EXPECT_FALSE(page().photo().content().pending);
}

TEST_F(PointMarksTest, BothPanesHaveALoupeWhilePointsArePicked) {
    const QPoint there = onTheModel();
    hover(page().model(), QPointF(there));
    ASSERT_TRUE(QTest::qWaitFor([&] { return page().modelMarks().loupe().has_value(); }, patience));
    EXPECT_EQ(*page().modelMarks().loupe(), widgets::loupeMiddle(QRectF(page().modelMarks().rect()), QPointF(there)));
    hover(page().photo(), QPointF(50, 60));
    EXPECT_TRUE(page().photo().loupe());
    QTest::keyClick(&page().photo(), Qt::Key_Escape);
    EXPECT_FALSE(page().photo().loupe());
    hover(page().model(), QPointF(there));
    EXPECT_FALSE(page().modelMarks().loupe()) << "nothing is picked any more";
}

}  // namespace

}  // namespace rubble
