#pragma once

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/text_table.h"
#include "core/analysis/accuracy/accuracy_study.h"

namespace rubble::cli {

// The two tables of the published method, with what was measured here beside what was printed there.

/// Elements, fragments, live FPS with a body per fragment, clusters and live FPS with them.
TextTable publishedFpsTable(const AccuracyReport& report);
Json publishedFpsJson(const AccuracyReport& report);

/// Accuracy rates within 0.3, 0.2 and 0.1 m.
TextTable publishedAccuracyTable(const AccuracyReport& report);
Json publishedAccuracyJson(const AccuracyReport& report);

}  // namespace rubble::cli
