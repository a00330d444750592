#include <QAction>

#include "app/gui/stage/actions.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

class Shadows : public FreshWorkbench {
protected:
    widgets::ViewWidget& views() { return window->area().views(); }
    QAction* action(const char* key) {
        for (QAction* each : window->findChildren<QAction*>()) {
            if (each->objectName() == QLatin1String(key)) {
                return each;
            }
        }
        return nullptr;
    }
};

TEST_F(Shadows, AreOnAndAreSwitchedInTheMenu) {
    openArch();
    views().setAnimated(false);
    QAction* shadows = action("shadows");
    ASSERT_NE(shadows, nullptr);
    EXPECT_TRUE(shadows->isEnabled());
    EXPECT_TRUE(shadows->isChecked());
    const QImage lit = views().grab().toImage();
    shadows->trigger();
    EXPECT_FALSE(views().view().shadows);
    EXPECT_FALSE(shadows->isChecked());
    const QImage plain = views().grab().toImage();
    EXPECT_NE(plain, lit);
    shadows->trigger();
    EXPECT_TRUE(views().view().shadows);
    EXPECT_EQ(views().grab().toImage(), lit) << "as it was";
}

}  // namespace

}  // namespace rubble
