#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/new_case.h"
#include "app/gui/case/project_display.h"
#include "app/gui/case/project_files.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/inspection.h"
#include "core/fe/units.h"
#include "tests/app/gui/window/hour_of_use.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/unit_label.h"
#include "widgets/case/case_panel.h"
#include "widgets/case/new_case_wizard.h"
#include "widgets/evidence/causes_panel.h"
#include "widgets/evidence/movie_dialog.h"
#include "widgets/evidence/report_panel.h"
#include "widgets/figures/number_text.h"
#include "widgets/run/run_panel.h"
#include "widgets/views/fragment_model.h"
#include "widgets/views/status_line.h"
#include "widgets/views/timeline.h"
#include "widgets/views/transport.h"

namespace rubble {

namespace {

/// What stood in the way of somebody who used the window for an hour and had not built it.
class SecondHour : public HourOfUse {
protected:
    QString shown(const char* name) { return window->findChild<QLabel*>(QLatin1String(name))->text(); }
};

TEST_F(SecondHour, ARunFileOpensInItsCaseWhereverItLies) {
    const QString fe = smallAs("east.exo");
    openAndAwait(fe);
    ASSERT_TRUE(window->rooms().files->saveTo(folder.filePath(QStringLiteral("east.rubble"))));
    simulateToEnd();
    const QString run = session->computation().currentRun()->path;
    const QString elsewhere = folder.filePath(QStringLiteral("handed-over.run.h5"));
    ASSERT_TRUE(QFile::copy(run, elsewhere));
    openAndAwait(timedAs("west.exo", 1.1));
    const auto isShown = [&](const QString& path) {
        const RunRecord* record = session->computation().currentRun();
        return record != nullptr && QFileInfo(record->path) == QFileInfo(path) && record->outcome != nullptr;
    };
    window->open(run);
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(run); }, patience));
    EXPECT_TRUE(session->document().path().endsWith(QLatin1String("east.rubble"))) << "it lies beside its case";
    window->open(elsewhere);
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(elsewhere); }, patience)) << "of the case that is open";
    openAndAwait(timedAs("north.exo", 1.2));
    ASSERT_TRUE(QFile::remove(fe));
    QStringList told;
    QObject::connect(session.get(), &Session::failed, session.get(), [&](const Failure& failure) { told << failure.what(); });
    window->open(elsewhere);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !told.empty(); }, patience));
    EXPECT_TRUE(told.join(u' ').contains(QStringLiteral("east.exo"))) << qPrintable(told.join(u' '));
    EXPECT_TRUE(session->document().openPath().endsWith(QLatin1String("north.exo"))) << "what was open stays";
}

TEST_F(SecondHour, ARunWithOtherSettingsThanTheCaseLendsThem) {
    openAndAwait(smallAs("east.exo"));
    Document& document = session->document();
    const Scenario delivered = document.scenario();
    document.setParameter(QStringLiteral("friction"), 0.3);
    document.setParameter(QStringLiteral("component[deck].density"), 2500.0);
    const Scenario ran = document.scenario();
    simulateToEnd();
    auto* take = window->findChild<QPushButton*>(QStringLiteral("takeSettings"));
    ASSERT_NE(take, nullptr);
    EXPECT_FALSE(take->isEnabled()) << "they are those of the case";
    document.undoStack().undo();
    document.undoStack().undo();
    ASSERT_EQ(document.scenario(), delivered);
    EXPECT_TRUE(take->isEnabled());
    EXPECT_TRUE(session->computation().runStale(document.scenario())) << "shown hatched";
    ASSERT_TRUE(take->isEnabled());
    clickPanel(PanelDeck::Run);
    const int steps = document.undoStack().index();
    QTest::mouseClick(take, Qt::LeftButton);
    EXPECT_EQ(document.scenario(), ran);
    EXPECT_EQ(document.undoStack().index(), steps + 1) << "one step";
    EXPECT_FALSE(session->computation().runStale(document.scenario()));
    EXPECT_FALSE(take->isEnabled());
    document.undoStack().undo();
    EXPECT_EQ(document.scenario(), delivered);
    EXPECT_TRUE(take->isEnabled());
}

