#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/simulation/health/health.h"
#include "core/simulation/run/acknowledgement.h"

namespace rubble::io {

/// Where the acknowledgements of a run are kept: RUN.h5.acknowledged.json beside it. The run file itself never changes once it is
/// complete, so that its digest and its readers are left alone.
std::string acknowledgementPath(const std::string& runPath);

/// Puts an acknowledgement beside a run, after those that are there, atomically. An empty `when` becomes now; `breaches` is taken
/// from the run whatever it holds.
/// Throws UsageError without a name or a note, or if the run has no breaches; ParseError if the run is not complete or is none, or
/// if what lies at the sidecar's place is not one; WorldError if the run cannot be read or the sidecar cannot be written.
void acknowledge(const std::string& runPath, Acknowledgement acknowledgement);

/// All acknowledgements that lie beside a run, in the order in which they were made; some may be of an earlier run of this name,
/// see acknowledgementOf(). Empty if there is no sidecar. Throws WorldError, ParseError naming the sidecar.
std::vector<Acknowledgement> acknowledgements(const std::string& runPath);

class RunReader;

/// What a run's breaches and the acknowledgements beside it come to.
struct Taint {
    std::size_t limits = 0;                          ///< passed, each counted once
    HealthGrade grade = HealthGrade::Notice;         ///< the gravest of them
    std::optional<Acknowledgement> acknowledgement;  ///< the one of these very breaches
    Message problem;                                 ///< why the acknowledgements could not be read; empty if they could
    bool complete = true;                            ///< only a run that is can be acknowledged
    bool tainted() const { return grade == HealthGrade::Tainted && !acknowledgement; }
};

/// Of a run that nobody has acknowledged.
Taint taintOf(std::span<const HealthBreach> breaches);
/// Of a run as far as it is there; one that is not complete cannot be acknowledged. A sidecar that cannot be read acknowledges
/// nothing and is no error.
Taint taintOf(const RunReader& run);

}  // namespace rubble::io
