#pragma once

#include "core/evidence/cautions.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// The coordinate system that a case names without a place of the model in it; empty: it names none, or the model has one.
std::string unplacedSystem(const Frame& frame, const Site& site);

/// How far a recorded run has come and what it is worth. Throws what reading its last frame throws.
RunStanding standingOf(const RunReader& run);
/// The same beside what shows one instant: of an earlier one than the last it says what moved then.
/// @param time  s. Throws what reading its frame throws.
RunStanding standingAt(const RunReader& run, double time);

}  // namespace rubble::io
