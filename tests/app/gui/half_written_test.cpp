#include <QDir>
#include <QElapsedTimer>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <fstream>

#include "app/gui/evidence/ensemble_display.h"
#include "app/gui/evidence/evidence_display.h"
#include "app/gui/evidence/evidence_studies.h"
#include "app/gui/exports/picture_export.h"
#include "app/gui/exports/report_work.h"
#include "app/gui/stage/view_area.h"
#include "io/case/case_file.h"
#include "io/run/run_file.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/photographed_case.h"
#include "widgets/evidence/report_panel.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// The window is closed while something works: it ends, and what it was to write is there whole or not at all.
class HalfWritten : public Workbench {
protected:
    void SetUp() override {
        qputenv("RUBBLE_CACHE", m_cache.path().toUtf8());
        Workbench::SetUp();
    }
    void TearDown() override {
        endProgram();
        qunsetenv("RUBBLE_CACHE");
    }
    void openCase(const Case& theCase, double settle) {
        Case saved = theCase;
        setParameterText(saved.scenarios[0].scenario, "settle_time", std::to_string(settle));
        io::saveCase(m_path, saved);
        window->open(QString::fromStdString(m_path), true);
        awaitRun();
    }
    void openSmall() { openCase(io::caseForFe(cli::writeSmallCollapse(m_folder / "small.exo"), m_path), 0.5); }
    void close() {
        session->document().undoStack().setClean();
        QElapsedTimer clock;
        clock.start();
        endProgram();
        EXPECT_LT(clock.elapsed(), patience / 3) << "it waited for the work instead of ending it";
        QTest::qWait(50);
    }
    /// Files of a folder of the test whose names hold a text.
    std::vector<std::string> named(const std::string& part) const {
        std::vector<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(m_folder.path())) {
            if (entry.is_regular_file() && entry.path().filename().string().find(part) != std::string::npos) {
                found.push_back(entry.path().filename().string());
            }
        }
        return found;
    }

    QTemporaryDir m_cache;
    io::TemporaryFolder m_folder;
    std::string m_path = m_folder / "small.rubble";
};

TEST_F(HalfWritten, AFigureIsWholeOrNotThere) {
    openSmall();
    window->rooms().pictures->exportFigureTo(QString::fromStdString(m_folder / "figure.pdf"),
                                             {figures::FigurePreset::Pairs, {4800, 3000}, 400}, window->area().views().view(),
                                             window->rooms().scene->data());
    ASSERT_TRUE(session->computation().busy());
    close();
    for (const std::string& name : named("figure")) {
        EXPECT_EQ(name, "figure.pdf") << "half of a figure was left";
        std::ifstream file(m_folder / name, std::ios::binary | std::ios::ate);
        file.seekg(-6, std::ios::end);
        std::string end(6, ' ');
        file.read(end.data(), 6);
        EXPECT_NE(end.find("%%EOF"), std::string::npos);
    }
}

TEST_F(HalfWritten, AReportIsWholeOrNotThere) {
    openSmall();
    window->rooms().deck->report().findChild<QSpinBox*>(QStringLiteral("reportRepeats"))->setValue(50);
    window->rooms().report->writeTo(QString::fromStdString(m_folder / "report"));
    ASSERT_TRUE(window->rooms().report->writing());
    QTest::qWait(100);
    close();
    EXPECT_TRUE(named("report.").empty());
}

TEST_F(HalfWritten, AComparisonWithAPhotographEnds) {
    Case theCase = io::caseForFe(cli::writeSmallCollapse(m_folder / "small.exo"), m_path);
    cli::addPhotograph(theCase, m_folder / "site.tif");
    openCase(theCase, 2.0);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return window->rooms().evidence->settled() && window->rooms().evidence->match(); }, patience));
    window->rooms().evidence->compare();
    ASSERT_TRUE(window->rooms().evidence->work().comparing());
    close();
}

TEST_F(HalfWritten, MembersThatAreDoneAreKept) {
    openSmall();
    session->document().setEnsemble({{variationFrom("friction", "uniform:0.3:0.5")}, 400, 1},
                                    [] { return QStringLiteral("many"); });
    window->actions()[ActionId::SimulateEnsemble].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().studies->ensemble().made().report != nullptr; }, patience));
    ASSERT_TRUE(window->rooms().studies->work().running());
    close();
    EXPECT_FALSE(QDir(m_cache.path()).isEmpty()) << "members are kept for the next start";
    for (const auto& entry : fs::recursive_directory_iterator(m_cache.path().toStdString())) {
        EXPECT_EQ(entry.path().extension().string().find("tmp"), std::string::npos) << entry.path();
    }
}

}  // namespace
}  // namespace rubble
