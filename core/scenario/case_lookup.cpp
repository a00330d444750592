#include "core/scenario/case_lookup.h"

#include <algorithm>

namespace rubble {

const CaseScenario* findScenario(const Case& theCase, const std::optional<std::string>& wanted) {
    const std::vector<CaseScenario>& all = theCase.scenarios;
    const std::string& name = wanted ? *wanted : theCase.activeScenario;
    auto found = std::find_if(all.begin(), all.end(), [&](const CaseScenario& each) { return each.id == name; });
    if (found == all.end() && !wanted) {
        found = all.begin();
    } else if (found == all.end()) {
        found = std::find_if(all.begin(), all.end(), [&](const CaseScenario& each) { return each.name == name; });
    }
    return found == all.end() ? nullptr : &*found;
}

const CaseInput* findFeInput(const Case& theCase, const CaseScenario& scenario) {
    const auto found = std::find_if(theCase.inputs.begin(), theCase.inputs.end(), [&](const CaseInput& each) {
        return each.role == InputRole::Fe && (scenario.feInput.empty() || each.id == scenario.feInput);
    });
    return found == theCase.inputs.end() ? nullptr : &*found;
}

}  // namespace rubble
