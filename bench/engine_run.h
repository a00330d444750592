#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "bench/engine_scene.h"
#include "core/base/hash.h"
#include "core/validation/box_overlap.h"

namespace rubble::bench {

using EngineFactory = std::function<std::unique_ptr<RigidWorld>(const WorldSettings&)>;

/// What an engine made of a scene and what it took. The judgement is of the places and speeds that it gives, whatever it says
/// itself.
struct EngineMeasure {
    std::int64_t bodies = 0;  ///< that entered
    std::int64_t steps = 0;
    double birthSeconds = 0.0;           ///< s, simulated, from the first to the last body that enters
    double birthWallSeconds = 0.0;       ///< s, of these, as the clock goes
    double birthProcessorSeconds = 0.0;  ///< s, of these, of all processors
    std::int64_t birthSteps = 0;
    double processorSeconds = 0.0;  ///< s, of all steps
    std::int64_t pairsPeak = 0;     ///< touching at one time, as the engine counts them
    std::int64_t pointsPeak = 0;    ///< of these
    double pointsMean = 0.0;        ///< of the steps between the births
    std::int64_t tooFast = 0;       ///< bodies that were ever 3 % faster than their birth and fall allow
    std::int64_t thrown = 0;        ///< bodies that ever rose faster than 3 m/s, and than they were born
    OverlapMeasure overlap;         ///< at the end, between bodies
    double meanHeight = 0.0;        ///< m above the ground, of the mass, at the end
    double spread = 0.0;            ///< m, 95 % of the mass ends no farther from its centre across
    double asleep = 0.0;            ///< share of the bodies present at the end
    Digest end;                     ///< of all places at the end: equal bits in a repeat
};

/// Runs a scene. Pieces and bodies are the scene's alone: nothing acts besides the engine.
EngineMeasure measureEngine(const EngineScene& scene, const EngineFactory& makeEngine);

/// Bytes that the soft-step solver keeps for a contact of four points, all in all.
struct ContactBytes {
    std::size_t found = 0;       ///< by the narrow phase
    std::size_t kept = 0;        ///< from step to step, twice
    std::size_t record = 0;      ///< on its way to the solver
    std::size_t solving = 0;     ///< read by every pass
    std::size_t tally = 0;       ///< read by some
    std::size_t correction = 0;  ///< read by the passes of position correction

    std::size_t all() const { return found + kept + record + solving + tally + correction; }
};
ContactBytes contactBytes();

}  // namespace rubble::bench