TEST_F(SecondHour, ABareResultSaysWhatItIsAndWhatItsKeptRunWasMadeWith) {
    const QString east = folder.filePath(QStringLiteral("east.exo"));
    io::ExodusBuilder builder = cli::smallCollapse();
    for (Vec3& node : builder.nodes) {
        node += Vec3(500000.0, 4000000.0, 0.0);
    }
    builder.write(east.toStdString());
    openAndAwait(east);
    Document& document = session->document();
    document.setParameter(QStringLiteral("friction"), 0.3);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    simulateToEnd();
    document.undoStack().setClean();
    openAndAwait(timedAs("west.exo", 1.1));
    openAndAwait(east);
    clickPanel(PanelDeck::Case);
    ASSERT_TRUE(document.path().isEmpty()) << "no case";
    EXPECT_EQ(parameterValue(document.scenario(), "friction"), parameterValue(Scenario(), "friction"));
    QStringList found;
    for (const auto* notice : window->rooms().deck->casePanel().findChildren<widgets::Notice*>()) {
        if (notice->isVisible()) {
            found << notice->text();
        }
    }
    EXPECT_TRUE(found.join(u'\n').contains(QStringLiteral("The structure lies far from the origin")))
        << qPrintable(found.join(u'\n'));
    QStringList told;
    QObject::connect(session.get(), &Session::told, window, [&](const QString& what) { told << what; });
    RunHistory& history = session->part<ProjectFiles>().runs;
    ASSERT_EQ(history.runs().size(), 1U) << "kept beside nothing, found again";
    history.show(0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().currentRun() != nullptr && !told.empty(); }, patience));
    EXPECT_TRUE(told.last().contains(QStringLiteral("It has other settings than the case"))) << qPrintable(told.join(u'\n'));
    EXPECT_TRUE(window->findChild<widgets::StatusLine*>()->activityText().contains(QStringLiteral("other settings")));
}

