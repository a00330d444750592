#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QStandardItemModel>
#include <fstream>

#include "app/gui/evidence/causes_display.h"
#include "app/gui/evidence/evidence_studies.h"
#include "app/gui/exports/report_work.h"
#include "core/scenario/case.h"
#include "io/case/case_file.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"
#include "widgets/basics/language.h"
#include "widgets/basics/panel.h"
#include "widgets/case/preferences_dialog.h"
#include "widgets/evidence/report_panel.h"

namespace rubble {

namespace {

/// The Report panel with a run of the small collapse, and a cache of its own.
class ReportFields : public FreshWorkbench {
protected:
    void SetUp() override {
        qputenv("RUBBLE_CACHE", QByteArray::fromStdString(m_folder / "cache"));
        FreshWorkbench::SetUp();
        Case theCase = io::caseForFe(cli::writeSmallCollapse(m_folder / "small.exo"), m_folder / "small.rubble");
        setParameterText(theCase.scenarios[0].scenario, "settle_time", "0.5");
        theCase.ensemble.members = 2;
        io::saveCase(m_folder / "small.rubble", theCase);
        window->open(QString::fromStdString(m_folder / "small.rubble"), true);
        awaitRun();
        QTest::mouseClick(window->rooms().deck->rail().findChildren<QAbstractButton*>().at(PanelDeck::Report), Qt::LeftButton);
        part<QSpinBox>("reportRepeats").setValue(0);
        auto& selfTest = part<QComboBox>("reportSelfTest");
        selfTest.setCurrentIndex(selfTest.findData(QStringLiteral("none")));
    }
    void TearDown() override {
        FreshWorkbench::TearDown();
        qunsetenv("RUBBLE_CACHE");
    }
    widgets::ReportPanel& panel() { return window->rooms().deck->report(); }
    template <typename Kind>
    Kind& part(const char* name) {
        return *panel().findChild<Kind*>(QLatin1String(name));
    }
    void type(const char* field, const QString& text) {
        auto& edit = part<QPlainTextEdit>(field);
        panel().ensureWidgetVisible(&edit);
        QTest::mouseClick(edit.viewport(), Qt::LeftButton);
        QTest::keyClicks(QApplication::focusWidget(), text);
    }
    void chooseCauses(int item) {
        auto& causes = part<QComboBox>("reportCauses");
        panel().ensureWidgetVisible(&causes);
        causes.setFocus();
        while (causes.currentIndex() > 0) {
            QTest::keyClick(&causes, Qt::Key_Up);
        }
        for (int i = 0; i < item; ++i) {
            QTest::keyClick(&causes, Qt::Key_Down);
        }
    }
    void check() {
        panel().ensureWidgetVisible(&part<QPushButton>("checkReport"));
        QTest::mouseClick(&part<QPushButton>("checkReport"), Qt::LeftButton);
        EXPECT_TRUE(window->rooms().report->writing());
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().report->writing(); }, patience));
    }
    std::string report() {
        const std::string folder = m_folder / "report";
        window->rooms().report->writeTo(QString::fromStdString(folder));
        EXPECT_TRUE(QTest::qWaitFor([&] { return !window->rooms().report->writing(); }, patience));
        return textOf(QString::fromStdString(folder + "/report.html"));
    }
    QString text(const char* label) {
        const auto& shown = part<QLabel>(label);
        return shown.isVisibleTo(&panel()) ? shown.text() : QString();
    }

    io::TemporaryFolder m_folder;
};

