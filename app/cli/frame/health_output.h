#pragma once

#include <ostream>
#include <string>

#include "app/cli/frame/json_output.h"
#include "core/simulation/run/simulation.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_file.h"

namespace rubble::cli {

/// {breaches [{check, from_s, to_s, worst_at_s, body, place_m, worst, limit, bodies, what, remedy}], ...}; the manual lists the
/// keys.
Json healthJson(const SimulationResult& result);
/// {by, when, note}, or null.
Json acknowledgedJson(const io::Taint& taint);

/// The breaches as a table, or a sentence that there is none, with what was watched.
void printHealth(std::ostream& out, const SimulationResult& result, const io::Taint& taint);

/// Says on standard error that a run has breaches that nobody has acknowledged, and how to do so.
void warnIfTainted(Session& session, const std::string& runPath, const io::Taint& taint);

}  // namespace rubble::cli
