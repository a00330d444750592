#include "app/gui/case/new_case.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "app/gui/help/help.h"
#include "app/gui/help/manual.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/case/case_preview.h"
#include "widgets/case/new_case_wizard.h"

namespace rubble {

namespace {

using widgets::NewCaseWizard;

/// A wizard over the small collapse.
class NewCases : public Workbench {
protected:
    void SetUp() override {
        Workbench::SetUp();
        fe = QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString()));
    }
    void begin() {
        window->rooms().opening->newCase(fe);
        ASSERT_NE(window->rooms().opening->caseInTheMaking(), nullptr);
        ASSERT_TRUE(QTest::qWaitForWindowActive(&wizard(), patience)) << "without a window manager too";
        settle();
    }
    void settle() {
        ASSERT_TRUE(QTest::qWaitFor(
            [&] {
                const NewCase* making = window->rooms().opening->caseInTheMaking();
                return making == nullptr ||
                       (making->settled() &&
                        window->rooms().opening->caseInTheMaking()->computation().results().fragments != nullptr);
            },
            patience));
    }
    /// Buttons that are pressed by a key show it for a moment before they act.
    bool reaches(NewCaseWizard::Step step) {
        return QTest::qWaitFor([&] { return wizard().step() == step; }, 10'000);
    }
    NewCase& making() { return *window->rooms().opening->caseInTheMaking(); }
    NewCaseWizard& wizard() { return making().wizard(); }
    QPushButton* button(const QString& text) {
        for (auto* each : wizard().findChildren<QPushButton*>()) {
            if (each->text() == text) {
                return each;
            }
        }
        return nullptr;
    }
    void type(const QString& key, const QString& text) {
        auto* field = wizard().findChild<widgets::ParameterEditor*>(key)->findChild<QLineEdit*>();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    std::size_t components() { return making().computation().results().components->list.size(); }

    QTemporaryDir folder;
    QString fe;
};

TEST_F(NewCases, AreMadeStepByStep) {
    begin();
    EXPECT_TRUE(session->document().empty()) << "nothing is open before the case is made";
    for (const NewCaseWizard::Step step :
         {NewCaseWizard::Units, NewCaseWizard::Ground, NewCaseWizard::Components, NewCaseWizard::Deaths, NewCaseWizard::Summary}) {
        EXPECT_EQ(wizard().step(), step);
        button(QStringLiteral("&Next"))->click();
    }
    settle();
    wizard().go(NewCaseWizard::Ground);
    EXPECT_EQ(wizard().step(), NewCaseWizard::Ground);
    type(QStringLiteral("ground_height"), QStringLiteral("-0.5"));
    EXPECT_EQ(wizard().step(), NewCaseWizard::Ground) << "Enter settles a number and does not go on";
    EXPECT_DOUBLE_EQ(making().document().scenario().simulation.groundHeight, -0.5);
    wizard().go(NewCaseWizard::Summary);
    auto* title = wizard().findChild<QLineEdit*>(QStringLiteral("caseTitle"));
    EXPECT_EQ(title->text(), QStringLiteral("small"));
    title->setFocus();
    title->selectAll();
    QTest::keyClicks(title, QStringLiteral("Three blocks"));
    settle();
    button(QStringLiteral("&Make the case"))->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().opening->caseInTheMaking() == nullptr && prepared(); }, patience));
    EXPECT_EQ(session->document().theCase().title, "Three blocks");
    EXPECT_DOUBLE_EQ(session->document().scenario().simulation.groundHeight, -0.5);
    EXPECT_TRUE(session->document().modified()) << "it was never saved";
    EXPECT_TRUE(session->document().path().isEmpty());
    session->document().undoStack().setClean();
}

TEST_F(NewCases, TheManualIsReadBesideTheWizardThatBlocksTheWindow) {
    begin();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
    const QPointer<ManualWindow> manual = wizard().findChild<ManualWindow*>();
    ASSERT_NE(manual, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowActive(manual, patience));
    EXPECT_EQ(window->help().openPage(), QStringLiteral("Case"));
    // As the window system sends them: to a window that is blocked they do not come.
    auto* search = manual->findChild<QLineEdit*>(QStringLiteral("search"));
    QTest::mouseClick(manual->windowHandle(), Qt::LeftButton, {}, search->mapTo(manual, search->rect().center()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return search->hasFocus(); }, patience));
    QTest::keyClick(manual->windowHandle(), Qt::Key_Z);
    EXPECT_EQ(search->text(), QStringLiteral("z"));
    QTest::keyClick(manual->windowHandle(), Qt::Key_Escape);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !manual->isVisible() && wizard().isActiveWindow(); }, patience));
    QTest::keyClick(&wizard(), Qt::Key_Escape);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().opening->caseInTheMaking() == nullptr; }, patience));
    ASSERT_NE(manual, nullptr) << "it stays when the wizard goes";
    EXPECT_EQ(manual->parentWidget(), window);
}

