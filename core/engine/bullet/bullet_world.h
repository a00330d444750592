#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>

#include "core/engine/world/bullet_collider.h"
#include "core/engine/world/scene_world.h"

namespace rubble {

/// Bodies, pieces and ground in a world that Bullet steps.
class BulletWorld : public SceneWorld {
public:
    ~BulletWorld() override;

    void movePiece(PieceId piece, const Pose& atStepEnd) override;
    double mass(BodyId body) const override { return objectOf(bodyAt(body)).getMass(); }
    double kineticEnergy(BodyId body) const override;
    Momenta momenta(BodyId body) const override;

protected:
    explicit BulletWorld(const WorldSettings& settings);
    /// Takes over the Bullet world and puts the ground in.
    void begin(std::unique_ptr<btDiscreteDynamicsWorld> world);
    btDispatcher* dispatcher() { return &m_dispatcher; }
    btBroadphaseInterface* broadphase() { return &m_broadphase; }
    btCollisionConfiguration* configuration() { return &m_configuration; }
    static btRigidBody& objectOf(const Collider& collider) { return *bulletCollider(collider).object; }

    std::unique_ptr<Collider> makeCollider() const override { return std::make_unique<BulletCollider>(); }
    void bodyEntered(Collider& collider, const NewBody& body) override;
    void pieceEntered(Collider& collider, const Pose& pose) override;
    void aboutToLeave() override {}
    void left(Collider& collider) override;
    void stoodStill(Collider& piece) override;
    BodyMotion motionOf(const Collider& body) const override;
    void advance(double dt) override;

private:
    static void embody(BulletCollider& collider, const Pose& place);
    void insert(BulletCollider& collider, int group, int partners);
    void addGround();

    btDefaultCollisionConfiguration m_configuration;
    FragmentDispatcher m_dispatcher;
    btDbvtBroadphase m_broadphase;
    std::unique_ptr<btDiscreteDynamicsWorld> m_world;
    std::unique_ptr<BulletCollider> m_ground;
};

}  // namespace rubble
