#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/causes_display.h"
#include "app/gui/evidence/evidence_studies.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/survey_reach.h"
#include "io/case/case_file.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "widgets/evidence/causes_panel.h"

namespace rubble {
namespace {

/// A case of the small collapse beside another one, with a cache and a state of their own.
class CauseChoices : public FreshWorkbench {
protected:
    void SetUp() override {
        qputenv("RUBBLE_CACHE", m_cache.path().toUtf8());
        FreshWorkbench::SetUp();
        m_west = caseOf("west");
        openCase();
    }
    void TearDown() override {
        FreshWorkbench::TearDown();
        qunsetenv("RUBBLE_CACHE");
    }
    QString pathOf(const char* name) const { return m_folder.path() + u'/' + QLatin1String(name); }
    QString caseOf(const char* name) {
        const std::string path = pathOf(name).toStdString();
        Case made = io::caseForFe(cli::writeSmallCollapse(path + ".exo"), path + ".rubble");
        made.title = "Bridge";
        made.scenarios.front().scenario.simulation.settleTime = 1.0;
        made.ensemble = {{variationFrom("friction", "uniform:0.3:0.5")}, 2, 1};
        io::saveCase(path + ".rubble", made);
        return QString::fromStdString(path + ".rubble");
    }
    void openCase() {
        window->open(m_west);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    /// Heights every metre, a metre of debris in the middle.
    QString survey() {
        const io::AsciiGrid around{60, 60, -30.0, -30.0};
        return QString::fromStdString(around.write(pathOf("after.asc").toStdString(), [](double x, double y) {
            return std::abs(x) < 8.0 && std::abs(y) < 4.0 ? 1.0 : 0.0;
        }));
    }
    CausesDisplay& causes() { return window->rooms().studies->causes(); }
    QListWidget& listed(const char* name) {
        return *window->findChild<widgets::CausesPanel*>()->findChild<QListWidget*>(QLatin1String(name));
    }
    void tick(QListWidget& list, int row, Qt::CheckState state) { list.item(row)->setCheckState(state); }
    void compare() {
        window->actions()[ActionId::CompareCauses].trigger();
        ASSERT_TRUE(window->rooms().studies->work().comparing());
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().studies->work().running(); }, patience));
        ASSERT_NE(causes().made(), nullptr);
    }

    QTemporaryDir m_cache;
    QTemporaryDir m_folder;
    QString m_west;
};

TEST_F(CauseChoices, SurveysOfTheCaseAreEvidenceAsTheCaseSays) {
    causes().addCauses({caseOf("east")});
    window->rooms().survey->add(survey());
    QListWidget& evidence = listed("causeEvidence");
    ASSERT_EQ(evidence.count(), 1);
    EXPECT_EQ(evidence.item(0)->text(), QStringLiteral("height model: after.asc"));
    EXPECT_EQ(evidence.item(0)->checkState(), Qt::Checked) << "what the case has counts";
    const auto edit = [&](const auto& change) {
        std::vector<CaseInput> inputs = session->document().theCase().inputs;
        change(inputs.back());
        session->document().setSurveys(std::move(inputs), [] { return QStringLiteral("survey"); });
    };
    edit([](CaseInput& input) { input.noise = 0.25; });
    compare();
    ASSERT_NE(causes().made()->comparison, nullptr);
    EXPECT_EQ(causes().made()->comparison->evidence, std::vector<std::string>{"after.asc"});
    EXPECT_FALSE(causes().stale());
    edit([](CaseInput& input) { input.scope.area.polygons = {{{{-2.0, -2.0}, {2.0, -2.0}, {2.0, 2.0}, {-2.0, 2.0}}}}; });
    EXPECT_TRUE(causes().stale()) << "another part of it counts";
    edit([](CaseInput& input) { input.scope.area.polygons = {{{{900.0, 900.0}, {902.0, 900.0}, {902.0, 902.0}}}}; });
    window->actions()[ActionId::CompareCauses].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().studies->work().running(); }, patience));
    EXPECT_TRUE(causes().stale()) << "an area without any debris is refused, as that of a file is";
    // One of before the collapse, and one of another instant, are listed with the reason.
    edit([](CaseInput& input) {
        input.scope = {};
        input.before = true;
    });
    EXPECT_EQ(evidence.item(0)->checkState(), Qt::Unchecked);
    EXPECT_TRUE(evidence.item(0)->toolTip().contains(QStringLiteral("before the collapse")));
    EXPECT_FALSE(evidence.item(0)->flags().testFlag(Qt::ItemIsEnabled));
    edit([](CaseInput& input) {
        input.before = false;
        input.instant = 0.5;
    });
    EXPECT_TRUE(evidence.item(0)->toolTip().contains(QStringLiteral("not taken at rest")));
    // One that lies elsewhere does not count either.
    edit([](CaseInput& input) {
        input.instant.reset();
        input.registration.emplace().shift = Vec3(9'000.0, 0.0, 0.0);
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->part<SurveyReach>().busy(); }, patience));
    EXPECT_EQ(evidence.item(0)->checkState(), Qt::Unchecked);
    EXPECT_TRUE(evidence.item(0)->toolTip().contains(QStringLiteral("the structure stands at")));
    edit([](CaseInput& input) { input.registration.reset(); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->part<SurveyReach>().busy(); }, patience));
    EXPECT_EQ(evidence.item(0)->checkState(), Qt::Checked);
    // Added as something else it does not count twice.
    causes().addEvidence(io::EvidenceFile::Kind::Heights, {pathOf("after.asc")});
    ASSERT_EQ(evidence.count(), 2);
    EXPECT_EQ(evidence.item(0)->checkState(), Qt::Unchecked);
    EXPECT_EQ(evidence.item(1)->checkState(), Qt::Checked);
    // What the case says of its instant holds for it as well.
    edit([](CaseInput& input) { input.instant = 0.5; });
    EXPECT_EQ(evidence.item(1)->checkState(), Qt::Unchecked);
    EXPECT_TRUE(evidence.item(1)->toolTip().contains(QStringLiteral("not taken at rest")));
}