TEST_F(NewCases, CountEveryDeath) {
    begin();
    wizard().go(NewCaseWizard::Deaths);
    settle();
    const auto labels = wizard().deaths().findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text().startsWith(QStringLiteral("%1 of %2 elements are dead").arg(cli::smallDead).arg(cli::smallElements));
    }));
    EXPECT_EQ(making().preview().views().view().layout, render::Layout::FragmentsOnly);
}

TEST_F(NewCases, RegroupAndTakeItBack) {
    begin();
    wizard().go(NewCaseWizard::Components);
    const std::size_t before = components();
    QTreeWidget& tree = wizard().components().tree().tree();
    ASSERT_GT(tree.topLevelItemCount(), 0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !tree.topLevelItem(0)->child(0)->text(1).isEmpty(); }, 10'000))
        << "counted when it is seen";
    tree.setFocus();
    tree.selectAll();
    EXPECT_FALSE(making().preview().views().view().selection.empty()) << "the preview marks what is chosen";
    if (before > 1) {
        wizard().findChild<QPushButton*>(QStringLiteral("merge"))->click();
        QTest::keyClick(wizard().findChild<QLineEdit*>(QStringLiteral("newName")), Qt::Key_Return);
        ASSERT_TRUE(QTest::qWaitFor([&] { return making().settled() && components() == 1; }, patience));
        button(QStringLiteral("Undo"))->click();
        ASSERT_TRUE(QTest::qWaitFor([&] { return making().settled() && components() == before; }, patience));
    } else {
        wizard().findChild<QPushButton*>(QStringLiteral("split"))->click();
        wizard().components().form().findChild<QPushButton*>(QStringLiteral("primary"))->click();
        ASSERT_TRUE(QTest::qWaitFor([&] { return making().settled() && components() > 1; }, patience));
        button(QStringLiteral("Undo"))->click();
        ASSERT_TRUE(QTest::qWaitFor([&] { return making().settled() && components() == before; }, patience));
    }
}

TEST_F(NewCases, ReadAgainInOtherUnitsAndBack) {
    begin();
    auto* size = wizard().units().findChild<widgets::ParameterEditor*>(QStringLiteral("units"));
    ASSERT_NE(size, nullptr);
    const double height = making().preview().views().bounds().sizes().z();
    emit size->edited(QStringLiteral("units"), ParameterValue(std::string("t-mm-s")));
    settle();
    EXPECT_NEAR(making().preview().views().bounds().sizes().z(), height / 1000.0, 1e-6 * height);
    button(QStringLiteral("Undo"))->click();
    settle();
    EXPECT_NEAR(making().preview().views().bounds().sizes().z(), height, 1e-9 * height);
}

TEST_F(NewCases, AskBeforeTheyGoOnWithDensitiesOfNoMaterial) {
    begin();
    EXPECT_EQ(wizard().step(), NewCaseWizard::Units);
    auto* units = wizard().units().findChild<widgets::ParameterEditor*>(QStringLiteral("units"));
    emit units->edited(QStringLiteral("units"), ParameterValue(std::string("t-mm-s")));
    settle();
    QString said;
    const auto answer = [&](const QString& label) {
        whenAsked([&said, label](QDialog& dialog) {
            said = dynamic_cast<QMessageBox&>(dialog).text();
            for (auto* each : dialog.findChildren<QPushButton*>()) {
                if (each->text() == label) {
                    QTest::mouseClick(each, Qt::LeftButton);
                    return;
                }
            }
        });
    };
    answer(QStringLiteral("Back to the units"));
    QTest::mouseClick(button(QStringLiteral("&Next")), Qt::LeftButton);
    EXPECT_TRUE(said.contains(QStringLiteral("kg/m³"))) << said.toStdString();
    EXPECT_EQ(wizard().step(), NewCaseWizard::Units);
    answer(QStringLiteral("Go on all the same"));
    QTest::mouseClick(button(QStringLiteral("&Next")), Qt::LeftButton);
    EXPECT_EQ(wizard().step(), NewCaseWizard::Ground);
    QTest::mouseClick(button(QStringLiteral("&Next")), Qt::LeftButton);
    EXPECT_EQ(wizard().step(), NewCaseWizard::Components) << "it is asked once";
    button(QStringLiteral("Undo"))->click();
    settle();
    wizard().go(NewCaseWizard::Units);
    QTest::mouseClick(button(QStringLiteral("&Next")), Qt::LeftButton);
    EXPECT_EQ(wizard().step(), NewCaseWizard::Ground) << "masonry is nothing to ask about";
}

