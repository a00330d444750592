#include "io/case/ensemble_source.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/fe/fe_reader.h"
#include "tests/support/exodus_builder.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// A case with two scenarios on two FE results.
class EnsembleSources : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name : {"a.exo", "b.exo"}) {
            ExodusBuilder builder;
            builder.addCubes(3, "deck", 1);
            builder.times = {0.0, 0.1};
            builder.addStillDisplacement();
            builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
            builder.write(m_folder / name);
        }
        m_case = caseForFe(m_folder / "a.exo", m_base);
        m_case.inputs.push_back({"fe-2", InputRole::Fe, "b.exo", {}});
        m_case.scenarios.push_back(m_case.scenarios.front());
        m_case.scenarios.back().id = "scenario-2";
        m_case.scenarios.back().name = "scour";
        m_case.scenarios.back().feInput = "fe-2";
    }
    EnsembleSource open(const std::optional<std::string>& scenario, const OpenResult& known = {}) {
        CaseRequest request;
        request.path = m_base;
        request.theCase = m_case;
        request.scenario = scenario;
        request.open = known;
        return openEnsemble(request, m_case.ensemble, Execution());
    }
    TemporaryFolder m_folder;
    std::string m_base = m_folder / "x.rubble";
    Case m_case;
};

TEST_F(EnsembleSources, OpensTheScenarioThatIsWorkedOnUnlessScenariosAreVaried) {
    EnsembleSource source = open(std::nullopt);
    ASSERT_EQ(source.scenes.size(), 1u);
    EXPECT_EQ(source.scenes[0].id, "scenario-1");
    EXPECT_EQ(source.name, "a");
    ASSERT_EQ(source.inputs.size(), 1u);
    EXPECT_EQ(source.inputs[0].role, "fe");
    EXPECT_EQ(source.inputs[0].sha256.size(), 64u);
    m_case.ensemble.varied.push_back(variationFrom("scenario", "choice:scenario-2:scenario-1:scenario-2"));
    source = open(std::nullopt);
    ASSERT_EQ(source.scenes.size(), 2u);
    EXPECT_EQ(source.scenes[1].id, "scenario-2");
    EXPECT_EQ(source.inputs.size(), 2u);
    EXPECT_NE(source.scenes[0].inputs.fe, source.scenes[1].inputs.fe);
    // One that is asked for stands alone, under its name.
    for (const char* wanted : {"scenario-2", "scour"}) {
        source = open(wanted);
        ASSERT_EQ(source.scenes.size(), 1u);
        EXPECT_EQ(source.scenes[0].id, "scenario-2");
        EXPECT_EQ(source.name, "scour");
    }
}

TEST_F(EnsembleSources, ScenariosAreVariedByIdOrName) {
    m_case.ensemble.varied.push_back(variationFrom("scenario", "choice:scour:scenario-1"));
    const EnsembleSource source = open(std::nullopt);
    ASSERT_EQ(source.scenes.size(), 2u);
    EXPECT_EQ(source.scenes[0].id, "scenario-1");
    EXPECT_EQ(source.scenes[1].id, "scour") << "as the setting chooses it";
    EXPECT_EQ(source.scenes[1].name, "scour");
}

TEST_F(EnsembleSources, AResultThatIsOpenIsNotReadAgain) {
    const auto fe = openFe(m_folder / "a.exo", {}, Frame(), Execution());
    EXPECT_EQ(open("scenario-1", {m_folder / "a.exo", {}, fe}).scenes[0].inputs.fe, fe);
    ImportSettings other;
    other.statusVariable = "STATUS";
    EXPECT_NE(open("scenario-2", {m_folder / "a.exo", {}, fe}).scenes[0].inputs.fe, fe);
    EXPECT_NE(open("scenario-1", {m_folder / "a.exo", other, fe}).scenes[0].inputs.fe, fe) << "read with other settings";
}

TEST_F(EnsembleSources, SaysWhatIsMissing) {
    EXPECT_THROW(open("scenario-9"), UsageError);
    m_case.scenarios[0].feInput = "fe-9";
    EXPECT_THROW(open("scenario-1"), UsageError);
    m_case.inputs[1].sha256 = std::string(64, '0');
    const EnsembleSource changed = open("scenario-2");
    ASSERT_EQ(changed.findings.list().size(), 1u);
    EXPECT_EQ(changed.findings.list()[0].what.id, "case.input_changed");
}

}  // namespace
}  // namespace rubble::io
