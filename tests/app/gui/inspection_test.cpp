#include "app/gui/views/inspection.h"

#include <QDockWidget>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <algorithm>

#include "app/gui/case/component_display.h"
#include "app/gui/case/file_commands.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/selection_display.h"
#include "tests/app/gui/workbench.h"
#include "widgets/case/component_tree.h"
#include "widgets/figures/view_json.h"
#include "widgets/views/clip_bar.h"
#include "widgets/views/inspector.h"

namespace rubble {

namespace {

class Inspecting : public Workbench {
protected:
    void SetUp() override {
        Workbench::SetUp();
        if (HasFatalFailure()) {
            return;
        }
        openArch();
        views().setAnimated(false);
        drawViews();
    }
    widgets::ViewWidget& views() { return window->area().views(); }
    Inspection& inspection() { return (*window->rooms().inspection); }
    const std::vector<ElementIndex>& selected() { return inspection().selection().selection(); }
    /// Where an element's centre at rest lies in the first pane, in pixels of the widget.
    QPoint pixelOf(ElementIndex element) {
        const Mesh& mesh = session->computation().inputs().fe->mesh();
        Vec3 centre = Vec3::Zero();
        for (const std::uint32_t node : mesh.cornersOf(element)) {
            centre += mesh.nodes[node] / static_cast<double>(mesh.cornersOf(element).size());
        }
        const render::Pane pane = render::panesOf(views().view().layout, views().width(), views().height()).front();
        const auto place = render::project(render::cameraOf(views().view(), pane.content), centre, pane.aspect());
        return {pane.x + static_cast<int>(place->u * pane.width), pane.y + static_cast<int>(place->v * pane.height)};
    }
    /// Clicks on the middle of an element; what is hit may be one that stands before it.
    void click(ElementIndex element, Qt::KeyboardModifiers keys = {}) {
        drawViews();
        QTest::mouseClick(&views(), Qt::LeftButton, keys, pixelOf(element));
    }
    ElementIndex firstOf(const char* component) {
        for (const Component& each : views().data().components->list) {
            if (each.name == component) {
                return each.elements[each.elements.size() / 2];
            }
        }
        ADD_FAILURE() << component;
        return {};
    }
    void press(ActionId id) {
        QAction& action = window->actions()[id];
        ASSERT_TRUE(action.isEnabled()) << action.objectName().toStdString();
        action.trigger();
    }
};

TEST_F(Inspecting, AClickSelectsAndCtrlClickAdds) {
    EXPECT_TRUE(inspection().dock("inspectorDock").isHidden());
    click(firstOf("girder 1"));
    ASSERT_EQ(selected().size(), 1U);
    EXPECT_FALSE(inspection().dock("inspectorDock").isHidden());
    EXPECT_NE(inspection().inspector().title(), QStringLiteral("Nothing selected"));
    const ElementIndex first = selected().front();
    // The dock took room: the same place is elsewhere now.
    click(firstOf("arch rib 1"), Qt::ControlModifier);
    ASSERT_EQ(selected().size(), 2U);
    EXPECT_TRUE(inspection().inspector().title().startsWith(QStringLiteral("2 ")));
    click(firstOf("arch rib 1"), Qt::ControlModifier);
    EXPECT_EQ(selected(), std::vector{first}) << "a second Ctrl-click takes it away";
    drawViews();
    QTest::mouseClick(&views(), Qt::LeftButton, {}, QPoint(views().width() / 2, 3));
    EXPECT_TRUE(selected().empty()) << "the sky";
    EXPECT_TRUE(inspection().dock("inspectorDock").isHidden());
}

TEST_F(Inspecting, TheInspectorStandsBesideTheViewsWhereThereIsRoomAndFloatsWhereThereIsNone) {
    const QDockWidget& dock = *window->findChild<QDockWidget*>(QStringLiteral("inspectorDock"));
    window->resize(1280, 800);
    inspection().selection().select({views().data().fragments->list.front().element});
    for (const bool wide : {false, true, false, true}) {
        window->resize(wide ? QSize(1900, 1000) : QSize(1280, 800));
        ASSERT_TRUE(QTest::qWaitFor([&] { return dock.isVisible() && dock.isFloating() != wide; }, patience)) << wide;
    }
}

TEST_F(Inspecting, DraggingTurnsAndDoesNotSelect) {
    const QPoint from = pixelOf(firstOf("girder 1"));
    const render::Camera before = views().view().cameras[0];
    QTest::mousePress(&views(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&views(), from + QPoint(60, 5));
    QTest::mouseRelease(&views(), Qt::LeftButton, {}, from + QPoint(60, 5));
    EXPECT_FALSE(views().view().cameras[0] == before);
    EXPECT_TRUE(selected().empty());
}

TEST_F(Inspecting, ARubberBandTakesAllInItEvenCovered) {
    const render::Camera before = views().view().cameras[0];
    drawViews();
    QTest::mousePress(&views(), Qt::LeftButton, Qt::ControlModifier, QPoint(1, 1));
    const QPoint far(views().width() - 1, views().height() / 2 - 2);
    QMouseEvent move(QEvent::MouseMove, QPointF(far), views().mapToGlobal(QPointF(far)), Qt::NoButton, Qt::LeftButton,
                     Qt::ControlModifier);
    QApplication::sendEvent(&views(), &move);
    EXPECT_TRUE(views().view().cameras[0] == before);
    QTest::mouseRelease(&views(), Qt::LeftButton, Qt::ControlModifier, far);
    const render::Camera& after = views().view().cameras[0];
    EXPECT_TRUE((after.focalPoint - after.position).normalized().isApprox((before.focalPoint - before.position).normalized(), 1e-9))
        << "an inspector that opens may fit the view anew, and turns nothing";
    EXPECT_EQ(selected().size(), session->computation().inputs().fe->activity().activeCount(0));
}

TEST_F(Inspecting, HideIsolateAndShowAll) {
    click(firstOf("girder 1"));
    ASSERT_EQ(selected().size(), 1U);
    const ElementIndex element = selected().front();
    QTest::keyClick(window, Qt::Key_K, Qt::ShiftModifier);
    EXPECT_GT(selected().size(), 100U) << "the whole component";
    const std::size_t many = selected().size();
    QTest::keyClick(window, Qt::Key_I, Qt::ShiftModifier);
    const std::size_t all = session->computation().inputs().fe->mesh().elementCount();
    EXPECT_EQ(views().view().hidden.size(), all - many);
    drawViews();
    EXPECT_EQ(views().status(render::PaneContent::Fe).hidden, all - many);
    QTest::keyClick(window, Qt::Key_H, Qt::ShiftModifier);
    EXPECT_TRUE(views().view().hidden.empty());
    QTest::keyClick(window, Qt::Key_H);
    EXPECT_EQ(views().view().hidden.size(), many);
    EXPECT_TRUE(selected().empty());
    drawViews();
    QTest::mouseClick(&views(), Qt::LeftButton, {}, pixelOf(element));
    EXPECT_TRUE(selected().empty() || selected().front() != element);
}

TEST_F(Inspecting, TheComponentTreeFollowsTheClockAndEditsCanBeUndone) {
    QTest::keyClick(window, Qt::Key_T);
    ASSERT_TRUE(inspection().tree().isVisible());
    QTreeWidget& tree = inspection().tree().tree();
    const auto dead = [&] {
        int sum = 0;
        for (QTreeWidgetItem* item : tree.findItems(QStringLiteral("*"), Qt::MatchWildcard | Qt::MatchRecursive)) {
            sum += QLocale().toInt(item->text(2));
        }
        return sum;
    };
    EXPECT_EQ(dead(), 0);
    window->rooms().playback->jumpToLast();
    EXPECT_EQ(dead(), 1269);
    inspection().components().isolate({"girder 1"});
    EXPECT_EQ(views().view().hiddenComponents.size(), views().data().components->list.size() - 1);
    EXPECT_EQ(tree.findItems(QStringLiteral("deck slab"), Qt::MatchExactly | Qt::MatchRecursive).front()->checkState(0),
              Qt::Unchecked);
    inspection().components().showAll();
    EXPECT_TRUE(views().view().hiddenComponents.empty());
    emit inspection().tree().edited(QStringLiteral("component[girder 1].reinforced"), true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_TRUE(session->document().scenario().components.at("girder 1").reinforced);
    session->document().undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_FALSE(session->document().scenario().components.contains("girder 1"));
}

TEST_F(Inspecting, TwoClicksMeasure) {
    QTest::keyClick(window, Qt::Key_M);
    EXPECT_EQ(views().tool(), widgets::ViewWidget::Tool::Distance);
    click(firstOf("girder 1"));
    EXPECT_TRUE(selected().empty());
    ASSERT_EQ(views().view().measurements.size(), 1U);
    EXPECT_DOUBLE_EQ(views().view().measurements[0].length(), 0.0);
    click(firstOf("arch rib 1"));
    ASSERT_EQ(views().view().measurements.size(), 1U);
    EXPECT_GT(views().view().measurements[0].length(), 1.0);
    // A length that was begun goes with Esc, then the tool.
    click(firstOf("arch rib 1"));
    EXPECT_EQ(views().view().measurements.size(), 2U);
    QTest::keyClick(&views(), Qt::Key_Escape);
    EXPECT_EQ(views().view().measurements.size(), 1U);
    QTest::keyClick(&views(), Qt::Key_Escape);
    EXPECT_EQ(views().tool(), widgets::ViewWidget::Tool::Select);
    EXPECT_FALSE(window->actions()[ActionId::MeasureDistance].isChecked());
    window->rooms().playback->jumpToLast();
    EXPECT_EQ(views().view().measurements.size(), 1U) << "kept until cleared";
    press(ActionId::ClearMeasurements);
    EXPECT_TRUE(views().view().measurements.empty());
}

TEST_F(Inspecting, TheCutComesAndGoes) {
    QTest::keyClick(window, Qt::Key_C);
    ASSERT_TRUE(views().view().clip);
    EXPECT_TRUE(window->area().clipBar().isVisible());
    drawViews();
    emit window->area().clipBar().viewDirectionRequested();
    EXPECT_NEAR(views().view().clip->normal.norm(), 1.0, 1e-12);
    EXPECT_LT(views().view().clip->normal.y(), -0.9) << "towards the eye";
    emit window->area().clipBar().closeRequested();
    EXPECT_FALSE(views().view().clip);
    EXPECT_FALSE(window->area().clipBar().isVisible());
    EXPECT_FALSE(window->actions()[ActionId::Clip].isChecked());
}

TEST_F(Inspecting, ProjectionLayoutsAndStyleByKeys) {
    QTest::keyClick(window, Qt::Key_P);
    EXPECT_TRUE(views().view().cameras[0].parallel);
    press(ActionId::LookCorner);
    EXPECT_TRUE(views().view().cameras[0].parallel) << "the projection stays";
    QTest::keyClick(window, Qt::Key_P);
    EXPECT_FALSE(views().view().cameras[0].parallel);
    QTest::keyClick(window, Qt::Key_4);
    EXPECT_EQ(views().view().layout, render::Layout::Four);
    drawViews();
    QTest::keyClick(window, Qt::Key_3);
    EXPECT_EQ(views().view().layout, render::Layout::OverlayOnly);
    drawViews();
    const render::Style style = views().view().style;
    QTest::keyClick(window, Qt::Key_P, Qt::ShiftModifier);
    EXPECT_NE(views().view().style, style);
    const double before = (views().view().cameras[0].position - views().view().cameras[0].focalPoint).norm();
    QTest::keyClick(window, Qt::Key_Plus);
    EXPECT_LT((views().view().cameras[0].position - views().view().cameras[0].focalPoint).norm(), before);
}

TEST_F(Inspecting, AFragmentsWayIsReadDrawnAndExported) {
    makeCheap();
    window->rooms().runs->simulate(false);
    const auto ended = [&] { return session->computation().currentRun() != nullptr && !session->computation().busy(); };
    ASSERT_TRUE(QTest::qWaitFor(ended, patience));
    window->rooms().playback->clock().pause();
    const FragmentSet& fragments = *views().data().fragments;
    const ElementIndex element = fragments.list[fragments.size() / 2].element;
    inspection().selection().select({element});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !inspection().selection().reading(); }, patience));
    EXPECT_GT(views().view().path.size(), 3U);
    EXPECT_TRUE(inspection().inspector().title().startsWith(QStringLiteral("Fragment")));
    QTest::keyClick(window, Qt::Key_G);
    EXPECT_DOUBLE_EQ(window->rooms().playback->clock().time(), fragments.list[fragments.size() / 2].handOverTime);
    EXPECT_LT((views().view().cameras[0].focalPoint - fragments.list[fragments.size() / 2].centre).norm(), 1e-6);
    inspection().selection().follow(true);
    window->rooms().playback->jumpToLast();
    EXPECT_LT((views().view().cameras[0].focalPoint - views().view().path.back()).norm(), 1e-3) << "the camera goes along";
    QTest::keyClick(window, Qt::Key_K);
    EXPECT_EQ(selected().size(),
              views().data().clustering->list[at(views().data().clustering->of[fragments.size() / 2])].memberCount);
    widgets::SelectForm::Criteria born;
    born.bornFrom = 2.0;
    born.bornTo = 2.5;
    inspection().selection().selectBy(born);
    const auto chosen = inspection().selection().fragments();
    ASSERT_FALSE(chosen.empty());
    for (const FragmentId id : chosen) {
        EXPECT_GE(fragments.list[at(id)].birthTime, 2.0);
        EXPECT_LE(fragments.list[at(id)].birthTime, 2.5);
    }
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("selection.csv"));
    window->rooms().files->exportSelectionTo(path, chosen);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    const std::string text = textOf(path);
    EXPECT_TRUE(text.starts_with("fragment_id,element_id,component,cluster_id,birth_time_s,"));
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), chosen.size() + 1);
}

