#include "core/engine/soft/body_results.h"

#include <algorithm>
#include <numeric>

#include "core/engine/world/constants.h"
#include "core/engine/world/scene_rules.h"

namespace rubble {

namespace {

Quat turnedBy(const Quat& q, const Vec3& turn) {
    const Vec3 half = 0.5 * turn;
    return (Quat(1.0, half.x(), half.y(), half.z()) * q).normalized();
}

}  // namespace

void BodyResults::take(SoftSolver& solver, bool corrected, double dt, ContactReport& report) {
    std::vector<double> lifting(m_scene.bodies.awake.size());  // J
    m_scene.pool.loop(m_scene.bodies.awake.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            SoftBody& body = m_scene.bodies.bodies[m_scene.bodies.awake[i]];
            const SolverBody& moved = solver.bodies[i];
            body.pose = solver.poseOf(i);
            body.velocity = moved.velocity;
            body.spin = moved.spin;
            body.active = moved.active;
            body.supported = m_assembly.supported(i);
            lifting[i] = (corrected ? correct(solver, i, dt) : 0.0) + keepAboveGround(body, dt);
        }
    });
    report.overlapWork = std::accumulate(lifting.begin(), lifting.end(), report.overlapWork);
    m_scene.pool.loop(m_scene.bodies.moving.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            SoftBody& piece = m_scene.bodies.pieces[m_scene.bodies.moving[i]];
            piece.pose = m_scene.bodies.goals[m_scene.bodies.moving[i]];
            m_finder.place(piece);
        }
    });
}

/// Moves and turns what lies in others from birth or is jammed in them, without a change of its speed. Returns the work [J] that it
/// took.
double BodyResults::correct(SoftSolver& solver, std::size_t slot, double dt) const {
    SoftBody& body = m_scene.bodies.bodies[m_scene.bodies.awake[slot]];
    auto [way, turned] = solver.correctionOf(slot);
    const double length = way.norm() + turned.norm() * body.collider->radius;
    const double most = correctionReach * m_scene.settings.overlapSpeed * dt;
    if (length > most) {
        way *= most / length;
        turned *= most / length;
    }
    body.pose.position += way;
    body.collider->lifted += way.z();
    body.pose.orientation = turnedBy(body.pose.orientation, turned);
    solver.bodies[slot].moved += way;
    solver.bodies[slot].turned += turned;
    return m_scene.settings.gravity * way.z() / body.inverseMass;
}

/// Returns the work [J] that it took.
double BodyResults::keepAboveGround(SoftBody& body, double dt) const {
    Collider& collider = *body.collider;
    const double sunk = m_surface.depth(body.pose.position);
    collider.bornBelow = sunk > 0.0 && (collider.bornBelow || collider.newborn);
    if (sunk <= 0.0) {
        return 0.0;
    }
    const GroundRise rise = riseAboveGround(m_surface, body.pose.position, collider.bornBelow, dt);
    body.pose.position += rise.share * rise.way;
    body.velocity -= std::min(0.0, body.velocity.dot(rise.normal)) * rise.normal;
    return m_scene.settings.gravity * rise.share * rise.way.z() / body.inverseMass;
}

}  // namespace rubble
