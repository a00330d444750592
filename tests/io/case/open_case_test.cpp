#include "io/case/open_case.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/case/case_file.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// The small collapse on a level terrain, beside a house that debris falls on, with two scenarios.
class CaseDoor : public testing::Test {
protected:
    void SetUp() override {
        m_case = caseForFe(cli::writeSmallCollapse(m_folder / "small.exo"), m_path);
        AsciiGrid().writeLevel(m_folder / "level.asc", -1.5);
        std::ofstream(m_folder / "house.obj") << "v 4 -1 0\nv 6 -1 0\nv 4 1 1\nf 1 2 3\n";
        m_case.inputs.push_back({"terrain-1", InputRole::Terrain, "level.asc", {}});
        m_case.inputs.push_back({"surroundings-1", InputRole::Surroundings, "house.obj", {}});
        m_case.site.collide = true;
        m_case.scenarios.push_back(m_case.scenarios.front());
        m_case.scenarios.back().id = "scenario-2";
        m_case.scenarios.back().name = "low ground";
        m_case.scenarios.back().scenario.simulation.groundHeight = -3.0;
        m_request.path = m_path;
    }
    OpenedCase open() {
        saveCase(m_path, m_case);
        return openCase(m_request, Execution());
    }
    std::string refusal() {
        try {
            open();
        } catch (const UsageError& error) {
            EXPECT_FALSE(error.remedy().pattern.empty());
            return error.message().id;
        }
        return {};
    }

    TemporaryFolder m_folder;
    std::string m_path = m_folder / "small.rubble";
    Case m_case;
    CaseRequest m_request;
};

TEST_F(CaseDoor, EverythingThatARunStandsOnIsThere) {
    const OpenedCase opened = open();
    EXPECT_EQ(opened.scenarioId, "scenario-1");
    EXPECT_EQ(opened.fePath, m_folder / "small.exo");
    ASSERT_TRUE(opened.inputs.fe);
    EXPECT_EQ(opened.inputs.terrain, opened.terrain.grid);
    EXPECT_TRUE(opened.terrain.collided);
    EXPECT_EQ(opened.files,
              (std::vector<std::string>{m_path, m_folder / "small.exo", m_folder / "level.asc", m_folder / "house.obj"}));
    EXPECT_EQ(openingFindings(opened).count("case.input_changed"), 0);
    EXPECT_FALSE(opened.failure);
    const RunOrigin origin = originOf(opened);
    EXPECT_EQ(origin.fePath, opened.fePath);
    EXPECT_EQ(origin.feSha256, opened.inputs.fe->contents().sha256);
    EXPECT_EQ(origin.terrainPath, m_folder / "level.asc");
    EXPECT_TRUE(origin.site.collide);
    ASSERT_EQ(origin.surroundings.size(), 1u);
    EXPECT_EQ(origin.surroundings[0].path, m_folder / "house.obj");
    EXPECT_EQ(origin.fingerprint, stageKey(opened.inputs, opened.scenario, Stage::Simulation));
    EXPECT_EQ(originOf(opened, Scenario(), "other").scenarioName, "other");
}

TEST_F(CaseDoor, AnFeResultOpensByItself) {
    m_request.path = m_folder / "small.exo";
    const OpenedCase opened = openCase(m_request, Execution());
    EXPECT_TRUE(opened.casePath.empty());
    EXPECT_EQ(opened.scenarioName, "As computed");
    EXPECT_EQ(opened.fePath, m_request.path);
    EXPECT_EQ(opened.files, std::vector<std::string>{m_request.path});
    EXPECT_FALSE(opened.inputs.terrain);
    m_request.scenario = "As computed";
    EXPECT_EQ(refusal(), "case.no_case");
}

TEST_F(CaseDoor, ScenariosAreNamedByIdOrName) {
    for (const char* wanted : {"scenario-2", "low ground"}) {
        m_request.scenario = wanted;
        EXPECT_EQ(open().scenario.simulation.groundHeight, -3.0) << wanted;
    }
    // An id goes before the same name.
    m_case.scenarios[0].name = "scenario-2";
    m_request.scenario = "scenario-2";
    EXPECT_EQ(open().scenarioId, "scenario-2");
    m_request.scenario = "none of these";
    EXPECT_EQ(refusal(), "case.no_scenario");
    m_request.scenario.reset();
    m_case.activeScenario.clear();
    EXPECT_EQ(open().scenarioId, "scenario-1") << "none is worked on: the first";
    m_case.scenarios.clear();
    EXPECT_EQ(refusal(), "case.without_scenarios");
}

