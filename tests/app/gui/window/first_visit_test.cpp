#include "app/gui/window/first_visit.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSettings>
#include <QTest>

#include "app/gui/case/project_display.h"
#include "app/gui/case/start_display.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/window/options.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/case/start_page.h"
#include "widgets/views/tour.h"

namespace rubble {

namespace {

/// A program that nobody has used before.
class FirstVisitOf : public FreshWorkbench {
protected:
    void SetUp() override {
        FreshWorkbench::SetUp();
        // The sample lies among the sources.
        widgets::Preferences preferences = session->preferences();
        preferences.keepRunsGib = 0;
        session->setPreferences(preferences);
    }
    widgets::Tour& tour() { return *window->findChild<widgets::Tour*>(); }
    static QWidget* focus() { return QApplication::focusWidget(); }
    /// To whatever has the keyboard, as a user types.
    static void type(Qt::Key key) { QTest::keyClick(focus(), key); }
    bool due(const QStringList& words = {}) { return FirstVisit::isDue(*session, parseOptions(QStringList("rubble") + words)); }
    void openSmall() {
        const QString fe = QString::fromStdString(cli::writeSmallCollapse(folder.filePath("small.exo").toStdString()));
        window->open(fe);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && !session->document().empty(); }, patience));
    }

    QTemporaryDir folder;
};

TEST_F(FirstVisitOf, PlaysTheSampleAndIsNeverMadeAgain) {
    ASSERT_TRUE(due());
    window->rooms().project->begin();
    window->firstVisit().begin();
    ASSERT_TRUE(QTest::qWaitFor([&] { return tour().isVisible(); }, patience));
    EXPECT_TRUE(session->document().path().endsWith(QLatin1String("stone-arch.rubble")));
    EXPECT_FALSE(session->document().modified());
    const double began = window->rooms().playback->clock().time();
    EXPECT_TRUE(QTest::qWaitFor([&] { return window->rooms().playback->clock().time() > began; }, patience)) << "it plays";
    EXPECT_TRUE(due()) << "whoever was cut off sees it once more";
    // A run that has begun has chosen its panel: the keys are the tour's all the same.
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().simulating(); }, patience));
    window->rooms().deck->choose(PanelDeck::Case);
    window->setFocus();
    EXPECT_TRUE(QTest::qWaitFor([&] { return tour().isAncestorOf(focus()); }, 10'000));
    type(Qt::Key_Escape);
    EXPECT_FALSE(tour().isVisible());
    EXPECT_FALSE(due());
    EXPECT_TRUE(window->rooms().project->start().recent().list().empty()) << "nobody has chosen the sample";
    session->computation().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
}

TEST_F(FirstVisitOf, IsMadeOnlyWhereNothingIsAskedFor) {
    const QStringList nothing[] = {{}, {"--theme", "dark"}, {"--size", "1280x800"}, {"--language", "zh_CN"}};
    for (const QStringList& words : nothing) {
        EXPECT_TRUE(due(words)) << words.join(u' ').toStdString();
    }
    const QStringList something[] = {{"a.rubble"},           {"--sample"},        {"--screenshot", "a.png", "a.exo"},
                                     {"--measure", "a.exo"}, {"--panel", "run"},  {"--time", "1", "a.exo"},
                                     {"--chart", "a.svg"},   {"--action", "four"}};
    for (const QStringList& words : something) {
        EXPECT_FALSE(due(words)) << words.join(u' ').toStdString();
    }
    window->rooms().project->begin();
    openSmall();
    EXPECT_FALSE(due()) << "something was opened here before";
}

TEST_F(FirstVisitOf, LeavesAnOpenCaseAsItIs) {
    openSmall();
    const QString base = session->document().base();
    const int edits = session->document().undoStack().count();
    window->actions()[ActionId::Tour].trigger();
    ASSERT_TRUE(tour().isVisible());
    while (tour().isVisible()) {
        type(Qt::Key_Return);
    }
    EXPECT_EQ(session->document().base(), base);
    EXPECT_EQ(session->document().undoStack().count(), edits);
    EXPECT_EQ(session->computation().currentRun(), nullptr);
    EXPECT_FALSE(session->computation().busy());
    EXPECT_EQ(focus(), window) << "no field has the keyboard now";
}

TEST_F(FirstVisitOf, GoesOnAndBackByKeysAndButtons) {
    openSmall();
    window->actions()[ActionId::Tour].trigger();
    auto* skip = tour().findChild<QPushButton*>(QStringLiteral("tourSkip"));
    auto* back = tour().findChild<QPushButton*>(QStringLiteral("tourBack"));
    auto* next = tour().findChild<QPushButton*>(QStringLiteral("primary"));
    int stop = 0;
    for (const auto& [key, step] : {std::pair(Qt::Key_Right, 1), std::pair(Qt::Key_Enter, 1), std::pair(Qt::Key_Left, -1),
                                    std::pair(Qt::Key_Return, 1), std::pair(Qt::Key_Space, 1)}) {
        type(key);
        EXPECT_EQ(tour().current(), stop += step) << key;
        // A screen reader speaks it with the button that has the focus.
        EXPECT_TRUE(next->accessibleDescription().contains(QString::number(stop + 1)));
        EXPECT_EQ(next->accessibleDescription(), tour().accessibleDescription());
    }
    QTest::mouseClick(back, Qt::LeftButton);
    EXPECT_EQ(tour().current(), stop -= 1);
    QTest::mouseClick(next, Qt::LeftButton);
    EXPECT_EQ(tour().current(), stop += 1);
    EXPECT_FALSE(window->rooms().playback->clock().playing()) << "Space is the tour's";
    // Tab stays among its buttons.
    for (const QPushButton* button : {skip, back, next}) {
        type(Qt::Key_Tab);
        EXPECT_EQ(focus(), button);
    }
    type(Qt::Key_Tab);
    type(Qt::Key_Return);
    EXPECT_FALSE(tour().isVisible()) << "Enter pushes what has the focus: Skip";
    EXPECT_TRUE(QSettings().value(QStringLiteral("tour_seen")).toBool());
}

TEST_F(FirstVisitOf, IsReachedFromTheStartPage) {
    auto* button = window->area().startPage().findChild<QPushButton*>(QStringLiteral("tour"));
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return tour().isVisible(); }, patience));
    EXPECT_FALSE(session->document().empty()) << "the sample is there to look at";
    QTest::mouseClick(tour().findChild<QPushButton*>(QStringLiteral("tourSkip")), Qt::LeftButton);
    EXPECT_FALSE(tour().isVisible());
    session->computation().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
}

}  // namespace

}  // namespace rubble
