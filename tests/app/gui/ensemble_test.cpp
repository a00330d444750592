#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <filesystem>

#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/causes_display.h"
#include "app/gui/evidence/ensemble_display.h"
#include "app/gui/evidence/evidence_studies.h"
#include "app/gui/exports/report_work.h"
#include "io/case/case_file.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "widgets/basics/evidence_tabs.h"
#include "widgets/basics/panel.h"
#include "widgets/case/case_panel.h"
#include "widgets/evidence/causes_page.h"
#include "widgets/evidence/causes_panel.h"
#include "widgets/evidence/ensemble_page.h"
#include "widgets/evidence/ensemble_panel.h"

namespace rubble {
namespace {

/// A window with the small collapse, whose members take a fraction of a second, and a cache of its own.
class Studies : public Workbench {
protected:
    void SetUp() override {
        qputenv("RUBBLE_CACHE", m_cache.path().toUtf8());
        Workbench::SetUp();
        m_west = pathOf("west.exo");
        cli::writeSmallCollapse(m_west.toStdString());
        window->open(m_west);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        session->document().setParameter(QStringLiteral("settle_time"), 1.0);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    void TearDown() override {
        endProgram();
        qunsetenv("RUBBLE_CACHE");
    }
    QString pathOf(const char* name) const { return m_folder.path() + u'/' + QLatin1String(name); }
    EnsembleDisplay& ensemble() { return window->rooms().studies->ensemble(); }
    CausesDisplay& causes() { return window->rooms().studies->causes(); }
    void varyOnlyFriction(std::int64_t members) {
        session->document().setEnsemble({{variationFrom("friction", "uniform:0.3:0.5")}, members, 1},
                                        [] { return QStringLiteral("fewer"); });
    }
    void simulate() {
        window->actions()[ActionId::SimulateEnsemble].trigger();
        wait();
    }
    void wait() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().studies->work().running(); }, patience));
    }
    std::size_t kept() {
        std::size_t count = 0;
        for (const EnsembleMember& member : ensemble().made().report->members) {
            count += member.kept ? 1 : 0;
        }
        return count;
    }
    /// The same collapse six metres to the east.
    QString east() {
        io::ExodusBuilder builder = cli::smallCollapse();
        for (Vec3& node : builder.nodes) {
            node.x() += 6.0;
        }
        builder.write(pathOf("east.exo").toStdString());
        return pathOf("east.exo");
    }

    QTemporaryDir m_cache;
    QTemporaryDir m_folder;
    QString m_west;
};

TEST_F(Studies, WhatAnEnsembleVariesIsKeptInTheCaseAndUndone) {
    auto* members = window->rooms().deck->ensemble().findChild<QSpinBox*>(QStringLiteral("members"));
    window->actions()[ActionId::ShowEnsemble].trigger();
    EXPECT_TRUE(window->rooms().studies->ensemblePage().isVisible());
    members->setValue(5);
    EXPECT_EQ(session->document().theCase().ensemble.members, 5);
    EXPECT_EQ(session->document().undoStack().undoText(), QStringLiteral("members of the ensemble"));
    session->document().undoStack().undo();
    EXPECT_EQ(session->document().theCase().ensemble.members, 16);
    EXPECT_EQ(members->value(), 16);
    session->document().undoStack().redo();
    const QString path = pathOf("west.rubble");
    ASSERT_TRUE(window->rooms().files->saveTo(path));
    const Case saved = io::loadCase(path.toStdString());
    EXPECT_EQ(saved.ensemble.members, 5);
    ASSERT_FALSE(saved.journal.entries.empty());
    const auto& changes = saved.journal.entries.back().changes;
    EXPECT_TRUE(std::any_of(changes.begin(), changes.end(),
                            [](const JournalChange& change) { return change.place == "ensemble/members" && change.after == "5"; }));
}