TEST_F(SecondHour, ABlastOfMicrosecondsIsToldInItsOwnUnitsAndHasHalfOfTheTimeline) {
    openAndAwait(timedAs("blast.exo", 1.4e-4));
    EXPECT_EQ(shown("timeFigures"), QStringLiteral("0.00 µs"));
    EXPECT_EQ(figures::timeText(35e-6), QStringLiteral("35.00 µs"));
    EXPECT_EQ(figures::timeText(2.5), QStringLiteral("2.50 s"));
    auto& line = *window->findChild<widgets::Timeline*>();
    EXPECT_FALSE(line.fold()) << "nothing comes after the result yet";
    session->document().setParameter(QStringLiteral("settle_time"), 1.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    simulateToEnd();
    ASSERT_TRUE(line.fold());
    const double wide = line.toX(session->computation().currentRun()->newest) - line.toX(0.0);
    EXPECT_NEAR(line.toX(70e-6) - line.toX(0.0), 0.5 * wide, 1.0);
    for (const double time : {10e-6, 70e-6, 0.3}) {
        EXPECT_NEAR(line.toTime(line.toX(time)), time, 1e-6 * time);
    }
    QTest::mouseClick(&line, Qt::LeftButton, {}, QPoint(static_cast<int>(line.toX(35e-6)), line.height() / 2 - 20));
    EXPECT_TRUE(shown("timeFigures").endsWith(QStringLiteral(" µs"))) << qPrintable(shown("timeFigures"));
    EXPECT_NEAR(window->rooms().playback->clock().time(), 35e-6, 1e-6);
    EXPECT_LT(window->rooms().playback->clock().rate(), 1e-4) << "it can be watched";
    QString end;
    bool possible = false;
    whenAsked([&](QDialog& dialog) {
        end = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"))->text();
        possible = dialog.findChild<QPushButton*>(QStringLiteral("primary"))->isEnabled();
        dialog.reject();
    });
    window->actions()[ActionId::ExportMovie].trigger();
    EXPECT_EQ(end, QStringLiteral("70.000 µs")) << "not its settling";
    EXPECT_TRUE(possible);
    session->document().undoStack().setClean();
    openAndAwait(smallAs("east.exo"));
    EXPECT_EQ(shown("timeFigures"), QStringLiteral("0.00 s"));
    EXPECT_EQ(window->rooms().playback->clock().rate(), 1.0);
}

TEST_F(SecondHour, TimesOfABlastAreTypedAndSaidInUnitsThatSuitThem) {
    openAndAwait(timedAs("blast.exo", 1.4e-4));
    clickPanel(PanelDeck::Run);
    auto* panel = window->findChild<widgets::RunPanel*>();
    auto* editor = panel->findChild<widgets::ParameterEditor*>(QStringLiteral("settle_time"));
    ASSERT_NE(editor, nullptr);
    auto* field = editor->findChild<QLineEdit*>();
    // The unit stands right of its field.
    const auto unit = [&] {
        const QPoint middle = editor->mapTo(panel->widget(), editor->rect().center());
        for (const auto* label : panel->findChildren<widgets::UnitLabel*>()) {
            const QRect place(label->mapTo(panel->widget(), QPoint(0, 0)), label->size());
            if (std::abs(place.center().y() - middle.y()) < 4 && place.left() > middle.x()) {
                return label->text();
            }
        }
        return QString();
    };
    const auto type = [&](const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        return std::get<double>(parameterValue(session->document().scenario(), "settle_time"));
    };
    EXPECT_EQ(field->text() + unit(), QStringLiteral("10s"));
    EXPECT_TRUE(editor->toolTip().contains(QStringLiteral("From 0\u00A0s to "))) << qPrintable(editor->toolTip());
    const auto* said = panel->findChild<widgets::Notice*>(QStringLiteral("briefResult"));
    EXPECT_TRUE(said->text().contains(QStringLiteral("70.00 µs"))) << qPrintable(said->text());
    EXPECT_DOUBLE_EQ(type(QStringLiteral("500 us")), 5e-4);
    EXPECT_EQ(field->text() + unit(), QStringLiteral("500µs"));
    EXPECT_DOUBLE_EQ(type(QStringLiteral("70")), 7e-5) << "a bare number is in the unit beside the field";
    EXPECT_DOUBLE_EQ(type(QStringLiteral("20ms")), 0.02);
    EXPECT_EQ(field->text() + unit(), QStringLiteral("20ms"));
    EXPECT_DOUBLE_EQ(type(QStringLiteral("2 s")), 2.0);
    EXPECT_EQ(field->text() + unit(), QStringLiteral("2s"));
    EXPECT_DOUBLE_EQ(type(QStringLiteral("3 kg")), 2.0) << "no time";
    auto& rates = *window->findChild<widgets::Transport*>()->findChild<QComboBox*>();
    EXPECT_GE(rates.findText(QStringLiteral("10 µs/s")), 0);
    EXPECT_GE(rates.findText(QStringLiteral("1 ×")), 0);
    widgets::MovieChoice choice;
    choice.settings.to = 70e-6;
    widgets::MovieDialog movie(choice, false);
    EXPECT_EQ(movie.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"))->text(), QStringLiteral("70.000 µs"));
    EXPECT_NEAR(movie.choice().settings.to, 70e-6, 1e-9);
    EXPECT_EQ(figures::movieLength(movie.choice().settings), 176U) << "seven seconds to watch";
    widgets::FragmentModel model;
    EXPECT_EQ(model.headerData(widgets::FragmentModel::Birth, Qt::Horizontal, Qt::DisplayRole), QStringLiteral("born, µs"));
    session->document().undoStack().setClean();
    openAndAwait(smallAs("east.exo"));
    EXPECT_TRUE(said->isHidden());
    EXPECT_EQ(model.headerData(widgets::FragmentModel::Birth, Qt::Horizontal, Qt::DisplayRole), QStringLiteral("born, s"));
    EXPECT_EQ(field->text() + unit(), QStringLiteral("10s"));
    EXPECT_DOUBLE_EQ(type(QStringLiteral("0.05")), 0.05);
    EXPECT_EQ(field->text() + unit(), QStringLiteral("0.05s")) << "only a brief result has other units";
}

TEST_F(SecondHour, TheWizardReadsAFileInTheUnitsThatFitIt) {
    io::ExodusBuilder builder = cli::smallCollapse();
    for (Vec3& node : builder.nodes) {
        node *= 1000.0;
    }
    for (io::ExodusBuilder::Block& block : builder.blocks) {
        block.attributes.assign(block.attributes.size(), 2.4e-9);
    }
    const QString path = folder.filePath(QStringLiteral("millimetres.exo"));
    builder.write(path.toStdString());
    window->rooms().opening->newCase(path);
    NewCase* making = window->rooms().opening->caseInTheMaking();
    ASSERT_NE(making, nullptr);
    const auto units = [&] { return unitChoices()[making->document().scenario().import.units]; };
    ASSERT_TRUE(QTest::qWaitFor([&] { return units() != "frame" && making->settled(); }, patience));
    EXPECT_EQ(units(), "t-mm-s");
    EXPECT_TRUE(making->document().undoStack().canUndo());
    making->document().undoStack().undo();
    QTest::qWait(200);
    ASSERT_TRUE(QTest::qWaitFor([&] { return making->settled(); }, patience));
    EXPECT_EQ(units(), "frame") << "taking it back lasts";
    for (const char* note : {"unitsWords", "axisWords"}) {
        const auto* words = making->wizard().findChild<QLabel*>(QLatin1String(note));
        ASSERT_NE(words, nullptr);
        EXPECT_TRUE(words->isVisible()) << note;
        EXPECT_TRUE(words->text().contains(QStringLiteral("frame: ")) && words->text().contains(QStringLiteral("auto: ")))
            << qPrintable(words->text());
    }
    QTest::keyClick(&making->wizard(), Qt::Key_Escape);
}

TEST_F(SecondHour, ACaseThatWasJustMadeIsAutosavedAtOnce) {
    const QString fe = smallAs("east.exo");
    window->rooms().opening->newCase(fe);
    NewCase* making = window->rooms().opening->caseInTheMaking();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return making->settled() && making->computation().results().fragments != nullptr; }, patience));
    emit making->wizard().createRequested();
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_TRUE(QFile::exists(window->rooms().project->autosave().file()));
    ASSERT_TRUE(window->rooms().files->saveTo(folder.filePath(QStringLiteral("made.rubble"))));
    EXPECT_TRUE(window->rooms().project->autosave().file().isEmpty());
    session->document().setParameter(QStringLiteral("settle_time"), 0.5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    simulateToEnd();
    EXPECT_TRUE(QFile::exists(window->rooms().project->autosave().file())) << "a run is kept, and so is what it was made from";
}

