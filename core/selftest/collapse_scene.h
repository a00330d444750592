#pragma once

#include <memory>

#include "core/pipeline/pipeline.h"
#include "core/selftest/element_scene.h"
#include "core/selftest/hard_case.h"

namespace rubble::selftest {

/// A small FE result taken through the whole pipeline, trajectory in memory.
struct CollapseScene {
    explicit CollapseScene(const CaseSetting& setting);

    /// Runs to the end. Throws what the pipeline throws.
    const SimulationResult& run(std::shared_ptr<const FeResult> fe);
    const SimulationResult& result() const { return *results.simulation; }

    /// A run that was made with parts of this one.
    void took(const SimulationResult& run) const;

    /// Bodies that lie with their centre below the level ground or at no place at all, at the end.
    std::int64_t lost() const;
    /// Places of the fragments at the end that are not numbers.
    std::int64_t notANumber() const;
    /// Fastest body over sqrt(v^2 + 2 g h), v and h the most that any body was born with.
    double speedShare() const;

    Scenario scenario;
    Frame frame;
    Execution execution;
    std::shared_ptr<TrajectoryHashes> hashes;  ///< takes what the run moves, if asked for
    Results results;
    MemoryTrajectory trajectory;
};

/// The eight corners of a box in the order of a hexahedron.
std::vector<Vec3> boxCorners(const Vec3& low, const Vec3& size);

}  // namespace rubble::selftest
