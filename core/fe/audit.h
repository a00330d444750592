#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"

namespace rubble {

/// One kind of anomaly in an FE result, counted, with the place of the first.
struct Anomaly {
    std::string kind;  ///< stable: "inactive_from_start", "revived", "inverted", "zero_volume", "sliver", "large_distortion",
                       ///< "no_density", ...
    std::int64_t count = 0;
    std::string example;  ///< "element 17,233 (deck 1) at state 12"
};

struct ComponentAudit {
    std::string name;
    std::string kind;
    std::int64_t elements = 0;
    std::int64_t dead = 0;  ///< at the last state
    double density = 0.0;   ///< kg/m3
    double mass = 0.0;      ///< kg
    double deadMass = 0.0;  ///< kg
};

/// Whether an element at its death is no longer the one that was meshed: less than half or more than twice its volume at rest.
/// @param ratio  volume at its death over the one at rest
bool isFarFromRest(double ratio);

/// What the file holds, and an account of every death in it.
struct Audit {
    std::vector<ComponentAudit> components;
    std::vector<std::int64_t> deadPerState;  ///< elements inactive at each state that were active at some earlier one
    std::int64_t deadTotal = 0;              ///< at the last state
    double mass = 0.0;
    double deadMass = 0.0;
    std::vector<Anomaly> anomalies;
};

/// Audits the deaths of an FE result; reads the last active geometry of every dead element (each state once).
Audit auditDeaths(const FeResult& fe, const Components& components, const Execution& execution);

}  // namespace rubble
