#include "core/engine/soft/contact_results.h"

#include <algorithm>

#include "core/engine/world/constants.h"

namespace rubble {

void ContactResults::take(SoftSolver& solver, bool corrected, ContactReport& report) {
    m_outcomes.resize(solver.contacts.size());
    solver.takeBack({.take = [&](std::uint32_t k) { m_outcomes[k] = outcomeOf(solver, solver.contacts[k], corrected); },
                     .prefetch = [&](std::uint32_t k) { m_assembly.prefetchFor(solver.contacts[k]); }});
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

ContactResults::Outcome ContactResults::outcomeOf(const SoftSolver& solver, const SolverContact& c, bool corrected) const {
    SoftContact& contact = m_scene.contacts[c.found];
    contact.yield = m_assembly.yieldOf(c);
    Outcome outcome;
    double pushed = 0.0;  // N s along the normal, over the substeps
    for (std::uint32_t k = 0; k < c.points; ++k) {
        const SolverPoint& p = solver.points[c.firstPoint + k];
        contact.points[k].impulse = p.normalImpulse;
        contact.points[k].push = p.push;
        contact.points[k].friction = p.tangentImpulse[0] * c.tangent[0] + p.tangentImpulse[1] * c.tangent[1];
        pushed += p.impulseSum;
        outcome.points = outcome.points > 0 || p.largestImpulse > 0.0 ? c.points : 0;
    }
    if (outcome.points > 0) {
        m_assembly.noteSupport(c);
        outcome.pushOnA = loosePushBy(false, solver, c, contact);
        outcome.pushOnB = loosePushBy(true, solver, c, contact);
    }
    if (corrected) {
        contact.offset += pressedByCorrection(solver, c, contact);
    }
    contact.correctedFor += c.correction > 0.0 ? m_assembly.substepLength() * m_assembly.substeps() : 0.0;
    contact.load += loadMemory * (loadOf(contact) - contact.load);
    if (const std::uint32_t still = m_scene.bodies.stillSlot; c.a == still || c.b == still) {
        outcome.unloaded = unloadedBy(contact);
    }
    outcome.work = c.driven || c.countsWork ? c.work : 0.0;
    outcome.driven = c.driven;
    if (c.driven) {
        accountForPiece(solver, c, contact, pushed);
    }
    return outcome;
}

/// J/kg, v^2 / 2 + g z with the speed of the fastest point of one side that pushes the other and the height of the other's centre,
/// or noPush if the first is neither loose nor was pushed by what is, or if the other is loose itself. What a turning span carries
/// along gets faster than by its fall, and hands that on, but not more.
double ContactResults::loosePushBy(bool sideA, const SoftSolver& solver, const SolverContact& c, const SoftContact& contact) const {
    const Collider& pusher = sideA ? *contact.a : *contact.b;
    const Collider& pushed = sideA ? *contact.b : *contact.a;
    if (pushed.kind != ColliderKind::Body || pushed.loose || (!pusher.loose && pusher.loosePush == noPush)) {
        return noPush;
    }
    const SolverBody& body = solver.bodies[sideA ? c.a : c.b];
    const double gravity = m_scene.settings.gravity;
    const Vec3 centre = m_scene.bodies.of(pushed).pose.position;
    double most = noPush;
    for (std::uint32_t k = 0; k < c.points; ++k) {
        const SolverPoint& p = solver.points[c.firstPoint + k];
        if (p.largestImpulse > 0.0) {
            // What lies on it goes as fast as it would at the centre of what lies there.
            const Vec3 arm = sideA ? p.fromA : p.fromB;
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
double ContactResults::pressedByCorrection(const SoftSolver& solver, const SolverContact& c, const SoftContact& contact) const {
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
    for (std::uint32_t k = 0; k < c.points; ++k) {
        const SolverPoint& p = solver.points[c.firstPoint + k];
        const double closed = c.normal.dot(wayOf(c.a, p.fromA) - wayOf(c.b, p.fromB));
        pressed = std::max(pressed, closed - std::max(0.0, contact.points[k].separation));
    }
    return pressed > jammingPush ? pressed : 0.0;
}

void ContactResults::accountForPiece(const SoftSolver& solver, const SolverContact& c, SoftContact& contact, double pushed) const {
    double left = 0.0;  // m/s of closing speed
    for (std::uint32_t k = 0; k < c.points; ++k) {
        const SolverPoint& p = solver.points[c.firstPoint + k];
        const SolverBody& a = solver.bodies[c.a];
        const SolverBody& b = solver.bodies[c.b];
        left = std::max(left, -c.normal.dot(b.velocity + b.spin.cross(p.fromB) - a.velocity - a.spin.cross(p.fromA)));
    }
    m_scene.rests.accountForPiece(contact, pushed, c.impulseLimit * c.points * m_assembly.substeps(), left);
}

}  // namespace rubble
