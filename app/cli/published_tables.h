#pragma once

#include "app/cli/json_output.h"
#include "app/cli/text_table.h"
#include "core/analysis/accuracy_study.h"

namespace rubble::cli {

// The two tables of the published method, with what was measured here beside what was printed there.

/// Elements, fragments, live FPS with a body per fragment, clusters and live FPS with them.
TextTable publishedFpsTable(const AccuracyReport& report);
Json publishedFpsJson(const AccuracyReport& report);

/// Accuracy rates within 0.3, 0.2 and 0.1 m.
TextTable publishedAccuracyTable(const AccuracyReport& report);
Json publishedAccuracyJson(const AccuracyReport& report);

/// The share of fragments within one of the three distances of the published table: 0.1, 0.2, 0.3 m by number; NaN if it was not
/// among the tolerances.
double publishedRate(const DebrisDifference& difference, std::size_t number);
inline constexpr std::array<double, 3> publishedTolerances{0.1, 0.2, 0.3};  ///< m

}  // namespace rubble::cli
