#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "core/engine/bullet/fragment_solver.h"
#include "core/engine/world/birth_overlap.h"
#include "core/engine/world/bullet_collider.h"
#include "core/engine/world/rigid_world.h"
#include "core/engine/world/scene_rules.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// Bullet's world with what a collapse needs: births that keep their overlap as rest offset, pieces that give way,
/// freezing per body, a fall without the error of the stock integrator, spin about a conserved angular momentum. Contacts are
/// solved in the order of the colliders' numbers, all in one group, so that no memory address reaches a result.
class FragmentWorld : public btDiscreteDynamicsWorld {
public:
    /// What it shares with the world that it steps for.
    struct Scene {
        Sleep& sleep;
        ContactReport& report;
        const SubstepHook& hook;
    };
    FragmentWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, FragmentSolver* solver,
                  btCollisionConfiguration* configuration, const WorldSettings& settings, const Scene& scene);

    /// A body that was added to the world, in the order of bodies.
    void addBody(BulletCollider& body) { m_bodies.push_back(&body); }
    void forget(std::uint32_t body) { m_bodies[body] = nullptr; }
    void thaw(BulletCollider& body);
    /// Thaws the frozen bodies that touch what is marked as leaving.
    void thawNeighboursOfLeaving();

protected:
    void calculateSimulationIslands() override {}
    void createPredictiveContacts(btScalar) override {}
    void solveConstraints(btContactSolverInfo& info) override;
    void integrateTransforms(btScalar dt) override;
    void updateActivationState(btScalar dt) override;

private:
    struct Contact {
        ColliderPair pair = 0;
        btPersistentManifold* manifold = nullptr;
        BulletCollider* a = nullptr;
        BulletCollider* b = nullptr;
        double depth = 0.0;     ///< m, of the deepest point
        int deepest = 0;        ///< its index
        double offset = 0.0;    ///< m
        double approach = 0.0;  ///< m/s, of a moving piece towards its body
        bool pressing = false;  ///< it strikes from above or from the side
        bool yielding = false;  ///< its piece has given way and goes on into the body
    };
    struct Stock {
        double distance = 0.0;
        double restitution = 0.0;
        double impulse = 0.0;  ///< N s, of the step before
        double opening = 0.0;  ///< m/s, of overlapping points before the solve
        double bias = 0.0;     ///< m/s at which the solver wants to open them
    };

    void collectContacts();
    void wakeByContacts();
    void offsetContacts(double dt);
    void dropInertPoints(Contact& contact, double dt);
    void limitPiece(Contact& contact, double dt);
    void restoreContacts(double dt);
    void accumulateWork();
    void bleedOverlaps(double dt);
    void runHook(double dt);
    void freeze(BulletCollider& body);
    bool awake(const Collider& c) const { return m_sleep.awake(c); }
    template <class Visit>
    void forEachTouching(Visit visit) const;

    WorldSettings m_settings;
    SiteSurface m_surface;
    BirthOverlaps m_overlaps;
    Sleep& m_sleep;
    ContactReport& m_report;
    const SubstepHook& m_hook;
    std::vector<BulletCollider*> m_bodies;  ///< [bodies]; null once removed
    std::vector<Contact> m_contacts;
    std::vector<Stock> m_stock;
    std::vector<btCollisionObject*> m_solved;
    std::vector<btPersistentManifold*> m_manifolds;
    std::vector<double> m_heights;  ///< m, of the solved bodies before the solve
    std::vector<MovingBody> m_moving;
    std::vector<std::int32_t> m_slotOf;
};

}  // namespace rubble
