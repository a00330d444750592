#include "io/case/open_case.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "core/base/build.h"
#include "core/base/elapsed.h"
#include "core/base/error.h"
#include "core/evidence/cautions.h"
#include "core/fe/unit_evidence.h"
#include "core/pipeline/stage_reports.h"
#include "core/scenario/case_lookup.h"
#include "core/scenario/parameters.h"
#include "io/base/machine.h"
#include "io/case/case_file.h"
#include "io/case/site_reader.h"
#include "io/fe/fe_copy/fe_cache.h"
#include "io/fe/fe_reader.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

std::string absolutePlace(const std::string& path) {
    return fs::absolute(path).lexically_normal().string();
}

std::string namesOf(const std::vector<CaseScenario>& scenarios) {
    std::string names;
    for (const CaseScenario& scenario : scenarios) {
        names += (names.empty() ? "" : ", ") + scenario.id + " (" + scenario.name + ")";
    }
    return names;
}

const CaseScenario& scenarioAskedFor(const Case& theCase, const CaseRequest& request) {
    if (theCase.scenarios.empty()) {
        throw UsageError({"case.without_scenarios", "{0} has no scenarios.", {request.path}},
                         {"case.without_scenarios.remedy", "Open the FE result itself.", {}});
    }
    const CaseScenario* found = findScenario(theCase, request.scenario);
    if (found == nullptr) {
        throw UsageError({"case.no_scenario", "{0} has no scenario \"{1}\".", {request.path, *request.scenario}},
                         {"case.no_scenario.remedy", "Its scenarios: {0}.", {namesOf(theCase.scenarios)}});
    }
    return *found;
}

const CaseInput& feInputOf(const Case& theCase, const CaseScenario& scenario, const std::string& path) {
    if (const CaseInput* found = findFeInput(theCase, scenario)) {
        return *found;
    }
    if (scenario.feInput.empty()) {
        throw UsageError({"case.without_fe", "{0} names no FE result.", {path}},
                         {"case.without_fe.remedy", "Add the FE result to the case, or open the FE result itself.", {}});
    }
    throw UsageError({"case.no_fe_input",
                      "{0}: the scenario \"{1}\" names the FE input \"{2}\", which the case does not have.",
                      {path, scenario.name, scenario.feInput}},
                     {"case.no_fe_input.remedy", "Add the FE result to the case, or open the FE result itself.", {}});
}

/// Opens one case, step by step.
class CaseOpening {
public:
    CaseOpening(const CaseRequest& request, const Execution& execution) : m_request(request), m_execution(execution) {}

    OpenedCase open() {
        takeCase();
        try {
            takeScenario();
            readFe();
            readSite();
        } catch (const Cancelled&) {
            throw;
        } catch (...) {
            if (!m_request.evenWithoutInputs) {
                throw;
            }
            // A case whose terrain cannot be read is not simulated on level ground instead.
            m_opened.inputs.fe.reset();
            m_opened.inputs.frame = m_opened.theCase.frame;
            m_opened.failure = std::current_exception();
        }
        return std::move(m_opened);
    }

private:
    void takeCase() {
        const std::string& path = m_request.path;
        m_opened.files.push_back(path);
        m_opened.base = path;
        if (m_request.theCase || isCaseFile(path)) {
            m_opened.theCase = m_request.theCase ? *m_request.theCase : loadCase(path);
            m_opened.casePath = path;
        } else if (m_request.scenario) {
            throw UsageError({"case.no_case", "{0} is not a case, so it has no scenarios.", {path}},
                             {"case.no_case.remedy", "Name no scenario, or open a case.", {}});
        } else {
            m_opened.base = absolutePlace(path) + ".rubble";
            m_opened.theCase = caseForFe(path, m_opened.base);
        }
        takeMeshOffset();
        m_opened.inputs.frame = m_opened.theCase.frame;
    }

    void takeMeshOffset() {
        bool any = false;
        for (CaseInput& input : m_opened.theCase.inputs) {
            if (m_request.meshOffset && input.role == InputRole::Surroundings) {
                input.offset = m_request.meshOffset;
                any = true;
            }
        }
        if (m_request.meshOffset && !any) {
            throw UsageError({"case.no_mesh", "{0} has no mesh of surroundings that an offset could move.", {m_request.path}},
                             {"case.no_mesh.remedy", "Leave the offset out, or add the mesh to the case.", {}});
        }
    }

    void takeScenario() {
        const CaseScenario& chosen = scenarioAskedFor(m_opened.theCase, m_request);
        m_opened.scenarioId = chosen.id;
        m_opened.scenarioName = chosen.name;
        m_opened.scenario = chosen.scenario;
        for (const auto& [key, text] : m_request.settings) {
            setParameterText(m_opened.scenario, key, text);
        }
        m_opened.fePath = inputPath(m_opened.base, feInputOf(m_opened.theCase, chosen, m_request.path));
        if (!m_opened.casePath.empty()) {
            m_opened.files.push_back(m_opened.fePath);
        }
    }

