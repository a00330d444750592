#include <QAction>
#include <QSignalSpy>

#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

class SlowShading : public FreshWorkbench {
protected:
    void TearDown() override {
        widgets::ViewWidget::shadeUpTo(widgets::ViewWidget::slowShading);
        FreshWorkbench::TearDown();
    }
    widgets::ViewWidget& views() { return window->area().views(); }
    /// The action by its key, as a user switches it.
    QAction* shading() {
        for (QAction* action : window->findChildren<QAction*>()) {
            if (action->objectName() == QLatin1String("shading")) {
                return action;
            }
        }
        return nullptr;
    }
    /// Pictures one after the other, as while the model is turned.
    void turnALittle() {
        for (int picture = 0; picture < 4; ++picture) {
            views().turn(0.02, 0.0);
            views().grab();
            QTest::qWait(10);
        }
    }
};

TEST_F(SlowShading, SwitchesItselfOffAndSaysSo) {
    openArch();
    views().setAnimated(false);
    QStringList told;
    QObject::connect(session.get(), &Session::told, [&](const QString& what) { told << what; });
    ASSERT_NE(shading(), nullptr);
    widgets::ViewWidget::shadeUpTo(1e6);
    shading()->trigger();
    ASSERT_TRUE(views().view().shading);
    turnALittle();
    EXPECT_TRUE(views().view().shading) << "pictures are fast enough";
    widgets::ViewWidget::shadeUpTo(0.0);
    turnALittle();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !views().view().shading; }, 20'000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !shading()->isChecked(); }, patience)) << "the menu says so";
    EXPECT_TRUE(told.join(u' ').contains(QStringLiteral("Shaded edges are off"))) << told.join(u'|').toStdString();
}

}  // namespace

}  // namespace rubble
