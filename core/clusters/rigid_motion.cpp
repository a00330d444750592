#include "core/clusters/rigid_motion.h"

#include <cassert>
#include <limits>

namespace rubble {

namespace {

constexpr double singular = 1e-12;  // relative to the trace: below it an axis has no inertia

/// I^-1 L, with zero about axes that have no inertia.
Vec3 angularVelocityOf(const Mat3& inertia, const Vec3& angularMomentum) {
    const double scale = inertia.trace();
    if (!(scale > 0.0)) {
        return Vec3::Zero();
    }
    const Eigen::LLT<Mat3> factor(inertia);
    if (factor.info() == Eigen::Success) {
        const double least = factor.matrixLLT().diagonal().minCoeff();
        if (least * least > singular * scale) {
            return factor.solve(angularMomentum);
        }
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(inertia);
    const Vec3 local = axes.eigenvectors().transpose() * angularMomentum;
    Vec3 spin = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        if (axes.eigenvalues()[k] > singular * scale) {
            spin += axes.eigenvectors().col(k) * (local[k] / axes.eigenvalues()[k]);
        }
    }
    return spin;
}

/// Inertia of a point of mass m at r.
Mat3 pointInertia(double m, const Vec3& r) {
    return m * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
}

}  // namespace

MovingMass joinRigidly(std::span<const MovingMass> all, std::span<const std::uint32_t> members) {
    assert(!members.empty());
    const MovingMass& first = all[members.front()];
    if (members.size() == 1) {
        return first;
    }
    MovingMass body;
    for (const std::uint32_t i : members) {
        body.mass += all[i].mass;
    }
    const double equalShare = body.mass > 0.0 ? 0.0 : 1.0;
    const double total = body.mass > 0.0 ? body.mass : static_cast<double>(members.size());
    // Sums of differences to the first member lose no digits to the distance from the origin.
    Vec3 offset = Vec3::Zero();
    Vec3 excess = Vec3::Zero();
    for (const std::uint32_t i : members) {
        const double share = all[i].mass + equalShare;
        offset += share * (all[i].centre - first.centre);
        excess += share * (all[i].velocity - first.velocity);
    }
    body.centre = first.centre + offset / total;
    body.velocity = first.velocity + excess / total;
    Vec3 angularMomentum = Vec3::Zero();
    for (const std::uint32_t i : members) {
        const MovingMass& member = all[i];
        const Vec3 r = member.centre - body.centre;
        body.inertia += member.inertia + pointInertia(member.mass, r);
        angularMomentum += member.inertia * member.angularVelocity + member.mass * r.cross(member.velocity - body.velocity);
    }
    body.angularVelocity = angularVelocityOf(body.inertia, angularMomentum);
    return body;
}

double velocityMisfit(const MovingMass& body, const MovingMass& member) {
    const Vec3 rigid = body.velocity + body.angularVelocity.cross(member.centre - body.centre);
    return (member.velocity - rigid).norm();
}

}  // namespace rubble
