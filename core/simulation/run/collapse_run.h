#pragma once

#include <functional>
#include <memory>

#include "core/base/execution.h"
#include "core/engine/world/rigid_world.h"
#include "core/simulation/run/simulation.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

using WorldFactory = std::function<std::unique_ptr<RigidWorld>(const WorldSettings&)>;

/// simulate() in a world of the caller's choice: for benchmarks against the plain engine, and for tests.
SimulationResult simulateIn(const WorldFactory& makeWorld, const RunDescription& description, TrajectorySink& sink,
                            const Execution& execution, CheckpointStore* checkpoints = nullptr);

}  // namespace rubble
