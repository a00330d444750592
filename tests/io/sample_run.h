#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/trajectory/trajectory.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// A made-up run over random fragments, as the simulation would hand it over: for tests of the run file and the exports. Bodies
/// enter in two batches; numbers are random, so that a lost or shifted one shows.
struct SampleRun {
    RunOrigin origin;
    RunDescription description;
    std::vector<BodyRecord> bodies;
    std::vector<Carrier> carriers;
    std::size_t firstBatch = 0;     ///< bodies that enter before the first frame
    std::size_t firstCarriers = 0;  ///< carriers of these
    std::vector<TrajectoryFrame> frames;
    std::vector<IslandRecord> islands;  ///< of bodies that exist; none without bodies
    LedgerRow islandLedger;
    std::vector<IslandLoss> islandLosses;
    std::vector<LedgerRow> ledger;
    SimulationResult result;

    /// Feeds everything into a sink, in order, with `frameCount` of the frames; finishes only if all were fed.
    void feed(TrajectorySink& sink, std::size_t frameCount) const;
    void feed(TrajectorySink& sink) const { feed(sink, frames.size()); }
};

SampleRun makeSampleRun(std::uint32_t seed, std::size_t clusters, std::size_t frames);

/// Whether two frames are the same bit for bit.
bool sameFrame(const TrajectoryFrame& a, const TrajectoryFrame& b);

}  // namespace rubble::io