    void readFe() {
        const std::string& path = m_opened.fePath;
        const ImportSettings& import = m_opened.scenario.import;
        const Frame& frame = m_opened.theCase.frame;
        const OpenResult& open = m_request.open;
        const auto start = std::chrono::steady_clock::now();
        std::shared_ptr<const FeResult> fe;
        if (open.fe != nullptr && open.path == path && open.import == import) {
            fe = open.fe;
        } else if (m_request.cached) {
            fe = openFeCached(path, import, frame, m_execution, cacheFolder());
        } else {
            fe = openFe(path, import, frame, m_execution);
        }
        if (fe != open.fe && m_request.stateBytes) {
            fe = std::make_shared<const FeResult>(fe->contents(), *m_request.stateBytes);
        }
        m_opened.openSeconds = secondsSince(start);
        m_opened.inputs.fe = fe;
        m_opened.inputs.frame = fe->contents().frame;
    }

    void readSite() {
        if (m_request.groundClasses) {
            m_opened.theCase.site.groundClasses = *m_request.groundClasses;
        }
        Case framed = m_opened.theCase;
        framed.frame = m_opened.inputs.frame;
        if (m_request.terrain) {
            std::erase_if(framed.inputs, [](const CaseInput& input) { return input.role == InputRole::Terrain; });
            framed.inputs.push_back({"terrain", InputRole::Terrain, absolutePlace(*m_request.terrain), {}});
        }
        stateTerrain(framed);
        m_opened.terrain = openSiteOfCase(framed, m_opened.base, m_opened.inputs.fe->mesh(), m_execution);
        m_opened.inputs.terrain = m_opened.terrain.grid;
        if (m_opened.terrain.grid) {
            m_opened.files.push_back(m_opened.terrain.path);
        }
        for (const SiteFile& file : m_opened.terrain.files) {
            m_opened.files.push_back(file.path);
        }
    }

    void stateTerrain(Case& framed) const {
        const CloudRequest& asked = m_request.terrainRead;
        const auto terrain = std::find_if(framed.inputs.begin(), framed.inputs.end(),
                                          [](const CaseInput& input) { return input.role == InputRole::Terrain; });
        if (terrain != framed.inputs.end()) {
            terrain->read.crs = asked.crs.empty() ? terrain->read.crs : asked.crs;
            terrain->read.columns = asked.columns.empty() ? terrain->read.columns : asked.columns;
        } else if (!asked.empty()) {
            throw UsageError({"case.no_terrain_to_read", "Columns or a system are stated of a terrain, and there is none", {}},
                             {"case.no_terrain_to_read.remedy", "Give the terrain as well, or leave them out.", {}});
        }
    }

    const CaseRequest& m_request;
    const Execution& m_execution;
    OpenedCase m_opened;
};

void addFindingsOfFe(Findings& findings, const OpenedCase& opened) {
    const CaseScenario* scenario = findScenario(opened.theCase, opened.scenarioId);
    const CaseInput* input = scenario != nullptr ? findFeInput(opened.theCase, *scenario) : nullptr;
    if (input == nullptr || opened.inputs.fe == nullptr) {
        return;
    }
    const std::int64_t results = std::count_if(opened.theCase.inputs.begin(), opened.theCase.inputs.end(),
                                               [](const CaseInput& each) { return each.role == InputRole::Fe; });
    if (scenario->feInput.empty() && results > 1) {
        findings.add({"case.fe_inputs", "the scenario names no FE result, and the case has {0}; the first is used", {results}},
                     {"case.fe_inputs.remedy", "name the FE result of the scenario, or keep one in the case", {}}, opened.fePath);
    }
    if (!input->sha256.empty() && input->sha256 != opened.inputs.fe->contents().sha256) {
        findings.add({"case.input_changed", "The FE file is not the one the case was saved with.", {}},
                     {"case.input_changed.remedy", "Find the file with the SHA-256 of the case, or save the case anew.", {}},
                     opened.fePath);
    }
}

}  // namespace

OpenedCase openCase(const CaseRequest& request, const Execution& execution) {
    return CaseOpening(request, execution).open();
}

Findings openingFindings(const OpenedCase& opened) {
    Findings findings;
    addFindingsOfFe(findings, opened);
    findings.append(opened.terrain.findings);
    return findings;
}

Findings allFindings(const OpenedCase& opened, const Results& results) {
    Findings all = openingFindings(opened);
    if (opened.inputs.fe != nullptr) {
        all.append(opened.inputs.fe->contents().findings);
    }
    all.append(stageFindings(results));
    return all;
}

RunOrigin originOf(const OpenedCase& opened) {
    return originOf(opened, opened.scenario, opened.scenarioName);
}

RunOrigin originOf(const OpenedCase& opened, const Scenario& scenario, const std::string& scenarioName) {
    RunOrigin origin;
    origin.fePath = opened.fePath;
    origin.feSha256 = opened.inputs.fe->contents().sha256;
    origin.terrainPath = opened.terrain.path;
    origin.terrainSha256 = opened.terrain.sha256;
    recordSite(origin, opened.terrain, opened.theCase.site);
    origin.frame = opened.inputs.frame;
    origin.scenario = scenario;
    origin.scenarioName = scenarioName;
    origin.build = std::string(buildText());
    origin.fingerprint = stageKey(opened.inputs, scenario, Stage::Simulation);
    origin.unsaidUnits = unsaidUnits(opened.inputs.fe->contents().findings);
    origin.placeDoubts = placeDoubts(opened.terrain.findings);
    return origin;
}

}  // namespace rubble::io
