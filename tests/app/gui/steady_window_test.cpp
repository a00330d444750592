#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QSlider>
#include <QTableWidget>
#include <QTest>
#include <QUndoStack>
#include <QWheelEvent>
#include <map>
#include <string>
#include <vector>

#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/case/preferences_dialog.h"
#include "widgets/views/transport.h"

namespace rubble {

namespace {

/// One notch of the wheel over a widget, as the window system has it delivered.
void turnWheel(QWidget& over, int delta = -120) {
    const QPointF at = over.rect().center();
    QWheelEvent event(at, over.mapToGlobal(at), QPoint(), QPoint(0, delta), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    // Only such events give the focus and go on to parents.
    QSpontaneKeyEvent::setSpontaneous(&event);
    QCoreApplication::instance()->notify(&over, &event);
}

std::vector<QWidget*> whatTheWheelCouldChange(const QWidget& within) {
    std::vector<QWidget*> all;
    for (auto* each : within.findChildren<QWidget*>()) {
        const bool slides = qobject_cast<QSlider*>(each) != nullptr;
        if (each->isVisible() && each->isEnabled() &&
            (slides || qobject_cast<QComboBox*>(each) != nullptr || qobject_cast<QAbstractSpinBox*>(each) != nullptr)) {
            all.push_back(each);
        }
    }
    return all;
}

QString stateOf(const QWidget& widget) {
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        return box->currentText();
    }
    if (const auto* slider = qobject_cast<const QSlider*>(&widget)) {
        return QString::number(slider->value());
    }
    const auto* spin = qobject_cast<const QAbstractSpinBox*>(&widget);
    return spin != nullptr ? spin->text() : QString();
}

/// Where everything stands that can be clicked or typed into. Remedies go with their sentences, which stand below all of it.
std::map<QWidget*, QPoint> placesIn(const QWidget& window) {
    std::map<QWidget*, QPoint> places;
    for (auto* each : window.findChildren<QWidget*>()) {
        const bool control = qobject_cast<QAbstractButton*>(each) != nullptr || qobject_cast<QComboBox*>(each) != nullptr ||
                             qobject_cast<QLineEdit*>(each) != nullptr || qobject_cast<QSlider*>(each) != nullptr;
        if (control && each->isVisible() && each->objectName() != QLatin1String("applyRemedy")) {
            places[each] = each->mapTo(&window, QPoint(0, 0));
        }
    }
    return places;
}

QString nameOf(const QWidget& widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    return QStringLiteral("%1 %2 %3")
        .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(),
             button != nullptr ? button->text() : widget.accessibleName());
}

}  // namespace

/// A workbench in which the arch is open, and what its tests ask for.
class SteadyWindow : public Workbench {
protected:
    static constexpr std::array entries{PanelDeck::Case, PanelDeck::Fragments, PanelDeck::Grid,     PanelDeck::Effects,
                                        PanelDeck::Run,  PanelDeck::Accuracy,  PanelDeck::Evidence, PanelDeck::Report};

    void SetUp() override {
        Workbench::SetUp();
        openArch();
    }
    void TearDown() override {
        session->document().undoStack().setClean();
        session->computation().cancel();
        endProgram();
    }
    /// Clicks an entry of the rail.
    void clickPanel(PanelDeck::Entry entry) {
        const auto buttons = window->rooms().deck->rail().findChildren<QAbstractButton*>();
        QTest::mouseClick(buttons.at(entry), Qt::LeftButton);
        ASSERT_EQ(window->rooms().deck->rail().current(), entry);
    }
    QLineEdit* fieldOf(const char* key) {
        auto* editor = window->findChild<widgets::ParameterEditor*>(QLatin1String(key));
        return editor != nullptr ? editor->findChild<QLineEdit*>() : nullptr;
    }
    /// Keys go where the window system sends them: to what has the focus.
    void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : window, key); }
    bool playing() { return window->rooms().playback->clock().playing(); }
    render::Layout layout() { return window->area().views().view().layout; }
    void startLongRun() {
        session->document().setParameter(QStringLiteral("settle_time"), 20.0);
        window->rooms().runs->simulate(false);
        ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().simulating(); }, patience));
    }
};

