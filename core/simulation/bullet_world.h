#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <span>
#include <vector>

#include "core/simulation/fragment_world.h"
#include "core/simulation/rigid_world.h"

namespace rubble {

/// Bodies, pieces and ground in a Bullet world, whichever way that steps.
class BulletWorld : public RigidWorld {
public:
    ~BulletWorld() override;

    BodyId addBody(const NewBody& body) override;
    void removeBody(BodyId body) override;
    PieceId addPiece(const CollisionShape& shape, const Pose& pose, Material material) override;
    void removePiece(PieceId piece) override;
    void movePiece(PieceId piece, const Pose& atStepEnd) override;
    void step(double dt) override;
    const StepCosts& costs() const override { return m_costs; }

    std::size_t bodyCount() const override { return m_bodies.size(); }
    BodyMotion motion(BodyId body) const override;
    double mass(BodyId body) const override { return m_bodies[at(body)]->object->getMass(); }
    double kineticEnergy(BodyId body) const override;
    Momenta momenta(BodyId body) const override;
    double smallestSide(BodyId body) const override { return m_bodies[at(body)]->smallestSide; }
    double lifted(BodyId body) const override { return m_bodies[at(body)]->lifted; }
    double penetration(BodyId body) const override { return removed(body) ? 0.0 : m_bodies[at(body)]->penetration; }
    double birthDepth(BodyId body) const override;
    double overlapLeft(BodyId body) const override { return removed(body) ? 0.0 : m_bodies[at(body)]->overlapLeft; }
    bool pushedByPiece(BodyId body) const override { return m_bodies[at(body)]->pushed; }

protected:
    explicit BulletWorld(const WorldSettings& settings);
    /// Takes over the Bullet world and puts the ground in.
    /// @param holdsObjects  the Bullet world holds ground, bodies and pieces; one with a ground and a search for pairs of its own
    ///                      does without
    void begin(std::unique_ptr<btDiscreteDynamicsWorld> world, bool holdsObjects = true);
    Collider& bodyAt(BodyId body) { return *m_bodies[at(body)]; }
    bool removed(BodyId body) const { return m_bodies[at(body)]->leaving; }
    btDispatcher* dispatcher() { return &m_dispatcher; }
    btBroadphaseInterface* broadphase() { return &m_broadphase; }
    btCollisionConfiguration* configuration() { return &m_configuration; }

    /// A body has entered the Bullet world.
    virtual void entered(Collider&) {}
    virtual void pieceEntered(Collider&) {}
    /// Marked objects are about to leave the Bullet world.
    virtual void aboutToLeave() {}
    virtual void left(Collider&) {}
    /// Bodies and pieces, out or in, for a Bullet world that does not hold them.
    void keepColliders(Archive& archive);
    std::span<const std::unique_ptr<Collider>> bodies() const { return m_bodies; }
    std::span<const std::unique_ptr<Collider>> pieces() const { return m_pieces; }
    StepCosts m_costs;

private:
    using Colliders = std::vector<std::unique_ptr<Collider>>;
    Collider& makeCollider(Colliders& list, ColliderKind kind, const CollisionShape& shape);
    void furnish(Collider& collider);
    static void embody(Collider& collider, const btTransform& place);
    void insert(Collider& collider);
    void keepColliders(Archive& archive, Colliders& list, ColliderKind kind);
    void keepObject(Archive& archive, Collider& collider);
    void addGround();
    void takeOut();
    void settlePieces();

    WorldSettings m_settings;
    btDefaultCollisionConfiguration m_configuration;
    FragmentDispatcher m_dispatcher;
    btDbvtBroadphase m_broadphase;
    std::unique_ptr<btDiscreteDynamicsWorld> m_world;
    bool m_holdsObjects = true;
    Colliders m_ground;
    Colliders m_bodies;
    Colliders m_pieces;
    std::vector<std::uint32_t> m_presentPieces;
    std::vector<Collider*> m_leaving;
    std::uint32_t m_nextNumber = 1;  ///< 0 is the ground's
};

}  // namespace rubble