TEST_F(SecondHour, TheInspectorLeavesAPageThatStandsInFrontOfTheViews) {
    openAndAwait(smallAs("east.exo"));
    const QDockWidget& dock = *window->findChild<QDockWidget*>(QStringLiteral("inspectorDock"));
    window->rooms().inspection->selection().select({session->computation().results().fragments->list.front().element});
    ASSERT_TRUE(QTest::qWaitFor([&] { return dock.isVisible() && dock.isFloating(); }, patience));
    clickPanel(PanelDeck::Accuracy);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !dock.isVisible(); }, patience));
    clickPanel(PanelDeck::Run);
    EXPECT_TRUE(QTest::qWaitFor([&] { return dock.isVisible(); }, patience));
}

TEST_F(SecondHour, MenusInEnglishNameNoLetterBesideTheirWords) {
    for (const QAction* action : window->menuBar()->actions()) {
        for (const QAction* each : action->menu()->actions()) {
            EXPECT_FALSE(each->text().contains(QStringLiteral("(&"))) << qPrintable(each->text());
        }
    }
}

TEST_F(SecondHour, WhatTheAuthorOfAReportSaysOutlivesTheProgram) {
    const QString fe = smallAs("east.exo");
    openAndAwait(fe);
    const QString path = folder.filePath(QStringLiteral("east.rubble"));
    ASSERT_TRUE(window->rooms().files->saveTo(path));
    clickPanel(PanelDeck::Report);
    const auto field = [&](const char* name) {
        return window->rooms().deck->report().findChild<QPlainTextEdit*>(QLatin1String(name));
    };
    window->rooms().deck->report().ensureWidgetVisible(field("reportCustody"));
    QTest::mouseClick(field("reportCustody")->viewport(), Qt::LeftButton);
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("The county held it."));
    const QString notes = path + QStringLiteral(".report.json");
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(notes); }, patience));
    endProgram();
    Workbench::SetUp();
    EXPECT_TRUE(window->rooms().deck->report().wishes().words.custody.empty());
    openAndAwait(path);
    EXPECT_EQ(window->rooms().deck->report().wishes().words.custody, "The county held it.");
    clickPanel(PanelDeck::Report);
    QTest::mouseClick(field("reportCustody")->viewport(), Qt::LeftButton);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Delete);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !QFile::exists(notes); }, patience)) << "nothing said, nothing kept";
}

