#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSpinBox>
#include <QTest>
#include <set>

#include "app/gui/evidence/evidence_display.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/report_panel.h"
#include "widgets/run/health_list.h"
#include "widgets/run/run_panel.h"
#include "widgets/views/status_line.h"

namespace rubble {

namespace {

/// What somebody meets who uses the window for the first time.
class FirstHour : public FreshWorkbench {
protected:
    widgets::StatusLine& status() { return *window->findChild<widgets::StatusLine*>(); }
    PanelDeck& deck() { return *window->rooms().deck; }
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    void startLongRun() {
        session->document().setParameter(QStringLiteral("settle_time"), 20.0);
        window->rooms().runs->simulate(false);
        ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().simulating(); }, patience));
    }
    void clickFigure(const QString& name) {
        for (auto* label : status().findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(name)) {
                QTest::mouseClick(label, Qt::LeftButton);
                return;
            }
        }
        FAIL() << "no figure " << name.toStdString();
    }
    /// Some of it can be seen, not only scrolled to.
    static bool inSight(const QWidget& widget) { return widget.isVisible() && !widget.visibleRegion().isEmpty(); }

    QTemporaryDir folder;
};

TEST_F(FirstHour, AButtonThatVanishesGivesTheKeysToTheWindow) {
    openArch();
    for (const bool inPanel : {false, true}) {
        startLongRun();
        QPushButton* cancel = nullptr;
        const QWidget& where = inPanel ? static_cast<QWidget&>(deck().run()) : status();
        for (auto* button : where.findChildren<QPushButton*>()) {
            cancel = button->text() == QLatin1String("Cancel") ? button : cancel;
        }
        ASSERT_NE(cancel, nullptr);
        ASSERT_TRUE(QTest::qWaitFor([&] { return cancel->isVisible() && cancel->isEnabled(); }, patience));
        window->rooms().playback->clock().pause();
        QTest::mouseClick(cancel, Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
        QCoreApplication::processEvents();
        ASSERT_EQ(QApplication::focusWidget(), window) << "and no button, which Space would push";
        press(Qt::Key_Space);
        EXPECT_TRUE(window->rooms().playback->clock().playing());
    }
}

TEST_F(FirstHour, MaterialsAreSeenFirst) {
    openArch();
    const auto style = [&] { return window->area().views().view().style; };
    EXPECT_EQ(style(), render::Style::Presentation);
    EXPECT_TRUE(window->actions()[ActionId::Presentation].isChecked());
    press(Qt::Key_P, Qt::ShiftModifier);
    EXPECT_EQ(style(), render::Style::Analysis);
    const QString other = folder.filePath(QStringLiteral("other.exo"));
    ASSERT_TRUE(QFile::copy(arch(), other));
    window->open(other);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().openPath() == other && prepared(); }, patience));
    EXPECT_EQ(style(), render::Style::Analysis) << "what was chosen stays";
}

TEST_F(FirstHour, FindingsAreOneClickAway) {
    openArch();
    deck().choose(PanelDeck::Report);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !status().figureText(widgets::StatusLine::Figure::Findings).isEmpty(); }, patience));
    clickFigure(QStringLiteral("Findings"));
    ASSERT_NE(deck().rail().current(), PanelDeck::Report);
    auto* list = deck().stack().currentWidget()->findChild<widgets::FindingList*>();
    ASSERT_NE(list, nullptr);
    EXPECT_TRUE(QTest::qWaitFor([&] { return inSight(*list); }, patience));
}

TEST_F(FirstHour, TheStatusLineCountsTheBoxesThatThePanelsHave) {
    openArch();
    const auto boxes = [&] {
        std::int64_t found = 0;
        for (widgets::Panel* panel : deck().panels()) {
            deck().choosePanel(*panel);
            QCoreApplication::processEvents();
            for (const widgets::FindingList* list : panel->findChildren<widgets::FindingList*>()) {
                for (const widgets::Notice* box : list->findChildren<widgets::Notice*>()) {
                    found += box->isVisible() ? 1 : 0;
                }
            }
        }
        return found;
    };
    makeCheap();
    simulateToEnd();
    const std::int64_t shown = boxes();
    ASSERT_GT(shown, 0);
    window->rooms().feed->refresh();
    const QString text = status().figureText(widgets::StatusLine::Figure::Findings);
    EXPECT_TRUE(text.contains(QStringLiteral("<b>%1</b>").arg(shown))) << qPrintable(text) << " for " << shown;
    // Each click leads to the next panel that has some, and none is left out.
    std::set<const QWidget*> reached;
    std::set<const QWidget*> having;
    for (widgets::Panel* panel : deck().panels()) {
        if (PanelDeck::findingsIn(*panel) > 0) {
            having.insert(panel);
        }
    }
    for (std::size_t click = 0; click < having.size(); ++click) {
        clickFigure(QStringLiteral("Findings"));
        reached.insert(deck().shownPanel());
    }
    EXPECT_EQ(reached, having);
}

