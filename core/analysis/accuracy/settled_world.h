#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/analysis/accuracy/study_store.h"
#include "core/analysis/debris/arrivals.h"

namespace rubble {

class Archive;

/// Live elements of an island and how they were carried since the engine took them over.
struct CarriedIsland {
    std::vector<ElementIndex> elements;  ///< ascending
    std::uint32_t state = atLastState;   ///< FE state at which it did
    Pose moved;                          ///< a point that lay at p at that state lies at moved * p

    void keep(Archive& archive);
};

/// Where the islands of a run are in one of its frames: those that bodies carry then.
/// @param bodies  of the islands at least, in any order
std::vector<CarriedIsland> carriedIslands(std::span<const IslandRecord> islands, std::span<const BodyRecord> bodies,
                                          const TrajectoryFrame& frame);

/// Elements that left such an island and are no fragments yet: from hand-over to birth they count as structure, and bodies carry
/// them already. One entry each.
std::vector<CarriedIsland> leftIslands(const FragmentSet& fragments, std::span<const IslandRecord> islands,
                                       std::span<const Carrier> carriers, const TrajectoryFrame& frame);

/// A simulated world with the live structure that fell in it: all that lies on the site.
struct SettledWorld {
    SimulatedWorld world;
    std::vector<CarriedIsland> islands;  ///< at rest
    DebrisArrivals arrivals;
};

/// Simulates a world; frames are not kept. Throws what simulate() throws.
/// @param checkpoints  null: none are kept
SettledWorld simulateSettled(const RunDescription& description, const Execution& execution, CheckpointStore* checkpoints = nullptr);

/// Where settled worlds are kept. Members may be called from several threads at once.
class SettledStore {
public:
    virtual ~SettledStore() = default;
    /// As StudyStore::world(); a world whose islands are not kept beside it is not taken.
    virtual std::optional<SettledWorld> settled(const WorldOrigin& origin, Findings& findings) = 0;
    /// Throws WorldError when there is no room.
    virtual void keep(const WorldOrigin& origin, const SettledWorld& settled) = 0;
    /// As StudyStore::checkpoints().
    virtual std::unique_ptr<CheckpointStore> checkpoints(const WorldOrigin&) { return nullptr; }
};

}  // namespace rubble
