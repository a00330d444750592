#pragma once

#include <ostream>
#include <string>

#include "app/cli/frame/json_output.h"
#include "core/evidence/cautions.h"
#include "core/simulation/run/simulation.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_file.h"

namespace rubble::cli {

/// {breaches [{check, grade, why, from_s, to_s, times_s, worst_at_s, body, place_m, worst, limit, bodies, what, remedy}], ...}, one
/// entry for each limit that was passed; the manual lists the keys.
Json healthJson(const SimulationResult& result);
/// {by, when, note}, or null.
Json acknowledgedJson(const io::Taint& taint);

/// What must be known beside the figures of a run or a photograph, [{key, grade, text}].
Json cautionsJson(const std::vector<Caution>& cautions);
/// The same for a recorded run.
Json cautionsOf(const io::RunReader& run);
/// Those that pictures show, one line each.
void printCautions(std::ostream& out, const std::vector<Caution>& cautions);

/// The breaches as a table, or a sentence that there is none, with what was watched.
void printHealth(std::ostream& out, const SimulationResult& result, const io::Taint& taint);

/// Says on standard error that a run has breaches that nobody has acknowledged, and how to do so.
void warnIfTainted(Session& session, const std::string& runPath, const io::Taint& taint);

}  // namespace rubble::cli
