#include "io/ensemble_source.h"

#include <algorithm>

#include "core/base/error.h"
#include "io/case_file.h"
#include "io/fe_copy/fe_cache.h"
#include "io/fe_reader.h"
#include "io/machine.h"
#include "io/site_reader.h"

namespace rubble::io {

namespace {

const CaseScenario& scenarioOf(const Case& theCase, const std::string& id, const std::string& base) {
    const auto found =
        std::find_if(theCase.scenarios.begin(), theCase.scenarios.end(), [&](const CaseScenario& each) { return each.id == id; });
    if (found == theCase.scenarios.end()) {
        throw UsageError({"ensemble.case_scenario", "{0} has no scenario \"{1}\".", {base, id}},
                         {"ensemble.no_scenario.remedy", "Name scenarios of the case by their ids.", {}});
    }
    return *found;
}

const CaseInput& feInputOf(const Case& theCase, const CaseScenario& scenario, const std::string& base) {
    for (const CaseInput& input : theCase.inputs) {
        if (input.role == InputRole::Fe && (input.id == scenario.feInput || scenario.feInput.empty())) {
            return input;
        }
    }
    throw UsageError({"ensemble.no_result", "{0}: the scenario \"{1}\" stands on no FE result.", {base, scenario.name}},
                     {"ensemble.no_result.remedy", "Add the FE result to the case.", {}});
}

void note(EnsembleSource& source, const std::string& role, const std::string& path, const std::string& sha256) {
    const bool known =
        std::any_of(source.inputs.begin(), source.inputs.end(), [&](const EnsembleInput& input) { return input.path == path; });
    if (!known && !path.empty()) {
        source.inputs.push_back({role, path, sha256});
    }
}

void addScene(EnsembleSource& source, const Case& theCase, const std::string& base, const CaseScenario& scenario,
              const OpenResult& open, bool copies, const Execution& execution) {
    const CaseInput& input = feInputOf(theCase, scenario, base);
    const std::string path = inputPath(base, input);
    EnsembleScene scene{scenario.id, scenario.name, {}, scenario.scenario};
    const ImportSettings& import = scenario.scenario.import;
    scene.inputs.fe = open.fe != nullptr && open.path == path && open.import == import ? open.fe
                      : copies ? openFeCached(path, import, theCase.frame, execution, cacheFolder())
                               : openFe(path, import, theCase.frame, execution);
    const auto& contents = scene.inputs.fe->contents();
    scene.inputs.frame = contents.frame;
    if (!input.sha256.empty() && input.sha256 != contents.sha256) {
        source.findings.add({"case.input_changed", "The FE file is not the one the case was saved with.", {}},
                            {"case.input_changed.remedy", "Find the file with the SHA-256 of the case, or save the case anew.", {}},
                            path);
    }
    Case framed = theCase;
    framed.frame = contents.frame;
    const TerrainInput terrain = openSiteOfCase(framed, base, scene.inputs.fe->mesh(), execution);
    scene.inputs.terrain = terrain.grid;
    source.findings.append(terrain.findings);
    note(source, "fe", path, contents.sha256);
    note(source, "terrain", terrain.path, terrain.sha256);
    for (const SiteFile& file : terrain.files) {
        note(source, "surroundings", file.path, file.sha256);
    }
    source.frame = contents.frame;
    source.site = theCase.site;
    source.scenes.push_back(std::move(scene));
}

}  // namespace

std::vector<std::string> variedScenarios(const EnsembleSettings& settings) {
    for (const VariedSetting& varied : settings.varied) {
        if (varied.key == scenarioKey) {
            std::vector<std::string> ids = varied.choices;
            std::sort(ids.begin(), ids.end());
            ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
            return ids;
        }
    }
    return {};
}

EnsembleSource openEnsemble(const Case& theCase, const std::string& base, const std::optional<std::string>& scenario,
                            const EnsembleSettings& settings, const OpenResult& open, bool copies, const Execution& execution) {
    EnsembleSource source;
    source.name = theCase.title;
    std::vector<std::string> ids = variedScenarios(settings);
    if (scenario || ids.empty()) {
        ids = {scenario.value_or(theCase.activeScenario)};
    }
    for (const std::string& id : ids) {
        execution.check();
        const CaseScenario& chosen = scenarioOf(theCase, id, base);
        addScene(source, theCase, base, chosen, open, copies, execution);
        source.name = scenario ? chosen.name : source.name;
    }
    return source;
}

}  // namespace rubble::io
