#include "io/case/ensemble_source.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/scenario/case_lookup.h"
#include "core/scenario/differences.h"

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
    if (source.scenes.empty()) {
        source.fePath = opened.fePath;
    }
    source.scenes.push_back({id, opened.scenarioName, opened.inputs, opened.scenario});
    source.theCase = opened.theCase;
    source.frame = opened.inputs.frame;
    source.terrainRead = opened.terrain.read;
    source.files.insert(source.files.end(), opened.files.begin(), opened.files.end());
    source.findings.append(openingFindings(opened));
    const RunOrigin origin = originOf(opened);
    addCautions(source.cautions, inputCautions(origin.unsaidUnits, origin.placeDoubts));
    note(source, "fe", origin.fePath, origin.feSha256);
    note(source, "terrain", origin.terrainPath, origin.terrainSha256);
    for (const RecordedInput& mesh : origin.surroundings) {
        note(source, "surroundings", mesh.path, mesh.sha256);
    }
}

/// Causes that are simulated in different ways differ by more than their cause.
void tellOtherSettings(EnsembleSource& next, const EnsembleSource& first) {
    const auto differences = sharedDifferences(differencesBetween(first.scenes.front().scenario, next.scenes.front().scenario));
    constexpr std::size_t most = 6;
    std::string listed;
    for (std::size_t i = 0; i < std::min(differences.size(), most); ++i) {
        const SharedDifference& each = differences[i];
        listed += (i == 0 ? "" : "; ") + each.key() + " " + valueText(each.change.second) + ", not " + valueText(each.change.first);
    }
    if (differences.size() > most) {
        listed += "; …";
    }
    if (!differences.empty()) {
        Message what{"causes.other_settings", "\"{0}\" has other settings than \"{1}\": {2}", {next.name, first.name, listed}};
        // Of each cause by itself: findings with one id are counted together, and the first says what.
        what.id += '.' + next.name;
        next.findings.add(what,
                          {"causes.other_settings.remedy",
                           "set them alike, unless the cause itself asks for the difference: it is measured with the causes",
                           {}},
                          {}, static_cast<std::int64_t>(differences.size()));
    }
}

std::string titleOf(const EnsembleSource& source, const std::string& path) {
    return source.theCase.title.empty() ? std::filesystem::path(path).stem().string() : source.theCase.title;
}

}  // namespace

void EnsembleBasis::join(const EnsembleBasis& other) {
    inputs.insert(inputs.end(), other.inputs.begin(), other.inputs.end());
    scenes.insert(scenes.end(), other.scenes.begin(), other.scenes.end());
    addCautions(cautions, other.cautions);
}

EnsembleBasis EnsembleSource::basis() const {
    EnsembleBasis made{inputs, frame, theCase.site, cautions};
    for (const EnsembleScene& scene : scenes) {
        made.scenes.push_back({scene.name.empty() || scene.name == name ? name : name + " · " + scene.name, scene.scenario});
    }
    return made;
}

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
        source.name = request.scenario ? opened.scenarioName : titleOf(source, request.path);
        return source;
    }
    CaseRequest each = request;
    for (const std::string& scenario : varied) {
        execution.check();
        each.scenario = scenario;
        addScene(source, openCase(each, execution), scenario);
    }
    source.name = titleOf(source, request.path);
    return source;
}

std::string causeName(const std::string& name, const std::string& fePath, std::span<const std::string> taken) {
    const auto isTaken = [&](const std::string& each) { return std::find(taken.begin(), taken.end(), each) != taken.end(); };
    const std::string own = isTaken(name) ? name + " (" + std::filesystem::path(fePath).stem().string() + ")" : name;
    std::string found = own;
    for (int number = 2; isTaken(found); ++number) {
        found = own + " " + std::to_string(number);
    }
    return found;
}

void joinCauses(EnsembleSource& next, const EnsembleSource* first, std::span<const std::string> taken) {
    if (first != nullptr && !(next.frame == first->frame && next.theCase.site.controlPoints == first->theCase.site.controlPoints)) {
        throw UsageError({"causes.other_frame",
                          "\"{0}\" has another origin, axes, coordinate system or control points than \"{1}\".",
                          {next.name, first->name}},
                         {"causes.other_frame.remedy", "Give both cases the same frame: they must be of one site.", {}});
    }
    next.name = causeName(next.name, next.fePath, taken);
    if (first != nullptr) {
        tellOtherSettings(next, *first);
    }
}

Case caseOfCause(const Case& like, const CaseScenario& scenario, const std::string& fePath) {
    Case cause = like;
    cause.scenarios = {scenario};
    const CaseInput* replaced = findFeInput(cause, scenario);
    for (CaseInput& input : cause.inputs) {
        if (&input == replaced) {
            input.path = fePath;
            input.sha256.clear();
        }
    }
    return cause;
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