TEST_F(Studies, MembersComeInAndASecondStartTakesThemFromTheCache) {
    varyOnlyFriction(3);
    simulate();
    ASSERT_NE(ensemble().made().report, nullptr);
    EXPECT_TRUE(ensemble().made().report->complete);
    EXPECT_EQ(kept(), 0u);
    EXPECT_FALSE(ensemble().stale());
    const widgets::EnsemblePage& page = window->rooms().studies->ensemblePage();
    ASSERT_NE(page.content().map, nullptr);
    EXPECT_EQ(page.content().map->members, 3);
    varyOnlyFriction(5);
    EXPECT_FALSE(ensemble().stale()) << "more members are asked for, those that are there still hold";
    simulate();
    EXPECT_EQ(kept(), 3u);
    EXPECT_EQ(page.content().map->members, 5);
    // Another setting makes them stale; undo brings them back.
    session->document().setParameter(QStringLiteral("ground_height"), -1.0);
    EXPECT_TRUE(ensemble().stale());
    EXPECT_TRUE(page.content().stale);
    session->document().undoStack().undo();
    EXPECT_FALSE(ensemble().stale());
}

TEST_F(Studies, AReportReadsMembersAndSimulatesNone) {
    varyOnlyFriction(3);
    simulate();
    simulateToEnd();
    ASSERT_EQ(window->rooms().runs->costlyWork(), QString());
    QStringList told;
    QObject::connect(&session->computation(), &Computation::progressed, window, [&](const QString& what) { told << what; });
    QTemporaryDir folder;
    window->rooms().deck->choose(PanelDeck::Report);
    window->rooms().report->writeTo(folder.filePath(QStringLiteral("report")));
    ASSERT_TRUE(session->computation().busy());
    EXPECT_EQ(window->rooms().runs->costlyWork(), QString()) << "no study runs";
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("report/report.html"))));
    EXPECT_FALSE(told.isEmpty());
    // Repeats of the run are simulated; what is read of few members may be too brief to be told.
    EXPECT_TRUE(told.filter(QStringLiteral("members of the ensemble")).filter(QStringLiteral("simulating")).isEmpty())
        << told.join(u'\n').toStdString();
}

TEST_F(Studies, WritesItsMapAndItsMembers) {
    varyOnlyFriction(2);
    simulate();
    for (const char* name : {"map.tif", "map.csv", "map.png"}) {
        ensemble().saveMapTo(pathOf(name));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
        EXPECT_TRUE(std::filesystem::exists(pathOf(name).toStdString())) << name;
        EXPECT_NE(textOf(pathOf(name) + QStringLiteral(".provenance.json")).find("trajectory_hash"), std::string::npos) << name;
    }
    ensemble().saveTableTo(pathOf("members.csv"));
    const std::string table = textOf(pathOf("members.csv"));
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
    ensemble().saveTableTo(pathOf("no/such/folder.csv"));
    EXPECT_FALSE(window->rooms().deck->casePanel().findChildren<widgets::Notice*>().isEmpty());
}

TEST_F(Studies, TheMapLiesOnTheGroundOfTheViews) {
    varyOnlyFriction(2);
    simulate();
    EXPECT_EQ(window->rooms().scene->data().orthophoto, nullptr);
    auto* onGround = window->rooms().studies->ensemblePage().findChild<QToolButton*>(QStringLiteral("onGround"));
    onGround->click();
    const auto picture = window->rooms().scene->data().orthophoto;
    ASSERT_NE(picture, nullptr);
    EXPECT_EQ(picture->pixel, 0.5);
    EXPECT_EQ(picture->rgba.size(), 4u * static_cast<std::size_t>(picture->width * picture->height));
    window->rooms().studies->ensemblePage().setLayer(MapLayer::HeightHigh);
    EXPECT_NE(window->rooms().scene->data().orthophoto, picture) << "the layer that is chosen";
    onGround->click();
    EXPECT_EQ(window->rooms().scene->data().orthophoto, nullptr);
}

TEST_F(Studies, CancelKeepsWhatIsDone) {
    varyOnlyFriction(400);
    window->actions()[ActionId::SimulateEnsemble].trigger();
    EXPECT_TRUE(window->rooms().studies->work().simulating());
    EXPECT_FALSE(window->actions()[ActionId::Simulate].isEnabled()) << "a run beside it would take its time";
    ASSERT_TRUE(QTest::qWaitFor([&] { return ensemble().made().report != nullptr && !ensemble().made().report->done().empty(); },
                                patience));
    window->actions()[ActionId::Cancel].trigger();
    wait();
    EXPECT_FALSE(ensemble().made().report->complete);
    EXPECT_FALSE(ensemble().made().report->done().empty());
    EXPECT_TRUE(window->actions()[ActionId::Simulate].isEnabled());
}

