#include "app/python/collapse.h"

#include <filesystem>

#include "core/analysis/accuracy/loose_beside.h"
#include "core/base/error.h"
#include "core/scenario/parameters.h"

namespace rubble::python {

namespace fs = std::filesystem;

Collapse::Collapse(io::OpenedCase opened) : m_opened(std::move(opened)) {}

Collapse::Collapse(std::shared_ptr<const FeResult> fe) {
    m_opened.fePath = fe->contents().path;
    m_opened.scenarioName = "As computed";
    m_opened.inputs.frame = fe->contents().frame;
    m_opened.inputs.fe = std::move(fe);
}

std::string Collapse::path() const {
    return m_opened.casePath.empty() ? m_opened.fePath : fs::absolute(m_opened.casePath).lexically_normal().string();
}

std::vector<std::string> Collapse::scenarios() const {
    std::vector<std::string> names;
    if (!m_opened.casePath.empty()) {
        for (const CaseScenario& scenario : m_opened.theCase.scenarios) {
            names.push_back(scenario.name);
        }
    }
    return names;
}

void Collapse::set(const std::string& key, const std::string& text) {
    Scenario changed = m_opened.scenario;
    setParameterText(changed, key, text);
    if (!(changed.import == m_opened.scenario.import)) {
        throw UsageError({"python.import_setting", "{0} says how the FE result is read, and that is open already.", {key}},
                         {"python.import_setting.remedy", "Give it to rubble.open() in settings.", {}});
    }
    m_opened.scenario = std::move(changed);
    m_beside.reset();
}

Findings Collapse::findings() const {
    Findings all = io::allFindings(m_opened, m_results);
    std::optional<Finding> beside = m_beside;
    if (m_results.simulation != nullptr) {
        beside = looseBesideCaution(m_results.sizing->fpsTarget, *m_results.simulation, m_opened.inputs.fe->mesh().elementCount());
    }
    if (beside) {
        all.add(beside->what, beside->remedy);
    }
    return all;
}

void Collapse::lookBeside(const Execution& execution) {
    const std::optional<LooseAtOnce> beside = looseBeside(m_opened.inputs, m_opened.scenario, execution);
    m_beside.reset();
    if (beside) {
        m_beside = looseBesideCaution(m_opened.scenario.grid.fpsTarget, *beside, m_opened.inputs.fe->mesh().elementCount());
    }
}

const Results& Collapse::upTo(Stage last, const Execution& execution) {
    m_results = run(m_opened.inputs, m_opened.scenario, last, m_results, nullptr, execution);
    return m_results;
}

void Collapse::record(const std::string& path, const Execution& execution) {
    std::error_code ignored;
    for (const std::string& input : m_opened.files) {
        if (fs::equivalent(path, input, ignored)) {
            throw UsageError({"python.out_is_input", "{0} is an input of this run.", {path}},
                             {"python.out_is_input.remedy", "Choose another name for the run.", {}});
        }
    }
    if (fs::exists(path, ignored) && fs::file_size(path, ignored) > 0) {
        try {
            io::openRun(path);
        } catch (const ParseError&) {
            throw UsageError({"python.out_not_a_run", "{0} exists and is not a run.", {path}},
                             {"python.out_not_a_run.remedy", "Choose another name, or delete the file first.", {}});
        }
    }
    const std::unique_ptr<TrajectorySink> sink = io::createRun(path, io::originOf(m_opened));
    // A simulation that is there already would not be recorded.
    Results earlier = m_results;
    earlier.simulation = nullptr;
    m_results = run(m_opened.inputs, m_opened.scenario, Stage::Simulation, earlier, sink.get(), execution);
}

}  // namespace rubble::python
