#include "core/scenario/case_lookup.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

TEST(CaseChoice, ScenariosAreFoundByIdThenByNameThenTheOneThatIsWorkedOn) {
    Case theCase;
    EXPECT_EQ(findScenario(theCase, std::nullopt), nullptr);
    theCase.scenarios = {{"a", "b", {}, {}, {}}, {"b", "c", {}, {}, {}}};
    EXPECT_EQ(findScenario(theCase, std::nullopt)->id, "a") << "the first";
    theCase.activeScenario = "b";
    EXPECT_EQ(findScenario(theCase, std::nullopt)->id, "b");
    EXPECT_EQ(findScenario(theCase, "b")->id, "b") << "an id before a name";
    EXPECT_EQ(findScenario(theCase, "c")->id, "b");
    EXPECT_EQ(findScenario(theCase, "d"), nullptr);
    EXPECT_EQ(findScenario(theCase, ""), nullptr);
}

TEST(CaseChoice, AScenarioWithoutFeInputStandsOnTheFirst) {
    Case theCase;
    theCase.inputs = {
        {"terrain-1", InputRole::Terrain, "a.tif", {}}, {"fe-1", InputRole::Fe, "a.exo", {}}, {"fe-2", InputRole::Fe, "b.exo", {}}};
    CaseScenario scenario;
    EXPECT_EQ(findFeInput(theCase, scenario)->id, "fe-1");
    scenario.feInput = "fe-2";
    EXPECT_EQ(findFeInput(theCase, scenario)->path, "b.exo");
    scenario.feInput = "terrain-1";
    EXPECT_EQ(findFeInput(theCase, scenario), nullptr) << "that is no FE result";
}

}  // namespace
}  // namespace rubble