TEST_F(ReportFields, WhatTheAuthorSaysIsAskedForUntilItIsSaidAndStandsInTheReport) {
    EXPECT_TRUE(text("reportUnsaid").contains(QStringLiteral("plain language")));
    EXPECT_TRUE(text("reportUnsaid").contains(QStringLiteral("would change")));
    type("reportSummary", QStringLiteral("The deck fell to the east."));
    EXPECT_FALSE(text("reportUnsaid").contains(QStringLiteral("plain language")));
    type("reportCustody", QStringLiteral("The county held the photographs."));
    type("reportAlternatives", QStringLiteral("Scour was excluded."));
    type("reportChange", QStringLiteral("Debris on the north bank."));
    type("reportQualification", QStringLiteral("Engineer since 1998."));
    EXPECT_TRUE(text("reportUnsaid").isEmpty()) << qPrintable(text("reportUnsaid"));
    const std::string html = report();
    for (const char* words : {"The deck fell to the east.", "The county held the photographs.", "Scour was excluded.",
                              "Debris on the north bank.", "Engineer since 1998."}) {
        EXPECT_NE(html.find(words), std::string::npos) << words;
    }
    // Another case has other words, and the first one has its own again.
    const QString first = session->document().base();
    window->open(QString::fromStdString(cli::writeSmallCollapse(m_folder / "other.exo")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().base() != first && prepared(); }, patience));
    EXPECT_TRUE(panel().wishes().words.summary.empty());
    EXPECT_TRUE(text("reportUnsaid").contains(QStringLiteral("plain language")));
    window->open(first);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().base() == first && prepared(); }, patience));
    EXPECT_EQ(panel().wishes().words.summary, "The deck fell to the east.");
    // A language is another window.
    const widgets::ReportWishes before = panel().wishes();
    widgets::Preferences preferences = session->preferences();
    preferences.language = QStringLiteral("zh_CN");
    session->setPreferences(preferences);
    ASSERT_TRUE(QTest::qWaitFor([&] { return widgets::currentLanguage() == QLatin1String("zh_CN"); }, patience));
    EXPECT_EQ(panel().wishes().words.summary, before.words.summary);
    EXPECT_EQ(panel().wishes().words.change, before.words.change);
}

TEST_F(ReportFields, WhatItLacksIsCheckedAndFollowsWhatIsTyped) {
    EXPECT_TRUE(text("reportGaps").isEmpty());
    EXPECT_TRUE(text("reportChecked").contains(QStringLiteral("Not checked")));
    check();
    EXPECT_FALSE(QFile::exists(QString::fromStdString(m_folder / "report"))) << "nothing is written";
    EXPECT_TRUE(text("reportGaps").contains(QStringLiteral("no question")));
    EXPECT_TRUE(text("reportGaps").contains(QStringLiteral("no intervals")));
    EXPECT_TRUE(text("reportGaps").contains(QStringLiteral("no photograph and no survey")));
    EXPECT_TRUE(text("reportGaps").contains(QStringLiteral("was not tested")));
    type("reportQuestion", QStringLiteral("Where did it fall?"));
    EXPECT_FALSE(text("reportGaps").contains(QStringLiteral("no question"))) << "without another check";
    auto& repeats = part<QSpinBox>("reportRepeats");
    repeats.setFocus();
    QTest::keyClick(&repeats, Qt::Key_Up);
    EXPECT_FALSE(text("reportGaps").contains(QStringLiteral("no intervals")));
    session->document().setParameter(QStringLiteral("friction"), 0.3);
    EXPECT_TRUE(text("reportGaps").isEmpty()) << "of another run";
    EXPECT_TRUE(text("reportChecked").contains(QStringLiteral("Not checked")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_FALSE(part<QPushButton>("checkReport").isEnabled()) << "a stale run is not reported";
}

TEST_F(ReportFields, AComparisonThatWasPrintedIntoAFileBecomesATable) {
    const std::string path = m_folder / "causes.json";
    std::ofstream(path) << R"({"told_apart": true, "unexplained": false, "evidence": [{"name": "banks.asc"}], "ranking": [
        {"cause": "scour of pier 2", "score": {"members": 8}, "closest_over_it": null, "told_apart": null},
        {"cause": "overload", "score": {"members": 8}, "closest_over_it": {"share": 0.95, "low": 0.8, "high": 1.0},
         "told_apart": true}]})";
    const auto choose = [](const QString& file) {
        whenAsked([file](QDialog& dialog) {
            auto* files = qobject_cast<QFileDialog*>(&dialog);
            if (file.isEmpty()) {
                QTest::keyClick(files, Qt::Key_Escape);
                return;
            }
            auto* name = files->findChild<QLineEdit*>();
            name->setText(file);
            QTest::keyClick(name, Qt::Key_Return);
        });
    };
    auto& causes = part<QComboBox>("reportCauses");
    // Nothing was compared in this window: the keys pass over that.
    choose({});
    chooseCauses(1);
    EXPECT_EQ(panel().wishes().causes, widgets::ReportedCauses::None) << "no file was chosen";
    choose(QString::fromStdString(path));
    chooseCauses(1);
    EXPECT_EQ(panel().wishes().causes, widgets::ReportedCauses::File);
    EXPECT_TRUE(causes.currentText().contains(QStringLiteral("causes.json")));
    EXPECT_FALSE(text("reportUnsaid").contains(QStringLiteral("other causes")));
    const std::string html = report();
    EXPECT_NE(html.find("scour of pier 2"), std::string::npos);
    EXPECT_NE(html.find("excluded"), std::string::npos);
    std::ofstream(path) << "{}";
    report();
    EXPECT_FALSE(panel().findChildren<widgets::Notice*>().front()->text().isEmpty()) << "what is wrong with the file is said";
}

