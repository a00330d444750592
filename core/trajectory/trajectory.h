#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/hash.h"
#include "core/base/ids.h"
#include "core/clusters/clustering.h"
#include "core/clusters/sizing.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/fe/terrain_grid.h"
#include "core/fragments/fragment_set.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// What a frame shows: an FE state, a simulated instant, something between two frames, or something only for the eye.
enum class FrameKind : std::uint8_t { Fe, Simulated, Interpolated, Illustrative };

enum class BodyState : std::uint8_t { Awake = 1, Frozen = 2, Removed = 3 };

/// In place of a cluster: the body carries an island of live structure.
inline constexpr ClusterId noCluster = idAt<ClusterId>(0xffffffffu);

/// A rigid body as it entered the engine.
struct BodyRecord {
    BodyId body{};
    ClusterId cluster{};                                  ///< noCluster for an island
    double from = 0.0;                                    ///< s, hand-over
    double to = std::numeric_limits<double>::infinity();  ///< s, when it left again
    double mass = 0.0;                                    ///< kg
    Pose atBirth;                                         ///< centre of mass and axes at `from`
    Pose inFe;          ///< the same among the places of the FE result then; not in files, readers have it by carriers and islands
    bool part = false;  ///< it carries only some fragments of its cluster, for islands had moved the others elsewhere; not in files

    bool isIsland() const { return cluster == noCluster; }
};

/// In place of an FE state: the last one, whatever its number.
inline constexpr std::uint32_t atLastState = 0xffffffffu;

/// The live elements that an island is made of, for as long as its body is there. A node of theirs that lay at p at an FE state
/// lies at body pose * (inFe^-1 * p). What is left of an island that lost elements is another record with the same state.
struct IslandRecord {
    BodyId body{};
    std::uint32_t state = 0;             ///< FE state at which the engine took it over, or atLastState
    Pose inFe;                           ///< of the body's frame, among the places of that state
    std::vector<ElementIndex> elements;  ///< ascending
};

/// A fragment is carried by a body over an interval of time; the next carrier of a fragment ends the one before. While carried, a
/// point of the fragment that lay at p (world) at hand-over lies at body pose * handOverToBody * p.
struct Carrier {
    FragmentId fragment{};
    BodyId body{};
    double from = 0.0;  ///< s
    double to = std::numeric_limits<double>::infinity();
    Pose handOverToBody;
};

/// All bodies at one instant. Arrays are indexed by BodyId and hold the bodies that entered up to then.
struct TrajectoryFrame {
    double time = 0.0;  ///< s, on the file's clock
    FrameKind kind = FrameKind::Simulated;
    std::vector<Eigen::Vector3f> positions;  ///< centre of mass, local frame, m
    std::vector<Eigen::Quaternionf> orientations;
    std::vector<float> speeds;  ///< m/s
    std::vector<BodyState> states;

    std::size_t bodies() const { return positions.size(); }
};

/// One row of the mass, momentum and energy ledger, at one FE state (or one second, after the last).
struct LedgerRow {
    double time = 0.0;
    std::uint32_t state = 0;
    Momenta fe;                         ///< of the elements handed over here, by quadrature from the file
    Momenta fragments;                  ///< of their rigid fragments
    Momenta clusters;                   ///< of the clusters they form
    Momenta bodies;                     ///< of the new bodies, as read back from the engine
    double droppedKineticEnergy = 0.0;  ///< J, fe - bodies: deformation and spin that a rigid cluster cannot carry
    Momenta all;                        ///< of all bodies in the engine at this instant
    double potentialEnergy = 0.0;       ///< J, of all bodies, above the ground
    double pieceWork = 0.0;             ///< J, cumulated: done by moving pieces on bodies
    double overlapWork = 0.0;           ///< J, cumulated: done by resolving overlap at birth
};

/// What a run consists of before its first step.
struct RunDescription {
    std::shared_ptr<const FeResult> fe;
    std::shared_ptr<const TerrainGrid> terrain;  ///< null: the case has none
    Scenario scenario;
    std::shared_ptr<const Components> components;
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const Sizing> sizing;
    std::shared_ptr<const Clustering> clustering;
    Digest fingerprint;  ///< of inputs, scenario and build
};

struct SimulationResult;
struct HealthBreach;

/// What islands lost at one FE state: elements that died, or the parts they fell into.
struct IslandLoss {
    double time = 0.0;  ///< s
    std::uint32_t state = 0;
    Momenta before;  ///< of the islands that lost something
    Momenta born;    ///< of the bodies of fragments that were born from them
    Momenta left;    ///< of the islands that are left
};

