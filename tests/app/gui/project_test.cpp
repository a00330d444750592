#include "app/gui/case/project_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSplitter>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoView>
#include <fstream>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/inputs_display.h"
#include "app/gui/case/layout_memory.h"
#include "app/gui/case/run_history.h"
#include "app/gui/case/scenarios_display.h"
#include "app/gui/case/start_display.h"
#include "app/gui/session/sample.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "io/case/case_file.h"
#include "io/run/run_history.h"
#include "tests/app/gui/window/box_answer.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/basics/notice_bar.h"
#include "widgets/basics/panel.h"
#include "widgets/case/case_card.h"
#include "widgets/case/case_panel.h"
#include "widgets/case/scenario_comparison.h"
#include "widgets/case/site_dialog.h"
#include "widgets/case/start_page.h"
#include "widgets/views/status_line.h"

namespace rubble {

namespace {

/// A window on the small collapse, saved as a case in a folder of its own.
class Project : public Workbench {
protected:
    void SetUp() override {
        Workbench::SetUp();
        QSettings().clear();
        fe = QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString()));
    }
    void openIt(const QString& path) {
        window->open(path);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    void openCase() {
        openIt(fe);
        ASSERT_TRUE(window->rooms().files->saveTo(caseFile()));
        openIt(caseFile());
        ASSERT_EQ(session->document().path(), caseFile());
    }
    void simulateIt() {
        const std::size_t before = window->rooms().project->runs().runs().size();
        window->rooms().runs->simulate(false);
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return window->rooms().project->runs().runs().size() > before && !session->computation().busy(); }, 30'000));
    }
    QString caseFile() const { return folder.filePath(QStringLiteral("small.rubble")); }
    /// A small collapse that is another file: its deaths are the same, its times are not.
    QString writeOther(const QString& path) {
        io::ExodusBuilder other = cli::smallCollapse();
        other.times.back() += 0.05;
        other.write(path.toStdString());
        return path;
    }
    /// The button of the bar that is shown, by its object name.
    QPushButton* barButton(const QString& name) {
        for (widgets::NoticeBar* bar : window->findChildren<widgets::NoticeBar*>()) {
            for (QPushButton* button : bar->findChildren<QPushButton*>(name)) {
                if (button->isVisible()) {
                    return button;
                }
            }
        }
        return nullptr;
    }
    QStringList bars() { return window->rooms().project->inputs().texts(); }

    QTemporaryDir folder;
    QString fe;
};

TEST_F(Project, AMissingResultIsFoundAgainByItsHash) {
    openCase();
    const QString moved = folder.filePath(QStringLiteral("elsewhere.exo"));
    ASSERT_TRUE(QFile::rename(fe, moved));
    window->actions()[ActionId::Close].trigger();
    window->open(caseFile());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy() && !bars().isEmpty(); }, patience));
    EXPECT_TRUE(bars().front().contains(QStringLiteral("small.exo is missing"))) << bars().front().toStdString();
    EXPECT_EQ(window->area().currentIndex(), 2) << "the case is open, its result is not";
    QPushButton* locate = barButton(QStringLiteral("primary"));
    ASSERT_NE(locate, nullptr);
    // The dialog of the user: types the path, presses Enter.
    QTimer::singleShot(300, window, [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        auto* edit = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        edit->setText(moved);
        QTest::keyClick(edit, Qt::Key_Return);
    });
    QTest::mouseClick(locate, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_TRUE(bars().isEmpty()) << "the same file by its hash: nothing is asked";
    EXPECT_EQ(session->document().theCase().inputs[0].path, "elsewhere.exo");
    EXPECT_TRUE(session->document().modified());
    session->document().undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy() && bars().size() == 1; }, patience));
    EXPECT_TRUE(bars().front().contains(QStringLiteral("missing")));
    session->document().undoStack().redo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && bars().isEmpty(); }, patience));
}

