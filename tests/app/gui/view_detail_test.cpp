#include <QCheckBox>
#include <QDockWidget>
#include <QPainter>
#include <QScreen>
#include <QSettings>
#include <QTest>
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "app/gui/session/settings.h"
#include "app/gui/stage/dock_area.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "widgets/case/preferences_dialog.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/panes.h"

namespace rubble {
namespace {

/// Of all channels of all pixels, 0 to 255.
double meanDifference(const QImage& a, const QImage& b) {
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            sum += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue());
        }
    }
    return sum / (3.0 * a.width() * a.height());
}

class ViewDetail : public Workbench {
protected:
    void SetUp() override {
        Workbench::SetUp();
        openArch();
        views().setAnimated(false);
    }
    void TearDown() override { widgets::ViewWidget::simplifyAbove(widgets::ViewWidget::slowDraw); }
    widgets::ViewWidget& views() { return window->area().views(); }

    /// Orbits picture by picture; true as soon as one is drawn with less detail.
    bool simplifiedInOrbit() {
        for (int picture = 0; picture < 8; ++picture) {
            views().turn(0.02, 0.0);
            views().grab();
            if (views().simplified()) {
                return true;
            }
        }
        return false;
    }
};

TEST_F(ViewDetail, SlowViewsAreSimplifiedWhileTheyMoveAndNotAtRest) {
    widgets::ViewWidget::simplifyAbove(0.0);  // every picture counts as slow
    ASSERT_TRUE(simplifiedInOrbit());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !views().simplified(); }, patience)) << "full detail comes back by itself";
    EXPECT_EQ(views().status(render::PaneContent::Fe).simplifiedTo, 0.0);
}

TEST_F(ViewDetail, SlowViewsAreDrawnWithFewerPixelsAndAreSharpAgainAtRest) {
    widgets::ViewWidget::simplifyAbove(std::numeric_limits<double>::infinity());
    const QImage sharp = views().picture();
    const render::View home = views().view();
    const render::PaneStatus before = views().status(render::PaneContent::Fragments);
    widgets::ViewWidget::simplifyAbove(0.0);
    const auto resolution = [&] { return views().status(render::PaneContent::Fe).resolution; };
    for (int picture = 0; picture < 16 && resolution() > render::DrawnResolution::steps.back(); ++picture) {
        ASSERT_TRUE(simplifiedInOrbit());
    }
    ASSERT_EQ(resolution(), render::DrawnResolution::steps.back());
    // Once more where it began: the same picture, less sharp.
    views().setView(home);
    const QImage coarse = views().grabFramebuffer();
    ASSERT_TRUE(views().simplified());
    ASSERT_EQ(coarse.size(), sharp.size());
    EXPECT_GT(meanDifference(coarse, sharp), 0.0);
    EXPECT_LT(meanDifference(coarse, sharp), 8.0) << "of 255: everything is where it was";
    EXPECT_EQ(views().status(render::PaneContent::Fragments).fragments, before.fragments);
    EXPECT_EQ(views().status(render::PaneContent::Fragments).active, before.active);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !views().simplified(); }, patience));
    EXPECT_EQ(resolution(), 1.0);
    EXPECT_EQ(views().grabFramebuffer(), sharp);
}

TEST_F(ViewDetail, WhatIsFastEnoughOrNotAllowedKeepsItsDetail) {
    // Switched off on the move, too.
    widgets::ViewWidget::simplifyAbove(0.0);
    ASSERT_TRUE(simplifiedInOrbit());
    widgets::ViewWidget::simplifyAbove(std::numeric_limits<double>::infinity());
    EXPECT_FALSE(simplifiedInOrbit());
}

TEST_F(ViewDetail, APictureThatIsTakenHasEveryDetail) {
    widgets::ViewWidget::simplifyAbove(0.0);
    ASSERT_TRUE(simplifiedInOrbit());
    EXPECT_FALSE(views().picture().isNull());
    EXPECT_FALSE(views().simplified());
}

TEST_F(ViewDetail, ThePreferenceSwitchesItOff) {
    widgets::ViewWidget::simplifyAbove(0.0);
    ASSERT_TRUE(simplifiedInOrbit());
    window->actions()[ActionId::Preferences].trigger();
    auto* dialog = window->findChild<widgets::PreferencesDialog*>();
    ASSERT_NE(dialog, nullptr);
    // A window that becomes active between press and release takes the key away.
    ASSERT_TRUE(QTest::qWaitForWindowActive(dialog, patience));
    auto* simplify = dialog->findChild<QCheckBox*>(QStringLiteral("simplify"));
    ASSERT_TRUE(simplify->isChecked());
    QTest::keyClick(simplify, Qt::Key_Space);
    EXPECT_FALSE(simplifiedInOrbit());
    QSettings settings;
    EXPECT_FALSE(readPreferences(settings).simplify);
    EXPECT_FALSE(Session().preferences().simplify) << "the next window has it, too";
    QTest::keyClick(simplify, Qt::Key_Space);
    EXPECT_TRUE(readPreferences(settings).simplify);
}

/// All corners of the model lie within all panes.
bool seenWhole(const widgets::ViewWidget& views) {
    const render::View& view = views.view();
    for (const render::Pane& pane : render::panesOf(view.layout, views.width(), views.height())) {
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 at = views.bounds().corner(static_cast<Aabb::CornerType>(corner));
            const auto seen = render::project(render::cameraOf(view, pane.content), at, pane.aspect());
            if (!seen || seen->u < 0.0 || seen->u > 1.0 || seen->v < 0.0 || seen->v > 1.0) {
                return false;
            }
        }
    }
    return true;
}

