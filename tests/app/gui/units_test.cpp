#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "app/gui/case/file_commands.h"
#include "app/gui/session/worker.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/case/fragments_panel.h"
#include "widgets/figures/figure_file.h"

namespace rubble {

namespace {

class UnitsOfDisplay : public Workbench {
protected:
    void SetUp() override {
        Workbench::SetUp();
        window->open(QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString())));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    void TearDown() override { choose(0); }
    /// Chooses units in the preferences by the keyboard, as a user does.
    void choose(int row) {
        QTest::keyClick(window, Qt::Key_Comma, Qt::ControlModifier);
        auto* dialog = window->findChild<widgets::PreferencesDialog*>();
        ASSERT_NE(dialog, nullptr);
        auto* units = dialog->findChild<QComboBox*>(QStringLiteral("units"));
        units->setFocus();
        // Without a window manager Home goes to the timeline of the window that counts as active.
        for (int i = units->count(); i > 0; --i) {
            QTest::keyClick(units, Qt::Key_Up);
        }
        for (int i = 0; i < row; ++i) {
            QTest::keyClick(units, Qt::Key_Down);
        }
        EXPECT_EQ(units->currentIndex(), row);
        dialog->close();
        // It goes with the next round of events; the next one asked for must not be this.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        // Other units are shown by another window.
        QTest::qWait(50);
        QApplication::setActiveWindow(window);
    }
    QStringList unitsShown() {
        QStringList all;
        for (const QLabel* label : window->rooms().deck->stack().findChildren<QLabel*>(QStringLiteral("unit"))) {
            all << label->text();
        }
        return all;
    }
    /// Fragments of masses that are told in this unit.
    bool massesIn(const char* unit) {
        const auto labels = window->findChild<widgets::FragmentsPanel*>()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return QString(label->text()).replace(QChar(0x00A0), u' ').contains(u' ' + QLatin1String(unit));
        });
    }
    std::string saved(const QString& name) {
        EXPECT_TRUE(window->rooms().files->saveTo(folder.filePath(name)));
        return textOf(folder.filePath(name));
    }
    std::string figure(const QString& name) {
        figures::writeFigure(folder.filePath(name).toStdString(), window->area().views().view(), window->rooms().scene->data(), {});
        return textOf(folder.filePath(name));
    }

    QTemporaryDir folder;
};

TEST_F(UnitsOfDisplay, ChangeWhatIsShownAndTypedButNoFile) {
    const std::string inSi = saved(QStringLiteral("a.rubble"));
    const std::string figureInSi = figure(QStringLiteral("a.png"));
    EXPECT_TRUE(massesIn("t") && !massesIn("short tons"));
    choose(2);
    EXPECT_TRUE(massesIn("short tons"));
    EXPECT_FALSE(massesIn("kg") || unitsShown().contains(QStringLiteral("kg")));
    EXPECT_FALSE(unitsShown().contains(QStringLiteral("m")));
    EXPECT_EQ(saved(QStringLiteral("b.rubble")), inSi);
    EXPECT_EQ(figure(QStringLiteral("b.png")), figureInSi);
    auto* height = window->rooms().deck->run().editor(QStringLiteral("ground_height"));
    if (height == nullptr) {
        height = window->findChild<widgets::ParameterEditor*>(QStringLiteral("ground_height"));
    }
    ASSERT_NE(height, nullptr);
    auto* field = height->findChild<QLineEdit*>();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("-10"));
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_NEAR(session->document().scenario().simulation.groundHeight, -3.048, 1e-12);
    choose(1);
    field = window->findChild<widgets::ParameterEditor*>(QStringLiteral("ground_height"))->findChild<QLineEdit*>();
    EXPECT_EQ(field->text(), QStringLiteral("-3,048"));
    session->document().undoStack().undo();
    EXPECT_EQ(saved(QStringLiteral("c.rubble")), inSi);
}

TEST_F(UnitsOfDisplay, AreRemembered) {
    choose(2);
    EXPECT_EQ(QSettings().value(QStringLiteral("units")).toString(), QStringLiteral("US"));
    Session other;
    EXPECT_EQ(other.preferences().units, figures::UnitSet::UsCustomary);
}

}  // namespace
}  // namespace rubble