// Enter and Space press what has the focus, Escape leaves, letters and Ctrl with a digit go from step to step.
TEST_F(NewCases, AreMadeByKeyboardAlone) {
    begin();
    QTest::keyClick(&wizard(), Qt::Key_N, Qt::AltModifier);
    EXPECT_TRUE(reaches(NewCaseWizard::Ground));
    QTest::keyClick(&wizard(), Qt::Key_B, Qt::AltModifier);
    EXPECT_TRUE(reaches(NewCaseWizard::Units));
    QTest::keyClick(&wizard(), Qt::Key_4, Qt::ControlModifier);
    EXPECT_TRUE(reaches(NewCaseWizard::Deaths));
    button(QStringLiteral("&Next"))->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_TRUE(reaches(NewCaseWizard::Summary));
    EXPECT_FALSE(button(QStringLiteral("&Next"))->isEnabled());
    auto* title = wizard().findChild<QLineEdit*>(QStringLiteral("caseTitle"));
    title->setFocus();
    QTest::keyClick(title, Qt::Key_Return);
    EXPECT_NE(window->rooms().opening->caseInTheMaking(), nullptr) << "Enter in a field makes no case";
    settle();
    QTest::keyClick(&wizard(), Qt::Key_M, Qt::AltModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().opening->caseInTheMaking() == nullptr && prepared(); }, patience));
    EXPECT_EQ(session->document().theCase().title, "small");
    session->document().undoStack().setClean();
}

TEST_F(NewCases, TabGoesFromTheStepsThroughThePanelToTheButtons) {
    begin();
    for (const NewCaseWizard::Step step :
         {NewCaseWizard::Units, NewCaseWizard::Ground, NewCaseWizard::Components, NewCaseWizard::Deaths, NewCaseWizard::Summary}) {
        wizard().go(step);
        settle();
        wizard().findChildren<QToolButton*>().front()->setFocus();
        // Steps, panel, preview, buttons: each is entered once.
        QStringList parts;
        QWidget* first = QApplication::focusWidget();
        for (int i = 0; i < 200; ++i) {
            const QWidget* at = QApplication::focusWidget();
            ASSERT_TRUE(at != nullptr && at->isVisible() && at->window() == &wizard());
            const int y = at->mapTo(&wizard(), QPoint(0, 0)).y();
            const bool panel = wizard().panels()[static_cast<std::size_t>(step)]->isAncestorOf(at);
            const QString part = panel                                 ? QStringLiteral("panel")
                                 : making().preview().isAncestorOf(at) ? QStringLiteral("preview")
                                 : y < wizard().height() / 4           ? QStringLiteral("steps")
                                                                       : QStringLiteral("buttons");
            if (parts.isEmpty() || parts.back() != part) {
                parts << part;
            }
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            if (QApplication::focusWidget() == first) {
                break;
            }
        }
        EXPECT_EQ(QApplication::focusWidget(), first) << "step " << step << ": Tab comes round";
        EXPECT_EQ(parts.front(), QStringLiteral("steps"));
        EXPECT_EQ(parts.back(), QStringLiteral("buttons"));
        EXPECT_EQ(parts.removeDuplicates(), 0) << "step " << step << ": " << parts.join(u' ').toStdString();
        EXPECT_TRUE(parts.contains(QStringLiteral("panel"))) << "step " << step;
    }
    wizard().reject();
}