TEST_F(Project, AnotherFileIsAskedAbout) {
    openCase();
    const std::string before = session->document().theCase().inputs[0].sha256;
    const QString other = writeOther(folder.filePath(QStringLiteral("other.exo")));
    window->rooms().project->inputs().locate("fe-1", other);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy() && bars().size() == 1; }, patience));
    EXPECT_TRUE(bars().front().contains(QStringLiteral("other.exo is another file"))) << bars().front().toStdString();
    EXPECT_EQ(session->document().theCase().inputs[0].path, "small.exo") << "nothing is taken before the answer";
    QTest::mouseClick(barButton(QStringLiteral("primary")), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && bars().isEmpty(); }, patience));
    EXPECT_EQ(session->document().theCase().inputs[0].path, "other.exo");
    EXPECT_NE(session->document().theCase().inputs[0].sha256, before);
    window->rooms().project->inputs().locate("fe-1", folder.filePath(QStringLiteral("nowhere.exo")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    EXPECT_EQ(session->document().theCase().inputs[0].path, "other.exo");
}

TEST_F(Project, AChangedResultIsAcceptedAndThatIsUndone) {
    openCase();
    const std::string before = session->document().theCase().inputs[0].sha256;
    writeOther(fe);
    openIt(caseFile());
    ASSERT_EQ(bars().size(), 1);
    EXPECT_TRUE(bars().front().contains(QStringLiteral("has changed since the case was saved"))) << bars().front().toStdString();
    EXPECT_NE(session->computation().inputs().fe, nullptr) << "it is shown all the same";
    QTest::mouseClick(barButton(QStringLiteral("primary")), Qt::LeftButton);
    EXPECT_TRUE(bars().isEmpty());
    EXPECT_FALSE(session->computation().busy()) << "the file that is open is not read again";
    EXPECT_NE(session->document().theCase().inputs[0].sha256, before);
    EXPECT_TRUE(session->document().undoStack().undoText().contains(QStringLiteral("small.exo")));
    ASSERT_TRUE(window->rooms().files->save());
    EXPECT_EQ(io::loadCase(caseFile().toStdString()).inputs[0].sha256, session->computation().inputs().fe->contents().sha256);
    session->document().undoStack().undo();
    EXPECT_EQ(session->document().theCase().inputs[0].sha256, before);
    EXPECT_EQ(bars().size(), 1);
}

TEST_F(Project, ScenariosAreDuplicatedNamedSwitchedAndDeleted) {
    openCase();
    widgets::ScenarioList& list = window->rooms().deck->casePanel().scenarios();
    auto* rows = list.findChild<QListWidget*>();
    const auto press = [&](const QString& text) {
        for (QPushButton* button : list.findChildren<QPushButton*>()) {
            if (button->text() == text) {
                QTest::mouseClick(button, Qt::LeftButton);
            }
        }
    };
    ASSERT_EQ(rows->count(), 1);
    session->document().setParameter(QStringLiteral("friction"), 0.4);
    press(QStringLiteral("Duplicate"));
    ASSERT_EQ(rows->count(), 2);
    EXPECT_EQ(rows->currentRow(), 1);
    session->document().setParameter(QStringLiteral("friction"), 0.8);
    EXPECT_EQ(session->document().theCase().scenarios[0].scenario.simulation.friction, 0.4);

    rows->setFocus();
    QTest::keyClick(rows, Qt::Key_F2);
    auto* name = rows->findChild<QLineEdit*>();
    ASSERT_NE(name, nullptr);
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("Rough"));
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().theCase().scenarios[1].name == "Rough"; }, patience));
    auto* note = list.findChild<QPlainTextEdit*>();
    note->setFocus();
    QTest::keyClicks(note, QStringLiteral("as if wet"));
    rows->setFocus();
    EXPECT_EQ(session->document().theCase().scenarios[1].note, "as if wet");

    QTest::keyClick(rows, Qt::Key_Up);
    EXPECT_EQ(session->document().theCase().activeScenario, "scenario-1");
    EXPECT_EQ(session->document().scenario().simulation.friction, 0.4);
    EXPECT_EQ(note->toPlainText(), QString());
    press(QStringLiteral("Delete"));
    EXPECT_EQ(rows->count(), 1);
    EXPECT_EQ(session->document().scenario().simulation.friction, 0.8);

    // All the way back and forth again.
    const Case after = session->document().theCase();
    while (session->document().undoStack().canUndo()) {
        session->document().undoStack().undo();
    }
    EXPECT_EQ(session->document().theCase().scenarios.size(), 1U);
    EXPECT_FALSE(session->document().scenario().simulation.friction.has_value());
    EXPECT_FALSE(session->document().modified());
    while (session->document().undoStack().canRedo()) {
        session->document().undoStack().redo();
    }
    EXPECT_EQ(session->document().theCase(), after);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    ASSERT_TRUE(window->rooms().files->save());
    EXPECT_EQ(io::loadCase(caseFile().toStdString()), after);
}

