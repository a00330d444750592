#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QComboBox>
#include <QDialog>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QInputMethodEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <array>
#include <cstdio>
#include <random>

#include "app/gui/case/file_commands.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/complaints.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/run_tests.h"
#include "tests/support/small_collapse.h"
#include "widgets/views/timeline.h"

namespace rubble {

namespace {

#ifndef RUBBLE_WALK_LENGTH
#define RUBBLE_WALK_LENGTH sizedTo(100, 300)
#endif

int fromEnvironment(const char* name, int otherwise) {
    bool ok = false;
    const int value = qEnvironmentVariableIntValue(name, &ok);
    return ok ? value : otherwise;
}

/// A user without a plan: real events at random into the real window, from a seed. RUBBLE_WALK_STEPS and RUBBLE_WALK_SEED choose
/// another length and another walk, RUBBLE_WALK_TRACE names each step on standard error.
class RandomWalk : public Workbench {
protected:
    void SetUp() override {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        Workbench::SetUp();
        QSettings().clear();
        fe = QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString()));
        rubbish = folder.filePath(QStringLiteral("rubbish.exo"));
        QFile file(rubbish);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write("no result at all") > 0);
        // Menus and dialogs that wait for an answer get one, as their loops run inside the step that opened them. Queued, since a
        // timer rests while its slot runs, and an answer may bring up the next question.
        // Not to the window: another language makes another one.
        QObject::connect(&answers, &QTimer::timeout, &answers, [this] { answer(); }, Qt::QueuedConnection);
        answers.start(40);
    }
    void TearDown() override {
        answers.stop();
        session->computation().cancel();
        session->document().undoStack().setClean();
    }

    int below(int n) { return n > 0 ? static_cast<int>(random() % static_cast<unsigned>(n)) : 0; }
    QPoint placeIn(const QWidget& widget) { return {below(std::max(1, widget.width())), below(std::max(1, widget.height()))}; }

    void answer() {
        QWidget* modal = QApplication::activeModalWidget();
        if (auto* popup = QApplication::activePopupWidget(); popup != nullptr && (modal == nullptr || popupSteps++ < 4)) {
            // Also in the loop of the menu of a button.
            QTest::keyClick(popup, Qt::Key_Escape);
            return;
        }
        popupSteps = 0;
        if (modal == nullptr) {
            return;
        }
        if (auto* message = qobject_cast<QMessageBox*>(modal)) {
            const auto buttons = message->buttons();
            QTest::mouseClick(buttons[below(static_cast<int>(buttons.size()))], Qt::LeftButton);
        } else if (auto* file = qobject_cast<QFileDialog*>(modal); file != nullptr && below(2) == 0) {
            auto* name = file->findChild<QLineEdit*>();
            const bool saves = file->acceptMode() == QFileDialog::AcceptSave;
            const QString target = saves ? folder.filePath(QStringLiteral("walk-%1").arg(below(4))) : fe;
            name->setText(target);
            QTest::keyClick(name, Qt::Key_Return);
            if (QApplication::activeModalWidget() == file) {
                file->reject();
            }
        } else if (dialogSteps++ > 12) {
            dialogSteps = 0;
            QTest::keyClick(modal, Qt::Key_Escape);
        }
    }

    /// Windows that take part, and what of them can be reached.
    QWidget* anyWindow() {
        QList<QWidget*> all;
        for (QWidget* each : QApplication::topLevelWidgets()) {
            if (each->isVisible() && each->isEnabled() && each->windowType() != Qt::Popup && each->windowType() != Qt::ToolTip) {
                all << each;
            }
        }
        if (QWidget* modal = QApplication::activeModalWidget()) {
            return modal;
        }
        return all.isEmpty() ? window : below(3) != 0 ? window : all[below(static_cast<int>(all.size()))];
    }
    template <typename Kind>
    Kind* any(QWidget& root) {
        QList<Kind*> all;
        for (auto* each : root.findChildren<Kind*>()) {
            if (each->isVisible() && each->isEnabled() && each->window() == &root && !tabu(each->objectName())) {
                all << each;
            }
        }
        return all.isEmpty() ? nullptr : all[below(static_cast<int>(all.size()))];
    }
    /// Minutes of work behind one click are no step of a walk.
    static bool tabu(const QString& name) {
        return name == QLatin1String("calibrate") || name == QLatin1String("computeReference") || name == QLatin1String("quit") ||
               name == QLatin1String("sample") || name == QLatin1String("live") || name == QLatin1String("tour");
    }

    void pressKeyOfAction() {
        const auto table = actionTable();
        const ActionRow& row = table[static_cast<std::size_t>(below(static_cast<int>(table.size())))];
        if (std::string_view(row.key).empty() || tabu(QLatin1String(row.name))) {
            return;
        }
        pressKey(row.id);
    }
    void pressKey(ActionId id) {
        const ActionRow& row = actionTable()[static_cast<std::size_t>(id)];
        const QKeySequence keys = QKeySequence::fromString(QLatin1String(row.key), QKeySequence::PortableText);
        QTest::keyClick(window, static_cast<Qt::Key>(keys[0].key()), keys[0].keyboardModifiers());
    }
    void chooseInMenu() {
        const QList<QAction*> menus = window->menuBar()->actions();
        QMenu* menu = menus[below(static_cast<int>(menus.size()))]->menu();
        const QList<QAction*> entries = menu->actions();
        QAction* entry = entries[below(static_cast<int>(entries.size()))];
        if (entry->isSeparator() || !entry->isEnabled() || tabu(entry->objectName())) {
            return;
        }
        menu->popup(window->mapToGlobal(QPoint(40, 40)));
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
        menu->hide();
    }
    void clickAButton() {
        if (auto* button = any<QAbstractButton>(*anyWindow())) {
            QTest::mouseClick(button, Qt::LeftButton);
        }
    }
    /// What no key of a keyboard says comes from an input method.
    static void typeOne(QLineEdit& field, QChar c) {
        if (c.unicode() < 0x80) {
            QTest::keyClick(&field, c.toLatin1());
        } else {
            QInputMethodEvent written;
            written.setCommitString(c);
            QApplication::sendEvent(&field, &written);
        }
    }
    void typeInAField() {
        static const std::array texts{"",     "0",   "1",     "-3",   "2.5",  "1e9",    "nan",    "abc",   "0,5",
                                      "deck", "  7", "../..", "1e-4", "auto", "x;y=z=", "\"%1\"", "混凝土"};
        if (auto* field = any<QLineEdit>(*anyWindow())) {
            field->setFocus();
            QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
            const QString text = QString::fromUtf8(texts[static_cast<std::size_t>(below(static_cast<int>(texts.size())))]);
            if (text.isEmpty()) {
                QTest::keyClick(field, Qt::Key_Delete);
            }
            for (const QChar c : text) {
                typeOne(*field, c);
            }
            QTest::keyClick(field, below(3) != 0 ? Qt::Key_Return : Qt::Key_Tab);
        }
    }
    void turnAChoice() {
        static const std::array keys{Qt::Key_Down, Qt::Key_Up, Qt::Key_Home, Qt::Key_End, Qt::Key_PageDown};
        if (auto* box = any<QComboBox>(*anyWindow()); box != nullptr && below(2) == 0) {
            box->setFocus();
            QTest::keyClick(box, keys[static_cast<std::size_t>(below(4))]);
        } else if (auto* slider = any<QAbstractSlider>(*anyWindow())) {
            QTest::keyClick(slider, keys[static_cast<std::size_t>(below(5))]);
        }
    }
    void clickInAList() {
        if (auto* list = any<QAbstractItemView>(*anyWindow())) {
            const Qt::KeyboardModifiers held = below(3) == 0 ? Qt::ControlModifier : Qt::NoModifier;
            QTest::mouseClick(list->viewport(), Qt::LeftButton, held, placeIn(*list->viewport()));
            if (below(4) == 0) {
                QTest::keyClick(list, std::array{Qt::Key_Return, Qt::Key_Delete, Qt::Key_F2, Qt::Key_Space}[below(4)]);
            }
        }
    }
    void dragIn(QWidget& widget) {
        static const std::array held{Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier};
        const Qt::KeyboardModifiers modifiers = held[static_cast<std::size_t>(below(3))];
        const Qt::MouseButton button = below(5) == 0 ? Qt::MiddleButton : Qt::LeftButton;
        QTest::mousePress(&widget, button, modifiers, placeIn(widget));
        for (int i = below(4); i > 0; --i) {
            const QPointF to = placeIn(widget);
            QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, button, modifiers);
            QApplication::sendEvent(&widget, &move);
        }
        QTest::mouseRelease(&widget, button, modifiers, placeIn(widget));
    }
    void moveInTheViews() {
        widgets::ViewWidget& views = window->area().views();
        if (!views.isVisible()) {
            return;
        }
        switch (below(4)) {
            case 0:
                QTest::mouseDClick(&views, Qt::LeftButton, {}, placeIn(views));
                break;
            case 1: {
                const QPointF at = placeIn(views);
                QWheelEvent wheel(at, views.mapToGlobal(at), {}, {0, below(2) == 0 ? 120 : -120}, Qt::NoButton, Qt::NoModifier,
                                  Qt::NoScrollPhase, false);
                QApplication::sendEvent(&views, &wheel);
                break;
            }
            case 2:
                QTest::mouseClick(&views, Qt::LeftButton, below(3) == 0 ? Qt::ControlModifier : Qt::NoModifier, placeIn(views));
                break;
            default:
                dragIn(views);
        }
    }
    void scrub() { dragIn((*window->findChild<widgets::Timeline*>())); }
    void leaveOrGoOn() { QTest::keyClick(window, below(2) == 0 ? Qt::Key_Escape : Qt::Key_Tab); }
    void changeTheWindow() {
        static const std::array sizes{QSize(1280, 800), QSize(1600, 900), QSize(1920, 1080), QSize(1300, 820)};
        window->resize(sizes[static_cast<std::size_t>(below(4))]);
    }
    /// A result, a case, what is no result, what is not there.
    void dropAFile() {
        const QStringList files{fe, folder.filePath(QStringLiteral("walk.rubble")), rubbish,
                                folder.filePath(QStringLiteral("gone.exo"))};
        QMimeData dropped;
        dropped.setUrls({QUrl::fromLocalFile(files[below(3) != 0 ? 0 : below(4)])});
        const QPoint at = placeIn(*window);
        QDragEnterEvent enter(at, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window, &enter);
        if (enter.isAccepted() && QApplication::activeModalWidget() == nullptr && QApplication::activePopupWidget() == nullptr) {
            QDropEvent drop(at, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(window, &drop);
        }
    }
    void save() {
        if (!session->document().empty() && QApplication::activeModalWidget() == nullptr) {
            window->rooms().files->saveTo(folder.filePath(QStringLiteral("walk.rubble")));
        }
    }
    /// Language, theme, colours or units.
    void changePreferences() {
        pressKey(ActionId::Preferences);
        if (auto* dialog = window->findChild<widgets::PreferencesDialog*>(); dialog != nullptr && dialog->isVisible()) {
            const auto boxes = dialog->findChildren<QComboBox*>();
            QComboBox* box = boxes[below(static_cast<int>(boxes.size()))];
            box->setFocus();
            QTest::keyClick(box, below(2) == 0 ? Qt::Key_Down : Qt::Key_Up);
        }
    }
    struct Kind {
        const char* name;
        int weight;
        void (RandomWalk::*act)();
    };
    void step(int number) {
        static constexpr std::array kinds{Kind{"key of an action", 20, &RandomWalk::pressKeyOfAction},
                                          Kind{"menu", 14, &RandomWalk::chooseInMenu},
                                          Kind{"button", 16, &RandomWalk::clickAButton},
                                          Kind{"typing", 8, &RandomWalk::typeInAField},
                                          Kind{"choice or slider", 8, &RandomWalk::turnAChoice},
                                          Kind{"list", 8, &RandomWalk::clickInAList},
                                          Kind{"views", 8, &RandomWalk::moveInTheViews},
                                          Kind{"timeline", 6, &RandomWalk::scrub},
                                          Kind{"size of the window", 2, &RandomWalk::changeTheWindow},
                                          Kind{"preferences", 2, &RandomWalk::changePreferences},
                                          Kind{"drop", 3, &RandomWalk::dropAFile},
                                          Kind{"save", 2, &RandomWalk::save},
                                          Kind{"Escape or Tab", 3, &RandomWalk::leaveOrGoOn}};
        int which = below(100);
        const Kind* kind = kinds.data();
        while (which >= kind->weight) {
            which -= kind->weight;
            ++kind;
        }
        if (traced) {
            std::fprintf(stderr, "%d %s\n", number, kind->name);
        }
        (this->*kind->act)();
        QTest::qWait(below(8) == 0 ? 60 : 1);
        if (!window->isVisible()) {
            window->show();
        }
    }

    QTemporaryDir folder;
    QString fe;
    QString rubbish;
    QTimer answers;
    std::mt19937 random;
    int dialogSteps = 0;
    int popupSteps = 0;
    const bool traced = qEnvironmentVariableIsSet("RUBBLE_WALK_TRACE");
};

TEST_F(RandomWalk, HarmsNothing) {
    const int steps = fromEnvironment("RUBBLE_WALK_STEPS", RUBBLE_WALK_LENGTH);
    const int seed = fromEnvironment("RUBBLE_WALK_SEED", 6);
    random.seed(static_cast<unsigned>(seed));
    const Complaints complaints;
    window->open(fe);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    for (int i = 0; i < steps; ++i) {
        step(i);
        ASSERT_TRUE(Complaints::all().isEmpty())
            << "step " << i << ", seed " << seed << ": " << Complaints::all().front().toStdString();
    }
    // The window still does its work after all of that.
    for (QWidget* each : QApplication::topLevelWidgets()) {
        if (each != window && each->isVisible()) {
            each->close();
        }
    }
    session->computation().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    session->document().undoStack().setClean();
    window->open(fe);
    EXPECT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    RecordProperty("steps", steps);
}

}  // namespace
}  // namespace rubble
