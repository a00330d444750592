#include "core/simulation/effects/effect_run.h"

#include "core/base/archive.h"
#include "core/simulation/effects/air_drag.h"
#include "core/simulation/effects/fragment_contact.h"
#include "core/simulation/effects/ground_plane.h"
#include "core/simulation/effects/stopwatch.h"
#include "core/simulation/effects/terrain.h"
#include "core/simulation/effects/ties.h"
#include "core/simulation/effects/water.h"

namespace rubble {

void setUpWorld(const EffectDecisions& decisions, const RunDescription& description, WorldSettings& world) {
    world.ground = false;
    world.bodyContacts = false;
    if (isOn(decisions, EffectKind::Ground)) {
        setUpGroundPlane(description.scenario, world);
    }
    if (isOn(decisions, EffectKind::Terrain)) {
        setUpTerrain(description.terrain, description.scenario, world);
    }
    if (isOn(decisions, EffectKind::FragmentContact)) {
        setUpFragmentContact(world);
    }
}

EffectRun::EffectRun(const EffectDecisions& decisions, const RunDescription& description, RigidWorld& world) : m_world(world) {
    makeEffects(decisions, description);
    for (const Timed& timed : m_effects) {
        if (timed.inSubsteps) {
            m_world.onSubstep([this](const SubstepBodies& bodies, double h) { beforeSubstep(bodies, h); });
            break;
        }
    }
}

void EffectRun::makeEffects(const EffectDecisions& decisions, const RunDescription& description) {
    const Scenario& scenario = description.scenario;
    if (isOn(decisions, EffectKind::AirDrag)) {
        m_effects.push_back({std::make_unique<AirDrag>(scenario.effects), 0.0, 0.0, true});
    }
    if (isOn(decisions, EffectKind::Ties)) {
        m_effects.push_back({std::make_unique<Ties>(description, m_world), 0.0, 0.0, true});
    }
    // Water acts after the others: what they did is load to it, as contact is.
    if (isOn(decisions, EffectKind::Water)) {
        m_effects.push_back({std::make_unique<Water>(scenario.effects, scenario.simulation.gravity), 0.0, 0.0, true});
    }
    if (isOn(decisions, EffectKind::BreakUp)) {
        auto breakUp = std::make_unique<BreakUp>(description);
        m_breakUp = breakUp.get();
        m_effects.push_back({std::move(breakUp), 0.0, 0.0, false});
    }
}

void EffectRun::beforeSubstep(const SubstepBodies& bodies, double h) {
    if (m_breakUp != nullptr) {
        const Stopwatch watch(m_effects.back().substepSeconds);
        m_before.clear();
        for (const MovingBody& body : bodies.moving) {
            m_before.push_back(body.velocity);
        }
    }
    for (Timed& timed : m_effects) {
        if (timed.inSubsteps) {
            const Stopwatch watch(timed.substepSeconds);
            timed.effect->beforeSubstep(bodies, h);
        }
    }
    if (m_breakUp != nullptr) {
        const Stopwatch watch(m_effects.back().substepSeconds);
        for (std::size_t i = 0; i < m_before.size(); ++i) {
            m_breakUp->excuse(bodies.moving[i].id, bodies.moving[i].velocity - m_before[i]);
        }
    }
}

void EffectRun::entered(std::span<const BodyRecord> bodies) {
    for (Timed& timed : m_effects) {
        timed.effect->entered(bodies, m_world);
    }
}

void EffectRun::leaving(BodyId body) {
    for (Timed& timed : m_effects) {
        timed.effect->leaving(body);
    }
}

void EffectRun::stepped(double dt) {
    for (Timed& timed : m_effects) {
        const Stopwatch watch(timed.seconds);
        timed.effect->afterStep(m_world, dt);
    }
}

std::vector<BodyRecord> EffectRun::brokenUp(double dt, std::int64_t room) {
    if (m_breakUp == nullptr) {
        return {};
    }
    const Stopwatch watch(m_effects.back().seconds);
    return m_breakUp->brokenBy(m_world, dt, room);
}

void EffectRun::keep(Archive& archive) {
    for (Timed& timed : m_effects) {
        archive(timed.seconds, timed.substepSeconds);
        timed.effect->keep(archive);
    }
}

double EffectRun::work() const {
    double work = 0.0;
    for (const Timed& timed : m_effects) {
        work += timed.effect->work();
    }
    return work;
}

double EffectRun::secondsOf(const EffectDecisions& decisions, EffectKind kind, const EffectTimes& times) const {
    const StepCosts& costs = m_world.costs();
    switch (kind) {
        case EffectKind::Ground:
            // Terrain takes the place of level ground.
            return isOn(decisions, EffectKind::Terrain) ? 0.0 : costs.groundContact;
        case EffectKind::Terrain:
            return costs.groundContact;
        case EffectKind::StructureContact:
            return costs.structureContact + times.structureSeconds;
        case EffectKind::FragmentContact:
            return costs.fragmentContact;
        default:
            break;
    }
    for (const Timed& timed : m_effects) {
        if (timed.effect->kind() == kind) {
            const double replacing = kind == EffectKind::BreakUp ? times.breakUpSeconds : 0.0;
            return timed.seconds + timed.substepSeconds + replacing;
        }
    }
    return 0.0;
}

double EffectRun::secondsInSubsteps() const {
    double seconds = 0.0;
    for (const Timed& timed : m_effects) {
        seconds += timed.substepSeconds;
    }
    return seconds;
}

std::vector<EffectReport> EffectRun::reports(const EffectDecisions& decisions, const EffectTimes& times) const {
    std::vector<EffectReport> reports;
    for (const EffectDecision& decision : decisions) {
        EffectReport report;
        report.decision = decision;
        if (decision.on && times.steps > 0) {
            const double seconds = secondsOf(decisions, decision.kind, times);
            report.msPerStep = 1000.0 * seconds / static_cast<double>(times.steps);
            report.share = times.seconds > 0.0 ? seconds / times.seconds : 0.0;
        }
        for (const Timed& timed : m_effects) {
            if (timed.effect->kind() == decision.kind) {
                report.work = timed.effect->work();
                report.events = timed.effect->events();
            }
        }
        reports.push_back(report);
    }
    return reports;
}

}  // namespace rubble
