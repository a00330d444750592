#include <gtest/gtest.h>

#include <QTest>
#include <algorithm>
#include <fstream>

#include "app/gui/exports/export_source.h"
#include "app/gui/exports/picture_export.h"
#include "app/gui/stage/view_area.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"
#include "widgets/views/status_line.h"

namespace rubble {
namespace {

/// The window opens cases as command line, ensembles and Python do: tests/io/case/open_case_test.cpp.
class OneDoor : public Workbench {
protected:
    void SetUp() override {
        Workbench::SetUp();
        m_case = io::caseForFe(cli::writeSmallCollapse(m_folder / "small.exo"), m_path);
    }
    void openIt() {
        io::saveCase(m_path, m_case);
        window->open(QString::fromStdString(m_path));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() || session->computation().failure().has_value(); }, patience));
    }
    bool idle() {
        return QTest::qWaitFor([&] { return !session->computation().busy(); }, patience);
    }

    io::TemporaryFolder m_folder;
    std::string m_path = m_folder / "small.rubble";
    Case m_case;
};

TEST_F(OneDoor, AScenarioThatNamesNoFeInputStandsOnTheOneOfTheCase) {
    m_case.scenarios[0].feInput.clear();
    openIt();
    ASSERT_FALSE(session->computation().failure()) << session->computation().failure()->what().toStdString();
    EXPECT_TRUE(prepared());
}

TEST_F(OneDoor, AFigureMadeBeforeARunCarriesTheSite) {
    std::ofstream(m_folder / "house.obj") << "v 4 -1 0\nv 6 -1 0\nv 4 1 1\nf 1 2 3\n";
    io::AsciiGrid().writeLevel(m_folder / "level.asc", -1.5);
    m_case.inputs.push_back({"terrain-1", InputRole::Terrain, "level.asc", {}});
    m_case.inputs.push_back({"surroundings-1", InputRole::Surroundings, "house.obj", {}});
    m_case.site.heightShift = 0.25;
    m_case.site.collide = true;
    setParameterText(m_case.scenarios[0].scenario, "settle_time", "0.5");
    openIt();
    ASSERT_TRUE(prepared());
    const std::string figure = m_folder / "before.svg";
    window->rooms().pictures->exportFigureTo(QString::fromStdString(figure), {{}, {320, 200}, 50}, window->area().views().view(),
                                             window->rooms().scene->data());
    ASSERT_TRUE(idle());
    const auto carried = io::readProvenance(figure);
    ASSERT_TRUE(carried);
    EXPECT_NE(carried->text.find("\"height_shift_m\":0.25"), std::string::npos) << carried->text;
    EXPECT_NE(carried->text.find("house.obj"), std::string::npos) << carried->text;
    const io::RunOrigin before = shownOrigin(session->document(), session->computation());
    simulateToEnd();
    const io::RunOrigin& after = session->computation().currentRun()->reader->origin();
    EXPECT_EQ(before.fePath, after.fePath);
    EXPECT_EQ(before.fingerprint, after.fingerprint);
    EXPECT_EQ(before.site, after.site);
    ASSERT_EQ(before.surroundings.size(), 1u);
    EXPECT_EQ(before.surroundings[0].sha256, after.surroundings[0].sha256);
}

TEST_F(OneDoor, AnFeResultThatChangedIsAFindingUntilItIsAccepted) {
    openIt();
    io::ExodusBuilder other = cli::smallCollapse();
    other.times.back() += 0.05;
    other.write(m_folder / "small.exo");
    window->open(QString::fromStdString(m_path));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && session->computation().inputs().fe->times().back() > 0.52; }, patience));
    EXPECT_EQ(session->computation().findings().count("case.input_changed"), 1);
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs[0].sha256 = session->computation().inputs().fe->contents().sha256;
    session->document().setInputs(inputs, [] { return QStringLiteral("accepted"); });
    EXPECT_EQ(session->computation().findings().count("case.input_changed"), 0);
    session->document().undoStack().undo();
    EXPECT_EQ(session->computation().findings().count("case.input_changed"), 1);
}

TEST_F(OneDoor, ACaseWithoutAnyScenarioOpensAndSaysWhatIsMissing) {
    m_case.scenarios.clear();
    m_case.activeScenario.clear();
    openIt();
    ASSERT_TRUE(session->computation().failure());
    EXPECT_EQ(session->computation().failure()->id, "case.without_scenarios");
    EXPECT_EQ(session->document().path().toStdString(), m_path);
}

}  // namespace
}  // namespace rubble
