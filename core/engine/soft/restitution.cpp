#include "core/engine/soft/restitution.h"

#include <algorithm>
#include <array>

namespace rubble {

namespace {

/// Rounds over the points of a contact that bounces.
constexpr int restitutionRounds = 8;

Vec3 relativeVelocity(const SolverBody& a, const SolverBody& b, const BouncePoint& p) {
    return b.velocity + b.spin.cross(p.fromB) - a.velocity - a.spin.cross(p.fromA);
}

void apply(SolverBody& a, SolverBody& b, const BouncePoint& p, const Vec3& impulse) {
    // Threads may share an immovable body, so nothing is written to it.
    if (a.inverseMass > 0.0) {
        a.velocity -= a.inverseMass * impulse;
        a.spin -= a.inverseInertia * p.fromA.cross(impulse);
    }
    if (b.inverseMass > 0.0) {
        b.velocity += b.inverseMass * impulse;
        b.spin += b.inverseInertia * p.fromB.cross(impulse);
    }
}

/// Impulses that a contact gives in restitution, besides those of the substeps: their friction is bounded by what they press with.
struct BounceFriction {
    double pressed = 0.0;       ///< N s along the normal
    Vec3 along = Vec3::Zero();  ///< N s across it
};

double inverseMassAlong(const SolverBody& body, const Vec3& arm, const Vec3& direction) {
    const Vec3 swing = arm.cross(direction);
    return body.inverseMass + swing.dot(body.inverseInertia * swing);
}

/// Coulomb friction of what a bounce presses with: it acts against what slides, at most up to where it sticks.
void rub(const ContactConstraint& c, const BouncePoint& p, BounceFriction& bounce, SolverBody& a, SolverBody& b) {
    const Vec3 relative = relativeVelocity(a, b, p);
    const Vec3 sliding = relative - c.normal.dot(relative) * c.normal;
    const double speed = sliding.norm();
    if (!(speed > 0.0)) {
        return;
    }
    const Vec3 direction = sliding / speed;
    const double inverse = inverseMassAlong(a, p.fromA, direction) + inverseMassAlong(b, p.fromB, direction);
    const double limit = c.friction * std::max(0.0, bounce.pressed);
    Vec3 wanted = bounce.along - speed / inverse * direction;
    if (const double length = wanted.norm(); length > limit) {
        wanted *= limit / length;
    }
    apply(a, b, p, wanted - bounce.along);
    bounce.along = wanted;
}

}  // namespace

void restituteContact(const ContactConstraint& c, std::span<BouncePoint> points, SolverBody& a, SolverBody& b, double threshold,
                      bool friction) {
    std::array<BounceFriction, 4> bounces;
    // The points of one face share a blow; a few rounds find their shares.
    for (int round = 0; round < restitutionRounds; ++round) {
        for (std::size_t k = 0; k < points.size(); ++k) {
            BouncePoint& p = points[k];
            if (p.approachSpeed < threshold || p.impulses.largest == 0.0) {
                continue;
            }
            const double speed = c.normal.dot(relativeVelocity(a, b, p));
            // Over the whole step a contact never pulls.
            const double change = std::max(-p.normalMass * (speed - c.restitution * p.approachSpeed), -p.impulses.sum);
            // What a limit left of a moving piece's approach is not made up for here.
            if (c.driven && change > 0.0) {
                continue;
            }
            p.impulses.sum += change;
            p.impulses.normal = std::max(0.0, p.impulses.normal + change);
            apply(a, b, p, change * c.normal);
            if (friction) {
                bounces[k].pressed += change;
                rub(c, p, bounces[k], a, b);
            }
        }
    }
}

}  // namespace rubble
