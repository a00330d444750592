#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/pipeline.h"
#include "io/case/open_case.h"

namespace rubble::python {

/// One scenario of a case, or an FE result by itself: what rubble.open() gives. Results are kept as far as settings allow.
class Collapse {
public:
    explicit Collapse(io::OpenedCase opened);
    /// Around a result that is in memory already.
    explicit Collapse(std::shared_ptr<const FeResult> fe);

    /// Text may end in the unit of the parameter. Throws UsageError; nothing is changed then.
    void set(const std::string& key, const std::string& text);

    /// The part of a stage, made anew only where a setting has changed. Throws what the pipeline throws.
    const Results& upTo(Stage last, const Execution& execution);
    /// Simulates and records; what was simulated before a cancel stays in the file.
    /// Throws UsageError if the path is that of an input, and what createRun() and run() throw.
    void record(const std::string& path, const Execution& execution);

    const Inputs& inputs() const { return m_opened.inputs; }
    /// Of the case or FE result, absolute.
    std::string path() const;
    const std::string& scenarioName() const { return m_opened.scenarioName; }
    /// Names of all scenarios of the case; none of an FE result by itself.
    std::vector<std::string> scenarios() const;
    const Scenario& scenario() const { return m_opened.scenario; }
    /// Of opening and of every stage that has run.
    Findings findings() const;
    /// Looks for what moves beside the fragments and is not among the bodies that a frame rate allows, to be said among the
    /// findings. Throws Cancelled.
    void lookBeside(const Execution& execution);

private:
    io::OpenedCase m_opened;
    Results m_results;
    std::optional<Finding> m_beside;
};

}  // namespace rubble::python