TEST_F(SteadyWindow, TheWheelScrollsAndChangesNothing) {
    std::size_t tried = 0;
    const Scenario before = session->document().scenario();
    for (const PanelDeck::Entry entry : entries) {
        clickPanel(entry);
        for (QWidget* each : whatTheWheelCouldChange(*window)) {
            const QString state = stateOf(*each);
            turnWheel(*each);
            turnWheel(*each, 120);
            turnWheel(*each, 120);
            EXPECT_EQ(stateOf(*each), state) << qPrintable(nameOf(*each));
            EXPECT_FALSE(each->hasFocus());
            ++tried;
        }
    }
    EXPECT_GT(tried, 30U);
    EXPECT_EQ(session->document().scenario(), before);
    EXPECT_FALSE(session->document().undoStack().canUndo());
    // A box in a panel that can be scrolled lets it scroll.
    clickPanel(PanelDeck::Run);
    auto* panel = qobject_cast<QScrollArea*>(window->rooms().deck->stack().currentWidget());
    auto* solver = panel->findChild<QComboBox*>();
    ASSERT_NE(solver, nullptr);
    turnWheel(*solver);
    EXPECT_GT(panel->verticalScrollBar()->value(), 0);
}

TEST_F(SteadyWindow, TheWheelChangesWhatHasTheFocus) {
    clickPanel(PanelDeck::Case);
    auto* box = window->findChild<QComboBox*>(QStringLiteral("colourBy"));
    const int before = box->currentIndex();
    box->setFocus();
    turnWheel(*box);
    EXPECT_EQ(box->currentIndex(), before + 1);
    // What scrolls past a box that has the focus is scrolled on.
    clickPanel(PanelDeck::Run);
    auto* panel = qobject_cast<QScrollArea*>(window->rooms().deck->stack().currentWidget());
    auto* solver = panel->findChild<QComboBox*>();
    const QString chosen = solver->currentText();
    solver->setFocus();
    turnWheel(*panel->viewport());
    turnWheel(*solver);
    EXPECT_EQ(solver->currentText(), chosen);
}

TEST_F(SteadyWindow, TheWheelChangesNothingInDialogs) {
    window->showPreferences();
    auto* dialog = window->findChild<widgets::PreferencesDialog*>();
    ASSERT_NE(dialog, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowActive(dialog, patience));
    // As a window manager has it, and as the dialog begins.
    QApplication::setActiveWindow(dialog);
    dialog->findChild<QComboBox*>(QStringLiteral("language"))->setFocus();
    const auto boxes = whatTheWheelCouldChange(*dialog);
    EXPECT_GE(boxes.size(), 7U);
    const widgets::Preferences before = session->preferences();
    bool focused = false;
    for (QWidget* each : boxes) {
        focused = focused || each->hasFocus();
        turnWheel(*each);
    }
    EXPECT_TRUE(focused);
    EXPECT_EQ(session->preferences(), before);
    // Once a key was pressed there, the focus is meant.
    auto* theme = dialog->findChild<QComboBox*>(QStringLiteral("theme"));
    ASSERT_NE(theme, nullptr);
    const int at = theme->currentIndex();
    QTest::keyClick(dialog->focusWidget(), Qt::Key_Shift);
    theme->setFocus();
    turnWheel(*theme, at == 0 ? -120 : 120);
    EXPECT_NE(theme->currentIndex(), at);
}

