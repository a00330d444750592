#pragma once

#include <optional>
#include <vector>

#include "core/fe/loose_structure.h"
#include "core/fe/site_surface.h"
#include "core/simulation/bodies/hand_over.h"
#include "core/simulation/bodies/island_bodies.h"
#include "core/simulation/bodies/pieces.h"
#include "core/simulation/bodies/run_account.h"
#include "core/simulation/run/island_blows.h"

namespace rubble {

/// Loose islands of live structure that the engine moves before the FE result ends (setting loose_structure). The FE result stays
/// the judge of what breaks off what and when, the engine becomes the judge of where things are. An island becomes a body of many
/// boxes at one FE state. Elements that the FE result kills afterwards are born where the island's body has them, in the shape and
/// with the mass properties that they had when it became one: so mass, momentum and angular momentum are shared out to rounding.
/// What is left goes on as one body for each part that still hangs together, with the motion of the whole.
class CarriedIslands : public IslandBirths {
public:
    /// All arguments must outlive this object.
    CarriedIslands(const RunDescription& description, const Activity& activity, const SiteSurface& ground);

    bool on() const { return m_description.scenario.effects.loose != LooseStructurePolicy::Fe; }

    /// What entered and what is to leave at one FE state.
    struct Change {
        std::vector<BodyRecord> bodies;
        std::vector<IslandRecord> islands;  ///< in the order of the bodies
        std::vector<BodyId> ended;          ///< to be taken out: what is left of them is among the bodies
        LedgerRow ledger;                   ///< of those that the FE result handed over, as TrajectorySink::addIslands() wants it
        std::optional<IslandLoss> loss;
    };
    /// After the births of state k, before its first step: parts what lost elements and takes over what has come loose.
    /// @param born  what was born from islands at this state
    Change atState(std::size_t k, const HandOver& born, RigidWorld& world, Pieces& pieces, const Execution& execution,
                   Findings& findings);

    /// A body of the engine has the element, or had it when it was lost.
    bool carries(ElementIndex element) const { return !m_carrier.empty() && m_carrier[at(element)] >= 0; }
    std::optional<std::int32_t> carrierOf(ElementIndex element) const override;
    std::optional<IslandBirth> born(std::int32_t carrier, std::span<const FragmentId> members, std::size_t state,
                                    const RigidWorld& world) const override;

    /// Bodies that ever entered.
    std::int64_t bodies() const { return m_account.bodies; }
    /// Where the elements are that are carried now.
    std::vector<Aabb> outlines(const RigidWorld& world) const;
    bool atRest(const RigidWorld& world) const { return awake(world) == 0; }
    CarriedStructure outcome(const RigidWorld& world) const;
    void keep(Archive& archive);

private:
    struct Body {
        BodyId id{};
        std::uint32_t state = 0;  ///< FE state whose places its parts have
        IslandBody island;        ///< its pose: where the frame lies among those places
        bool there = true;

        void keep(Archive& archive);
    };
    void begin(const Execution& execution);
    void noteBlows(std::size_t k, const RigidWorld& world);
    void lose(std::size_t k, const HandOver& born, RigidWorld& world, Change& change);
    void countBirths(const HandOver& born, const RigidWorld& world);
    void goOn(std::size_t before, const std::vector<ElementIndex>& left, std::size_t k, RigidWorld& world, Change& change);
    void take(std::size_t k, RigidWorld& world, Pieces& pieces, Change& change, Findings& findings);
    void enter(Body body, const NewBody& made, std::size_t k, RigidWorld& world, Change& change);
    std::vector<LiveIsland> toTake(std::size_t k) const;
    double endOf(const std::vector<ElementIndex>& elements, std::size_t k) const;
    std::int64_t awake(const RigidWorld& world) const;

    const RunDescription& m_description;
    const Activity& m_activity;
    const SiteSurface& m_ground;
    std::optional<LooseStructure> m_loose;  ///< unset: not looked for yet
    std::vector<Body> m_bodies;
    std::vector<std::int32_t> m_carrier;  ///< [elements], index into m_bodies or -1; empty: none
    std::vector<bool> m_gone;             ///< [elements] that left the FE result's hands
    IslandBlows m_blows;
    CarriedStructure m_account;
};

}  // namespace rubble