TEST_F(Project, TwoScenariosAreComparedWithTheirRuns) {
    openCase();
    simulateIt();
    window->actions()[ActionId::DuplicateScenario].trigger();
    session->document().setParameter(QStringLiteral("friction"), 0.25);
    session->document().setParameter(QStringLiteral("restitution"), 0.1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    window->actions()[ActionId::CompareScenarios].trigger();
    widgets::ScenarioComparison& comparison = *window->rooms().project->scenarios().comparison();
    ASSERT_TRUE(comparison.isVisible());
    ASSERT_EQ(comparison.settings().rowCount(), 2);
    QStringList seen;
    for (int row = 0; row < 2; ++row) {
        seen << comparison.settings().item(row, 1)->text() + u'|' + comparison.settings().item(row, 2)->text();
    }
    EXPECT_TRUE(seen.contains(QStringLiteral("auto|0.25"))) << seen.join(u' ').toStdString();
    ASSERT_GT(comparison.results().rowCount(), 5);
    EXPECT_EQ(comparison.results().item(1, 1)->text(), QString::number(cli::smallDead)) << "fragments of the run";
    EXPECT_EQ(comparison.results().item(1, 2)->text(), QString(QChar(0x2013))) << "the copy has no run";
    simulateIt();
    EXPECT_EQ(comparison.results().item(1, 2)->text(), QString::number(cli::smallDead));
}

TEST_F(Project, RunsAreListedKeptAndShownAgain) {
    openCase();
    simulateIt();
    const QString kept = folder.filePath(QStringLiteral("first.run.h5"));
    window->rooms().files->saveRunTo(kept);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    const Digest first = session->computation().currentRun()->outcome->trajectoryHash;
    session->document().setParameter(QStringLiteral("friction"), 0.1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    simulateIt();
    EXPECT_NE(session->computation().currentRun()->outcome->trajectoryHash, first);
    ASSERT_EQ(window->rooms().project->runs().runs().size(), 2U);
    EXPECT_EQ(window->rooms().project->runs().shown(), 1U);

    auto* list = window->rooms().deck->run().runs().findChild<QListWidget*>();
    ASSERT_EQ(list->count(), 2);
    list->setCurrentRow(1);
    auto* show = window->rooms().deck->run().runs().findChild<QPushButton*>(QStringLiteral("showRun"));
    ASSERT_TRUE(show->isEnabled());
    QTest::mouseClick(show, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().project->runs().shown() == 0U; }, patience));
    EXPECT_EQ(session->computation().currentRun()->outcome->trajectoryHash, first);
    EXPECT_NE(window->rooms().scene->data().trajectory, nullptr);
    EXPECT_EQ(rail(PanelDeck::Run), widgets::StageState::Stale) << "it was made with other settings";
    QStringList whileSimulating;
    QObject watching;
    QObject::connect(&session->computation(), &Computation::stateChanged, &watching, [&] {
        if (session->computation().simulating()) {
            list->setCurrentRow(0);
            whileSimulating << (show->isEnabled() ? QStringLiteral("enabled") : show->toolTip());
        }
    });
    window->rooms().runs->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().project->runs().runs().size() > 2 && !session->computation().busy(); },
                                30'000));
    ASSERT_FALSE(whileSimulating.isEmpty());
    for (const QString& words : whileSimulating) {
        EXPECT_TRUE(words.contains(QStringLiteral("is being simulated"))) << qPrintable(words);
    }
    list->setCurrentRow(1);
    EXPECT_TRUE(show->isEnabled()) << "the simulation has ended";
    EXPECT_TRUE(QFile::exists(kept)) << "a kept run is the user's";

    // The history lies beside the case, and comes back with it.
    const std::string sidecar = io::runHistoryPath(caseFile().toStdString());
    EXPECT_EQ(io::readRunHistory(sidecar).size(), 3U);
    ASSERT_TRUE(window->rooms().files->save());
    window->actions()[ActionId::Close].trigger();
    EXPECT_TRUE(window->rooms().project->runs().runs().empty());
    openIt(caseFile());
    ASSERT_EQ(window->rooms().project->runs().runs().size(), 3U);
    EXPECT_EQ(window->rooms().project->runs().runs()[0].file, kept.toStdString());
    EXPECT_EQ(window->rooms().project->runs().runs()[0].trajectoryHash, first);
    EXPECT_TRUE(window->rooms().project->runs().runs()[0].complete);
    EXPECT_GT(window->rooms().project->runs().runs()[0].bodies, 0);
    ASSERT_TRUE(QFile::remove(kept));
    window->rooms().project->runs().show(0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().failure().has_value(); }, patience)) << "told, not crashed";
}