TEST_F(SteadyWindow, SpacePlaysAfterOpeningAfterEveryPanelAndAfterAClick) {
    press(Qt::Key_Space);
    EXPECT_TRUE(playing()) << "after opening";
    press(Qt::Key_Space);
    EXPECT_FALSE(playing());
    for (const PanelDeck::Entry entry : entries) {
        clickPanel(entry);
        press(Qt::Key_Space);
        EXPECT_TRUE(playing()) << "panel " << entry << ", focus " << qPrintable(nameOf(*QApplication::focusWidget()));
        press(Qt::Key_Space);
        EXPECT_FALSE(playing());
        EXPECT_EQ(window->rooms().deck->rail().current(), entry);
    }
    // From a field of one panel to another panel.
    clickPanel(PanelDeck::Run);
    QTest::mouseClick(fieldOf("settle_time"), Qt::LeftButton);
    clickPanel(PanelDeck::Grid);
    press(Qt::Key_Space);
    EXPECT_TRUE(playing());
    press(Qt::Key_Space);
    // A switch that was clicked is not pushed again.
    auto* box = window->rooms().deck->stack().currentWidget()->findChild<QCheckBox*>();
    ASSERT_NE(box, nullptr);
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    const bool checked = box->isChecked();
    press(Qt::Key_Space);
    EXPECT_EQ(box->isChecked(), checked);
    EXPECT_TRUE(playing());
    // Who works by keys pushes it.
    press(Qt::Key_Space);
    window->setFocus();
    box->setFocus(Qt::TabFocusReason);
    press(Qt::Key_Space);
    EXPECT_NE(box->isChecked(), checked);
    EXPECT_FALSE(playing());
}

TEST_F(SteadyWindow, NumbersTypedBesideAFieldDoNothing) {
    clickPanel(PanelDeck::Run);
    press(Qt::Key_2);
    EXPECT_EQ(layout(), render::Layout::Beside) << "no field has the focus";
    QLineEdit* field = fieldOf("gravity");
    auto* group = field->parentWidget()->parentWidget();
    QTest::mouseClick(group, Qt::LeftButton, {}, QPoint(4, field->parentWidget()->y() + 4));
    for (const Qt::Key key : {Qt::Key_1, Qt::Key_3, Qt::Key_Period, Qt::Key_4, Qt::Key_Minus}) {
        press(key);
    }
    EXPECT_EQ(layout(), render::Layout::Beside);
    QTest::mouseClick(field, Qt::LeftButton);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("3"));
    EXPECT_EQ(field->text(), QStringLiteral("3"));
    EXPECT_EQ(layout(), render::Layout::Beside);
    // Back in the views they are the window's again.
    QTest::mouseClick(&window->area().views(), Qt::LeftButton);
    press(Qt::Key_1);
    EXPECT_EQ(layout(), render::Layout::Stacked);
}

TEST_F(SteadyWindow, SentencesTypedBesideAFieldDoNothing) {
    clickPanel(PanelDeck::Run);
    QLineEdit* field = fieldOf("gravity");
    auto* group = field->parentWidget()->parentWidget();
    QTest::mouseClick(group, Qt::LeftButton, {}, QPoint(4, field->parentWidget()->y() + 4));
    const auto docks = [&] {
        std::vector<bool> shown;
        for (const auto* dock : window->findChildren<QDockWidget*>()) {
            shown.push_back(dock->isVisible());
        }
        return shown;
    };
    const auto typed = [&](const char* sentence) {
        const render::View view = window->area().views().view();
        const std::vector<bool> before = docks();
        for (const char character : std::string(sentence)) {
            QTest::keyClick(QApplication::focusWidget(), character);
            EXPECT_FALSE(playing()) << character;
        }
        EXPECT_EQ(window->area().views().view(), view) << sentence;
        EXPECT_EQ(docks(), before) << sentence;
        EXPECT_EQ(window->area().views().tool(), widgets::ViewWidget::Tool::Select) << sentence;
        EXPECT_EQ(QApplication::activePopupWidget(), nullptr) << sentence;
        EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << sentence;
    };
    typed("The pier, 2 m thick, came last but one");
    // Shift is held too long, or is pressed alone.
    for (const Qt::KeyboardModifiers held : {Qt::ShiftModifier, Qt::NoModifier}) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ShiftModifier);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Shift);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space, held);
        EXPECT_FALSE(playing()) << held.toInt();
    }
    // Nor do they choose in a list that was clicked.
    auto* solver = window->rooms().deck->stack().currentWidget()->findChild<QComboBox*>();
    ASSERT_NE(solver, nullptr);
    solver->setFocus(Qt::MouseFocusReason);
    const QString chosen = solver->currentText();
    typed("first soft sand below it");
    EXPECT_EQ(solver->currentText(), chosen);
    // The next space is no part of a sentence.
    press(Qt::Key_Space);
    press(Qt::Key_Space);
    EXPECT_TRUE(playing());
    press(Qt::Key_Space);
    // In the views letters are the window's.
    QTest::mouseClick(&window->area().views(), Qt::LeftButton);
    press(Qt::Key_C);
    EXPECT_TRUE(window->area().views().view().clip.has_value());
    // However a closed list was reached: Home and End are those of the timeline.
    for (const Qt::FocusReason reason : {Qt::MouseFocusReason, Qt::TabFocusReason}) {
        solver->clearFocus();
        solver->setFocus(reason);
        QTest::keyClick(solver, Qt::Key_B);
        QTest::keyClick(solver, Qt::Key_End);
        EXPECT_EQ(solver->currentText(), chosen) << reason;
    }
}

