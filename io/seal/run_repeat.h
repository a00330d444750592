#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/pipeline/pipeline.h"
#include "core/scenario/case.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// One figure of a run, then and now.
struct RepeatedFigure {
    std::string name;  ///< "trajectory hash"
    std::string recorded;
    std::string found;
    bool same() const { return recorded == found; }
};

/// What came of simulating a run once more.
struct RunRepeat {
    std::vector<RepeatedFigure> figures;  ///< build, fingerprint, clusters, frames, steps, health breaches, trajectory hash
    bool equal = false;                   ///< the trajectory is the same bit for bit
    /// The first recorded instant that differs, and by how much; empty: there is none.
    Message firstDifference;
};

/// FE result and terrain that a run was made from. @param origin  with the paths where its files are now
/// @param place  gets what speaks against the place of the run @param terrain  gets what reading the terrain found
/// Throws as openFe() and openTerrain().
Inputs openRunInputs(const RunOrigin& origin, Findings& place, Findings& terrain, const Execution& execution);

/// The origin of a run with its files where a case has them now. Throws UsageError if it stands on a file that is no input of the
/// case as it is now, and as digestOfInput().
RunOrigin originInCase(const RunReader& run, const std::string& casePath, const Case& theCase, const Execution& execution);

/// Simulates a complete run again and compares each frame with the recorded one, bit by bit. Throws what run() throws.
RunRepeat repeatRun(const RunReader& recorded, const Inputs& inputs, const Execution& execution);

}  // namespace rubble::io
