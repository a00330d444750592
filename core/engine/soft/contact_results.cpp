#include "core/engine/soft/contact_results.h"

#include <algorithm>

#include "core/engine/world/constants.h"

namespace rubble {

namespace {

/// Bodies in a row through which a blow may go in a step.
constexpr int longestRow = 16;
/// Cosine between a push and the motion of what it acts on, from which on it drives that on.
constexpr double drivingCosine = 0.1;

}  // namespace

void ContactResults::take(SoftSolver& solver, bool corrected, ContactReport& report) {
    m_outcomes.resize(solver.contacts.size());
    solver.takeBack(
        [&](std::uint32_t k, const ContactOutcome& c) { m_outcomes[k] = outcomeOf(solver, solver.contacts[k], c, corrected); });
    report.pairs = 0;
    report.points = 0;
    m_unloaded.clear();
    for (std::size_t k = 0; k < m_outcomes.size(); ++k) {
        const Outcome& outcome = m_outcomes[k];
        report.pairs += outcome.points > 0;
        report.points += outcome.points;
        if (outcome.unloaded != nobody) {
            m_unloaded.push_back(outcome.unloaded);
        }
        if (outcome.work != 0.0) {
            (outcome.driven ? report.pieceWork : report.overlapWork) += outcome.work;
        }
    }
    handOn(solver);
}

/// A blow goes through a row of bodies within a step, so this is repeated until nothing changes. Strikes are in the order of the
/// contacts, which threads do not reach.
void ContactResults::handOn(const SoftSolver& solver) const {
    struct Strike {
        Collider* by;
        Collider* on;
        double point;  ///< J/kg, kinetic, of the point that strikes
        double body;   ///< J/kg, kinetic, of the body that it is of
    };
    std::vector<Strike> strikes;
    const auto note = [&](Collider& by, std::uint32_t slot, Collider& on, double point) {
        if (point > noPush) {
            const SolverBody& body = solver.bodies[slot];
            const Vec3 spin = m_scene.bodies.of(by).pose.orientation.conjugate() * body.spin;
            strikes.push_back({&by, &on, point, specificKineticEnergy(body.velocity, spin, by.inertia, by.mass)});
        }
    };
    for (std::size_t k = 0; k < m_outcomes.size(); ++k) {
        const SolverContact& of = solver.contacts[k];
        const SoftContact& contact = m_scene.contacts[of.found];
        note(*contact.b, of.b, *contact.a, m_outcomes[k].strikesA);
        note(*contact.a, of.a, *contact.b, m_outcomes[k].strikesB);
    }
    const auto height = [&](const Collider& c) { return m_scene.settings.gravity * m_scene.bodies.of(c).pose.position.z(); };
    bool changed = !strikes.empty();
    for (int round = 0; changed && round < longestRow; ++round) {
        changed = false;
        for (const Strike& strike : strikes) {
            // A turning body may have points that are faster than its fall allows. What a piece has pushed may have what that gave.
            const double allowed = strike.by->allowedEnergy() - height(*strike.by);
            const bool within = strike.by->pushed || strike.body <= allowed;
            const double handed = (within ? strike.point : std::clamp(allowed, 0.0, strike.point)) + height(*strike.on);
            if (handed > strike.on->allowedEnergy()) {
                strike.on->handedEnergy = handed;
                changed = true;
            }
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
        outcome.strikesA = strikes(false, solver, of, c, contact);
        outcome.strikesB = strikes(true, solver, of, c, contact);
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

/// J/kg, kinetic, of the fastest point of one side that pushes the other on, or noPush if the other may have that by what is known
/// yet. What neither pushes nor rubs it on, but against or across its motion, hands on nothing: so does what a turning span carries
/// along.
double ContactResults::strikes(bool byA, const SoftSolver& solver, const SolverContact& of, const ContactOutcome& c,
                               const SoftContact& contact) const {
    const Collider& pusher = byA ? *contact.a : *contact.b;
    const Collider& pushed = byA ? *contact.b : *contact.a;
    if (pusher.kind != ColliderKind::Body || pushed.kind != ColliderKind::Body) {
        return noPush;
    }
    const SolverBody& from = solver.bodies[byA ? of.a : of.b];
    const SolverBody& to = solver.bodies[byA ? of.b : of.a];
    const Vec3 centre = m_scene.bodies.of(pushed).pose.position;
    double most = 0.0;  // m2/s2
    for (std::uint32_t k = 0; k < of.points; ++k) {
        const PointImpulses& p = c.points[k];
        const SoftContact::Point& point = contact.points[k];
        const Vec3 velocity = (byA ? 1.0 : -1.0) * (to.velocity + to.spin.cross(m_assembly.armOf(!byA, of, k)));
        const double least = drivingCosine * velocity.norm();
        if (p.largest > 0.0 &&
            (contact.normal.dot(velocity) > least || point.friction.dot(velocity) > least * point.friction.norm())) {
            // What lies on it goes as fast as it would at the centre of what lies there.
            const Vec3 arm = m_assembly.armOf(byA, of, k);
            const Vec3 atCentre = arm + centre - point.position;
            most = std::max({most, (from.velocity + from.spin.cross(arm)).squaredNorm(),
                             (from.velocity + from.spin.cross(atCentre)).squaredNorm()});
        }
    }
    return 0.5 * most + m_scene.settings.gravity * centre.z() > pushed.allowedEnergy() ? 0.5 * most : noPush;
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
