#include <gtest/gtest.h>

#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QScrollArea>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <QUrl>
#include <array>
#include <cstdlib>

#include "app/gui/stage/actions.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "widgets/basics/place_choice.h"
#include "widgets/evidence/run_map_panel.h"
#include "widgets/views/inspector.h"
#include "widgets/views/stage_rail.h"
#include "widgets/views/status_line.h"

namespace rubble {

namespace {

/// What is said and shown belongs to the present, and covers nothing that is in use.
class PresentState : public FreshWorkbench {
protected:
    void clickPanel(PanelDeck::Entry entry) {
        QTest::mouseClick(window->rooms().deck->rail().findChildren<QAbstractButton*>().at(entry), Qt::LeftButton);
    }
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    QString status() { return window->findChild<widgets::StatusLine*>()->activityText(); }
    QDockWidget* dock(const char* name) { return window->findChild<QDockWidget*>(QLatin1String(name)); }
    void select(ElementIndex element) {
        render::View view = window->area().views().view();
        view.selection = {element};
        window->area().views().setView(view);
    }
    std::string materialOf(const std::string& component) {
        const auto& all = session->document().scenario().components;
        const auto own = all.find(component);
        return own != all.end() && own->second.material ? std::string(materialName(*own->second.material)) : std::string();
    }
};

TEST_F(PresentState, TheMapThatIsAwaitedIsNotAwaitedForEver) {
    openArch();
    makeCheap();
    simulateToEnd();
    window->actions()[ActionId::ExportMap].trigger();
    ASSERT_TRUE(status().contains(QStringLiteral("being mapped"))) << status().toStdString();
    const auto& panel = window->rooms().map->panel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel.content().map != nullptr && !panel.content().making; }, patience));
    EXPECT_FALSE(status().contains(QStringLiteral("being mapped"))) << status().toStdString();
    EXPECT_TRUE(status().contains(QStringLiteral("save it now"))) << status().toStdString();
}

TEST_F(PresentState, ClustersAreInSightBesideTheSliderThatMakesThem) {
    openArch();
    clickPanel(PanelDeck::Grid);
    QWidget* panel = window->rooms().deck->stack().currentWidget();
    auto* slider = panel->findChild<QSlider*>();
    QLabel* clusters = nullptr;
    for (auto* label : panel->findChildren<QLabel*>(QStringLiteral("value"))) {
        clusters = label->accessibleName() == QLatin1String("Clusters") ? label : clusters;
    }
    ASSERT_NE(clusters, nullptr);
    static_cast<QScrollArea*>(panel)->ensureWidgetVisible(slider, 0, 120);
    QCoreApplication::processEvents();
    const QPoint place = slider->mapTo(window, QPoint());
    const QString before = clusters->text();
    const QPoint from(slider->width() / 2, slider->height() / 2);
    // Whoever drags does not stay on the slider. The cursor arrives before the press: what moves it tells of no pressed button.
    const QPoint elsewhere = panel->mapToGlobal(QPoint(60, panel->height() - 40));
    QCursor::setPos(elsewhere);
    EXPECT_TRUE(QTest::qWaitFor([&] { return QCursor::pos() == elsewhere; }));
    QTest::qWait(50);
    EXPECT_EQ(slider->mapTo(window, QPoint()), place);
    QTest::mousePress(slider, Qt::LeftButton, {}, from);
    for (int x = from.x(); x < slider->width() - 4; x += 8) {
        QTest::mouseMove(slider, QPoint(x, from.y()));
        QCoreApplication::processEvents();
        EXPECT_EQ(slider->mapTo(window, QPoint()), place);
    }
    QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(slider->width() - 4, from.y()));
    EXPECT_TRUE(QTest::qWaitFor([&] { return clusters->text() != before; }, patience));
    EXPECT_EQ(clusters->visibleRegion().boundingRect(), clusters->rect()) << "seen whole";
    EXPECT_LT(std::abs(clusters->mapTo(window, QPoint()).y() - place.y()), 80);
}

TEST_F(PresentState, TheFloatingInspectorCoversNoOtherDock) {
    openArch();
    Actions& actions = window->actions();
    const auto covers = [&] {
        const auto onScreen = [](const QWidget& widget) { return QRect(widget.mapToGlobal(QPoint()), widget.size()); };
        return onScreen(*dock("inspectorDock")).intersects(onScreen(*dock("componentsDock")));
    };
    for (const bool inspectorFirst : {true, false}) {
        for (const ActionId id : inspectorFirst ? std::array{ActionId::Inspector, ActionId::Components}
                                                : std::array{ActionId::Components, ActionId::Inspector}) {
            actions[id].trigger();
        }
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return dock("inspectorDock")->isFloating() && dock("componentsDock")->isVisible(); }, patience));
        EXPECT_TRUE(QTest::qWaitFor([&] { return !covers(); }, patience)) << inspectorFirst;
        actions[ActionId::Inspector].trigger();
        actions[ActionId::Components].trigger();
        QCoreApplication::processEvents();
    }
}