/// What the screen shows where the views are, whoever drew it last.
QImage onScreen(widgets::ViewWidget& views) {
    const QPoint at = views.mapToGlobal(QPoint(0, 0));
    return views.screen()
        ->grabWindow(0, at.x(), at.y(), views.width(), views.height())
        .toImage()
        .convertToFormat(QImage::Format_RGB32);
}

/// Leaves out what a window lies over.
void leaveOut(QImage& picture, const widgets::ViewWidget& views, const QWidget& over) {
    if (over.isVisible() && over.isWindow()) {
        QPainter(&picture).fillRect(over.frameGeometry().translated(-views.mapToGlobal(QPoint(0, 0))), Qt::black);
    }
}

/// Fitting once more changes nothing: they are fitted already.
void expectFitted(widgets::ViewWidget& views, const char* after) {
    const auto before = views.view().cameras;
    views.keepFitted();
    const auto& now = views.view().cameras;
    EXPECT_TRUE(std::equal(now.begin(), now.end(), before.begin(), render::showsAlike)) << after;
}

TEST_F(ViewDetail, EachPanelThatComesGoesOrChangesItsSizeFitsTheViewsAtOnce) {
    widgets::ViewWidget::simplifyAbove(std::numeric_limits<double>::infinity());
    auto* area = window->findChild<DockArea*>();
    auto* map = &window->rooms().map->dock();
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers with) { QTest::keyClick(window, key, with); };
    const std::vector<std::pair<const char*, std::function<void()>>> steps{
        {"Ctrl+M opens the map", [&] { press(Qt::Key_M, Qt::ControlModifier); }},
        {"the map is narrower", [&] { area->resizeDocks({map}, {map->width() - 60}, Qt::Horizontal); }},
        {"the map floats", [&] { map->setFloating(true); }},
        {"it is docked again", [&] { map->setFloating(false); }},
        {"Ctrl+M closes it", [&] { press(Qt::Key_M, Qt::ControlModifier); }},
        {"a list opens", [&] { window->actions()[ActionId::Components].trigger(); }},
        {"a list closes", [&] { window->actions()[ActionId::Components].trigger(); }},
        {"a bar comes", [&] { window->actions()[ActionId::Clip].trigger(); }},
        {"a bar goes", [&] { window->actions()[ActionId::Clip].trigger(); }},
        {"parallel", [&] { window->actions()[ActionId::Parallel].trigger(); }},
        {"perspective", [&] { window->actions()[ActionId::Parallel].trigger(); }},
        {"cameras of their own", [&] { window->actions()[ActionId::Link].trigger(); }},
        {"cameras linked", [&] { window->actions()[ActionId::Link].trigger(); }},
        {"four views", [&] { window->actions()[ActionId::Four].trigger(); }},
        {"two views", [&] { window->actions()[ActionId::Beside].trigger(); }},
        {"another window", [&] { window->resize(1200, 760); }}};
    for (const auto& [what, step] : steps) {
        step();
        QTest::qWait(150);
        expectFitted(views(), what);
        // A busy machine draws later: what counts is that nothing more is needed.
        double apart = 0.0;
        const auto alike = [&] {
            QImage shown = onScreen(views());
            QImage drawn = views().grabFramebuffer().convertToFormat(QImage::Format_RGB32);
            leaveOut(shown, views(), *map);
            leaveOut(drawn, views(), *map);
            apart = shown.size() == drawn.size() ? meanDifference(shown, drawn) : 255.0;
            return apart < 1.0;
        };
        EXPECT_TRUE(QTest::qWaitFor(alike, patience)) << what << ": the screen shows what the cameras see now; " << apart;
    }
}

TEST_F(ViewDetail, ACameraThatWasMovedByHandStaysThroughAllOfThem) {
    const QPoint middle = views().rect().center() / 2;
    QTest::mousePress(&views(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(&views(), middle + QPoint(60, 10));
    QTest::mouseRelease(&views(), Qt::LeftButton, {}, middle + QPoint(60, 10));
    ASSERT_TRUE(views().moved()[0]);
    const render::Camera moved = views().view().cameras[0];
    for (const ActionId id : {ActionId::DebrisMap, ActionId::Components, ActionId::Clip, ActionId::Stacked, ActionId::Four,
                              ActionId::Beside, ActionId::DebrisMap, ActionId::Components, ActionId::Clip}) {
        window->actions()[id].trigger();
        QTest::qWait(50);
        EXPECT_EQ(views().view().cameras[0], moved) << static_cast<int>(id);
    }
    EXPECT_FALSE(views().moved()[static_cast<std::size_t>(render::PaneContent::Plan)]) << "nobody moved that";
    window->actions()[ActionId::Fit].trigger();
    expectFitted(views(), "F fits again");
    EXPECT_EQ(views().moved(), widgets::ViewWidget::Moved{});
}

TEST_F(ViewDetail, WhatIsFittedStaysSoBesideADockUntilTheCameraIsMoved) {
    ASSERT_TRUE(seenWhole(views()));
    const int wide = views().width();
    window->actions()[ActionId::Components].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return views().width() < wide; }, patience));
    EXPECT_TRUE(seenWhole(views())) << "the model does not move out of sight because a list opens";
    window->actions()[ActionId::Components].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return views().width() == wide; }, patience));
    EXPECT_TRUE(seenWhole(views()));

    views().turn(0.3, 0.0);
    const render::View turned = views().view();
    window->actions()[ActionId::Components].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return views().width() < wide; }, patience));
    EXPECT_EQ(views().view(), turned) << "where the user looks from is not the window's to change";
    window->actions()[ActionId::Fit].trigger();
    EXPECT_TRUE(seenWhole(views()));
}

}  // namespace
}  // namespace rubble
