#pragma once

#include <span>
#include <string>

#include "core/base/hash.h"

namespace rubble {

struct SimulationResult;

/// Someone has seen the health breaches of a run and vouches for using it all the same.
struct Acknowledgement {
    std::string by;    ///< who
    std::string when;  ///< UTC, "2024-05-31T08:15:30Z"
    std::string note;  ///< why
    Digest breaches;   ///< breachesDigest() of the run it is about
    friend bool operator==(const Acknowledgement&, const Acknowledgement&) = default;
};

/// Names a run's trajectory and its breaches: another run, or the same with other breaches, has another one.
Digest breachesDigest(const SimulationResult& result);

/// The acknowledgement of this very result, or null: the last one that names its breaches.
const Acknowledgement* acknowledgementOf(const SimulationResult& result, std::span<const Acknowledgement> list);

/// The run has breaches that nobody has acknowledged.
bool isTainted(const SimulationResult& result, std::span<const Acknowledgement> list);

/// Now, as an acknowledgement writes it.
std::string utcNow();

}  // namespace rubble