TEST_F(CauseChoices, ListAndComparisonCallThemAlike) {
    causes().addCauses({caseOf("pier"), caseOf("crown")});
    QListWidget& list = listed("causes");
    ASSERT_EQ(list.count(), 3);
    EXPECT_EQ(list.item(0)->text(), QStringLiteral("Bridge"));
    EXPECT_EQ(list.item(1)->text(), QStringLiteral("Bridge (pier)"));
    EXPECT_EQ(list.item(2)->text(), QStringLiteral("Bridge (crown)"));
    tick(list, 1, Qt::Unchecked);
    compare();
    EXPECT_EQ(causes().made()->causes, (std::vector<std::string>{"Bridge", "Bridge (crown)"}));
}

TEST_F(CauseChoices, WhatWasChosenIsThereTheNextTime) {
    const QString east = caseOf("east");
    causes().addCauses({east, caseOf("north")});
    window->rooms().survey->add(survey());
    causes().addEvidence(io::EvidenceFile::Kind::Footprint, {pathOf("outline.gpkg")});
    tick(listed("causes"), 2, Qt::Unchecked);
    tick(listed("causeEvidence"), 0, Qt::Unchecked);
    emit window->findChild<widgets::CausesPanel*>()->timeTold(timeEvidence(3.0, {1.0, 2.0}, 5.0, 0.5));
    ASSERT_TRUE(window->rooms().files->saveTo(m_west));
    const auto shown = [&] {
        QStringList rows;
        for (const char* name : {"causes", "causeEvidence"}) {
            for (int row = 0; row < listed(name).count(); ++row) {
                const QListWidgetItem& item = *listed(name).item(row);
                rows << item.text() + (item.checkState() == Qt::Checked ? u'+' : u'-');
            }
        }
        return rows;
    };
    const QStringList before = shown();
    ASSERT_EQ(before.size(), 6);
    startProgram();
    window->show();
    openCase();
    EXPECT_EQ(shown(), before);
    // Another case has none of it, and a cause that is gone is listed with the reason.
    QFile::remove(east);
    window->open(pathOf("north.rubble"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && session->document().path() == pathOf("north.rubble"); }, patience));
    EXPECT_EQ(listed("causes").count(), 1);
    openCase();
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().path() == m_west; }, patience));
    ASSERT_EQ(listed("causes").count(), 3);
    EXPECT_FALSE(listed("causes").item(1)->flags().testFlag(Qt::ItemIsUserCheckable));
    EXPECT_TRUE(listed("causes").item(1)->toolTip().contains(QStringLiteral("east.rubble")));
    // What is taken off the list is off it the next time as well.
    listed("causes").setCurrentRow(1);
    for (auto* button : window->findChild<widgets::CausesPanel*>()->findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("Remove") && button->isEnabled()) {
            button->click();
        }
    }
    startProgram();
    window->show();
    openCase();
    EXPECT_EQ(listed("causes").count(), 2);
}

TEST_F(CauseChoices, AChoiceThatCannotBeReadIsSaidAndSetAside) {
    QFile broken(m_west + QStringLiteral(".causes.json"));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("{\"format\": \"rubble-causes\", ");
    broken.close();
    startProgram();
    window->show();
    QStringList told;
    QObject::connect(session.get(), &Session::failed, session.get(), [&](const Failure& failure) { told << failure.what(); });
    openCase();
    EXPECT_TRUE(told.join(u' ').contains(QStringLiteral(".causes.json"))) << qPrintable(told.join(u' '));
    EXPECT_EQ(QDir(m_folder.path()).entryList({QStringLiteral("*.causes.json.damaged-*")}).size(), 1);
}

}  // namespace
}  // namespace rubble
