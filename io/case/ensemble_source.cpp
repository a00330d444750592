#include "io/case/ensemble_source.h"

#include <algorithm>

namespace rubble::io {

namespace {

void note(EnsembleSource& source, const std::string& role, const std::string& path, const std::string& sha256) {
    const bool known =
        std::any_of(source.inputs.begin(), source.inputs.end(), [&](const EnsembleInput& input) { return input.path == path; });
    if (!known && !path.empty()) {
        source.inputs.push_back({role, path, sha256});
    }
}

/// @param id  as the setting "scenario" chooses it
void addScene(EnsembleSource& source, const OpenedCase& opened, const std::string& id) {
    source.scenes.push_back({id, opened.scenarioName, opened.inputs, opened.scenario});
    source.theCase = opened.theCase;
    source.frame = opened.inputs.frame;
    source.files.insert(source.files.end(), opened.files.begin(), opened.files.end());
    source.findings.append(openingFindings(opened));
    const RunOrigin origin = originOf(opened);
    note(source, "fe", origin.fePath, origin.feSha256);
    note(source, "terrain", origin.terrainPath, origin.terrainSha256);
    for (const RecordedInput& mesh : origin.surroundings) {
        note(source, "surroundings", mesh.path, mesh.sha256);
    }
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

EnsembleSource openEnsemble(const CaseRequest& request, const EnsembleSettings& settings, const Execution& execution) {
    EnsembleSource source;
    const std::vector<std::string> varied = variedScenarios(settings);
    if (request.scenario || varied.empty()) {
        const OpenedCase opened = openCase(request, execution);
        addScene(source, opened, opened.scenarioId);
        source.name = request.scenario ? opened.scenarioName : opened.theCase.title;
        return source;
    }
    CaseRequest each = request;
    for (const std::string& scenario : varied) {
        execution.check();
        each.scenario = scenario;
        addScene(source, openCase(each, execution), scenario);
    }
    source.name = source.theCase.title;
    return source;
}

std::string evidenceGround(const EnsembleSource& source) {
    std::string ground;
    for (const EnsembleInput& input : source.inputs) {
        if (input.role == "surroundings") {
            return {};
        }
        if (input.role == "terrain") {
            ground = input.path;
        }
    }
    return ground;
}

}  // namespace rubble::io
