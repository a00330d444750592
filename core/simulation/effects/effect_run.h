#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/simulation/effects/break_up.h"
#include "core/simulation/effects/decisions.h"
#include "core/simulation/effects/effect.h"

namespace rubble {

inline bool isOn(const EffectDecisions& decisions, EffectKind kind) {
    return decisions[static_cast<std::size_t>(kind)].on;
}

/// Sets a world up for the effects that are on; leaves out the others.
void setUpWorld(const EffectDecisions& decisions, const RunDescription& description, WorldSettings& world);

/// Wall time of the steps of a run, as far as effects have to know.
struct EffectTimes {
    std::int64_t steps = 0;
    double seconds = 0.0;           ///< of all steps
    double structureSeconds = 0.0;  ///< of these, what the pieces took outside the world
    double breakUpSeconds = 0.0;    ///< of these, what putting fragments in the place of clusters took
};

/// The effects that act on bodies while a run goes on: makes those that are on and no others, calls them, and keeps the account of
/// their time, work and events.
class EffectRun {
public:
    /// Hooks into the substeps only if an effect acts there. The arguments must outlive this object.
    EffectRun(const EffectDecisions& decisions, const RunDescription& description, RigidWorld& world);
    EffectRun(const EffectRun&) = delete;
    EffectRun& operator=(const EffectRun&) = delete;

    void entered(std::span<const BodyRecord> bodies);
    void leaving(BodyId body);
    /// A step of dt [s] has ended.
    void stepped(double dt);

    /// Clusters that fall apart for what the step of dt [s] that has just ended did to them.
    /// @param room  bodies that may come on top of those present
    std::vector<BodyRecord> brokenUp(double dt, std::int64_t room);
    /// One of them was replaced, or had to be left whole.
    void replaced(bool done) { done ? m_breakUp->broken() : m_breakUp->hold(); }
    /// Clusters that were hit hard enough and left whole.
    std::int64_t heldTogether() const { return m_breakUp != nullptr ? m_breakUp->held() : 0; }

    /// What the effects carry from step to step, out or in.
    void keep(Archive& archive);

    /// J, done on bodies by all effects so far; the work of contacts is the world's.
    double work() const;
    /// s of wall time that effects took before substeps.
    double secondsInSubsteps() const;
    /// Every effect, in the order of EffectKind; contact costs what the world says.
    std::vector<EffectReport> reports(const EffectDecisions& decisions, const EffectTimes& times) const;

private:
    struct Timed {
        std::unique_ptr<Effect> effect;
        double seconds = 0.0;         ///< after steps
        double substepSeconds = 0.0;  ///< before substeps
        bool inSubsteps = false;
    };
    void makeEffects(const EffectDecisions& decisions, const RunDescription& description);
    void beforeSubstep(const SubstepBodies& bodies, double h);
    double secondsOf(const EffectDecisions& decisions, EffectKind kind, const EffectTimes& times) const;

    RigidWorld& m_world;
    std::vector<Timed> m_effects;  ///< in the order in which they act
    BreakUp* m_breakUp = nullptr;  ///< one of the effects
    std::vector<Vec3> m_before;    ///< m/s, of the moving bodies before the effects
};

}  // namespace rubble
