#pragma once

#include <optional>
#include <ostream>

#include "app/cli/run/run_report.h"
#include "core/analysis/debris/debris_measures.h"

namespace rubble::cli {

/// Figures of the debris of a finished run on the ground that it fell on. Unset where there is no debris, and where it cannot be
/// measured: it lies too far apart, or a place is no number.
std::optional<DebrisFigures> figuresAtEnd(const io::OpenedCase& subject, const Results& results, Debris debris);

/// At most ten lines for people: what fell, where it lies, how the run went, whether it can be trusted, and where it is.
void printSummary(std::ostream& out, const RunReport& report, const std::optional<DebrisFigures>& figures);

}  // namespace rubble::cli
