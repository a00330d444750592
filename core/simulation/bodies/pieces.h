#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/archive.h"
#include "core/engine/world/rigid_world.h"
#include "core/fe/activity.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// The active structure as kinematic pieces (DESIGN.md 2.4). A piece of an FE interval holds the elements of its group that are
/// active at both ends; rigid fits of their nodes at both ends give its motion. A group is a component, the elements of a component
/// in one cell of a grid laid over it at rest, or a single element. Where pieces are made of bricks, what has come apart within a
/// cell are groups of their own.
class Pieces {
public:
    /// @param activity     under the revival policy; must outlive the pieces
    /// @param finestBrick  m, of pieces that are made of bricks (cluster_shape.h)
    Pieces(const FeResult& fe, const Components& components, const Activity& activity, const Scenario& scenario,
           double finestBrick = 0.0);

    /// Sets up the interval from state k to k + 1: takes out what lost elements, puts in what is left of it, fits the motion.
    void beginInterval(RigidWorld& world, std::size_t k);
    /// Moves every moving piece to where it is at a share of the interval in (0, 1].
    void moveTo(RigidWorld& world, double share);
    /// Puts in all that is active at state k, standing still.
    void standAt(RigidWorld& world, std::size_t k);
    /// Takes elements out for good; what is left of their pieces stands where state k has it.
    /// @param gone  [elements]
    void release(RigidWorld& world, const std::vector<bool>& gone, std::size_t k);
    /// From now on everything stands still (after the last FE state).
    void hold() { m_moving.clear(); }

    /// Where it is in an interval, out or in.
    void keep(Archive& archive);

    std::size_t present() const { return m_present; }
    std::size_t moving() const { return m_moving.size(); }

private:
    struct Group {
        ComponentId component{};
        std::vector<ElementIndex> elements;
        std::vector<std::uint32_t> nodes;   ///< of the present members, unique
        Vec3 centre = Vec3::Zero();         ///< m, mean of those nodes where the shape was made
        std::vector<ElementIndex> members;  ///< present in this interval
        std::optional<PieceId> piece;
        Pose pose;           ///< where the piece is
        Pose start, finish;  ///< of this interval
        Aabb box;            ///< of the members about that centre

        void keep(Archive& archive) { archive(component, elements, nodes, centre, members, piece, pose, start, finish, box); }
    };

    void makeGroups(const SimulationSettings& settings);
    void findNeighbours();
    bool exposed(ElementIndex e, std::size_t k) const;
    bool activeThrough(ElementIndex e, std::size_t k) const;
    std::optional<std::vector<ElementIndex>> newMembers(const Group& group, std::size_t k) const;
    /// Nodes, place and shape of what is left of a group; nothing if that makes no piece. Groups may be reshaped at once.
    std::optional<CollisionShape> reshape(Group& group, const FeState& from) const;
    void replace(RigidWorld& world, Group& group, const std::optional<CollisionShape>& shape);
    void rebuild(RigidWorld& world, Group& group, const FeState& from);
    /// @param nodes  m, of the mesh, where the shape is made
    CollisionShape shapeOf(const Group& group, const std::vector<Vec3>& nodes) const;
    CollisionShape bricksOf(const Group& group, const std::vector<Vec3>& nodes) const;
    using Parts = std::vector<std::vector<ElementIndex>>;
    Parts partsFor(std::span<const ElementIndex> members) const;
    void divide(std::size_t group, const Parts& parts);
    /// Where the piece goes with its nodes in an interval. Following their motion, not their shape at rest, its corners move no
    /// faster than they do, however they are deformed.
    static std::optional<Pose> follow(const Group& group, const FeState& from, const FeState& to);

    const FeResult& m_fe;
    const Components& m_components;
    const Activity& m_activity;
    PieceKind m_kind;
    bool m_bricks;         ///< grid boxes are made of joined bricks
    double m_finestBrick;  ///< m
    double m_leastHalfExtent;
    std::vector<Group> m_groups;
    std::vector<Group*> m_moving;
    std::vector<std::uint32_t> m_faceOffsets;  ///< first face of each element [elements + 1]; surface pieces only
    std::vector<std::int64_t> m_neighbour;     ///< element behind each face, -1 for none
    std::size_t m_present = 0;
    std::vector<bool> m_gone;  ///< [elements] taken out for good; empty: none
};

}  // namespace rubble
