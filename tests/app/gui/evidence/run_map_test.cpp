#include "tests/app/gui/workbench.h"

#include <QAction>
#include <QComboBox>
#include <QDateTime>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>
#include <nlohmann/json.hpp>

#include "app/gui/stage/view_area.h"
#include "widgets/basics/map_view.h"
#include "widgets/evidence/run_map_panel.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

class RunMapTest : public FreshWorkbench {
protected:
    MapDisplay& map() { return *window->rooms().map; }
    widgets::RunMapPanel& panel() { return map().panel(); }
    bool mapped() { return panel().content().map != nullptr && !panel().content().making; }
    void openMap() {
        QTest::keyClick(window, Qt::Key_M, Qt::ControlModifier);
        ASSERT_TRUE(QTest::qWaitFor([&] { return mapped(); }, patience));
    }
    void showsTheInstantOfTheViews();
    void liesOnTheGround();
    void isSavedInEachFormat();
    void asksForAFile();
    void staysWhereItIsDocked();
    void saysThatTheModelHasNoPlace();
    void leavesTheWindowAsWideAsItIs();
};

void RunMapTest::showsTheInstantOfTheViews() {
    const double end = panel().content().map->map.time;
    auto* when = panel().findChild<QComboBox*>(QStringLiteral("mapWhen"));
    when->setFocus();
    QTest::keyClick(when, Qt::Key_Down);
    window->rooms().playback->showInstant(0.75 * end);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return mapped() && std::abs(panel().content().map->map.time - 0.75 * end) < 1e-9; }, patience));
}

void RunMapTest::liesOnTheGround() {
    auto* button = panel().findChild<QToolButton*>(QStringLiteral("mapOnGround"));
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_NE(window->area().views().data().orthophoto, nullptr);
    EXPECT_GT(window->area().views().data().orthophoto->width, 0);
    // Without the panel no legend says what the colours mean.
    QTest::keyClick(window, Qt::Key_M, Qt::ControlModifier);
    ASSERT_FALSE(map().dock().isVisible());
    EXPECT_EQ(window->area().views().data().orthophoto, nullptr);
    QTest::keyClick(window, Qt::Key_M, Qt::ControlModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->area().views().data().orthophoto != nullptr; }, patience));
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(window->area().views().data().orthophoto, nullptr);
}

void RunMapTest::isSavedInEachFormat() {
    const QTemporaryDir folder;
    for (const char* name : {"m.tif", "m.gpkg", "m.csv", "m.png"}) {
        const QString path = folder.filePath(QLatin1String(name));
        map().saveTo(path);
        ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(path) && !session->computation().busy(); }, patience)) << name;
        ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(path + QStringLiteral(".provenance.json")); }, patience))
            << name;
        const nlohmann::json told = nlohmann::json::parse(textOf(path + QStringLiteral(".provenance.json")));
        bool moves = false;
        for (const nlohmann::json& caution : told["cautions"]) {
            moves = moves || caution["key"] == "still_moving";
        }
        EXPECT_TRUE(moves) << name << told["cautions"].dump();
    }
    EXPECT_GT(QImage(folder.filePath(QStringLiteral("m.png"))).width(), 500);
}

void RunMapTest::staysWhereItIsDocked() {
    ASSERT_FALSE(map().dock().isFloating());
    auto* layer = panel().findChild<QComboBox*>(QStringLiteral("mapLayer"));
    layer->setFocus();
    QTest::keyClick(layer, Qt::Key_Escape);
    EXPECT_TRUE(map().dock().isVisible()) << "a panel that is docked stays";
    map().dock().setFloating(true);
    QTest::keyClick(window, Qt::Key_Escape);
    EXPECT_FALSE(map().dock().isVisible()) << "one that floats is closed";
    QTest::keyClick(window, Qt::Key_M, Qt::ControlModifier);
    map().dock().setFloating(false);
    ASSERT_TRUE(map().dock().isVisible());
}

