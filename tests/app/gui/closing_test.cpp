#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <fstream>
#include <functional>

#include "app/gui/accuracy/accuracy_display.h"
#include "app/gui/accuracy/calibration_display.h"
#include "app/gui/accuracy/error_display.h"
#include "app/gui/case/file_commands.h"
#include "app/gui/case/new_case.h"
#include "app/gui/evidence/causes_display.h"
#include "app/gui/evidence/ensemble_display.h"
#include "app/gui/evidence/evidence_studies.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/validation_display.h"
#include "app/gui/exports/picture_export.h"
#include "app/gui/exports/report_work.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/complaints.h"
#include "tests/app/gui/window/box_answer.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/run_tests.h"
#include "tests/support/small_collapse.h"
#include "widgets/accuracy/accuracy_panel.h"
#include "widgets/accuracy/calibration_view.h"
#include "widgets/accuracy/error_bar.h"
#include "widgets/evidence/validation_view.h"

namespace rubble {

namespace {

class Closing;

/// A kind of work: starts it and tells whether it runs.
struct WorkKind {
    const char* name;
    std::function<bool(Closing&)> start;
};
void PrintTo(const WorkKind& kind, std::ostream* out) {
    *out << kind.name;
}

/// A window with a run of the small collapse, and a cache of its own.
class Closing : public Workbench, public testing::WithParamInterface<WorkKind> {
public:
    QString at(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    MainWindow& shown() { return *window; }

    bool figure() {
        shown().rooms().pictures->exportFigureTo(at("figure.png"), {{}, {1600, 1000}, 100}, shown().area().views().view(),
                                                 shown().rooms().scene->data());
        return shown().session().computation().busy();
    }
    bool calibration() {
        shown().rooms().calibration->open();
        shown().rooms().calibration->work().setBodies({8});
        shown().rooms().calibration->view().findChild<QPushButton*>(QStringLiteral("primary"))->click();
        return shown().rooms().calibration->work().running();
    }
    bool validation() {
        shown().rooms().validation->open();
        shown().rooms().validation->view().findChild<QPushButton*>(QStringLiteral("primary"))->click();
        return shown().rooms().validation->work().running();
    }
    bool reference() {
        shown().area().errorBar().findChild<QPushButton*>(QStringLiteral("computeReference"))->click();
        return shown().rooms().errors->work().running();
    }
    bool comparison() {
        shown().rooms().deck->choose(PanelDeck::Accuracy);
        shown()
            .rooms()
            .deck->accuracy()
            .findChild<QLineEdit*>(QStringLiteral("multiples"))
            ->setText(QStringLiteral("auto, 1, 2.5"));
        shown().rooms().deck->accuracy().findChild<QPushButton*>(QStringLiteral("primary"))->click();
        return shown().rooms().accuracy->work().running();
    }
    bool members() {
        shown().actions()[ActionId::SimulateEnsemble].trigger();
        return shown().rooms().studies->work().running();
    }
    bool causes() {
        io::ExodusBuilder builder = cli::smallCollapse();
        for (Vec3& node : builder.nodes) {
            node.x() += 6.0;
        }
        builder.write(at("east.exo").toStdString());
        shown().rooms().studies->causes().addCauses({at("east.exo")});
        shown().actions()[ActionId::CompareCauses].trigger();
        return shown().rooms().studies->work().running();
    }
    bool survey() {
        std::ofstream(at("after.asc").toStdString())
            << "ncols 2\nnrows 2\nxllcorner -10\nyllcorner -10\ncellsize 10\nNODATA_value -9999\n0 1\n1 0\n";
        shown().rooms().survey->add(at("after.asc"));
        shown().rooms().survey->compare();
        return shown().rooms().survey->busy();
    }

protected:
    void SetUp() override {
        qputenv("RUBBLE_CACHE", m_folder.filePath(QStringLiteral("cache")).toUtf8());
        Workbench::SetUp();
        cli::writeSmallCollapse(at("small.exo").toStdString());
        window->open(at("small.exo"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        session->document().setParameter(QStringLiteral("settle_time"), 0.5);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        simulateToEnd();
        window->rooms().files->saveRunTo(at("kept.run.h5"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    }
    void TearDown() override {
        endProgram();
        qunsetenv("RUBBLE_CACHE");
    }

    QTemporaryDir m_folder;
};

const WorkKind kinds[] = {
    {"Live",
     [](Closing& at) {
         at.shown().rooms().runs->simulate(true);
         return at.shown().session().computation().busy();
     }},
    {"Preparing",
     [](Closing& at) {
         at.shown().session().document().setParameter(QStringLiteral("multiple"), 2.0);
         return at.shown().session().computation().busy();
     }},
    {"Refreshing",
     [](Closing& at) {
         cli::writeSmallCollapse(at.at("small.exo").toStdString());
         at.shown().rooms().opening->refreshResult();
         return at.shown().session().computation().busy();
     }},
    {"ShowingAKeptRun",
     [](Closing& at) {
         at.shown().session().computation().showRun(at.at("kept.run.h5"), 1.0);
         return at.shown().session().computation().busy();
     }},
    {"MakingANewCase",
     [](Closing& at) {
         at.shown().rooms().opening->newCase(at.at("small.exo"));
         return at.shown().rooms().opening->caseInTheMaking() != nullptr &&
                !at.shown().rooms().opening->caseInTheMaking()->settled();
     }},
    {"SavingARun",
     [](Closing& at) {
         at.shown().rooms().files->saveRunTo(at.at("other.run.h5"));
         return at.shown().session().computation().busy();
     }},
    {"WritingAFigure", [](Closing& at) { return at.figure(); }},
    {"WritingAReport",
     [](Closing& at) {
         at.shown().rooms().report->writeTo(at.at("report"));
         return at.shown().rooms().report->writing();
     }},
    {"Calibrating", [](Closing& at) { return at.calibration(); }},
    {"HoldingAgainstMeasuredFalls", [](Closing& at) { return at.validation(); }},
    {"ComputingAReference", [](Closing& at) { return at.reference(); }},
    {"ComparingSettings", [](Closing& at) { return at.comparison(); }},
    {"SimulatingMembers", [](Closing& at) { return at.members(); }},
    {"ComparingCauses", [](Closing& at) { return at.causes(); }},
    {"ComparingWithASurvey", [](Closing& at) { return at.survey(); }},
};

TEST_P(Closing, InTheMiddleOfWorkIsClean) {
    const Complaints complaints;
    ASSERT_TRUE(GetParam().start(*this));
    const RunRecord* run = session->computation().currentRun();
    const bool kept = run != nullptr && run->kept;
    const QString scratch = session->computation().currentRun() != nullptr ? session->computation().currentRun()->path : QString();
    session->document().undoStack().setClean();
    // A simulation that would end is asked about.
    const bool simulates = session->computation().simulating();
    {
        const BoxAnswer leave(QMessageBox::Discard);
        EXPECT_TRUE(window->close());
        EXPECT_EQ(leave.asked(), simulates);
    }
    endProgram();
    QTest::qWait(100);
    EXPECT_TRUE(Complaints::all().isEmpty()) << Complaints::all().join(u'\n').toStdString();
    EXPECT_TRUE(kept || !QFile::exists(scratch)) << "the temporary run is left behind";
    // What was being written is whole or not there; what was there before is.
    EXPECT_TRUE(!QFile::exists(at("figure.png")) || !QImage(at("figure.png")).isNull());
    EXPECT_TRUE(QFile::exists(at("kept.run.h5")));
    EXPECT_TRUE(QDir(m_folder.path()).entryList({QStringLiteral("*.part*"), QStringLiteral("*.tmp*")}).isEmpty());
}

/// All kinds with the whole tests, else every third: they share the way in which a worker ends.
std::vector<WorkKind> kindsToTest() {
    std::vector<WorkKind> chosen;
    for (std::size_t i = 0; i < std::size(kinds); i += sizedTo<std::size_t>(3, 1)) {
        chosen.push_back(kinds[i]);
    }
    return chosen;
}

INSTANTIATE_TEST_SUITE_P(Work, Closing, testing::ValuesIn(kindsToTest()),
                         [](const testing::TestParamInfo<WorkKind>& kind) { return std::string(kind.param.name); });

TEST_F(Workbench, ClosingWithUnsavedChangesAsksAndDoesWhatIsAnswered) {
    const QTemporaryDir folder;
    const QString fe = QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString()));
    const QString path = folder.filePath(QStringLiteral("small.rubble"));
    window->open(fe);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    ASSERT_TRUE(window->rooms().files->saveTo(path));
    session->document().setParameter(QStringLiteral("friction"), 0.31);
    const std::string before = textOf(path);
    {
        const BoxAnswer stay(QMessageBox::Cancel);
        EXPECT_FALSE(window->close());
        EXPECT_TRUE(stay.asked());
        EXPECT_TRUE(window->isVisible());
        EXPECT_TRUE(session->document().modified());
    }
    {
        const BoxAnswer save(QMessageBox::Save);
        EXPECT_TRUE(window->close());
        EXPECT_TRUE(save.asked());
        EXPECT_NE(textOf(path), before);
        EXPECT_NE(textOf(path).find("0.31"), std::string::npos);
    }
    window->show();
    const std::string saved = textOf(path);
    session->document().setParameter(QStringLiteral("friction"), 0.9);
    {
        const BoxAnswer leave(QMessageBox::Discard);
        EXPECT_TRUE(window->close());
        EXPECT_TRUE(leave.asked());
        EXPECT_EQ(textOf(path), saved);
    }
    session->document().undoStack().setClean();
}

}  // namespace

}  // namespace rubble