TEST_F(Studies, CausesAreComparedAndTheClosestIsNamed) {
    varyOnlyFriction(10);
    causes().addCauses({east()});
    // What was found is the map of the east with a friction that no member has.
    const cli::Outcome map = cli::cli({"map", east().toStdString(), "--set", "friction=0.43", "--set", "settle_time=1", "--cell",
                                       "0.5", "--out", pathOf("found.tif").toStdString()});
    ASSERT_EQ(map.exitCode, 0) << map.err;
    causes().addEvidence(io::EvidenceFile::Kind::Heights, {pathOf("found.tif")});
    window->actions()[ActionId::CompareCauses].trigger();
    EXPECT_TRUE(window->rooms().studies->causesPage().isVisible());
    EXPECT_TRUE(window->rooms().runs->costlyWork().startsWith(QStringLiteral("Causes are being compared")));
    wait();
    ASSERT_NE(causes().made(), nullptr);
    const CauseComparison& made = *causes().made()->comparison;
    EXPECT_EQ(made.hypotheses[made.ranking.causes.front().hypothesis], "east");
    EXPECT_TRUE(made.ranking.decided());
    const EnsembleMember& member = causes().made()->hypotheses[1].ensemble->members.front();
    EXPECT_EQ(member.scenario.simulation.settleTime, 1.0) << "an FE result takes the settings of the case";
    EXPECT_FALSE(causes().stale());
    const widgets::CausesPage& page = window->rooms().studies->causesPage();
    EXPECT_NE(page.content().separation, nullptr);
    causes().saveTableTo(pathOf("causes.csv"));
    EXPECT_NE(textOf(pathOf("causes.csv")).find("1,east,10,"), std::string::npos);
    causes().saveMapTo(pathOf("separation.tif"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    EXPECT_TRUE(std::filesystem::exists(pathOf("separation.tif").toStdString()));
    varyOnlyFriction(12);
    EXPECT_TRUE(causes().stale());
    // The command line says the same.
    const cli::Outcome told = cli::cli({"compare", m_west.toStdString(), pathOf("east.exo").toStdString(), "--against",
                                        "height=" + pathOf("found.tif").toStdString(), "--members", "10", "--vary",
                                        "friction=uniform:0.3:0.5", "--set", "settle_time=1", "--json"});
    ASSERT_EQ(told.exitCode, 0) << told.err;
    EXPECT_EQ(told.json()["closest"], "east");
}

TEST_F(Studies, OneCauseIsNoneAndABadFileIsToldInPlace) {
    window->actions()[ActionId::ShowCauses].trigger();
    causes().compare();
    EXPECT_FALSE(window->rooms().studies->work().running()) << "one cause cannot be compared";
    QFile wrong(pathOf("wrong.exo"));
    ASSERT_TRUE(wrong.open(QIODevice::WriteOnly));
    wrong.write("no result");
    wrong.close();
    varyOnlyFriction(2);
    causes().addCauses({pathOf("wrong.exo")});
    causes().compare();
    wait();
    EXPECT_EQ(causes().made(), nullptr);
    bool told = false;
    for (const auto* notice : window->rooms().deck->causes().findChildren<widgets::Notice*>()) {
        told = told || notice->text().contains(QStringLiteral("wrong.exo"));
    }
    EXPECT_TRUE(told);
}

TEST_F(Studies, ABlindTestNeedsNoEvidence) {
    varyOnlyFriction(2);
    causes().addCauses({east()});
    causes().compare();
    wait();
    ASSERT_NE(causes().made(), nullptr);
    EXPECT_EQ(causes().made()->comparison, nullptr);
    ASSERT_EQ(causes().made()->blind.size(), 2u);
    EXPECT_EQ(causes().made()->blind[0].trials(), 4);
}

}  // namespace
}  // namespace rubble
