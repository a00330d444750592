#pragma once

#include <ostream>

#include "app/cli/frame/progress_line.h"
#include "core/base/execution.h"

namespace rubble::cli {

/// Where a command writes to, and the progress and cancel that it hands on.
class Session {
public:
    Session(std::ostream& out, std::ostream& err, Execution execution, ProgressLine& line)
        : m_out(out), m_err(err), m_execution(std::move(execution)), m_line(line) {}

    /// Results. The progress line is wiped first, so that the two never mix on a terminal.
    std::ostream& out() {
        m_line.clear();
        return m_out;
    }
    /// Everything else.
    std::ostream& err() {
        m_line.clear();
        return m_err;
    }

    const Execution& execution() const { return m_execution; }

private:
    std::ostream& m_out;
    std::ostream& m_err;
    const Execution m_execution;
    ProgressLine& m_line;
};

}  // namespace rubble::cli
