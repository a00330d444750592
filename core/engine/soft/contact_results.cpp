#include "core/engine/soft/contact_results.h"

#include <algorithm>

#include "core/engine/world/constants.h"

namespace rubble {

void ContactResults::take(SoftSolver& solver, bool corrected, ContactReport& report) {
    m_outcomes.resize(solver.contacts.size());
    solver.takeBack(
        [&](std::uint32_t k, const ContactOutcome& c) { m_outcomes[k] = outcomeOf(solver, solver.contacts[k], c, corrected); });
    report.pairs = 0;
    report.points = 0;
    m_unloaded.clear();
    for (std::size_t k = 0; k < m_outcomes.size(); ++k) {
        const Outcome& outcome = m_outcomes[k];
        const SoftContact& contact = m_scene.contacts[solver.contacts[k].found];
        // Only now, for pushes were handed on from what was known before the step.
        if (outcome.pushOnA > noPush) {
            contact.a->loosePush = std::max(contact.a->loosePush, outcome.pushOnA);
        }
        if (outcome.pushOnB > noPush) {
            contact.b->loosePush = std::max(contact.b->loosePush, outcome.pushOnB);
        }
        report.pairs += outcome.points > 0;
        report.points += outcome.points;
        if (outcome.unloaded != nobody) {
            m_unloaded.push_back(outcome.unloaded);
        }
        if (outcome.work != 0.0) {
            (outcome.driven ? report.pieceWork : report.overlapWork) += outcome.work;
        }
    }
}

ContactResults::Outcome ContactResults::outcomeOf(const SoftSolver& solver, const SolverContact& of, const ContactOutcome& c,
                                                  bool corrected) const {
    SoftContact& contact = m_scene.contacts[of.found];
    contact.yield = m_assembly.yieldOf(of);
    Outcome outcome;
    const std::array<Vec3, 2> tangents = SolverAssembly::tangentsOf(contact.normal);
    double pushed = 0.0;  // N s along the normal, over the substeps
    for (std::uint32_t k = 0; k < of.points; ++k) {
        const PointImpulses& p = c.points[k];
        contact.points[k].impulse = p.normal;
        contact.points[k].push = p.push;
        contact.points[k].friction = p.tangent[0] * tangents[0] + p.tangent[1] * tangents[1];
        pushed += p.sum;
        outcome.points = outcome.points > 0 || p.largest > 0.0 ? of.points : 0;
    }
    if (outcome.points > 0) {
        m_assembly.noteSupport(of, contact.normal);
        outcome.pushOnA = loosePushBy(false, solver, of, c, contact);
        outcome.pushOnB = loosePushBy(true, solver, of, c, contact);
    }
    if (corrected) {
        contact.offset += pressedByCorrection(solver, of, contact);
    }
    contact.correctedFor += c.corrected ? m_assembly.substepLength() * m_assembly.substeps() : 0.0;
    contact.load += loadMemory * (loadOf(contact) - contact.load);
    if (const std::uint32_t still = m_scene.bodies.stillSlot; of.a == still || of.b == still) {
        outcome.unloaded = unloadedBy(contact);
    }
    outcome.work = c.driven || c.countsWork ? c.work : 0.0;
    outcome.driven = c.driven;
    if (c.driven) {
        accountForPiece(solver, of, contact, pushed);
    }
    return outcome;
}

/// J/kg, v^2 / 2 + g z with the speed of the fastest point of one side that pushes the other and the height of the other's centre,
/// or noPush if the first is neither loose nor was pushed by what is, or if the other is loose itself. What a turning span carries
/// along gets faster than by its fall, and hands that on, but not more.
double ContactResults::loosePushBy(bool sideA, const SoftSolver& solver, const SolverContact& of, const ContactOutcome& c,
                                   const SoftContact& contact) const {
    const Collider& pusher = sideA ? *contact.a : *contact.b;
    const Collider& pushed = sideA ? *contact.b : *contact.a;
    if (pushed.kind != ColliderKind::Body || pushed.loose || (!pusher.loose && pusher.loosePush == noPush)) {
        return noPush;
    }
    const SolverBody& body = solver.bodies[sideA ? of.a : of.b];
    const double gravity = m_scene.settings.gravity;
    const Vec3 centre = m_scene.bodies.of(pushed).pose.position;
    double most = noPush;
    for (std::uint32_t k = 0; k < of.points; ++k) {
        const PointImpulses& p = c.points[k];
        if (p.largest > 0.0) {
            // What lies on it goes as fast as it would at the centre of what lies there.
            const Vec3 arm = m_assembly.armOf(sideA, of, k);
            const Vec3 atCentre = arm + centre - contact.points[k].position;
            most = std::max({most, (body.velocity + body.spin.cross(arm)).squaredNorm(),
                             (body.velocity + body.spin.cross(atCentre)).squaredNorm()});
        }
    }
    if (most == noPush) {
        return noPush;
    }
    const double speed = 0.5 * most;
    // What was pushed itself hands on the speed that it may have where it is.
    const double height = m_scene.bodies.of(pusher).pose.position.z();
    const double own = pusher.loose ? speed : std::min(speed, pusher.loosePush - gravity * height);
    return std::max(own, 0.0) + gravity * centre.z();
}

Vec3 ContactResults::loadOf(const SoftContact& contact) const {
    Vec3 impulse = Vec3::Zero();
    for (const SoftContact::Point& point : std::span(contact.points).first(static_cast<std::size_t>(contact.count))) {
        impulse += point.impulse * contact.normal + point.friction;
    }
    return impulse / m_assembly.substepLength();
}

/// A frozen body was at rest under the loads of its contacts; it thaws when one of them is no longer what it was.
std::uint32_t ContactResults::unloadedBy(const SoftContact& contact) const {
    const bool a = m_scene.sleep.frozen(*contact.a);
    if (a == m_scene.sleep.frozen(*contact.b)) {
        return nobody;
    }
    const Collider& sleeper = a ? *contact.a : *contact.b;
    const double rest = contact.restLoad.norm();
    const double lost = rest > 0.0 ? rest - contact.load.dot(contact.restLoad) / rest : 0.0;
    const double weight = m_scene.settings.gravity / m_scene.bodies.of(sleeper).inverseMass;
    return lost > thawLoad * (weight + rest) ? sleeper.index : nobody;
}

/// m by which what came apart elsewhere has pressed these two together, by position only: overlap at birth that has moved here. It
/// comes apart like all of it; taken for a load, it would be fought by impulses. The ground does not take any: what is pressed into
/// it is pushed up again. Nor does less than jammingPush count: columns that only touch would stand and spread otherwise than
/// grains.
double ContactResults::pressedByCorrection(const SoftSolver& solver, const SolverContact& of, const SoftContact& contact) const {
    if (contact.a->kind == ColliderKind::Ground) {
        return 0.0;
    }
    const auto wayOf = [&](std::uint32_t slot, const Vec3& arm) {
        if (slot >= m_scene.bodies.awake.size()) {
            return Vec3(Vec3::Zero());
        }
        const SolverWay way = solver.correctionOf(slot);
        return Vec3(way.moved + way.turned.cross(arm));
    };
    double pressed = 0.0;
    for (std::uint32_t k = 0; k < of.points; ++k) {
        const double closed =
            contact.normal.dot(wayOf(of.a, m_assembly.armOf(true, of, k)) - wayOf(of.b, m_assembly.armOf(false, of, k)));
        pressed = std::max(pressed, closed - std::max(0.0, contact.points[k].separation));
    }
    return pressed > jammingPush ? pressed : 0.0;
}

void ContactResults::accountForPiece(const SoftSolver& solver, const SolverContact& of, SoftContact& contact, double pushed) const {
    double left = 0.0;  // m/s of closing speed
    for (std::uint32_t k = 0; k < of.points; ++k) {
        const SolverBody& a = solver.bodies[of.a];
        const SolverBody& b = solver.bodies[of.b];
        const Vec3 fromA = m_assembly.armOf(true, of, k), fromB = m_assembly.armOf(false, of, k);
        left = std::max(left, -contact.normal.dot(b.velocity + b.spin.cross(fromB) - a.velocity - a.spin.cross(fromA)));
    }
    m_scene.rests.accountForPiece(contact, pushed, m_assembly.pieceLimit(contact) * of.points * m_assembly.substeps(), left);
}

}  // namespace rubble