// A run that was cancelled has figures that are not known; it is one run all the same, however often its case is saved and opened.
TEST_F(Project, ACancelledRunIsListedOnce) {
    openCase();
    const QString elsewhere = folder.filePath(QStringLiteral("elsewhere.rubble"));
    RunEntry cancelled;
    cancelled.when = "2024-05-31T08:15:30Z";
    cancelled.scenarioId = session->document().active()->id;
    cancelled.wallSeconds = 0.1;
    io::writeRunHistory(io::runHistoryPath(caseFile().toStdString()), {cancelled});
    window->actions()[ActionId::Close].trigger();
    openIt(caseFile());
    for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(window->rooms().project->runs().runs().size(), 1U) << i;
        ASSERT_TRUE(window->rooms().files->saveTo(elsewhere) && window->rooms().files->saveTo(caseFile()));
        cancelled.file = "/kept/first.run.h5";
        io::writeRunHistory(io::runHistoryPath(elsewhere.toStdString()), {cancelled});
    }
    EXPECT_EQ(window->rooms().project->runs().runs().size(), 1U);
    EXPECT_EQ(window->rooms().project->runs().runs().front().file, cancelled.file) << "what is new of a run that is known";
    EXPECT_EQ(io::readRunHistory(io::runHistoryPath(caseFile().toStdString())).size(), 1U);
}

// Cut off, emptied, garbled, of another kind or of a newer program: each is told with its name, and what is open stays.
TEST_F(Project, ADamagedCaseIsToldAndLeavesWhatIsOpen) {
    openCase();
    const std::string whole = textOf(caseFile());
    const QString damaged = folder.filePath(QStringLiteral("damaged.rubble"));
    std::vector<std::string> texts{"", "{", "[]", "null", "{}", std::string(4096, '\0'), whole + "}"};
    for (std::size_t part = 1; part < 8; ++part) {
        texts.push_back(whole.substr(0, whole.size() * part / 8));
    }
    const auto with = [&](const std::string& before, const std::string& after) {
        std::string text = whole;
        const std::size_t place = text.find(before);
        ASSERT_NE(place, std::string::npos) << before;
        texts.push_back(text.replace(place, before.size(), after));
    };
    with("\"format\": \"rubble-case\"", "\"format\": 7");
    with("\"version\": ", "\"version\": 99");
    with("\"scenarios\": [", "\"scenarios\": [3, ");
    with("\"inputs\": [", "\"inputs\": [{}, ");
    for (const std::string& text : texts) {
        SCOPED_TRACE(text.substr(0, 60));
        std::ofstream(damaged.toStdString(), std::ios::binary) << text;
        window->findChild<widgets::StatusLine*>()->setMessage({});
        window->open(damaged);
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return !session->computation().busy() && !window->findChild<widgets::StatusLine*>()->activityText().isEmpty(); },
            patience));
        EXPECT_TRUE(window->findChild<widgets::StatusLine*>()->activityText().contains(QStringLiteral("damaged.rubble")))
            << window->findChild<widgets::StatusLine*>()->activityText().toStdString();
        EXPECT_EQ(session->document().path(), caseFile());
        EXPECT_NE(session->computation().inputs().fe, nullptr);
        EXPECT_FALSE(session->document().modified());
    }
}

