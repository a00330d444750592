#pragma once

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <btBulletDynamicsCommon.h>

namespace rubble {

/// Bullet's sequential impulses with an upper limit to the impulse of a contact point, which the stock solver has no place for.
class FragmentSolver : public btSequentialImpulseConstraintSolver {
public:
    /// Limits the normal impulse of a contact point in the next solve, N s.
    static void limit(btManifoldPoint& point, double impulse);
    static void unlimit(btManifoldPoint& point);
    static bool limited(const btManifoldPoint& point);
    /// The limit was reached in the latest solve.
    static bool atLimit(const btManifoldPoint& point);

protected:
    void convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) override;
};

}  // namespace rubble
