#include "app/cli/subject.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/scenario/parameters.h"
#include "io/case_file.h"
#include "io/fe_copy/fe_cache.h"
#include "io/fe_reader.h"
#include "io/machine.h"
#include "io/site_reader.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

void applySettings(Scenario& scenario, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
        const auto [key, value] = splitAssignment("--set", setting);
        setParameterText(scenario, key, value);
    }
}

std::string namesOf(const std::vector<CaseScenario>& scenarios) {
    std::string names;
    for (const CaseScenario& scenario : scenarios) {
        names += (names.empty() ? "" : ", ") + scenario.id + " (" + scenario.name + ")";
    }
    return names;
}

const CaseScenario& chooseScenario(const Case& theCase, const std::string& path, const std::optional<std::string>& wanted) {
    const std::string& id = wanted ? *wanted : theCase.activeScenario;
    const auto found = std::find_if(theCase.scenarios.begin(), theCase.scenarios.end(),
                                    [&](const CaseScenario& s) { return s.id == id || s.name == id; });
    if (found != theCase.scenarios.end()) {
        return *found;
    }
    if (wanted || theCase.scenarios.empty()) {
        throw UsageError({"cli.no_scenario", "{0} has no scenario \"{1}\".", {path, id}},
                         {"cli.no_scenario.remedy",
                          "Its scenarios: {0}.",
                          {theCase.scenarios.empty() ? std::string("none") : namesOf(theCase.scenarios)}});
    }
    return theCase.scenarios.front();
}

const CaseInput& feInputOf(const Case& theCase, const CaseScenario& scenario, const std::string& path) {
    for (const CaseInput& input : theCase.inputs) {
        if (input.role == InputRole::Fe && (input.id == scenario.feInput || scenario.feInput.empty())) {
            return input;
        }
    }
    throw UsageError({"cli.no_fe_input",
                      "{0}: the scenario \"{1}\" names the FE input \"{2}\", which the case does not have.",
                      {path, scenario.name, scenario.feInput}},
                     {"cli.no_fe_input.remedy", "Add the FE result to the case, or give the FE file itself.", {}});
}

void takeTerrain(Subject& subject, io::TerrainInput terrain) {
    subject.inputs.terrain = terrain.grid;
    subject.findings.append(terrain.findings);
    if (terrain.grid) {
        subject.files.push_back(terrain.path);
    }
    for (const io::SiteFile& file : terrain.files) {
        subject.files.push_back(file.path);
    }
    subject.terrain = std::move(terrain);
}

}  // namespace

Subject openSubject(const Arguments& arguments, Session& session) {
    const std::string& path = arguments.operand();
    const std::optional<std::string> wantedScenario = arguments.value("--scenario");
    Subject subject;
    subject.files.push_back(path);
    std::string expectedHash;
    Case theCase;
    if (io::isCaseFile(path)) {
        theCase = io::loadCase(path);
        subject.casePath = path;
        const CaseScenario& chosen = chooseScenario(theCase, path, wantedScenario);
        const CaseInput& input = feInputOf(theCase, chosen, path);
        subject.scenario = chosen.scenario;
        subject.scenarioName = chosen.name;
        subject.inputs.frame = theCase.frame;
        subject.fePath = io::inputPath(path, input);
        subject.files.push_back(subject.fePath);
        expectedHash = input.sha256;
    } else if (wantedScenario) {
        throw UsageError({"cli.scenario_without_case", "{0} is not a case, so it has no scenarios.", {path}},
                         {"cli.scenario_without_case.remedy", "Leave out --scenario, or give a case file.", {}});
    } else {
        subject.scenarioName = "As computed";
        subject.fePath = fs::absolute(path).lexically_normal().string();
    }
    applySettings(subject.scenario, arguments.values("--set"));

    const auto start = std::chrono::steady_clock::now();
    const ImportSettings& import = subject.scenario.import;
    subject.inputs.fe = arguments.has("--cached")
                            ? io::openFeCached(subject.fePath, import, subject.inputs.frame, session.execution(), io::cacheFolder())
                            : io::openFe(subject.fePath, import, subject.inputs.frame, session.execution());
    subject.inputs.frame = theCase.frame = subject.inputs.fe->contents().frame;
    subject.openSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::string& hash = subject.inputs.fe->contents().sha256;
    if (!expectedHash.empty() && hash != expectedHash) {
        subject.findings.add(
            {"case.input_changed", "The FE file is not the one the case was saved with.", {}},
            {"case.input_changed.remedy", "Find the file with the SHA-256 of the case, or save the case anew.", {}},
            subject.fePath);
    }
    const Mesh& mesh = subject.inputs.fe->mesh();
    if (const std::optional<std::string> given = arguments.value("--terrain")) {
        std::erase_if(theCase.inputs, [](const CaseInput& input) { return input.role == InputRole::Terrain; });
        theCase.inputs.push_back({"terrain-1", InputRole::Terrain, fs::absolute(*given).lexically_normal().string(), {}});
    }
    takeTerrain(subject, io::openSiteOfCase(theCase, path, mesh, session.execution()));
    subject.site = theCase.site;
    return subject;
}

Results runTo(const Subject& subject, Stage last, TrajectorySink* sink, const Execution& execution, CheckpointStore* checkpoints) {
    Results opened;
    opened.wallSeconds[static_cast<std::size_t>(Stage::Import)] = subject.openSeconds;
    return run(subject.inputs, subject.scenario, last, opened, sink, execution, checkpoints);
}

io::RunOrigin originOf(const Subject& subject) {
    io::RunOrigin origin;
    origin.fePath = subject.fePath;
    origin.feSha256 = subject.inputs.fe->contents().sha256;
    origin.terrainPath = subject.terrain.path;
    origin.terrainSha256 = subject.terrain.sha256;
    io::recordSite(origin, subject.terrain, subject.site);
    origin.frame = subject.inputs.frame;
    origin.scenario = subject.scenario;
    origin.scenarioName = subject.scenarioName;
    origin.build = std::string(buildText());
    origin.fingerprint = stageKey(subject.inputs, subject.scenario, Stage::Simulation);
    return origin;
}

Findings allFindings(const Subject& subject, const Results& results) {
    Findings all = subject.findings;
    all.append(subject.inputs.fe->contents().findings);
    const auto append = [&all](const auto& part) {
        if (part) {
            all.append(part->findings);
        }
    };
    append(results.components);
    append(results.fragments);
    append(results.sizing);
    append(results.clustering);
    append(results.simulation);
    return all;
}

}  // namespace rubble::cli
