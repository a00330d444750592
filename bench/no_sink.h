#pragma once

#include <span>

#include "core/simulation/run/simulation.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Takes everything and keeps nothing: what recording costs is measured with the command line.
class NoSink : public TrajectorySink {
public:
    void begin(const RunDescription&) override {}
    void addBodies(std::span<const BodyRecord>, std::span<const Carrier>) override {}
    void commit(const TrajectoryFrame&) override {}
    void addLedger(const LedgerRow&) override {}
    void finish(const SimulationResult&) override {}
};

}  // namespace rubble
