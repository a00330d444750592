#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/pipeline/pipeline.h"
#include "io/run_file.h"
#include "io/terrain_reader.h"

namespace rubble::python {

/// One scenario of a case, or an FE result by itself: what rubble.open() gives. Results are kept as far as settings allow.
class Collapse {
public:
    /// Opens a case or an FE result, recognised by content.
    /// @param scenario  of a case, by id or name; unset: its active one
    /// @param terrain   takes the place of the case's; unset: that of the case
    /// Throws UsageError, WorldError, ParseError, Cancelled.
    static std::shared_ptr<Collapse> open(const std::string& path, const std::optional<std::string>& scenario,
                                          const std::vector<std::pair<std::string, std::string>>& settings,
                                          const std::optional<std::string>& terrain, const Execution& execution);
    /// Around a result that is in memory already.
    explicit Collapse(std::shared_ptr<const FeResult> fe);

    /// Value of a parameter as text. Throws UsageError for an unknown key.
    std::string setting(const std::string& key) const;
    /// Text may end in the unit of the parameter. Throws UsageError; nothing is changed then.
    void set(const std::string& key, const std::string& text);

    /// The part of a stage, made anew only where a setting has changed. Throws what the pipeline throws.
    const Results& upTo(Stage last, const Execution& execution);
    /// Simulates and records; what was simulated before a cancel stays in the file.
    /// Throws UsageError if the path is that of an input, and what createRun() and run() throw.
    void record(const std::string& path, const Execution& execution);

    const Inputs& inputs() const { return m_inputs; }
    const std::string& path() const { return m_path; }
    const std::string& scenarioName() const { return m_scenarioName; }
    const std::vector<std::string>& scenarios() const { return m_scenarios; }
    const Scenario& scenario() const { return m_scenario; }
    /// Of opening and of every stage that has run.
    Findings findings() const;

private:
    Collapse() = default;
    void openCase(const std::optional<std::string>& scenario, std::string& sha256);
    io::RunOrigin origin() const;

    Inputs m_inputs;
    Scenario m_scenario;
    Case m_case;
    std::string m_path;
    std::string m_fePath;
    std::string m_scenarioName = "As computed";
    std::vector<std::string> m_scenarios;
    io::TerrainInput m_terrain;
    Findings m_findings;
    Results m_results;
};

/// Sets a parameter from text that may end in its unit ("25 cm" of a parameter in m is refused, "0.25 m" is not).
void setWithUnit(Scenario& scenario, const std::string& key, const std::string& text);

}  // namespace rubble::python