TEST_F(PresentState, NothingIsSaidOfAClusterThatIsNotChosen) {
    openArch();
    clickPanel(PanelDeck::Accuracy);
    auto* place = window->rooms().deck->stack().currentWidget()->findChild<widgets::PlaceChoice*>();
    ASSERT_NE(place, nullptr);
    place->setReached(QStringLiteral("Slurm is not installed here."), QStringLiteral("Simulate on this machine."));
    const auto said = [&] {
        QStringList all;
        for (auto* label : place->findChildren<QLabel*>()) {
            if (label->isVisible()) {
                all << label->text();
            }
        }
        return all.join(u' ');
    };
    EXPECT_FALSE(place->onCluster());
    EXPECT_FALSE(said().contains(QStringLiteral("Slurm"))) << said().toStdString();
    auto* box = place->findChild<QComboBox*>(QStringLiteral("place"));
    EXPECT_TRUE(box->toolTip().contains(QStringLiteral("not installed"))) << "why it cannot be chosen";
    EXPECT_TRUE(box->itemText(1).contains(QStringLiteral("not reached")));
}

TEST_F(PresentState, EscClosesTheEvidenceBeforeItCancelsARun) {
    openArch();
    session->document().setParameter(QStringLiteral("settle_time"), 20.0);
    window->rooms().runs->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().simulating(); }, patience));
    clickPanel(PanelDeck::Evidence);
    ASSERT_FALSE(window->area().isVisible());
    press(Qt::Key_Escape);
    EXPECT_TRUE(window->area().isVisible());
    EXPECT_EQ(window->rooms().deck->rail().current(), PanelDeck::Run);
    EXPECT_TRUE(session->computation().simulating());
    press(Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
}

TEST_F(PresentState, AMaterialThatIsGuessedSaysSoAndIsNamedByOneClick) {
    openArch();
    QTest::mouseClick(&window->area().views(), Qt::LeftButton);
    select(idAt<ElementIndex>(0));
    auto* inspector = window->findChild<widgets::Inspector*>();
    const std::string component = window->area().views().data().components->list[0].name;
    ASSERT_TRUE(materialOf(component).empty());
    EXPECT_TRUE(window->area().views().data().materialAssumed(component));
    auto* say = inspector->findChild<QToolButton*>(QStringLiteral("sayMaterial"));
    ASSERT_NE(say, nullptr);
    QAction* stone = say->menu()->actions().front();
    stone->trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return materialOf(component) == "stone" && prepared(); }, patience));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window->area().views().data().materialAssumed(component); }, patience));
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return inspector->findChild<QToolButton*>(QStringLiteral("sayMaterial")) == nullptr; }, patience));
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(materialOf(component).empty());
}

TEST_F(PresentState, AQuestionAboutADroppedFileStandsUnderNoOpenMenu) {
    openArch();
    session->document().setParameter(QStringLiteral("friction"), 0.65);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    QTest::qWait(500);  // the Inspector is made anew with what was prepared
    select(idAt<ElementIndex>(0));
    auto* say = window->findChild<widgets::Inspector*>()->findChild<QToolButton*>(QStringLiteral("sayMaterial"));
    ASSERT_NE(say, nullptr);
    bool asked = false;
    whenAsked([&](QDialog& question) {
        asked = true;
        EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
        say->menu()->close();
        QTest::mouseClick(qobject_cast<QMessageBox*>(&question)->button(QMessageBox::Cancel), Qt::LeftButton);
    });
    QTimer::singleShot(200, window, [&] {
        EXPECT_EQ(QApplication::activePopupWidget(), say->menu());
        QMimeData mime;
        mime.setUrls({QUrl::fromLocalFile(arch())});
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window, &enter);
        QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window, &drop);
    });
    // Whatever fails, the loop of the menu ends.
    QTimer::singleShot(10'000, say->menu(), &QMenu::close);
    QTest::mouseClick(say, Qt::LeftButton);
    EXPECT_TRUE(asked);
    EXPECT_EQ(session->document().scenario().simulation.friction, 0.65);
}

TEST_F(PresentState, TheStyleThatWasChosenIsThatOfTheNextStart) {
    openArch();
    press(Qt::Key_P, Qt::ShiftModifier);
    ASSERT_EQ(window->area().views().view().style, render::Style::Analysis);
    session->document().undoStack().setClean();
    startProgram();
    window->show();
    EXPECT_EQ(window->area().views().view().style, render::Style::Analysis);
    EXPECT_FALSE(window->actions()[ActionId::Presentation].isChecked());
}

}  // namespace

}  // namespace rubble