void RunMapTest::saysThatTheModelHasNoPlace() {
    const std::string before = panel().style().cautions;
    EXPECT_EQ(before.find("no place"), std::string::npos) << before;
    session->document().setSite({}, "EPSG:25832", {}, [] { return QStringLiteral("site"); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    makeCheap();
    simulateToEnd();
    ASSERT_TRUE(QTest::qWaitFor([&] { return mapped() && panel().style().cautions != before; }, patience));
    EXPECT_NE(panel().style().cautions.find("the model has no place in it"), std::string::npos) << panel().style().cautions;
}

void RunMapTest::asksForAFile() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("chosen.gpkg"));
    whenAsked([&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
        QMetaObject::invokeMethod(&dialog, "accept");
    });
    QTest::mouseClick(panel().findChild<QPushButton*>(QStringLiteral("saveMap")), Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(path); }, patience));
    // No file says that it is what it is not, and none is replaced without a word.
    const QString other = folder.filePath(QStringLiteral("chosen.svg"));
    const auto save = [&](const QString& name) {
        whenAsked([name](QDialog& dialog) {
            dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(name);
            QMetaObject::invokeMethod(&dialog, "accept");
        });
        QTest::mouseClick(panel().findChild<QPushButton*>(QStringLiteral("saveMap")), Qt::LeftButton);
    };
    save(other);
    const QString given = other + QStringLiteral(".tif");
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(given) && !session->computation().busy(); }, patience));
    EXPECT_FALSE(QFileInfo::exists(other));
    const QDateTime written = QFileInfo(given).lastModified();
    QString asked;
    QTimer waits;
    waits.setInterval(50);
    QObject::connect(&waits, &QTimer::timeout, &waits, [&] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            asked = box->text();
            box->button(QMessageBox::No)->click();
        }
    });
    waits.start();
    save(other);
    EXPECT_TRUE(asked.contains(QStringLiteral("chosen.svg.tif"))) << qPrintable(asked);
    EXPECT_FALSE(session->computation().busy());
    EXPECT_EQ(QFileInfo(given).lastModified(), written);
    // A bare X server gives the keyboard back to nobody.
    window->activateWindow();
    QApplication::setActiveWindow(window);
}

// The accuracy page beside its chart made the window wider than the screen, which nothing took back.
void RunMapTest::leavesTheWindowAsWideAsItIs() {
    ASSERT_TRUE(map().dock().isVisible() && !map().dock().isFloating());
    const int width = window->width();
    for (const auto entry : {PanelDeck::Accuracy, PanelDeck::Evidence, PanelDeck::Report, PanelDeck::Run}) {
        window->rooms().deck->choose(entry);
        QTest::qWait(50);
        EXPECT_EQ(window->width(), width) << static_cast<int>(entry) << ", panel "
                                          << window->rooms().deck->stack().minimumSizeHint().width() << ", page "
                                          << window->area().parentWidget()->minimumSizeHint().width() << ", map "
                                          << map().dock().minimumSizeHint().width();
    }
}

// One run serves all: it stops at the last FE state, so that much still moves.
TEST_F(RunMapTest, TheMapOfTheRunIsShownByItsKeyFollowsTheViewsAndIsSaved) {
    openArch();
    QTest::keyClick(window, Qt::Key_M, Qt::ControlModifier);
    EXPECT_TRUE(map().dock().isVisible());
    EXPECT_FALSE(panel().content().why.isEmpty()) << "there is no run yet, and it says so";
    makeCheap();
    simulateToEnd();
    ASSERT_TRUE(QTest::qWaitFor([&] { return mapped(); }, patience));
    const DebrisMap& made = panel().content().map->map;
    EXPECT_GT(made.cells.size(), 100U);
    EXPECT_EQ(made.time, session->computation().currentRun()->outcome->endTime);
    EXPECT_FALSE(panel().style().outlines.empty()) << "of the structure";
    EXPECT_NE(panel().style().cautions.find("still moved"), std::string::npos) << panel().style().cautions;
    liesOnTheGround();
    isSavedInEachFormat();
    asksForAFile();
    staysWhereItIsDocked();
    leavesTheWindowAsWideAsItIs();
    showsTheInstantOfTheViews();
    QTest::keyClick(window, Qt::Key_M, Qt::ControlModifier);
    EXPECT_FALSE(map().dock().isVisible());
    openMap();
    saysThatTheModelHasNoPlace();
    // Another case takes the map away.
    session->document().undoStack().setClean();
    window->open(arch());
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel().content().map == nullptr; }, patience));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_FALSE(panel().content().why.isEmpty());
}

}  // namespace

}  // namespace rubble