TEST_F(Project, WhatCannotBeReadTakesNothingFromWhatRuns) {
    openArch();
    makeCheap();
    session->document().setParameter(QStringLiteral("settle_time"), 10.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    // Nothing is to be asked about.
    session->document().undoStack().setClean();
    // A cheap run may begin and end within one round of events: the signal is what tells that it began.
    bool begun = false;
    QObject::connect(&session->computation(), &Computation::runBegun, window, [&begun] { begun = true; });
    window->rooms().runs->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return begun; }, patience));
    // Leaving the simulation is agreed to, and then there is nothing to leave it for.
    const BoxAnswer leave(QMessageBox::Discard);
    for (const char* name : {"damaged.rubble", "damaged.d3plot", "gone.exo"}) {
        const QString damaged = folder.filePath(QLatin1String(name));
        if (!damaged.endsWith(QStringLiteral("gone.exo"))) {
            std::ofstream(damaged.toStdString()) << "{ no case and no result";
        }
        window->open(damaged);
        const auto told = [&] {
            const auto all = window->findChildren<widgets::Notice*>();
            return std::any_of(all.begin(), all.end(), [&](const widgets::Notice* each) {
                return each->isVisible() && each->text().contains(QLatin1String(name));
            });
        };
        ASSERT_TRUE(QTest::qWaitFor(told, patience)) << name;
        EXPECT_NE(session->computation().inputs().fe, nullptr);
    }
    awaitRun();
}

TEST_F(Project, NoCaseTakesThePlaceOfOneThatADialogAsksAbout) {
    openCase();
    const QString other = writeOther(folder.filePath(QStringLiteral("other.exo")));
    const auto inDialog = [&](const std::function<void(QDialog&)>& answer) {
        whenAsked([&, answer](QDialog& dialog) {
            // The other result is read by now, and waits.
            EXPECT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
            QTest::qWait(200);
            EXPECT_EQ(session->document().path(), caseFile());
            answer(dialog);
        });
        window->open(other);
        window->actions()[ActionId::Site].trigger();
    };
    inDialog([](QDialog& dialog) {
        dynamic_cast<widgets::SiteDialog&>(dialog).setContent({}, QStringLiteral("EPSG:25832"));
        dialog.accept();
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    QTest::qWait(200);
    EXPECT_EQ(session->document().path(), caseFile()) << "its files were asked for after the other result";
    EXPECT_EQ(session->document().theCase().frame.crs, "EPSG:25832");
    window->actions()[ActionId::Undo].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && !session->computation().busy(); }, patience));
    inDialog([](QDialog& dialog) { dialog.reject(); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().base().endsWith(QStringLiteral("other.exo.rubble")); }, patience));
}

TEST_F(Project, AnEditMadeWhileAnotherCaseIsReadIsNotLost) {
    openCase();
    const QString other = writeOther(folder.filePath(QStringLiteral("other.exo")));
    for (const QMessageBox::StandardButton answer : {QMessageBox::Cancel, QMessageBox::Discard}) {
        bool asked = false;
        whenAsked([&, answer](QDialog& dialog) {
            asked = true;
            dynamic_cast<QMessageBox&>(dialog).button(answer)->click();
        });
        if (answer == QMessageBox::Discard) {
            window->actions()[ActionId::Undo].trigger();
        }
        window->open(other);
        session->document().setParameter(QStringLiteral("friction"), 0.3);
        ASSERT_TRUE(QTest::qWaitFor([&] { return asked && !session->computation().busy(); }, patience));
        QTest::qWait(200);
        EXPECT_EQ(session->document().path().isEmpty(), answer == QMessageBox::Discard);
    }
}

TEST_F(Project, ADamagedHistoryIsSetAside) {
    openCase();
    const QString sidecar = QString::fromStdString(io::runHistoryPath(caseFile().toStdString()));
    std::ofstream(sidecar.toStdString()) << R"({"format": "rubble-run-history", "version": 1, "runs": [{"when": 3}]})";
    window->actions()[ActionId::Close].trigger();
    QStringList told;
    QObject::connect(session.get(), &Session::failed, window, [&](const Failure& failure) { told << failure.what(); });
    openIt(caseFile());
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told[0].contains(QStringLiteral("small.rubble.runs.json"))) << told[0].toStdString();
    EXPECT_FALSE(QFile::exists(sidecar));
    EXPECT_EQ(QDir(folder.path()).entryList({QStringLiteral("*.damaged-*")}).size(), 1);
    simulateIt();
    EXPECT_EQ(window->rooms().project->runs().runs().size(), 1U);
}

