#pragma once

#include <memory>

#include "core/engine/world/rigid_world.h"

namespace rubble {

/// A world that hands everything on to a real one; who derives from it changes or watches what matters to them.
class ForwardingWorld : public RigidWorld {
public:
    explicit ForwardingWorld(std::unique_ptr<RigidWorld> world) : m_world(std::move(world)) {}

    BodyId addBody(const NewBody& body) override { return m_world->addBody(body); }
    void removeBody(BodyId body) override { m_world->removeBody(body); }
    PieceId addPiece(const CollisionShape& shape, const Pose& pose, Material material,
                     std::span<const std::uint32_t> nodes) override {
        return m_world->addPiece(shape, pose, material, nodes);
    }
    void removePiece(PieceId piece) override { m_world->removePiece(piece); }
    void movePiece(PieceId piece, const Pose& atStepEnd) override { m_world->movePiece(piece, atStepEnd); }
    void onSubstep(SubstepHook hook) override { m_world->onSubstep(std::move(hook)); }
    void wake(BodyId body) override { m_world->wake(body); }
    void setSubsteps(int substeps) override { m_world->setSubsteps(substeps); }
    void step(double dt) override { m_world->step(dt); }
    void onThreads(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work) const override {
        m_world->onThreads(count, grain, work);
    }
    std::size_t bodyCount() const override { return m_world->bodyCount(); }
    BodyState state(BodyId body) const override { return m_world->state(body); }
    BodyMotion motion(BodyId body) const override { return m_world->motion(body); }
    double mass(BodyId body) const override { return m_world->mass(body); }
    double kineticEnergy(BodyId body) const override { return m_world->kineticEnergy(body); }
    Momenta momenta(BodyId body) const override { return m_world->momenta(body); }
    double smallestSide(BodyId body) const override { return m_world->smallestSide(body); }
    double lifted(BodyId body) const override { return m_world->lifted(body); }
    double penetration(BodyId body) const override { return m_world->penetration(body); }
    double birthDepth(BodyId body) const override { return m_world->birthDepth(body); }
    double birthDepthApart(BodyId body) const override { return m_world->birthDepthApart(body); }
    double overlapLeft(BodyId body) const override { return m_world->overlapLeft(body); }
    bool pushedByPiece(BodyId body) const override { return m_world->pushedByPiece(body); }
    double handedEnergy(BodyId body) const override { return m_world->handedEnergy(body); }
    const ContactReport& contacts() const override { return m_world->contacts(); }
    const StepCosts& costs() const override { return m_world->costs(); }

protected:
    RigidWorld& world() { return *m_world; }
    const RigidWorld& world() const { return *m_world; }

private:
    std::unique_ptr<RigidWorld> m_world;
};

}  // namespace rubble