TEST_F(SecondHour, NotesThatCannotBeReadAreSetAsideAndTold) {
    const QString fe = smallAs("east.exo");
    openAndAwait(fe);
    const QString path = folder.filePath(QStringLiteral("east.rubble"));
    ASSERT_TRUE(window->rooms().files->saveTo(path));
    QFile broken(path + QStringLiteral(".report.json"));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("{\"format\": \"rubble-report-notes\", ");
    broken.close();
    openAndAwait(smallAs("west.exo"));
    QStringList told;
    QObject::connect(session.get(), &Session::failed, session.get(), [&](const Failure& failure) { told << failure.what(); });
    openAndAwait(path);
    EXPECT_TRUE(told.join(u' ').contains(QStringLiteral(".report.json"))) << qPrintable(told.join(u' '));
    EXPECT_FALSE(QDir(folder.path()).entryList({QStringLiteral("*.report.json.damaged-*")}).isEmpty());
}

TEST_F(SecondHour, ATimeAtWhichDebrisReachedAPlaceIsEvidence) {
    openAndAwait(smallAs("east.exo"));
    widgets::CausesPanel& panel = *window->findChild<widgets::CausesPanel*>();
    auto* list = panel.findChild<QListWidget*>(QStringLiteral("causeEvidence"));
    auto* menu = panel.findChild<QPushButton*>(QStringLiteral("addEvidence"))->menu();
    whenAsked([](QDialog& dialog) {
        const auto type = [&](const char* name, const QString& text) {
            auto* box = dialog.findChild<QDoubleSpinBox*>(QLatin1String(name));
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, text);
        };
        type("seconds", QStringLiteral("3.2"));
        type("x", QStringLiteral("12"));
        type("y", QStringLiteral("-4"));
        for (auto* button : dialog.findChildren<QPushButton*>()) {
            if (button->text() == QStringLiteral("Add")) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
    });
    for (QAction* action : menu->actions()) {
        if (action->text().contains(QStringLiteral("Time"))) {
            action->trigger();
        }
    }
    ASSERT_EQ(list->count(), 1);
    EXPECT_EQ(list->item(0)->text(), QStringLiteral("3.200\u00A0s at 12.0, -4.00\u00A0m")) << qPrintable(list->item(0)->text());
    EXPECT_EQ(list->item(0)->checkState(), Qt::Checked);
    list->setCurrentRow(0);
    for (auto* button : panel.findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("Remove") && button->isEnabled()) {
            button->click();
        }
    }
    EXPECT_EQ(list->item(0)->flags(), Qt::NoItemFlags) << "there is none again";
}

}  // namespace
}  // namespace rubble
