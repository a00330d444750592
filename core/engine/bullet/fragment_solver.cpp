#include "core/engine/bullet/fragment_solver.h"

#include <algorithm>

namespace rubble {

namespace {

/// A flag bit that Bullet does not use; the limit travels in the field for contact stiffness, which no body here has.
constexpr int limitedFlag = 1 << 20;

/// One row between its limits: the stock row for contacts knows only the lower one.
btScalar solveRow(btSolverBody& a, btSolverBody& b, const btSolverConstraint& row) {
    const btScalar speed = row.m_contactNormal1.dot(a.internalGetDeltaLinearVelocity()) +
                           row.m_relpos1CrossNormal.dot(a.internalGetDeltaAngularVelocity()) +
                           row.m_contactNormal2.dot(b.internalGetDeltaLinearVelocity()) +
                           row.m_relpos2CrossNormal.dot(b.internalGetDeltaAngularVelocity());
    const btScalar before = row.m_appliedImpulse;
    const btScalar wanted = before + row.m_rhs - before * row.m_cfm - speed * row.m_jacDiagABInv;
    const btScalar impulse = std::clamp(wanted, row.m_lowerLimit, row.m_upperLimit);
    const btScalar change = impulse - before;
    row.m_appliedImpulse = impulse;
    a.internalApplyImpulse(row.m_contactNormal1 * a.internalGetInvMass(), row.m_angularComponentA, change);
    b.internalApplyImpulse(row.m_contactNormal2 * b.internalGetInvMass(), row.m_angularComponentB, change);
    return change / row.m_jacDiagABInv;
}

}  // namespace

void FragmentSolver::limit(btManifoldPoint& point, double impulse) {
    point.m_contactPointFlags |= limitedFlag;
    point.m_combinedContactStiffness1 = impulse;
}

void FragmentSolver::unlimit(btManifoldPoint& point) {
    point.m_contactPointFlags &= ~limitedFlag;
    point.m_combinedContactStiffness1 = 0.0;
}

bool FragmentSolver::limited(const btManifoldPoint& point) {
    return (point.m_contactPointFlags & limitedFlag) != 0;
}

bool FragmentSolver::atLimit(const btManifoldPoint& point) {
    return limited(point) && point.m_appliedImpulse >= 0.999 * point.m_combinedContactStiffness1;
}

void FragmentSolver::convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) {
    // The stock set-up puts its own row solvers back whenever the solver mode changes.
    setConstraintRowSolverLowerLimit(solveRow);
    setConstraintRowSolverGeneric(solveRow);
    btSequentialImpulseConstraintSolver::convertContacts(manifolds, count, info);
    for (int i = 0; i < m_tmpSolverContactConstraintPool.size(); ++i) {
        btSolverConstraint& row = m_tmpSolverContactConstraintPool[i];
        const auto* point = static_cast<const btManifoldPoint*>(row.m_originalContactPoint);
        if (limited(*point)) {
            row.m_upperLimit = point->m_combinedContactStiffness1;
        }
    }
}

}  // namespace rubble
