#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/inputs_display.h"
#include "app/gui/case/project_display.h"
#include "tests/app/gui/window/hour_of_use.h"
#include "tests/support/ascii_grid.h"
#include "widgets/basics/notice_bar.h"
#include "widgets/case/case_panel.h"
#include "widgets/views/status_line.h"

namespace rubble {
namespace {

class TerrainElsewhere : public HourOfUse {
protected:
    QStringList casePanelTexts() {
        QStringList texts;
        for (const QLabel* label : window->rooms().deck->casePanel().findChildren<QLabel*>()) {
            texts << label->text();
        }
        return texts;
    }
    QPushButton* withoutTerrain() {
        for (auto* bar : window->findChildren<widgets::NoticeBar*>()) {
            for (auto* button : bar->findChildren<QPushButton*>()) {
                if (button->text() == QStringLiteral("Without terrain") && button->isVisible()) {
                    return button;
                }
            }
        }
        return nullptr;
    }
};

// The text said that what can be mended is offered above, and nothing was.
TEST_F(TerrainElsewhere, CanBeLeftOutWhereItIsSaid) {
    openAndAwait(smallAs("small.exo"));
    io::AsciiGrid grid;
    grid.west = 1e6;
    grid.writeLevel(folder.filePath(QStringLiteral("far.asc")).toStdString(), -1.5);
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs.push_back({"terrain-1", InputRole::Terrain, "far.asc", {}});
    session->document().setInputs(inputs, [] { return QStringLiteral("terrain far.asc"); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().terrainFailed(); }, patience));
    ASSERT_TRUE(QTest::qWaitFor([&] { return withoutTerrain() != nullptr; }, patience));
    const QString told = window->rooms().project->inputs().texts().join(u' ');
    EXPECT_TRUE(told.contains(QStringLiteral("The terrain far.asc cannot be used"))) << qPrintable(told);
    EXPECT_TRUE(casePanelTexts().contains(QStringLiteral("far.asc, not read"))) << qPrintable(casePanelTexts().join(u'|'));
    auto* status = window->findChild<widgets::StatusLine*>();
    EXPECT_TRUE(status->activityText().contains(QStringLiteral("far.asc"))) << qPrintable(status->activityText());
    QTest::mouseClick(withoutTerrain(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_EQ(withoutTerrain(), nullptr);
    EXPECT_TRUE(casePanelTexts().contains(QStringLiteral("level")));
    EXPECT_FALSE(status->activityText().contains(QStringLiteral("far.asc"))) << qPrintable(status->activityText());
    // As every other edit.
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return withoutTerrain() != nullptr; }, patience));
}

// A window that is made anew around an open case offers what can be mended at once; its bar flashed up as a window of its own.
TEST_F(TerrainElsewhere, IsOfferedInAWindowThatIsRenewed) {
    openAndAwait(smallAs("small.exo"));
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs.push_back({"terrain-1", InputRole::Terrain, "gone.asc", {}});
    session->document().setInputs(inputs, [] { return QStringLiteral("terrain gone.asc"); });
    const auto offered = [&] { return window->rooms().project->inputs().texts().join(u' ').contains(QStringLiteral("gone.asc")); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return offered() && !session->computation().busy(); }, patience));
    renewed->speak(QStringLiteral("zh_CN"));
    EXPECT_TRUE(QTest::qWaitFor(offered, patience));
    for (const auto* bar : window->findChildren<widgets::NoticeBar*>()) {
        EXPECT_EQ(bar->window(), window);
    }
}

}  // namespace
}  // namespace rubble