TEST_F(Inspecting, RegionAndComponentAreSelectedTogether) {
    drawViews();
    widgets::SelectForm::Criteria half;
    half.component = "girder 1";
    const auto& girder = *std::find_if(views().data().components->list.begin(), views().data().components->list.end(),
                                       [](const Component& c) { return c.name == "girder 1"; });
    const double middle = girder.bounds.center().x();
    half.high[0] = middle;
    inspection().selection().selectBy(half);
    const std::size_t left = selected().size();
    EXPECT_GT(left, girder.elements.size() / 3);
    EXPECT_LT(left, girder.elements.size() * 2 / 3);
    half.high[0].reset();
    half.low[0] = middle;
    half.how = widgets::SelectForm::How::Add;
    inspection().selection().selectBy(half);
    EXPECT_EQ(selected(), girder.elements);
    half.how = widgets::SelectForm::How::Remove;
    inspection().selection().selectBy(half);
    EXPECT_EQ(selected().size(), left);
}

TEST_F(Inspecting, ASavedViewIsLookedAtAgain) {
    render::View view = views().view();
    view.layout = render::Layout::Four;
    view.hiddenComponents = {"girder 1"};
    view.time = 1.0;
    view.theme = render::Theme::Print;
    window->rooms().scene->look(figures::viewFromJson(figures::toJson(view), "view"));
    EXPECT_EQ(views().view().layout, render::Layout::Four);
    EXPECT_DOUBLE_EQ(window->rooms().playback->clock().time(), 1.0);
    EXPECT_NE(views().view().theme, render::Theme::Print) << "the window keeps its colours";
    EXPECT_TRUE(window->actions()[ActionId::Four].isChecked());
    drawViews();
    EXPECT_GT(views().status(render::PaneContent::Fe).hidden, 0U);
}

}  // namespace

}  // namespace rubble
