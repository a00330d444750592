#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <filesystem>

#include "app/gui/accuracy/accuracy_display.h"
#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/ensemble_display.h"
#include "app/gui/evidence/evidence_studies.h"
#include "io/jobs/job_record.h"
#include "tests/app/gui/workbench.h"
#include "tests/app/slurm/one_node.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "widgets/accuracy/accuracy_page.h"
#include "widgets/accuracy/accuracy_table.h"
#include "widgets/basics/place_choice.h"
#include "widgets/evidence/ensemble_page.h"
#include "widgets/evidence/ensemble_panel.h"

namespace rubble {

namespace {

namespace fs = std::filesystem;

/// A window with the small collapse, each world of which takes a second or two, beside a Slurm of one node.
class ClusterWorkbench : public Workbench {
protected:
    void SetUp() override {
        qputenv("RUBBLE_CACHE", m_cache.toUtf8());
        cli::writeSmallCollapse(m_folder.filePath(QStringLiteral("small.exo")).toStdString());
        Workbench::SetUp();
        open(m_folder.filePath(QStringLiteral("small.exo")));
        for (const auto& [key, value] : std::initializer_list<std::pair<const char*, ParameterValue>>{
                 {"settle_time", 20.0}, {"freeze", false}, {"step_rate", 4000.0}, {"substeps", std::int64_t{8}}}) {
            session->document().setParameter(QLatin1String(key), value);
        }
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        ASSERT_TRUE(window->rooms().files->saveTo(m_case));
    }
    void TearDown() override {
        endProgram();
        OneNode::restore();
        qunsetenv("RUBBLE_CACHE");
    }
    void open(const QString& path) {
        window->open(path);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    /// Closes the window and opens the case in another one.
    void openAgain() {
        endProgram();
        Workbench::SetUp();
        open(m_case);
    }
    /// Waits until the cluster can be chosen, and chooses it.
    void chooseCluster(widgets::PlaceChoice& place) {
        auto* choice = place.findChild<QComboBox*>(QStringLiteral("place"));
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return qobject_cast<QStandardItemModel*>(choice->model())->item(1)->isEnabled(); }, patience));
        choice->setCurrentIndex(1);
        ASSERT_TRUE(place.onCluster());
    }
    void showAccuracy() {
        window->rooms().deck->choose(PanelDeck::Accuracy);
        chooseCluster(accuracyPanel().place());
        accuracyPanel().findChild<QLineEdit*>(QStringLiteral("multiples"))->setText(QStringLiteral("1, 2"));
    }
    void compare() { accuracyPanel().findChild<QPushButton*>(QStringLiteral("primary"))->click(); }
    void waitForComparison() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().accuracy->work().running(); }, patience));
    }
    widgets::AccuracyPanel& accuracyPanel() { return window->rooms().deck->accuracy(); }
    std::shared_ptr<const AccuracyReport> report() { return window->rooms().accuracy->work().report(); }
    std::size_t done() {
        const auto all = report();
        return all == nullptr ? 0u
                              : static_cast<std::size_t>(all->reference.done + std::count_if(all->points.begin(), all->points.end(),
                                                                                             [](const auto& p) { return p.done; }));
    }
    /// Answers the question that comes next.
    void answer(QMessageBox::StandardButton button) {
        QTimer::singleShot(100, window, [this, button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr) {
                answer(button);
                return;
            }
            m_asked = box->text();
            box->button(button)->click();
        });
    }
    io::JobRecord record() {
        const std::vector<std::string> ids = io::jobIds(m_cache.toStdString());
        EXPECT_EQ(ids.size(), 1u);
        return io::loadJob(m_cache.toStdString(), ids.at(0));
    }
    /// How many arrays were submitted.
    std::size_t arrays() {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(io::jobsFolder(m_cache.toStdString()) + "/" + record().id)) {
            count += entry.path().filename().string().starts_with("array-");
        }
        return count;
    }

    QTemporaryDir m_folder;
    QString m_cache = m_folder.filePath(QStringLiteral("cache"));
    QString m_case = m_folder.filePath(QStringLiteral("small.rubble"));
    QString m_asked;
};

TEST_F(ClusterWorkbench, AComparisonRunsOnTheClusterAndItsPointsComeIn) {
    showAccuracy();
    EXPECT_FALSE(window->rooms().accuracy->work().running());
    compare();
    EXPECT_TRUE(window->rooms().accuracy->work().running());
    EXPECT_FALSE(window->rooms().accuracy->work().simulatesHere());
    EXPECT_TRUE(window->actions()[ActionId::Simulate].isEnabled()) << "the cluster leaves this machine to itself";
    ASSERT_TRUE(QTest::qWaitFor([&] { return done() > 0; }, patience));
    EXPECT_FALSE(report()->complete) << "points come in while others are made";
    waitForComparison();
    ASSERT_NE(report(), nullptr);
    EXPECT_TRUE(report()->complete);
    EXPECT_EQ(done(), 4u);
    EXPECT_EQ(window->findChild<widgets::AccuracyPage*>()->table().rowCount(), 5) << "the reference, the floor, three settings";
    EXPECT_EQ(rail(PanelDeck::Accuracy), widgets::StageState::UpToDate);
    EXPECT_EQ(record().tasks.size(), 6u);
    EXPECT_EQ(arrays(), 1u);
    // Bit by bit what the command line makes on this machine.
    const cli::Outcome local = cli::cli({"accuracy", m_case.toStdString(), "--multiples", "1,2", "--no-fps", "--no-timing",
                                         "--json", "--cache", m_folder.filePath(QStringLiteral("other")).toStdString()});
    ASSERT_EQ(local.exitCode, 0) << local.err;
    for (std::size_t i = 0; i < report()->points.size(); ++i) {
        EXPECT_EQ(local.json()["details"][i]["trajectory_hash"], report()->points[i].trajectoryHash.hex());
    }
}

