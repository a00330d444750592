#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <set>

#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/inspection.h"
#include "app/gui/views/selection_display.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/basics/number_field.h"
#include "widgets/views/fragment_table.h"
#include "widgets/views/inspector.h"

namespace rubble {

namespace {

class FragmentListTest : public FreshWorkbench {
protected:
    void SetUp() override {
        FreshWorkbench::SetUp();
        if (HasFatalFailure()) {
            return;
        }
        openArch();
        QTest::keyClick(window, Qt::Key_T, Qt::ControlModifier);
        ASSERT_TRUE(window->rooms().inspection->dock("tableDock").isVisible());
    }
    widgets::ViewWidget& views() { return window->area().views(); }
    SelectionDisplay& selection() { return window->rooms().inspection->selection(); }
    widgets::FragmentTable& table() { return window->rooms().inspection->table(); }
    int fragments() { return static_cast<int>(views().data().fragments->size()); }
    QString said() { return table().findChild<QLabel*>(QStringLiteral("fragmentsShown"))->text(); }
    void type(const char* field, const QString& text) {
        auto* bound = table().findChild<widgets::NumberField*>(QLatin1String(field));
        bound->setFocus();
        bound->selectAll();
        QTest::keyClicks(bound, text);
        QTest::keyClick(bound, Qt::Key_Return);
    }
    /// What is asked of the views is in the picture.
    const render::PaneStatus& drawn() {
        views().grabFramebuffer();
        return views().status(render::PaneContent::Fragments);
    }
};

TEST_F(FragmentListTest, ARowIsSelectedInViewsAndInspector) {
    EXPECT_EQ(table().model().rowCount(), fragments());
    table().rows().scrollToTop();
    const QRect third = table().rows().visualRect(table().model().index(3, 0));
    QTest::mouseClick(table().rows().viewport(), Qt::LeftButton, {}, third.center());
    ASSERT_EQ(selection().selection().size(), 1U);
    EXPECT_EQ(selection().selection().front(), table().model().elementAt(3));
    EXPECT_TRUE(window->rooms().inspection->dock("inspectorDock").isVisible());
    EXPECT_TRUE(window->rooms().inspection->inspector().title().contains(QStringLiteral("3")));
    QTest::keyClick(&table().rows(), Qt::Key_Down);
    EXPECT_EQ(selection().selection().front(), table().model().elementAt(4));
    QTest::keyClick(&table().rows(), Qt::Key_Return);
    EXPECT_NEAR(window->rooms().playback->clock().time(), views().data().fragments->list[4].handOverTime, 1e-9);
}

TEST_F(FragmentListTest, WhatIsSelectedInTheViewsIsChosenInTheTable) {
    const ElementIndex element = views().data().fragments->list[20].element;
    selection().select({element});
    const QModelIndexList chosen = table().rows().selectionModel()->selectedRows();
    ASSERT_EQ(chosen.size(), 1);
    EXPECT_EQ(table().model().elementAt(chosen.front().row()), element);
    selection().clear();
    EXPECT_TRUE(table().rows().selectionModel()->selectedRows().empty());
}

TEST_F(FragmentListTest, BoundsLeaveFragmentsOutOfTheViewsAndSayHowMany) {
    window->rooms().playback->showInstant(session->computation().inputs().fe->times().back());
    EXPECT_FALSE(drawn().meeting);
    const double middle = views().data().fragments->list[static_cast<std::size_t>(fragments() / 2)].birthTime;
    type("filterHigh3", QString::number(middle, 'g', 8));
    const int left = table().model().rowCount();
    EXPECT_GT(left, 0);
    EXPECT_LT(left, fragments());
    EXPECT_EQ(said(), QStringLiteral("%1 of %2 fragments shown").arg(QLocale().toString(left), QLocale().toString(fragments())));
    ASSERT_TRUE(drawn().meeting);
    EXPECT_EQ(*drawn().meeting, static_cast<std::size_t>(left));
    QTest::mouseClick(table().findChild<QPushButton*>(QStringLiteral("clearFilter")), Qt::LeftButton);
    EXPECT_FALSE(drawn().meeting);
    EXPECT_EQ(table().model().rowCount(), fragments());
}

TEST_F(FragmentListTest, FastOnesAreThoseOfTheInstantShown) {
    makeCheap();
    simulateToEnd();
    type("filterLow0", QStringLiteral("1"));
    const double end = session->computation().currentRun()->outcome->endTime;
    std::set<std::size_t> counts;
    for (const double share : {0.2, 0.5, 0.8}) {
        window->rooms().playback->showInstant(share * end);
        const auto same = [&] {
            const render::PaneStatus& status = drawn();
            return status.meeting && *status.meeting <= static_cast<std::size_t>(table().model().rowCount());
        };
        ASSERT_TRUE(QTest::qWaitFor(same, patience)) << share;
        counts.insert(*drawn().meeting);
    }
    EXPECT_GT(counts.size(), 1U) << "it changes as the collapse goes on";
}

TEST_F(FragmentListTest, BoundsOutliveTheWindowAndEndWithTheModel) {
    type("filterHigh1", QStringLiteral("500"));
    const render::FragmentFilter filter = views().view().filter;
    ASSERT_EQ(filter.mass.high, 500.0);
    renewed->speak(QStringLiteral("zh_CN"));
    EXPECT_TRUE(views().view().filter == filter);
    EXPECT_TRUE(table().filter() == filter);
    renewed->speak(QStringLiteral("en"));
    session->document().undoStack().setClean();
    QTemporaryDir folder;
    window->open(QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString())));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && views().view().filter.empty(); }, patience));
    EXPECT_TRUE(table().filter().empty());
}

TEST_F(FragmentListTest, TheKeyClosesItAgain) {
    QTest::keyClick(window, Qt::Key_T, Qt::ControlModifier);
    EXPECT_FALSE(window->rooms().inspection->dock("tableDock").isVisible());
    EXPECT_FALSE(window->actions()[ActionId::FragmentTable].isChecked());
}

}  // namespace

}  // namespace rubble