/// Takes a run as it is made. Calls come from one thread in this order: begin, then any number of addBodies, commit, addLedger and
/// addBreaches, addIslands and addIslandLoss right after the addBodies of their bodies, then finish (not after a cancel or an
/// error). What was committed stays readable whatever happens next. A run that goes on from a checkpoint calls resume in place of
/// begin.
class TrajectorySink {
public:
    virtual ~TrajectorySink() = default;
    virtual void begin(const RunDescription& description) = 0;
    virtual void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) = 0;
    /// Islands of live structure are carried by bodies that were added just before.
    /// @param ledger  of those that the FE result handed over: `fe` by quadrature, `fragments` as rigid elements, `clusters` as the
    ///                islands, `bodies` as read back; they are in no row of addLedger but in its `all`. All zero where every one is
    ///                what was left of another
    virtual void addIslands(std::span<const IslandRecord> /*islands*/, const LedgerRow& /*ledger*/) {}
    virtual void addIslandLoss(const IslandLoss& /*loss*/) {}
    virtual void commit(const TrajectoryFrame& frame) = 0;
    virtual void addLedger(const LedgerRow& row) = 0;
    /// Breaches of health that have begun, or have grown longer or worse: one with the same check and beginning takes the place of
    /// what was said of it before. The result of the run says the last word.
    virtual void addBreaches(const std::vector<HealthBreach>& /*breaches*/) {}
    virtual void finish(const SimulationResult& result) = 0;

    /// What resume() needs to go on after what has come so far, in this process or another one; nothing: this sink cannot, and its
    /// run keeps no checkpoints.
    virtual std::optional<std::string> mark() { return std::nullopt; }
    /// In place of begin(): goes on after a mark of its own, and forgets what came after it. False: what it refers to is no longer
    /// there, and the run starts with begin().
    virtual bool resume(const RunDescription& /*description*/, std::string_view /*mark*/) { return false; }
};

/// Reads committed frames while a run is made or after; thread-safe. Frames come through a bounded cache.
class TrajectoryReader {
public:
    virtual ~TrajectoryReader() = default;
    virtual std::size_t frameCount() const = 0;
    virtual double frameTime(std::size_t i) const = 0;
    virtual std::shared_ptr<const TrajectoryFrame> frame(std::size_t i) const = 0;
    virtual std::vector<BodyRecord> bodies() const = 0;               ///< those that entered up to now
    virtual std::vector<Carrier> carriers() const = 0;                ///< in the order in which they were added
    virtual std::vector<IslandRecord> islands() const { return {}; }  ///< up to now, in the order in which they were added
    virtual bool complete() const = 0;                                ///< finish() was called

    /// Index of the last frame at or before a time; 0 if there is none.
    std::size_t frameAt(double time) const;
};

/// Ends each carrier where the next one of its fragment begins, and with its last carrier a body whose fragments have all changed
/// over to others (it broke up). Readers do this, since a sink only ever adds.
/// @param carriers  in the order in which they were added
void endReplaced(std::vector<BodyRecord>& bodies, std::vector<Carrier>& carriers);

/// Position and orientation of all bodies at any time: the frame at that time, or linear (position) and spherical (orientation)
/// interpolation between its two neighbours, marked Interpolated. Bodies that enter between the two come straight from their birth
/// place. The last frame after the end; empty before the first.
TrajectoryFrame frameAtTime(const TrajectoryReader& reader, double time);

/// Keeps a whole trajectory in memory: for tests, and for runs nobody wants as a file.
class MemoryTrajectory : public TrajectorySink, public TrajectoryReader {
public:
    MemoryTrajectory();
    ~MemoryTrajectory() override;
    void begin(const RunDescription& description) override;
    void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) override;
    void addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) override;
    void addIslandLoss(const IslandLoss& loss) override;
    void commit(const TrajectoryFrame& frame) override;
    void addLedger(const LedgerRow& row) override;
    void finish(const SimulationResult& result) override;
    /// The whole trajectory.
    std::optional<std::string> mark() override;
    bool resume(const RunDescription& description, std::string_view mark) override;
    std::size_t frameCount() const override;
    double frameTime(std::size_t i) const override;
    std::shared_ptr<const TrajectoryFrame> frame(std::size_t i) const override;
    std::vector<BodyRecord> bodies() const override;
    std::vector<Carrier> carriers() const override;
    std::vector<IslandRecord> islands() const override;
    bool complete() const override;
    std::vector<LedgerRow> ledger() const;
    std::vector<LedgerRow> islandLedger() const;
    std::vector<IslandLoss> islandLosses() const;

private:
    struct Store;
    std::unique_ptr<Store> m_store;
};

}  // namespace rubble
