#pragma once

#include <ostream>
#include <span>
#include <vector>

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/text_table.h"
#include "core/simulation/run/simulation.h"

namespace rubble::cli {

/// [{effect, asked, state, reason, measure, threshold}]
Json effectsJson(const EffectDecisions& decisions);
/// The same after a run, with {ms_per_step, share, work_j, events}.
Json effectsJson(const std::vector<EffectReport>& reports);

/// One row for each effect, with measure and threshold for programs.
/// What a step of a run cost, by what took it, and how far that is from the measured step; see the manual.
Json costsJson(const SimulationResult& run);
TextTable effectsTable(const EffectDecisions& decisions);

/// State and reason of each effect, as a list: the reasons are too long for a table on a terminal.
void printEffects(std::ostream& out, const EffectDecisions& decisions);
/// The same after a run, with what each cost in the mean over all steps.
void printEffects(std::ostream& out, const SimulationResult& run);

}  // namespace rubble::cli