// An hour of free fall without a ground, stopped as soon as a limit is passed.
TEST_F(FirstHour, TheHealthOfAStoppedRunLeadsToWhenItWasLost) {
    openArch();
    ASSERT_NO_FATAL_FAILURE(fallUntilABreach());
    Computation& computation = session->computation();
    computation.cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !computation.busy(); }, patience));
    deck().choose(PanelDeck::Case);
    window->rooms().playback->scrub(0.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !status().figureText(widgets::StatusLine::Figure::Health).isEmpty(); }, patience));
    clickFigure(QStringLiteral("Health"));
    EXPECT_EQ(deck().rail().current(), PanelDeck::Run);
    // The list says how far the run was looked at, and its entry leads there.
    widgets::HealthList& list = deck().run().health();
    EXPECT_TRUE(list.isVisibleTo(&deck().run()));
    for (auto* button : list.findChildren<QPushButton*>()) {
        if (button->text().startsWith(QStringLiteral("Show "))) {
            button->click();
            break;
        }
    }
    EXPECT_GT(window->rooms().playback->clock().time(), 0.0);
    EXPECT_NEAR(window->rooms().playback->clock().time(), computation.currentRun()->health().breaches.front().from, 0.1);
}

TEST_F(FirstHour, WhatNeedsAPhotographWaitsForOne) {
    openArch();
    Actions& actions = window->actions();
    EXPECT_FALSE(actions[ActionId::AddPoint].isEnabled());
    EXPECT_FALSE(actions[ActionId::LookThrough].isEnabled());
    const QString photo = folder.filePath(QStringLiteral("site.png"));
    QImage picture(64, 48, QImage::Format_RGB32);
    picture.fill(Qt::gray);
    ASSERT_TRUE(picture.save(photo));
    window->rooms().evidence->add({photo});
    ASSERT_TRUE(QTest::qWaitFor([&] { return actions[ActionId::AddPoint].isEnabled(); }, patience));
    EXPECT_FALSE(actions[ActionId::LookThrough].isEnabled()) << "no camera is found yet";
    session->document().undoStack().undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !actions[ActionId::AddPoint].isEnabled(); }, patience));
}

TEST_F(FirstHour, AnotherCaseTakesTheWordsOfTheOneBeforeAway) {
    const QString bad = folder.filePath(QStringLiteral("bad.rubble"));
    QFile file(bad);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"a\":");
    file.close();
    window->open(bad);
    ASSERT_TRUE(QTest::qWaitFor([&] { return status().activityText().contains(QStringLiteral("bad.rubble")); }, patience));
    openArch();
    EXPECT_FALSE(status().activityText().contains(QStringLiteral("bad.rubble"))) << status().activityText().toStdString();
}

TEST_F(FirstHour, TheReportTellsWhatItsRepeatsCost) {
    openArch();
    makeCheap();
    simulateToEnd();
    deck().choose(PanelDeck::Report);
    const auto* cost = deck().report().findChild<QLabel*>(QStringLiteral("reportCost"));
    auto* repeats = deck().report().findChild<QSpinBox*>(QStringLiteral("reportRepeats"));
    ASSERT_TRUE(cost != nullptr && repeats != nullptr);
    const double run = session->computation().currentRun()->wallSeconds;
    EXPECT_TRUE(cost->text().contains(widgets::shownDuration(3.0 * run))) << cost->text().toStdString();
    repeats->setFocus();
    QTest::keyClick(repeats, Qt::Key_Up);
    EXPECT_TRUE(cost->text().contains(widgets::shownDuration(4.0 * run))) << cost->text().toStdString();
}

TEST_F(FirstHour, TheWindowIsNoLargerThanTheScreen) {
    window->resize(5000, 4000);
    window->restoreLayout();
    const QSize room = window->screen()->availableSize();
    EXPECT_LT(window->width(), room.width());
    EXPECT_LT(window->height(), room.height()) << "the frame has room too";
}

}  // namespace

}  // namespace rubble
