#pragma once

#include <vector>

#include "core/engine/world/rigid_world.h"
#include "core/simulation/health/outcomes.h"

namespace rubble::test {

/// A world that says what a test tells it: for the monitor, one number at a time.
class ScriptedWorld : public RigidWorld {
public:
    struct Body {
        BodyState state = BodyState::Awake;
        double side = 1.0;         ///< m
        double penetration = 0.0;  ///< m
        double lifted = 0.0;       ///< m
        bool pushed = false;
        double handedEnergy = noPush;  ///< J/kg
    };
    std::vector<Body> scripted;
    ContactReport report;

    BodyId addBody(const NewBody&) override { return {}; }
    void removeBody(BodyId body) override { scripted[at(body)].state = BodyState::Removed; }
    PieceId addPiece(const CollisionShape&, const Pose&, Material, std::span<const std::uint32_t>) override { return {}; }
    void removePiece(PieceId) override {}
    void movePiece(PieceId, const Pose&) override {}
    void onSubstep(SubstepHook) override {}
    void wake(BodyId) override {}
    void step(double) override {}
    std::size_t bodyCount() const override { return scripted.size(); }
    BodyState state(BodyId body) const override { return scripted[at(body)].state; }
    BodyMotion motion(BodyId) const override { return {}; }
    double mass(BodyId) const override { return 1.0; }
    double kineticEnergy(BodyId) const override { return 0.0; }
    Momenta momenta(BodyId) const override { return {}; }
    double smallestSide(BodyId body) const override { return scripted[at(body)].side; }
    double lifted(BodyId body) const override { return scripted[at(body)].lifted; }
    double penetration(BodyId body) const override { return scripted[at(body)].penetration; }
    double birthDepth(BodyId) const override { return 0.0; }
    double birthDepthApart(BodyId) const override { return 0.0; }
    double overlapLeft(BodyId) const override { return 0.0; }
    bool pushedByPiece(BodyId body) const override { return scripted[at(body)].pushed; }
    double handedEnergy(BodyId body) const override { return scripted[at(body)].handedEnergy; }
    const ContactReport& contacts() const override { return report; }
    const StepCosts& costs() const override { return m_costs; }

private:
    StepCosts m_costs;
};

}  // namespace rubble::test