TEST_F(SteadyWindow, WhatIsTypedIntoTheEditorOfATableStaysInIt) {
    clickPanel(PanelDeck::Case);
    QWidget& panel = *window->rooms().deck->stack().currentWidget();
    const auto typed = [&](const QString& words) {
        auto* editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        ASSERT_NE(editor, nullptr);
        editor->selectAll();
        const render::View view = window->area().views().view();
        for (const QChar character : words) {
            QTest::keyClick(QApplication::focusWidget(), character.toLatin1());
        }
        EXPECT_EQ(editor->text(), words);
        EXPECT_EQ(QApplication::focusWidget(), editor);
        EXPECT_EQ(window->area().views().view(), view);
        EXPECT_EQ(window->area().views().tool(), widgets::ViewWidget::Tool::Select);
        EXPECT_FALSE(playing());
        EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
        QTest::keyClick(editor, Qt::Key_Escape);
    };
    QTableWidget* table = nullptr;
    for (auto* each : panel.findChildren<QTableWidget*>()) {
        table = each->accessibleName() == QLatin1String("Components") ? each : table;
    }
    ASSERT_NE(table, nullptr);
    QTableWidgetItem* density = table->item(0, table->columnCount() - 1);
    qobject_cast<widgets::Panel*>(&panel)->ensureWidgetVisible(table);
    table->scrollToItem(density);
    table->setFocus();
    table->setCurrentItem(density);
    table->editItem(density);
    typed(QStringLiteral("24131"));
    table->editItem(density);
    typed(QStringLiteral("fcmq 4 L"));
    auto* list = panel.findChild<QListWidget*>(QStringLiteral("scenarioList"));
    ASSERT_NE(list, nullptr);
    list->setFocus();
    list->editItem(list->item(0));
    typed(QStringLiteral("pier 2 fell first, Cam 1"));
}

TEST_F(SteadyWindow, EscLeavesAFieldAsItWas) {
    clickPanel(PanelDeck::Run);
    startLongRun();
    QLineEdit* field = fieldOf("gravity");
    const double gravity = session->document().scenario().simulation.gravity;
    const QString before = field->text();
    QTest::mouseClick(field, Qt::LeftButton);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("3"));
    press(Qt::Key_Escape);
    EXPECT_EQ(field->text(), before);
    EXPECT_FALSE(field->hasFocus());
    EXPECT_EQ(session->document().scenario().simulation.gravity, gravity);
    EXPECT_TRUE(session->computation().simulating());
    press(Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience)) << "nothing else is open";
}

