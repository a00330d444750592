#pragma once

#include <memory>
#include <vector>

#include "core/engine/world/collider.h"
#include "core/engine/world/rigid_world.h"
#include "core/engine/world/sleep.h"

namespace rubble {

/// What is the same in every engine: bodies and pieces numbered in the order in which they enter, what leaves between two steps,
/// which bodies are frozen, and what contacts did. How they move is the engine's.
class SceneWorld : public RigidWorld {
public:
    BodyId addBody(const NewBody& body) override;
    void removeBody(BodyId body) override;
    PieceId addPiece(const CollisionShape& shape, const Pose& pose, Material material,
                     std::span<const std::uint32_t> nodes) override;
    void removePiece(PieceId piece) override;
    void onSubstep(SubstepHook hook) override { m_hook = std::move(hook); }
    void wake(BodyId body) override;
    void step(double dt) override;

    std::size_t bodyCount() const override { return m_bodies.size(); }
    BodyState state(BodyId body) const override;
    BodyMotion motion(BodyId body) const override;
    double smallestSide(BodyId body) const override { return m_bodies[at(body)]->smallestSide; }
    double lifted(BodyId body) const override { return m_bodies[at(body)]->lifted; }
    double penetration(BodyId body) const override { return removed(body) ? 0.0 : m_bodies[at(body)]->penetration; }
    double birthDepth(BodyId body) const override;
    double birthDepthApart(BodyId body) const override;
    double overlapLeft(BodyId body) const override { return removed(body) ? 0.0 : m_bodies[at(body)]->overlapLeft; }
    bool pushedByPiece(BodyId body) const override { return m_bodies[at(body)]->pushed; }
    double handedEnergy(BodyId body) const override { return m_bodies[at(body)]->handedEnergy; }
    const ContactReport& contacts() const override { return m_report; }
    const StepCosts& costs() const override { return m_costs; }

protected:
    using Colliders = std::vector<std::unique_ptr<Collider>>;

    explicit SceneWorld(const WorldSettings& settings);
    Collider& bodyAt(BodyId body) { return *m_bodies[at(body)]; }
    const Collider& bodyAt(BodyId body) const { return *m_bodies[at(body)]; }
    Collider& pieceAt(PieceId piece) { return *m_pieces[at(piece)]; }
    bool removed(BodyId body) const { return m_bodies[at(body)]->leaving; }
    /// What the engine needs of a collider, before it has a number.
    virtual std::unique_ptr<Collider> makeCollider() const { return std::make_unique<Collider>(); }
    /// It has a number and a shape; the engine puts it into its world.
    virtual void bodyEntered(Collider& collider, const NewBody& body) = 0;
    virtual void pieceEntered(Collider& collider, const Pose& pose) = 0;
    /// What is marked as leaving is about to leave.
    virtual void aboutToLeave() = 0;
    virtual void left(Collider& collider) = 0;
    virtual void thaw(Collider& body) = 0;
    /// Where a body is and how it moves, as the engine has it.
    virtual BodyMotion motionOf(const Collider& body) const = 0;
    virtual void advance(double dt) = 0;
    /// The piece stood still for a whole step.
    virtual void stoodStill(Collider&) {}
    /// All that it holds between two steps, out or in.
    void keepScene(Archive& archive);

    WorldSettings m_settings;
    double m_time = 0.0;  ///< s, of all steps so far
    StepCosts m_costs;
    ContactReport m_report;
    SubstepHook m_hook;
    Sleep m_sleep;
    Colliders m_bodies;
    Colliders m_pieces;

private:
    Collider& enter(Colliders& list, ColliderKind kind, const CollisionShape& shape, Material material);
    void leave(Collider& collider);
    void takeOut();
    void settlePieces();
    static void keepColliders(Archive& archive, Colliders& list, ColliderKind kind);

    std::vector<std::uint32_t> m_presentPieces;
    std::vector<Collider*> m_leaving;
    std::uint32_t m_nextNumber = 1;  ///< 0 is the ground's
};

}  // namespace rubble