TEST_F(CaseDoor, AScenarioThatNamesNoFeInputStandsOnTheFirstOfTheCase) {
    m_case.scenarios[0].feInput.clear();
    EXPECT_EQ(open().fePath, m_folder / "small.exo");
    EXPECT_EQ(openingFindings(open()).count("case.fe_inputs"), 0) << "there is no choice";
    m_case.inputs.push_back({"fe-2", InputRole::Fe, "small.exo", {}});
    EXPECT_EQ(openingFindings(open()).count("case.fe_inputs"), 1);
    m_case.scenarios[0].feInput = "fe-2";
    EXPECT_EQ(openingFindings(open()).count("case.fe_inputs"), 0);
    std::erase_if(m_case.inputs, [](const CaseInput& input) { return input.role == InputRole::Fe; });
    for (CaseScenario& scenario : m_case.scenarios) {
        scenario.feInput.clear();
    }
    EXPECT_EQ(refusal(), "case.without_fe");
    m_case.scenarios[0].feInput = "fe-9";
    m_request.theCase = m_case;
    try {
        openCase(m_request, Execution());
        ADD_FAILURE() << "an input that is not there was found";
    } catch (const UsageError& error) {
        EXPECT_EQ(error.message().id, "case.no_fe_input");
    }
}

TEST_F(CaseDoor, SettingsAreAppliedInTheirOrderAndMayHaveUnits) {
    m_request.settings = {{"ground_height", "2 m"}, {"settle_time", "1"}, {"settle_time", "0.5 s"}};
    const OpenedCase opened = open();
    EXPECT_EQ(opened.scenario.simulation.groundHeight, 2.0);
    EXPECT_EQ(opened.scenario.simulation.settleTime, 0.5);
    EXPECT_EQ(opened.theCase.scenarios[0].scenario.simulation.groundHeight, 0.0) << "the case stays as it is in its file";
    m_request.settings = {{"ground_height", "2 ft"}};
    EXPECT_EQ(refusal(), "parameter.unit");
}

TEST_F(CaseDoor, ATerrainThatIsGivenLeavesTheSurroundingsWhereTheyAre) {
    const OpenedCase own = open();
    m_request.terrain = AsciiGrid().writeLevel(m_folder / "lower.asc", -2.5);
    const OpenedCase lower = open();
    EXPECT_EQ(lower.terrain.path, m_folder / "lower.asc");
    EXPECT_TRUE(lower.terrain.collided);
    EXPECT_NEAR(lower.inputs.terrain->height(-10.0, 0.0), -2.5, 1e-9);
    EXPECT_GT(lower.inputs.terrain->height(4.5, -0.5), -1.0) << "on the house";
    EXPECT_EQ(lower.theCase.inputs, own.theCase.inputs);
}

TEST_F(CaseDoor, AnInputThatChangedIsAFinding) {
    m_case = saveCase(m_path, m_case);
    ExodusBuilder other = cli::smallCollapse();
    other.times.back() += 0.05;
    other.write(m_folder / "small.exo");
    AsciiGrid().writeLevel(m_folder / "level.asc", -1.0);
    OpenedCase opened = openCase(m_request, Execution());
    const Findings findings = allFindings(opened, {});
    EXPECT_EQ(findings.count("case.input_changed"), 1);
    EXPECT_EQ(findings.count("case.terrain_changed"), 1);
    opened.theCase.inputs[0].sha256 = opened.inputs.fe->contents().sha256;
    EXPECT_EQ(openingFindings(opened).count("case.input_changed"), 0) << "accepted";
}

TEST_F(CaseDoor, FindingsOfEveryStageStandInTheOrderDataFlows) {
    const OpenedCase opened = open();
    const Results results = run(opened.inputs, opened.scenario, Stage::Clusters, {}, nullptr, Execution());
    Findings expected = opened.terrain.findings;
    expected.append(opened.inputs.fe->contents().findings);
    expected.append(results.components->findings);
    expected.append(results.fragments->findings);
    expected.append(results.sizing->findings);
    expected.append(results.clustering->findings);
    const Findings found = allFindings(opened, results);
    ASSERT_FALSE(found.empty());
    ASSERT_EQ(found.list().size(), expected.list().size());
    for (std::size_t i = 0; i < found.list().size(); ++i) {
        EXPECT_EQ(found.list()[i].what.id, expected.list()[i].what.id);
    }
}

TEST_F(CaseDoor, ACaseOpensWithoutInputsThatCannotBeReadIfThatIsAskedFor) {
    saveCase(m_path, m_case);
    std::filesystem::remove(m_folder / "level.asc");
    EXPECT_THROW(openCase(m_request, Execution()), WorldError);
    m_request.evenWithoutInputs = true;
    const OpenedCase opened = openCase(m_request, Execution());
    EXPECT_TRUE(opened.failure);
    EXPECT_FALSE(opened.inputs.fe) << "not simulated on level ground instead";
    EXPECT_EQ(opened.theCase.scenarios.size(), 2u);
    EXPECT_EQ(opened.scenarioId, "scenario-1");
}

TEST_F(CaseDoor, AnFeResultThatIsOpenIsNotReadAgain) {
    const OpenedCase first = open();
    m_request.open = {first.fePath, first.scenario.import, first.inputs.fe};
    EXPECT_EQ(open().inputs.fe, first.inputs.fe);
    m_request.settings = {{"status_variable", "STATUS"}};
    EXPECT_NE(open().inputs.fe, first.inputs.fe) << "read with other settings";
}

}  // namespace
}  // namespace rubble::io