TEST_F(NewCases, EscapeLeavesAndTheWindowHasTheKeyboardAgain) {
    openArch();
    QTest::keyClick(window, Qt::Key_End);
    const double end = window->rooms().playback->clock().time();
    begin();
    wizard().findChildren<QToolButton*>().front()->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Home);
    EXPECT_DOUBLE_EQ(window->rooms().playback->clock().time(), end) << "Home in the wizard is none of the timeline's";
    QTest::keyClick(&wizard(), Qt::Key_Escape);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().opening->caseInTheMaking() == nullptr; }, patience));
    ASSERT_TRUE(QTest::qWaitForWindowActive(window, patience));
    QTest::keyClick(window, Qt::Key_Home);
    EXPECT_LT(window->rooms().playback->clock().time(), end);
}

TEST_F(NewCases, EscapeInAFieldLeavesTheFieldAndWhatWasChosenIsAskedAbout) {
    begin();
    wizard().go(widgets::NewCaseWizard::Summary);
    auto* title = wizard().summary().findChild<QLineEdit*>();
    ASSERT_NE(title, nullptr);
    title->setFocus();
    QTest::keyClicks(title, QStringLiteral("Bridge"));
    QTest::keyClick(title, Qt::Key_Escape);
    ASSERT_NE(window->rooms().opening->caseInTheMaking(), nullptr);
    EXPECT_FALSE(title->hasFocus());
    EXPECT_TRUE(title->text().endsWith(QStringLiteral("Bridge")));
    bool asked = false;
    whenAsked([&](QDialog& dialog) {
        asked = true;
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_TRUE(asked);
    ASSERT_NE(window->rooms().opening->caseInTheMaking(), nullptr) << "Esc in the question goes on";
    whenAsked([&](QDialog& dialog) {
        for (auto* each : dialog.findChildren<QPushButton*>()) {
            if (each->text().contains(QStringLiteral("Leave"))) {
                each->click();
                return;
            }
        }
        ADD_FAILURE() << "nothing leaves";
        dialog.reject();
    });
    for (auto* each : wizard().findChildren<QPushButton*>()) {
        if (each->isVisible() && each->text() == QStringLiteral("Cancel")) {
            QTest::mouseClick(each, Qt::LeftButton);
            break;
        }
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().opening->caseInTheMaking() == nullptr; }, patience));
}

TEST_F(NewCases, AreShownInTheThemeOfTheWindow) {
    begin();
    EXPECT_EQ(making().preview().views().view().theme, render::Theme::Light);
    window->setTheme(QStringLiteral("dark"));
    EXPECT_EQ(making().preview().views().view().theme, render::Theme::Dark);
    wizard().reject();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().opening->caseInTheMaking() == nullptr; }, patience));
    window->rooms().opening->newCase(fe);
    EXPECT_EQ(making().preview().views().view().theme, render::Theme::Dark) << "before the file is read";
    settle();
    EXPECT_EQ(making().preview().views().view().theme, render::Theme::Dark);
    wizard().reject();
    window->setTheme(QStringLiteral("light"));
}

TEST_F(NewCases, LeaveNothingWhenCancelled) {
    openArch();
    const Case before = session->document().theCase();
    begin();
    type(QStringLiteral("default_density"), QStringLiteral("2000"));
    wizard().reject();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().opening->caseInTheMaking() == nullptr; }, patience));
    EXPECT_EQ(session->document().theCase(), before);
    EXPECT_FALSE(session->document().modified());
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), QStringList(QStringLiteral("small.exo")));
}

TEST_F(NewCases, SayWhatIsWrongWithAFile) {
    QFile rubbish(folder.filePath(QStringLiteral("rubbish.exo")));
    ASSERT_TRUE(rubbish.open(QIODevice::WriteOnly));
    rubbish.write("no result at all");
    rubbish.close();
    window->rooms().opening->newCase(rubbish.fileName());
    ASSERT_TRUE(QTest::qWaitFor([&] { return making().settled(); }, patience));
    EXPECT_FALSE(button(QStringLiteral("&Make the case"))->isEnabled());
    const auto notices = wizard().units().findChildren<widgets::Notice*>();
    EXPECT_TRUE(std::any_of(notices.begin(), notices.end(),
                            [](const widgets::Notice* notice) { return notice->text().contains(QStringLiteral("rubbish.exo")); }));
    wizard().reject();
}

}  // namespace
}  // namespace rubble
