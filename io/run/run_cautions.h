#pragma once

#include "core/evidence/cautions.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// How far a recorded run has come and what it is worth. Throws what reading its last frame throws.
RunStanding standingOf(const RunReader& run);

}  // namespace rubble::io
