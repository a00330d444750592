#include "app/python/collapse.h"

#include <algorithm>
#include <filesystem>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/scenario/parameters.h"
#include "io/case_file.h"
#include "io/fe_reader.h"
#include "io/site_reader.h"

namespace rubble::python {

namespace fs = std::filesystem;

namespace {

const CaseScenario& chooseScenario(const Case& theCase, const std::string& path, const std::optional<std::string>& wanted) {
    const std::string& name = wanted ? *wanted : theCase.activeScenario;
    std::string names;
    for (const CaseScenario& scenario : theCase.scenarios) {
        if (scenario.id == name || scenario.name == name) {
            return scenario;
        }
        names += (names.empty() ? "" : ", ") + scenario.name;
    }
    throw UsageError({"python.no_scenario", "{0} has no scenario \"{1}\".", {path, name}},
                     {"python.no_scenario.remedy", "Its scenarios: {0}.", {names.empty() ? std::string("none") : names}});
}

}  // namespace

void setWithUnit(Scenario& scenario, const std::string& key, const std::string& text) {
    if (key == "preset") {
        setParameterText(scenario, key, text);
        return;
    }
    const Parameter& row = *findParameter(key).first;
    const std::size_t blank = text.find(' ');
    const bool number = row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer;
    if (!number || blank == std::string::npos) {
        setParameterText(scenario, key, text);
        return;
    }
    const std::string unit = text.substr(text.find_first_not_of(' ', blank));
    if (unit != row.unit) {
        throw UsageError({"python.unit",
                          "{0} = {1}: the unit of {0} is {2}, not {3}.",
                          {key, text, row.unit.empty() ? std::string("none") : std::string(row.unit), unit}},
                         {"python.unit.remedy", "Convert the value and give the number alone.", {}});
    }
    setParameterText(scenario, key, text.substr(0, blank));
}

Collapse::Collapse(std::shared_ptr<const FeResult> fe) : m_path(fe->contents().path), m_fePath(m_path) {
    m_inputs.frame = fe->contents().frame;
    m_inputs.fe = std::move(fe);
}

std::shared_ptr<Collapse> Collapse::open(const std::string& path, const std::optional<std::string>& scenario,
                                         const std::vector<std::pair<std::string, std::string>>& settings,
                                         const std::optional<std::string>& terrain, const Execution& execution) {
    std::shared_ptr<Collapse> opened(new Collapse);
    opened->m_path = fs::absolute(path).lexically_normal().string();
    std::string sha256;
    if (io::isCaseFile(path)) {
        opened->openCase(scenario, sha256);
    } else if (scenario) {
        throw UsageError({"python.scenario_without_case", "{0} is not a case, so it has no scenarios.", {path}},
                         {"python.scenario_without_case.remedy", "Leave out scenario, or open a case.", {}});
    } else {
        opened->m_fePath = opened->m_path;
    }
    for (const auto& [key, text] : settings) {
        opened->set(key, text);
    }
    Inputs& inputs = opened->m_inputs;
    inputs.fe = io::openFe(opened->m_fePath, opened->m_scenario.import, inputs.frame, execution);
    inputs.frame = opened->m_case.frame = inputs.fe->contents().frame;
    if (!sha256.empty() && sha256 != inputs.fe->contents().sha256) {
        opened->m_findings.add(
            {"case.input_changed", "The FE file is not the one the case was saved with.", {}},
            {"case.input_changed.remedy", "Find the file with the SHA-256 of the case, or save the case anew.", {}},
            opened->m_fePath);
    }
    opened->m_terrain =
        terrain ? io::openTerrain(*terrain, inputs.frame, io::boundsAtRest(inputs.fe->mesh()), execution, opened->m_case.site)
                : io::openTerrainOfCase(opened->m_case, opened->m_path, inputs.fe->mesh(), execution);
    inputs.terrain = opened->m_terrain.grid;
    opened->m_findings.append(opened->m_terrain.findings);
    return opened;
}

void Collapse::openCase(const std::optional<std::string>& scenario, std::string& sha256) {
    m_case = io::loadCase(m_path);
    for (const CaseScenario& one : m_case.scenarios) {
        m_scenarios.push_back(one.name);
    }
    const CaseScenario& chosen = chooseScenario(m_case, m_path, scenario);
    m_scenario = chosen.scenario;
    m_scenarioName = chosen.name;
    m_inputs.frame = m_case.frame;
    for (const CaseInput& input : m_case.inputs) {
        if (input.role == InputRole::Fe && (input.id == chosen.feInput || chosen.feInput.empty())) {
            m_fePath = io::inputPath(m_path, input);
            sha256 = input.sha256;
            return;
        }
    }
    throw UsageError({"python.no_fe_input", "{0}: the scenario \"{1}\" has no FE result.", {m_path, chosen.name}},
                     {"python.no_fe_input.remedy", "Add the FE result to the case, or open the FE result itself.", {}});
}

std::string Collapse::setting(const std::string& key) const {
    return valueText(parameterValue(m_scenario, key));
}

void Collapse::set(const std::string& key, const std::string& text) {
    const ImportSettings import = m_scenario.import;
    setWithUnit(m_scenario, key, text);
    if (m_inputs.fe && !(import == m_scenario.import)) {
        m_scenario.import = import;
        throw UsageError({"python.import_setting", "{0} says how the FE result is read, and that is open already.", {key}},
                         {"python.import_setting.remedy", "Give it to rubble.open() in settings.", {}});
    }
}

const Results& Collapse::upTo(Stage last, const Execution& execution) {
    m_results = run(m_inputs, m_scenario, last, m_results, nullptr, execution);
    return m_results;
}

io::RunOrigin Collapse::origin() const {
    io::RunOrigin origin;
    origin.fePath = m_fePath;
    origin.feSha256 = m_inputs.fe->contents().sha256;
    origin.terrainPath = m_terrain.path;
    origin.terrainSha256 = m_terrain.sha256;
    io::recordSite(origin, m_terrain, m_case.site);
    origin.frame = m_inputs.frame;
    origin.scenario = m_scenario;
    origin.scenarioName = m_scenarioName;
    origin.build = std::string(buildText());
    origin.fingerprint = stageKey(m_inputs, m_scenario, Stage::Simulation);
    return origin;
}

void Collapse::record(const std::string& path, const Execution& execution) {
    for (const std::string& input : {m_path, m_fePath, m_terrain.path}) {
        std::error_code ignored;
        if (!input.empty() && fs::equivalent(path, input, ignored)) {
            throw UsageError({"python.out_is_input", "{0} is an input of this run.", {path}},
                             {"python.out_is_input.remedy", "Choose another name for the run.", {}});
        }
    }
    std::error_code ignored;
    if (fs::exists(path, ignored) && fs::file_size(path, ignored) > 0) {
        try {
            io::openRun(path);
        } catch (const ParseError&) {
            throw UsageError({"python.out_not_a_run", "{0} exists and is not a run.", {path}},
                             {"python.out_not_a_run.remedy", "Choose another name, or delete the file first.", {}});
        }
    }
    const std::unique_ptr<TrajectorySink> sink = io::createRun(path, origin());
    // A simulation that is there already would not be recorded.
    Results earlier = m_results;
    earlier.simulation = nullptr;
    m_results = run(m_inputs, m_scenario, Stage::Simulation, earlier, sink.get(), execution);
}

Findings Collapse::findings() const {
    Findings all = m_findings;
    all.append(m_inputs.fe->contents().findings);
    const auto append = [&all](const auto& part) {
        if (part) {
            all.append(part->findings);
        }
    };
    append(m_results.components);
    append(m_results.fragments);
    append(m_results.sizing);
    append(m_results.clustering);
    append(m_results.simulation);
    return all;
}

}  // namespace rubble::python
