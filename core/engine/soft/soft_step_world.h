#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "core/engine/soft/body_results.h"
#include "core/engine/soft/contact_book.h"
#include "core/engine/soft/contact_finder.h"
#include "core/engine/soft/contact_results.h"
#include "core/engine/soft/contact_search.h"
#include "core/engine/soft/hooked_bodies.h"
#include "core/engine/soft/pair_finder.h"
#include "core/engine/soft/rest_offsets.h"
#include "core/engine/soft/soft_bodies.h"
#include "core/engine/soft/soft_solver.h"
#include "core/engine/soft/solver_assembly.h"
#include "core/engine/world/rigid_state.h"
#include "core/engine/world/scene_world.h"
#include "core/engine/world/worker_pool.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// Soft contacts solved in small substeps. One step: boxes swept by the motion ahead, pairs, contacts once, then substeps of {the
/// caller's hook, gravity, one soft pass, move, three relaxation passes}, position correction, restitution, freeze and thaw. Of
/// Bullet only the geometry of hulls is used. Every contact has its place in an order of its own, so neither threads nor the
/// history of the search for pairs reach a result.
class SoftStepWorld : public SceneWorld {
public:
    explicit SoftStepWorld(const WorldSettings& settings);

    void setSubsteps(int substeps) override { m_settings.substeps = substeps; }
    void movePiece(PieceId piece, const Pose& atStepEnd) override;
    void onThreads(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work) const override;
    double mass(BodyId body) const override { return stateOf(body).mass(); }
    double kineticEnergy(BodyId body) const override { return stateOf(body).kineticEnergy(); }
    Momenta momenta(BodyId body) const override { return removed(body) ? Momenta{} : stateOf(body).momenta(); }
    bool keep(Archive& archive) override;

protected:
    void bodyEntered(Collider& collider, const NewBody& body) override;
    void pieceEntered(Collider& collider, const Pose& pose) override;
    void aboutToLeave() override;
    void left(Collider& collider) override;
    void thaw(Collider& body) override;
    BodyMotion motionOf(const Collider& body) const override;
    void advance(double dt) override;

private:
    AssemblyScene assembledScene() { return {m_settings, m_solids, m_sleep, m_contacts, m_rests, m_pool}; }
    RigidState stateOf(BodyId body) const { return m_solids.of(bodyAt(body)).state(bodyAt(body)); }
    void takeContacts(double dt);
    void substeps(double dt);
    void settle(double dt);
    void freeze(Collider& body);
    template <class Visit>
    void forEachTouching(Visit visit) const;
    template <class Visit>
    void forEachTouchingThawed(Visit visit) const;
    void shareSolveTime(double seconds);

    // mutable: a loop changes nothing of the world.
    mutable WorkerPool m_pool;
    SiteSurface m_surface;
    SoftBodies m_solids;
    PairFinder m_pairs;
    ContactFinder m_finder;
    ContactBook m_contacts;
    ContactSearch m_search;
    RestOffsets m_rests;
    SolverAssembly m_assembly;
    ContactResults m_results;
    BodyResults m_bodyResults;
    SoftSolver m_solver;
    HookedBodies m_hooked;
    bool m_corrected = false;      ///< bodies come apart by position in this step
    double m_takingSeconds = 0.0;  ///< s, of this step, for taking what was found
};

}  // namespace rubble
