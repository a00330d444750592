#include <QComboBox>
#include <QTest>
#include <set>

#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "widgets/basics/evidence_tabs.h"
#include "widgets/views/view_widget.h"

namespace rubble {
namespace {

/// The pages that stand in front of the views.
class CoveredViews : public FreshWorkbench {
protected:
    void SetUp() override {
        FreshWorkbench::SetUp();
        openArch();
        views().setAnimated(false);
    }
    widgets::ViewWidget& views() { return window->area().views(); }
    bool saysWhy(const QString& tip) { return tip.contains(viewsCovered()); }
    void show(int page) { window->rooms().deck->choosePage(page); }
    /// Accuracy, photographs and surveys, ensemble, causes.
    static constexpr int pages[] = {PanelDeck::Accuracy, PanelDeck::Evidence, PanelDeck::Report + 1, PanelDeck::Report + 2};
};

TEST_F(CoveredViews, EachActionOfTheViewsIsOfferedWhileTheyAreSeen) {
    for (const int page : pages) {
        std::set<const char*> before;
        for (const ActionRow& row : actionTable()) {
            if (window->actions()[row.id].isEnabled()) {
                before.insert(row.name);
            }
            EXPECT_FALSE(saysWhy(window->actions()[row.id].toolTip())) << row.name;
        }
        show(page);
        ASSERT_FALSE(views().isVisible()) << page;
        for (const ActionRow& row : actionTable()) {
            if (actsOnViews(row.id)) {
                EXPECT_FALSE(window->actions()[row.id].isEnabled()) << row.name << " on page " << page;
                EXPECT_TRUE(saysWhy(window->actions()[row.id].toolTip())) << row.name;
            }
        }
        auto& colours = *window->findChild<QComboBox*>(QStringLiteral("colourBy"));
        EXPECT_FALSE(colours.isEnabled());
        EXPECT_TRUE(saysWhy(colours.toolTip()));
        // What is decided meanwhile waits until the views are back.
        window->rooms().states->refresh();
        window->rooms().inspection->refresh();
        window->rooms().cameraKeys->refresh();
        EXPECT_FALSE(window->actions()[ActionId::Fit].isEnabled());
        EXPECT_FALSE(window->actions()[ActionId::MeasureDistance].isEnabled());
        EXPECT_FALSE(window->actions()[ActionId::CameraKey].isEnabled());
        show(PanelDeck::Run);
        for (const ActionRow& row : actionTable()) {
            EXPECT_EQ(window->actions()[row.id].isEnabled(), before.contains(row.name)) << row.name;
            EXPECT_FALSE(saysWhy(window->actions()[row.id].toolTip())) << row.name;
        }
        EXPECT_TRUE(colours.isEnabled());
        EXPECT_FALSE(saysWhy(colours.toolTip()));
    }
}

/// Whatever is still offered leaves views that nobody sees as they are.
TEST_F(CoveredViews, NothingThatIsOfferedChangesThem) {
    const std::set<ActionId> ownEffect{ActionId::Presentation, ActionId::ThemeSystem, ActionId::ThemeLight, ActionId::ThemeDark};
    show(PanelDeck::Evidence);
    const render::View before = views().view();
    for (const ActionRow& row : actionTable()) {
        const QString menu = QString::fromLatin1(row.menu);
        const bool ofViews = menu == QStringLiteral("View") || menu == QStringLiteral("Camera") || menu == QStringLiteral("Look");
        if (ofViews && !ownEffect.contains(row.id)) {
            window->actions()[row.id].trigger();
            EXPECT_TRUE(views().view() == before) << row.name;
        }
    }
    for (const Qt::Key key :
         {Qt::Key_F, Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_L, Qt::Key_P, Qt::Key_Plus, Qt::Key_M}) {
        QTest::keyClick(window, key);
    }
    EXPECT_TRUE(views().view() == before);
    EXPECT_EQ(views().tool(), widgets::ViewWidget::Tool::Select);
}

}  // namespace
}  // namespace rubble