TEST_F(ReportFields, AFolderThatIsNotThereIsNamedAndMade) {
    const QString made = QString::fromStdString(m_folder / "new place/report");
    const QString under = QString::fromStdString(m_folder / "small.exo/report");
    const auto askedFor = [&](const QStringList& names, bool cancels) {
        whenAsked([names, cancels](QDialog& dialog) {
            auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
            for (const QString& each : names) {
                name->setText(each);
                QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open), Qt::LeftButton);
            }
            if (cancels) {
                const auto* notice = dialog.findChild<widgets::Notice*>();
                EXPECT_TRUE(notice->text().contains(QStringLiteral("small.exo is no folder that you may write to")))
                    << qPrintable(notice->text());
                QTest::keyClick(&dialog, Qt::Key_Escape);
            }
        });
        panel().ensureWidgetVisible(&part<QPushButton>("writeReport"));
        QTest::mouseClick(&part<QPushButton>("writeReport"), Qt::LeftButton);
    };
    askedFor({under}, true);
    EXPECT_FALSE(window->rooms().report->writing());
    askedFor({under, made}, false);
    EXPECT_TRUE(window->rooms().report->writing());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().report->writing(); }, patience));
    EXPECT_TRUE(QFile::exists(made + QStringLiteral("/report.html")))
        << qPrintable(panel().findChildren<widgets::Notice*>().front()->text());
}

TEST_F(ReportFields, WhatThePageCausesComparedBecomesATable) {
    auto& causes = part<QComboBox>("reportCauses");
    const QStandardItem* page = qobject_cast<QStandardItemModel*>(causes.model())->item(1);
    EXPECT_FALSE(page->isEnabled());
    EXPECT_FALSE(page->toolTip().isEmpty());
    io::ExodusBuilder builder = cli::smallCollapse();
    for (Vec3& node : builder.nodes) {
        node.x() += 6.0;
    }
    builder.write(m_folder / "east.exo");
    std::ofstream(m_folder / "after.asc") << "ncols 4\nnrows 4\nxllcorner -10\nyllcorner -10\ncellsize 10\nNODATA_value -9999\n"
                                             "0 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 0\n";
    CausesDisplay& study = window->rooms().studies->causes();
    study.addCauses({QString::fromStdString(m_folder / "east.exo")});
    study.addEvidence(io::EvidenceFile::Kind::Heights, {QString::fromStdString(m_folder / "after.asc")});
    study.compare();
    ASSERT_TRUE(QTest::qWaitFor([&] { return study.made() != nullptr && !window->rooms().studies->work().running(); }, patience));
    ASSERT_NE(study.made()->comparison, nullptr);
    ASSERT_TRUE(QTest::qWaitFor([&] { return page->isEnabled(); }, patience));
    chooseCauses(1);
    ASSERT_EQ(panel().wishes().causes, widgets::ReportedCauses::Page);
    const std::string html = report();
    EXPECT_NE(html.find("east.exo"), std::string::npos) << "what was compared stands among the files";
    const CauseComparison& made = *study.made()->comparison;
    for (const std::string& name : made.hypotheses) {
        EXPECT_NE(html.find(">" + name + "</"), std::string::npos) << name;
    }
    const ReportCauses told = reportCauses(made, study.made()->findings, study.made()->further.get());
    ASSERT_EQ(told.ranked.size(), 2u);
    EXPECT_EQ(told.ranked[0].members, 2);
    EXPECT_EQ(told.ranked[1].apart, made.ranking.causes[1].apart);
    // Another cause left out: the comparison is not of now any more.
    window->rooms().studies->causes().addEvidence(io::EvidenceFile::Kind::Footprint,
                                                  {QString::fromStdString(m_folder / "none.gpkg")});
    EXPECT_TRUE(study.stale());
    window->rooms().report->refresh();
    EXPECT_FALSE(page->isEnabled());
    EXPECT_EQ(panel().wishes().causes, widgets::ReportedCauses::None);
}

}  // namespace

}  // namespace rubble