TEST_F(SteadyWindow, EscLeavesWordsAsTheyWereTyped) {
    clickPanel(PanelDeck::Report);
    auto* author = window->findChild<QLineEdit*>(QStringLiteral("reportAuthor"));
    ASSERT_NE(author, nullptr);
    author->setFocus();
    QTest::keyClicks(author, QStringLiteral("A. Miller"));
    press(Qt::Key_Escape);
    EXPECT_FALSE(author->hasFocus());
    EXPECT_EQ(author->text(), QStringLiteral("A. Miller")) << "it counted already, without Enter";
}

TEST_F(SteadyWindow, EscClosesWhatIsOpenBeforeItCancels) {
    makeCheap();
    startLongRun();
    window->actions()[ActionId::Clip].trigger();
    window->actions()[ActionId::MeasureDistance].trigger();
    ASSERT_TRUE(window->area().views().view().clip.has_value());
    clickPanel(PanelDeck::Grid);
    press(Qt::Key_Escape);
    EXPECT_EQ(window->area().views().tool(), widgets::ViewWidget::Tool::Select);
    EXPECT_TRUE(window->area().views().view().clip.has_value());
    press(Qt::Key_Escape);
    EXPECT_FALSE(window->area().views().view().clip.has_value());
    // The Inspector floats at this size.
    window->actions()[ActionId::Inspector].trigger();
    auto* inspector = window->findChild<QDockWidget*>(QStringLiteral("inspectorDock"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return inspector->isVisible() && inspector->isFloating(); }, patience));
    press(Qt::Key_Escape);
    EXPECT_FALSE(inspector->isVisible());
    EXPECT_TRUE(session->computation().simulating());
    press(Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
}

TEST_F(SteadyWindow, ControlsStandStillWhileSettingsAreTyped) {
    clickPanel(PanelDeck::Grid);
    for (const auto& [key, typed] : {std::pair("multiple", "12"), std::pair("grid_l", "5"), std::pair("fps_target", "many")}) {
        QLineEdit* field = fieldOf(key);
        ASSERT_NE(field, nullptr) << key;
        qobject_cast<QScrollArea*>(window->rooms().deck->stack().currentWidget())->ensureWidgetVisible(field);
        QTest::qWait(50);
        const auto before = placesIn(*window);
        QTest::mouseClick(field, Qt::LeftButton);
        field->selectAll();
        QTest::keyClicks(field, QLatin1String(typed));
        press(Qt::Key_Return);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        QTest::qWait(100);
        for (const auto& [control, place] : placesIn(*window)) {
            const auto was = before.find(control);
            EXPECT_TRUE(was == before.end() || was->second == place) << key << ": " << qPrintable(nameOf(*control));
        }
    }
    const auto* complaint = window->rooms().deck->stack().currentWidget()->findChild<QLabel*>(QStringLiteral("complaint"));
    EXPECT_NE(complaint, nullptr);
}

TEST_F(SteadyWindow, WhatIsUnderTheMouseStaysThereWhileARunEnds) {
    makeCheap();
    clickPanel(PanelDeck::Run);
    QLineEdit* field = fieldOf("settle_time");
    auto* panel = qobject_cast<QScrollArea*>(window->rooms().deck->stack().currentWidget());
    panel->ensureWidgetVisible(field);
    const auto* cancel = window->findChild<QPushButton*>(QStringLiteral("cancel"));
    QTest::mouseMove(field);
    QTest::qWait(100);
    const auto place = [&] { return field->mapTo(window, QPoint(0, 0)); };
    const QPoint before = place();
    window->rooms().runs->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().simulating(); }, patience));
    const QPoint cancelAt = cancel->mapTo(window, QPoint(0, 0));
    awaitRun();
    EXPECT_EQ(cancel->mapTo(window, QPoint(0, 0)), cancelAt);
    EXPECT_TRUE(QTest::qWaitFor([&] { return place() == before; }, 5000)) << place().y() << ", was " << before.y();
    session->document().setParameter(QStringLiteral("friction"), 0.7);
    QTest::qWait(200);
    EXPECT_EQ(place(), before) << "stale";
}

}  // namespace rubble
