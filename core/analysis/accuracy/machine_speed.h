#pragma once

#include <cstdint>

#include "core/analysis/accuracy/prediction.h"
#include "core/analysis/accuracy/run_time_left.h"
#include "core/base/execution.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

/// How fast this machine simulates, as a small pile says that takes about a second: enough for a crude prediction of any run.
struct MachineSpeed {
    double secondsPerWork = 0.0;  ///< s of wall time for a body second (RunTimeLeft::work())
    double stepRate = 0.0;        ///< 1/s, that the pile was simulated with
    int substeps = 0;             ///< of a step, likewise
};

/// Simulates the pile on as many threads as the execution grants. Throws Cancelled.
MachineSpeed measureMachineSpeed(const Execution& execution);
/// The same, measured once by a program for a number of threads.
MachineSpeed machineSpeed(const Execution& execution);

/// Wall time of a run that nothing like it was simulated before: from its bodies, their births and the speed of the machine, with
/// an interval as wide as that is crude.
/// @param bodies  that carry the fragments
/// @param scenario   settled, as a run takes it (settledScenario())
/// @param structure  the engine moves loose structure beside them, whose steps cost 2 to 3 times as much (docs/solver.md)
Prediction crudeWallSeconds(const FragmentSet& fragments, std::int64_t bodies, double feEnd, const Scenario& scenario,
                            const MachineSpeed& speed, bool structure = false);

}  // namespace rubble
