#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/history_display.h"
#include "app/gui/views/inspection.h"
#include "app/gui/views/selection_display.h"
#include "tests/app/gui/workbench.h"
#include "widgets/views/history_panel.h"

namespace rubble {

namespace {

class HistoryTest : public FreshWorkbench {
protected:
    HistoryDisplay& history() { return window->rooms().inspection->history(); }
    widgets::HistoryChart& chart() { return history().panel().chart(); }
    const std::vector<HistoryPoint>& points() { return chart().content().points; }
    SelectionDisplay& selection() { return window->rooms().inspection->selection(); }
    const FragmentSet& fragments() { return *window->area().views().data().fragments; }
    void read() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !history().reading() && !points().empty(); }, patience));
    }
    void simulated() {
        openArch();
        makeCheap();
        simulateToEnd();
        QTest::keyClick(window, Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
        ASSERT_TRUE(window->rooms().inspection->dock("curvesDock").isVisible());
        read();
    }
};

TEST_F(HistoryTest, WithoutARunItSaysWhatToDo) {
    openArch();
    QTest::keyClick(window, Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(window->rooms().inspection->dock("curvesDock").isVisible());
    EXPECT_FALSE(chart().isVisible());
    makeCheap();
    simulateToEnd();
    read();
    EXPECT_TRUE(chart().isVisible());
}

TEST_F(HistoryTest, TheCurvesAreThoseOfWhatIsSelectedElseOfAll) {
    simulated();
    double mass = 0.0;
    for (const Fragment& fragment : fragments().list) {
        mass += fragment.mass;
    }
    EXPECT_NEAR(points().back().mass, mass, 1e-6 * mass) << "nothing leaves the arch";
    EXPECT_TRUE(chart().content().subject.startsWith(QStringLiteral("All ")));
    selection().select({fragments().list[7].element});
    ASSERT_TRUE(QTest::qWaitFor([&] { return chart().content().subject == QStringLiteral("Fragment 7"); }, patience));
    read();
    EXPECT_DOUBLE_EQ(points().back().mass, fragments().list[7].mass);
    EXPECT_GE(points().front().time, fragments().list[7].handOverTime - 1e-9);
    selection().growToClusters();
    ASSERT_TRUE(QTest::qWaitFor([&] { return chart().content().subject.startsWith(QStringLiteral("Cluster ")); }, patience));
    read();
    EXPECT_GT(points().back().mass, fragments().list[7].mass);
    selection().clear();
    ASSERT_TRUE(QTest::qWaitFor([&] { return chart().content().subject.startsWith(QStringLiteral("All ")); }, patience));
}

TEST_F(HistoryTest, ItGoesWithTheTimelineBothWays) {
    simulated();
    const double end = session->computation().currentRun()->outcome->endTime;
    const QPoint middle(static_cast<int>(chart().placeOf(0.5 * end)), chart().height() / 2);
    QTest::mouseClick(&chart(), Qt::LeftButton, {}, middle);
    EXPECT_NEAR(window->rooms().playback->clock().time(), 0.5 * end, 0.02 * end);
    const QString before = history().panel().words();
    window->rooms().playback->showInstant(end);
    EXPECT_NE(history().panel().words(), before);
}

TEST_F(HistoryTest, TheTableIsSavedWithWhereItComesFrom) {
    simulated();
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("all.csv"));
    whenAsked([&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
        QMetaObject::invokeMethod(&dialog, "accept");
    });
    QTest::mouseClick(history().panel().findChild<QPushButton*>(QStringLiteral("saveHistoryTable")), Qt::LeftButton);
    const std::string text = textOf(path);
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), points().size() + 1);
    const nlohmann::json told = nlohmann::json::parse(textOf(path + QStringLiteral(".provenance.json")));
    EXPECT_NE(told.dump().find("History of All"), std::string::npos) << told.dump();
}

}  // namespace

}  // namespace rubble