TEST_F(Project, TheHistoryListGoesWhereItIsClicked) {
    openCase();
    for (int i = 1; i <= 4; ++i) {
        session->document().setParameter(QStringLiteral("friction"), 0.1 * i);
    }
    QTest::keyClick(window, Qt::Key_H, Qt::ControlModifier);
    ASSERT_TRUE(window->rooms().project->historyDock().isVisible());
    auto* list = window->rooms().project->historyDock().findChild<QUndoView*>();
    EXPECT_EQ(list->model()->rowCount(), 5);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(2, 0)).center());
    EXPECT_EQ(session->document().scenario().simulation.friction, 0.2);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
    EXPECT_FALSE(session->document().scenario().simulation.friction.has_value());
    window->rooms().project->historyDock().close();
    EXPECT_FALSE(window->actions()[ActionId::History].isChecked());
}

TEST_F(Project, TheLayoutComesBackAndIsReset) {
    window->restoreLayout();
    // Room for the panel to be as wide as it is pulled, beside views and history.
    window->resize(1800, 900);
    QTest::qWait(50);
    auto* splitter = window->findChild<QSplitter*>(QStringLiteral("mainSplitter"));
    const int first = splitter->sizes().front();
    window->actions()[ActionId::History].trigger();
    splitter->setSizes({first + 90, 400});
    const int wide = splitter->sizes().front();
    ASSERT_TRUE(window->close());
    startProgram();
    window->restoreLayout();
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window, patience));
    splitter = window->findChild<QSplitter*>(QStringLiteral("mainSplitter"));
    EXPECT_NEAR(splitter->sizes().front(), wide, 2);
    EXPECT_TRUE(window->rooms().project->historyDock().isVisible());
    EXPECT_TRUE(window->actions()[ActionId::History].isChecked());
    window->actions()[ActionId::ResetLayout].trigger();
    EXPECT_FALSE(window->rooms().project->historyDock().isVisible());
    EXPECT_LT(splitter->sizes().front(), wide - 40);
    QSettings().setValue(QStringLiteral("layout/docks"), QByteArray("no layout"));
    QSettings().setValue(QStringLiteral("layout/window"), 17);
    window->restoreLayout();
}

TEST_F(Project, TheStartPageOpensSamplesAndRecentCases) {
    window->rooms().project->begin();
    ASSERT_FALSE(samples().empty());
    const auto cards = [&] { return window->area().startPage().findChildren<widgets::CaseCard*>(); };
    EXPECT_EQ(cards().size(), static_cast<qsizetype>(samples().size())) << "nothing was opened yet";
    openCase();
    window->actions()[ActionId::Close].trigger();
    EXPECT_EQ(window->area().currentIndex(), 0);
    ASSERT_EQ(window->rooms().project->start().recent().list().size(), 2U) << "the result and the case";
    const auto card = [&](const QString& words) -> widgets::CaseCard* {
        for (widgets::CaseCard* each : cards()) {
            if (each->content().words == words && each->isVisible()) {
                return each;
            }
        }
        return nullptr;
    };
    ASSERT_NE(card(caseFile()), nullptr);
    QTest::mouseClick(card(caseFile()), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_EQ(session->document().path(), caseFile());
    window->actions()[ActionId::Close].trigger();
    const QString moved = folder.filePath(QStringLiteral("moved.rubble"));
    ASSERT_TRUE(QFile::rename(caseFile(), moved));
    window->rooms().project->start().refresh();
    QTest::qWait(10);
    ASSERT_NE(card(caseFile()), nullptr);
    EXPECT_FALSE(card(caseFile())->isEnabled());
    window->rooms().project->start().locate(caseFile(), moved);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_EQ(session->document().path(), moved);
    window->actions()[ActionId::Close].trigger();
    const std::size_t before = window->rooms().project->start().recent().list().size();
    QTest::qWait(10);
    for (QPushButton* forget : window->area().startPage().findChildren<QPushButton*>(QStringLiteral("forget"))) {
        if (forget->isVisible()) {
            QTest::mouseClick(forget, Qt::LeftButton);
            break;
        }
    }
    EXPECT_EQ(window->rooms().project->start().recent().list().size(), before - 1);
}

}  // namespace
}  // namespace rubble
