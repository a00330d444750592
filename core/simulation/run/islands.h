#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/activity.h"
#include "core/fe/site_surface.h"
#include "core/simulation/bodies/island_bodies.h"
#include "core/simulation/bodies/pieces.h"
#include "core/simulation/bodies/run_account.h"

namespace rubble {

/// Where the elements of an island are now, in boxes.
/// @param body  of the island
std::vector<Aabb> outlines(const IslandBody& island, const Pose& body);

/// The live islands of a run from the moment when the FE result ends (DESIGN.md 2.4): released as rigid bodies or held, by setting.
class Islands {
public:
    /// All arguments must outlive this object.
    Islands(const RunDescription& description, const Activity& activity, const SiteSurface& ground);

    /// Elements that other bodies carry already.
    void leaveOut(std::function<bool(ElementIndex)> carried) { m_carried = std::move(carried); }
    /// True if the setting releases something. Reads the last states of the FE result.
    bool toRelease();

    /// What entered the world, for the trajectory and the accounts.
    struct Release {
        std::vector<BodyRecord> bodies;
        std::vector<IslandRecord> islands;  ///< in the order of the bodies
        LedgerRow ledger;                   ///< as TrajectorySink::addIslands() wants it
    };
    /// Takes the elements of loose islands out of the pieces and puts the islands into the world as bodies, in the order of their
    /// first elements; what they overlap is overlap at birth. Nothing where the setting says held.
    Release release(RigidWorld& world, Pieces& pieces, Findings& findings);

    /// An element of a released island is no part of the standing structure any more.
    bool released(ElementIndex element) const { return !m_gone.empty() && m_gone[at(element)]; }
    std::int64_t bodies() const { return static_cast<std::int64_t>(m_bodies.size()); }
    /// Outlines of the elements of the released islands where their bodies are now.
    std::vector<Aabb> outlines(const RigidWorld& world) const;
    /// True once 99 % of the released islands sleep.
    bool atRest(const RigidWorld& world) const;
    /// What became of them, and the finding that says so.
    LiveIslands outcome(const RigidWorld& world, Findings& findings);
    void keep(Archive& archive);

private:
    struct Body {
        BodyId id{};
        IslandBody island;

        void keep(Archive& archive);
    };
    void find();
    void take(const IslandBody& island, RigidWorld& world, Release& release);
    void close(const LedgerRow& row);
    std::int64_t awake(const RigidWorld& world) const;

    const RunDescription& m_description;
    const Activity& m_activity;
    const SiteSurface& m_ground;
    std::optional<std::vector<LiveIsland>> m_loose;  ///< without a path to a support; unset: not looked for yet
    std::function<bool(ElementIndex)> m_carried;
    LiveIslands m_count;
    std::vector<Body> m_bodies;
    std::vector<bool> m_gone;  ///< [elements]; empty: none
    double m_linear = 0.0;     ///< kg m/s, sum of m |v| over the bodies: what errors are relative to
    double m_angular = 0.0;    ///< kg m2/s, sum of |x| m |v|
};

}  // namespace rubble
