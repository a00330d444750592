#include <gtest/gtest.h>

#include <QDockWidget>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <array>
#include <fstream>
#include <functional>
#include <memory>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/new_case.h"
#include "app/gui/evidence/cloud_points.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/inspection.h"
#include "app/gui/views/selection_display.h"
#include "tests/app/gui/legibility.h"
#include "tests/app/gui/spoken_texts.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/level_table.h"
#include "tests/support/temporary_folder.h"
#include "widgets/basics/language.h"
#include "widgets/case/new_case_wizard.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/evidence/survey_place.h"
#include "widgets/evidence/surveys/distance_fields.h"
#include "widgets/evidence/surveys/point_box.h"
#include "widgets/evidence/surveys/scanner_field.h"
#include "widgets/views/tour.h"

namespace rubble {

namespace {

/// Every screen, in both languages and at the sizes that the window is made for: what stands on it can be read whole.
/// RUBBLE_TAKE_SCREENS names a folder for pictures of all of them, in both themes, to be looked at.
class Screens : public FreshWorkbench {
protected:
    /// Does the same in each language. The window is another one in another language.
    void inEachLanguage(const std::function<void()>& walk) {
        for (const char* language : {"en", "zh_CN"}) {
            renewed->speak(QLatin1String(language));
            walk();
        }
    }
    /// Looks at one screen in the language that is spoken, at every size and in every theme.
    void look(const QString& name, const std::function<QWidget*()>& screen) {
        static const std::array sizes{QSize(1280, 800), QSize(1920, 1080), QSize(3840, 2160)};
        static const QString folder = qEnvironmentVariable("RUBBLE_TAKE_SCREENS");
        const QString language = widgets::currentLanguage();
        for (const QSize& size : sizes) {
            if (folder.isEmpty() && size != sizes[0]) {
                continue;  // what fits into the smallest window fits into larger ones
            }
            window->resize(size);
            QTest::qWait(100);
            ASSERT_NE(screen(), nullptr) << name.toStdString();
            const QString where = QStringLiteral("%1-%2-%3").arg(name, language).arg(size.width());
            // What comes at any time (what a cluster answers) gets its room within the events that follow.
            QStringList illegible;
            (void)QTest::qWaitFor(
                [&] {
                    illegible = illegibleIn(*screen());
                    return illegible.isEmpty();
                },
                1000);
            for (const QString& each : illegible) {
                ADD_FAILURE() << where.toStdString() << ": " << each.toStdString();
            }
            if (widgets::currentLanguage() != QLatin1String("en")) {
                askForEnglish(where, *screen());
            }
            for (const char* theme : {"light", "dark"}) {
                if (!folder.isEmpty()) {
                    window->setTheme(QLatin1String(theme));
                    keep(*screen(), QStringLiteral("%1/%2-%3.png").arg(folder, where, QLatin1String(theme)));
                }
            }
        }
    }
    void askForEnglish(const QString& where, QWidget& screen) {
        NewCase* making = window->rooms().opening->caseInTheMaking();
        const auto& fe = (making != nullptr ? making->computation() : session->computation()).inputs().fe;
        for (const auto& [place, text] : textsOf(screen)) {
            EXPECT_TRUE(strangeWords(text, namesIn(fe.get())).isEmpty())
                << qPrintable(where) << ", " << qPrintable(place) << ": " << qPrintable(text);
        }
    }
    static void keep(QWidget& shown, const QString& path) {
        QTest::qWait(150);
        ASSERT_TRUE(pictureOf(shown).save(path)) << path.toStdString();
    }
    void lookAtPanels(const QString& prefix) {
        static constexpr std::array panels{"case",     "fragments", "grid",   "effects",  "run",
                                           "accuracy", "evidence",  "report", "ensemble", "causes"};
        for (int i = 0; i < static_cast<int>(panels.size()); ++i) {
            window->rooms().deck->choosePage(i);
            look(prefix + QLatin1String(panels[static_cast<std::size_t>(i)]), [this] { return window; });
        }
        window->rooms().deck->choosePage(0);
    }
    void simulated() {
        openArch();
        makeCheap();
        simulateToEnd();
        window->rooms().playback->showInstant(0.6 * window->rooms().playback->clock().last());
    }
    void lookAtRun() {
        lookAtPanels({});
        window->rooms().inspection->selection().select({window->area().views().data().fragments->list.front().element});
        look(QStringLiteral("inspector"), [this]() -> QWidget* {
            auto* inspector = window->findChild<QDockWidget*>(QStringLiteral("inspectorDock"));
            if (inspector->isFloating()) {
                return inspector;
            }
            return window;
        });
        window->actions()[ActionId::SelectNone].trigger();
        for (const ActionId id :
             {ActionId::Components, ActionId::History, ActionId::SelectBy, ActionId::FragmentTable, ActionId::HistoryCurves,
              ActionId::DebrisMap, ActionId::Clip, ActionId::Four, ActionId::Overlay, ActionId::Presentation}) {
            QAction& action = window->actions()[id];
            action.trigger();
            look(action.objectName(), [this] { return window; });
            action.trigger();
        }
    }
    /// Triggers an action, looks at the dialog that it opens, which may hold the action up, and closes that.
    void lookAtDialogOf(ActionId id) {
        QAction& action = window->actions()[id];
        const QString name = action.objectName();
        bool seen = false;
        QTimer::singleShot(400, window, [this, name, &seen] {
            QWidget* dialog = nullptr;
            for (QWidget* each : QApplication::topLevelWidgets()) {
                const bool isDialog = each->isVisible() && each != window && each->windowType() == Qt::Dialog;
                if (isDialog) {
                    dialog = each;
                }
            }
            seen = true;
            ASSERT_NE(dialog, nullptr) << name.toStdString();
            look(QStringLiteral("dialog-") + name, [dialog] { return dialog; });
            dialog->close();
        });
        action.trigger();
        ASSERT_TRUE(QTest::qWaitFor([&] { return seen; }, patience)) << name.toStdString();
    }
};

TEST_F(Screens, CanBeReadWholeWithoutACase) {
    inEachLanguage([this] {
        look(QStringLiteral("start"), [this] { return window; });
        lookAtPanels(QStringLiteral("empty-"));
    });
}

TEST_F(Screens, CanBeReadWholeWithARun) {
    simulated();
    inEachLanguage([this] { lookAtRun(); });
}

TEST_F(Screens, TheTourCanBeReadWhole) {
    openArch();
    inEachLanguage([this] {
        auto* tour = window->findChild<widgets::Tour*>();
        tour->start();
        for (int stop = 0; stop < 7; ++stop) {
            look(QStringLiteral("tour-%1").arg(stop), [&] {
                while (tour->current() < stop) {
                    QTest::keyClick(tour, Qt::Key_Right);
                }
                return window;
            });
        }
    });
}

TEST_F(Screens, WholeDialogsCanBeReadWhole) {
    simulated();
    window->actions()[ActionId::DuplicateScenario].trigger();
    inEachLanguage([this] {
        for (const ActionId id : {ActionId::Preferences, ActionId::KeptRuns, ActionId::Manual, ActionId::CompareScenarios,
                                  ActionId::ExportFigure, ActionId::ExportMovie, ActionId::Site, ActionId::About}) {
            lookAtDialogOf(id);
        }
    });
}

TEST_F(Screens, ACloudAndItsDialogsCanBeReadWhole) {
    simulated();
    const io::TemporaryFolder folder;
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(folder / "case.rubble")));
    std::ofstream(folder / "bare.txt") << "7 1 2 0.5\n7 10 3 0.5\n7 4 9 1.5\n";
    std::ofstream(folder / "survey.csv") << "name,easting,northing,height\nA,-15,-5,0.4\nB,15,-5,0.4\nC,15,5,0.6\n";
    window->rooms().survey->add(QString::fromStdString(folder / "survey.csv"));
    window->rooms().survey->add(QString::fromStdString(layLevelTable(folder / "level.csv", 0.1)));
    window->rooms().deck->evidence().survey().points().distances().setCell(1.0);
    window->rooms().cloudPoints->measure();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().cloudPoints->busy(); }, patience));
    inEachLanguage([&] {
        window->rooms().deck->choose(PanelDeck::Evidence);
        auto& place = window->rooms().deck->evidence().survey().place();
        window->rooms().deck->evidence().ensureWidgetVisible(&place);
        look(QStringLiteral("cloud"), [this] { return window; });
        auto* save = window->rooms().deck->evidence().findChild<QPushButton*>(QStringLiteral("saveDistances"));
        EXPECT_TRUE(save->isVisibleTo(window)) << "a language changes nothing of what was measured";
        QTest::qWait(100);
        window->rooms().deck->evidence().ensureWidgetVisible(save, 0, 200);
        look(QStringLiteral("cloud-distances"), [this] { return window; });
        const auto seen = [&](const QString& name) {
            auto done = std::make_shared<bool>(false);
            whenAsked([this, name, done](QDialog& dialog) {
                look(name, [&] { return &dialog; });
                *done = true;
                dialog.reject();
            });
            return done;
        };
        const auto picked = seen(QStringLiteral("dialog-scanners"));
        emit window->rooms().deck->evidence().survey().points().scanners().pickRequested();
        ASSERT_TRUE(QTest::qWaitFor([&] { return *picked; }, patience));
        const auto fitted = seen(QStringLiteral("dialog-fit"));
        emit place.fitRequested();
        ASSERT_TRUE(QTest::qWaitFor([&] { return *fitted; }, patience));
        const auto read = seen(QStringLiteral("dialog-reading"));
        window->rooms().survey->add(QString::fromStdString(folder / "bare.txt"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return *read; }, patience));
        lookAtDialogOf(ActionId::CompareClouds);
        lookAtDialogOf(ActionId::ScanRun);
    });
}

TEST_F(Screens, WholeTheWizardCanBeReadWhole) {
    static const std::array steps{"units", "ground", "components", "deaths", "case"};
    inEachLanguage([this] {
        window->rooms().opening->newCase(arch());
        NewCase& making = *window->rooms().opening->caseInTheMaking();
        for (int step = 0; step < widgets::NewCaseWizard::StepCount; ++step) {
            making.wizard().go(static_cast<widgets::NewCaseWizard::Step>(step));
            ASSERT_TRUE(
                QTest::qWaitFor([&] { return making.settled() && making.computation().results().fragments != nullptr; }, patience));
            look(QStringLiteral("wizard-%1").arg(QLatin1String(steps[static_cast<std::size_t>(step)])),
                 [&] { return &making.wizard(); });
        }
        making.wizard().reject();
        ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().opening->caseInTheMaking() == nullptr; }, patience));
    });
}

}  // namespace

}  // namespace rubble