TEST_F(ClusterWorkbench, WholeClosingTheWindowStopsNothingAndTheCaseFindsItsJobAgain) {
    showAccuracy();
    OneNode::drain();
    compare();
    ASSERT_TRUE(QTest::qWaitFor([&] { return OneNode::tasksIn("PENDING") == 6; }, patience));
    openAgain();
    EXPECT_EQ(OneNode::tasksIn("PENDING"), 6u);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().accuracy->work().running(); }, patience)) << "it is followed again";
    EXPECT_EQ(accuracyPanel().findChild<QLineEdit*>(QStringLiteral("multiples"))->text(), QStringLiteral("1, 2"));
    EXPECT_TRUE(accuracyPanel().place().onCluster());
    OneNode::resume();
    waitForComparison();
    ASSERT_NE(report(), nullptr);
    EXPECT_TRUE(report()->complete);
    EXPECT_EQ(arrays(), 1u) << "nothing was submitted a second time";
    // A window that comes when all is made shows it without asking the cluster.
    openAgain();
    ASSERT_TRUE(QTest::qWaitFor([&] { return done() == 4; }, patience));
}

TEST_F(ClusterWorkbench, WholeCancelAsksAndTheSecondStartSendsOnlyWhatIsMissing) {
    showAccuracy();
    compare();
    ASSERT_TRUE(QTest::qWaitFor([&] { return done() > 0; }, patience));
    auto* cancel = accuracyPanel().findChild<QPushButton*>(QStringLiteral("cancelComparison"));
    answer(QMessageBox::No);
    cancel->click();
    EXPECT_FALSE(m_asked.isEmpty());
    EXPECT_TRUE(window->rooms().accuracy->work().running());
    answer(QMessageBox::Yes);
    cancel->click();
    waitForComparison();
    ASSERT_TRUE(QTest::qWaitFor([] { return OneNode::tasksIn("PENDING") + OneNode::tasksIn("RUNNING") == 0; }, patience));
    ASSERT_FALSE(report()->complete);
    EXPECT_FALSE(report()->findings.list().empty()) << "worlds that are missing are named";
    const std::size_t kept = done();
    compare();
    waitForComparison();
    EXPECT_TRUE(report()->complete);
    EXPECT_EQ(arrays(), 2u);
    const std::string second =
        textOf(QString::fromStdString(io::jobsFolder(m_cache.toStdString()) + "/" + record().id + "/tasks-2"));
    EXPECT_LE(static_cast<std::size_t>(std::count(second.begin(), second.end(), '\n')), 6 - kept);
}

TEST_F(ClusterWorkbench, WholeMembersOfAnEnsembleComeFromTheCluster) {
    session->document().setEnsemble({{variationFrom("friction", "uniform:0.3:0.5")}, 4, 1}, [] { return QStringLiteral("fewer"); });
    ASSERT_TRUE(window->rooms().files->saveTo(m_case));
    window->actions()[ActionId::ShowEnsemble].trigger();
    widgets::EnsemblePanel& panel = window->rooms().deck->ensemble();
    chooseCluster(panel.place());
    panel.findChild<QPushButton*>(QStringLiteral("primary"))->click();
    const auto made = [&] {
        const auto& ensemble = window->rooms().studies->ensemble().made().report;
        return ensemble == nullptr ? 0u : ensemble->done().size();
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return made() > 0; }, patience));
    EXPECT_LT(made(), 4u) << "members come in while others are made";
    EXPECT_NE(window->rooms().studies->ensemblePage().content().map, nullptr);
    openAgain();
    ASSERT_TRUE(QTest::qWaitFor([&] { return made() == 4 && !window->rooms().studies->ensemble().cluster().running(); }, patience));
    EXPECT_TRUE(window->rooms().studies->ensemble().made().report->complete);
    EXPECT_FALSE(window->rooms().studies->ensemble().stale());
    EXPECT_EQ(arrays(), 1u);
}

TEST_F(ClusterWorkbench, AClusterThatIsNotThereCannotBeChosenAndTheReasonIsSaid) {
    const auto reasonWith = [this](const char* variable, const QByteArray& value) {
        const QByteArray before = qgetenv(variable);
        qputenv(variable, value);
        openAgain();
        window->rooms().deck->choose(PanelDeck::Accuracy);
        widgets::PlaceChoice& place = accuracyPanel().place();
        // With the choice that cannot be made; beside one that works it would only stand in the way.
        const auto* cluster =
            qobject_cast<QStandardItemModel*>(place.findChild<QComboBox*>(QStringLiteral("place"))->model())->item(1);
        const auto said = [cluster] { return cluster->toolTip(); };
        EXPECT_TRUE(QTest::qWaitFor([&] { return !said().isEmpty() && !said().contains(u'…'); }, patience));
        EXPECT_FALSE(cluster->isEnabled());
        qputenv(variable, before);
        return said();
    };
    EXPECT_TRUE(reasonWith("PATH", "/nowhere").contains(QStringLiteral("sbatch")));
    // Nobody listens where this file says that the controller is.
    std::string conf = textOf(QString::fromUtf8(qgetenv("SLURM_CONF")));
    const std::size_t port = conf.find("SlurmctldPort=");
    conf.replace(port, conf.find('\n', port) - port, "SlurmctldPort=1");
    const QString path = m_folder.filePath(QStringLiteral("slurm.conf"));
    std::ofstream(path.toStdString()) << conf << "MessageTimeout=2\n";
    EXPECT_TRUE(reasonWith("SLURM_CONF", path.toUtf8()).contains(QStringLiteral("does not answer")));
}

}  // namespace

}  // namespace rubble
