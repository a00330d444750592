#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/base/prefetch.h"
#include "core/simulation/constants.h"
#include "core/simulation/height_order.h"
#include "core/simulation/soft_step_world.h"

namespace rubble {

namespace {

/// Raises a number that threads share to at least this; in which order they come does not matter.
void raise(double& number, double least) {
    std::atomic_ref<double> shared(number);
    double now = shared.load(std::memory_order_relaxed);
    while (now < least && !shared.compare_exchange_weak(now, least, std::memory_order_relaxed)) {
    }
}

}  // namespace

void SoftStepWorld::restPair(std::size_t first, std::size_t last, double dt) {
    Collider& a = *m_contacts[first].a;
    Collider& b = *m_contacts[first].b;
    for (std::size_t i = first; i < last; ++i) {
        SoftContact& contact = m_contacts[i];
        if (a.newborn || b.newborn) {
            contact.offset = contact.depth > touchingDepth ? contact.depth : 0.0;
            contact.yielded = contact.offset > 0.0;
        }
        if (contact.fresh && contact.depth > contactMargin) {
            // Nothing comes into being deep: what lies deeper than the way of one step was there, under another part's name.
            contact.offset = std::max(contact.offset, contact.depth - marginOf(a.number, b.number, dt));
        }
        for (auto [born, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
            const bool older = other->kind == ColliderKind::Piece || (other->kind == ColliderKind::Body && !other->newborn);
            if (born->newborn && older) {
                raise(born->birthDepth, contact.depth);
            }
        }
    }
    const bool bodies = a.kind == ColliderKind::Body && b.kind == ColliderKind::Body;
    limitPiece(first, last);
    for (std::size_t i = first; i < last; ++i) {
        SoftContact& contact = m_contacts[i];
        giveWayToJam(contact, dt);
        if (contact.offset > 0.0) {
            std::atomic_ref(a.overlapping).store(true, std::memory_order_relaxed);
            std::atomic_ref(b.overlapping).store(true, std::memory_order_relaxed);
        }
        for (Collider* side : {&a, &b}) {
            if (bodies && awake(*side)) {
                raise(side->overlapLeft, contact.offset);
            }
        }
        // How deep a piece sweeps into what may not resist it is how far it went, not what the solver let through.
        const bool swept = contact.pressed > 0.0 && (a.moving || b.moving);
        if (!contact.yielding && !swept) {
            const double depth = contact.depth - contact.offset;
            raise(m_report.penetrationMax, depth);
            for (Collider* side : {&a, &b}) {
                if (awake(*side)) {
                    raise(side->penetration, depth);
                }
            }
        }
    }
}

/// A body that a piece and something else hold between them cannot get out of both: after a while the piece gives way, since the FE
/// analysis never felt the body.
void SoftStepWorld::giveWayToJam(SoftContact& contact, double dt) {
    const bool piece = contact.a->kind == ColliderKind::Piece || contact.b->kind == ColliderKind::Piece;
    contact.jammedFor = piece && !contact.fresh && contact.depth - contact.offset > jamDepth ? contact.jammedFor + dt : 0.0;
    if (contact.jammedFor > jamTime) {
        contact.jammedFor = 0.0;
        contact.offset = contact.depth;
        if (!std::exchange(contact.yielded, true)) {
            std::atomic_ref(m_report.piecesYielded).fetch_add(1, std::memory_order_relaxed);
        }
    }
}

void SoftStepWorld::limitPiece(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        SoftContact& contact = m_contacts[i];
        contact.yielding = contact.pressing = false;
        contact.approach = 0.0;
        const bool pieceIsA = contact.a->kind == ColliderKind::Piece;
        const Collider& piece = pieceIsA ? *contact.a : *contact.b;
        const Collider& body = pieceIsA ? *contact.b : *contact.a;
        if (piece.kind != ColliderKind::Piece || !piece.moving) {
            continue;
        }
        const Solid& p = solidOf(piece);
        const Solid& q = solidOf(body);
        for (std::size_t k = 0; k < static_cast<std::size_t>(contact.count); ++k) {
            const Vec3& where = contact.points[k].position;
            const Vec3 relative =
                p.velocity + p.spin.cross(where - p.pose.position) - q.velocity - q.spin.cross(where - q.pose.position);
            contact.approach = std::max(contact.approach, (pieceIsA ? 1.0 : -1.0) * contact.normal.dot(relative));
        }
        const double up = (pieceIsA ? 1.0 : -1.0) * contact.normal.z();
        const bool closing = contact.approach > pieceYieldSpeed;
        contact.yielding = contact.yielded && closing;
        contact.pressing = closing && up < carryingNormal;
        if (contact.yielding) {
            contact.offset = std::max(contact.offset, contact.depth);
        }
    }
}

void SoftStepWorld::takeBodies() {
    m_solver.bodies.resize(m_stillSlot + 1);
    m_supported.assign(m_stillSlot + 1, 0);
    m_supported[m_stillSlot] = 1;
    m_supportedNow.assign(m_stillSlot + 1, 0);
    m_sides.resize(m_stillSlot);
    m_inverse.assign(m_stillSlot + 1, 0.0);
    m_reach.assign(m_stillSlot + 1, 0.0);
    m_pool.loop(m_awake.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            Solid& solid = m_bodies[m_awake[i]];
            const Mat3 axes = solid.pose.orientation.toRotationMatrix();
            SolverBody body;
            body.velocity = solid.velocity;
            body.spin = solid.spin;
            body.inverseMass = solid.inverseMass;
            body.inverseInertia = axes * solid.inertia.cwiseInverse().asDiagonal() * axes.transpose();
            body.pose = solid.pose;
            body.inertia = solid.inertia;
            body.radius = solid.collider->radius;
            m_solver.bodies[i] = body;
            m_sides[i] = sideOf(*solid.collider);
            m_inverse[i] = body.inverseMass;
            m_reach[i] = speedOf(solid);
            m_supported[i] = solid.supported;
        }
    });
    for (std::size_t i = 0; i < m_moving.size(); ++i) {
        SolverBody body;
        body.velocity = m_pieces[m_moving[i]].velocity;
        body.spin = m_pieces[m_moving[i]].spin;
        m_solver.bodies[m_awake.size() + i] = body;
        m_sides[m_awake.size() + i] = sideOf(*m_pieces[m_moving[i]].collider);
        m_reach[m_awake.size() + i] = speedOf(m_pieces[m_moving[i]]);
    }
    m_solver.bodies[m_stillSlot] = {};
}

SoftStepWorld::Side SoftStepWorld::sideOf(const Collider& collider) const {
    Side side;
    side.thickness = thicknessOf(collider);
    side.material = collider.material;
    side.swelling = collider.kind == ColliderKind::Body && collider.overlapping;
    if (collider.kind != ColliderKind::Ground) {
        const Solid& solid = solidOf(collider);
        side.centre = solid.pose.position;
        side.inverseMass = awake(collider) ? solid.inverseMass : 0.0;
    }
    return side;
}

/// @param still  room for what has no slot of its own
const SoftStepWorld::Side& SoftStepWorld::sideOf(std::uint32_t slot, const Collider& collider, Side& still) const {
    return slot != m_stillSlot ? m_sides[slot] : still = sideOf(collider);
}

SoftStepWorld::Kind SoftStepWorld::kindOf(const SoftContact& contact) {
    const bool piece = contact.a->kind == ColliderKind::Piece || contact.b->kind == ColliderKind::Piece;
    return contact.a->kind == ColliderKind::Ground ? Ground : piece ? Structure : Fragments;
}

bool SoftStepWorld::idle(const SoftContact& contact) {
    const auto points = std::span(contact.points).first(static_cast<std::size_t>(contact.count));
    return contact.offset == 0.0 &&
           std::ranges::all_of(points, [](const SoftContact::Point& p) { return p.impulse == 0.0 && p.push == 0.0; });
}

/// A contact on its way to the solver, which other contacts of its body hear of.
SoftStepWorld::Taken SoftStepWorld::taken(std::size_t i) {
    const SoftContact& contact = m_contacts[i];
    const auto slotOf = [&](const Collider& c) {
        const std::int32_t slot = c.kind == ColliderKind::Ground ? -1 : solidOf(c).slot;
        return slot < 0 ? m_stillSlot : static_cast<std::uint32_t>(slot);
    };
    const bool pieceIsA = contact.a->kind == ColliderKind::Piece;
    const Collider& piece = pieceIsA ? *contact.a : *contact.b;
    const bool driven = piece.kind == ColliderKind::Piece && piece.moving && !contact.yielding;
    if (driven && (contact.depth > -contactMargin || contact.approach > 0.0)) {
        std::atomic_ref(solidOf(pieceIsA ? *contact.b : *contact.a).drivers).fetch_add(1, std::memory_order_relaxed);
    }
    const double up = contact.normal.z();
    const Vec3& where = contact.points[0].position;
    return {heightKey(where.z()),
            static_cast<float>(where.x()),
            static_cast<float>(where.y()),
            static_cast<std::uint32_t>(i),
            slotOf(*contact.a),
            slotOf(*contact.b),
            static_cast<std::uint8_t>(contact.yielding ? 0 : contact.count),
            static_cast<std::uint8_t>(kindOf(contact)),
            std::abs(up) <= supportingNormal ? Support::None
            : up > 0.0                       ? Support::ByA
                                             : Support::ByB,
            idle(contact)};
}

/// From the ground up, so that one pass carries the support of the lower contacts to the upper ones.
void SoftStepWorld::buildSolver(double h) {
    takeBodies();
    std::erase_if(m_taken, [&](const Taken& x) { return x.points == 0 || (x.a >= m_awake.size() && x.b >= m_awake.size()); });
    sortByHeight(m_taken);
    const std::vector<Taken>& taken = m_taken;
    limitMassRatios();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends(taken.size());
    std::transform(taken.begin(), taken.end(), ends.begin(), [](const Taken& x) { return std::pair{x.a, x.b}; });
    ContactColours colours;
    colourContacts(ends, m_awake.size(), colours);
    m_solver.firstOfGroup = colours.first;
    m_solver.lastInOrder = colours.lastInOrder;
    m_points.fill(0.0);
    m_ends.resize(taken.size());
    std::vector<std::uint32_t> firstPoint(taken.size() + 1, 0);
    for (std::size_t k = 0; k < taken.size(); ++k) {
        const Taken& from = taken[colours.order[k]];
        firstPoint[k + 1] = firstPoint[k] + from.points;
        m_points[from.kind] += from.points;
        m_ends[k] = {from.a, from.b};
    }
    m_solver.resize(taken.size(), firstPoint.back());
    m_pool.loop(taken.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const Taken& from = taken[colours.order[k]];
            SolverContact& c = m_solver.contacts[k];
            c = {};
            c.a = from.a;
            c.b = from.b;
            c.firstPoint = firstPoint[k];
            c.points = from.points;
            c.x = from.x;
            c.y = from.y;
            c.found = from.contact;
            c.idle = from.idle;
        }
    });
    const double frequency = std::min(contactFrequency, 0.25 / h);
    m_solver.begin(m_awake.size());
    m_solver.layOut(h, {.fill =
                            [&](std::uint32_t k) {
                                SolverContact& c = m_solver.contacts[k];
                                fillContact(m_contacts[c.found], c, frequency, h);
                            },
                        .prefetch = [&](std::uint32_t k) { prefetchFor(m_solver.contacts[k]); }});
}

/// m by which the two are brought apart by position only in this step: overlap at birth, or what others have jammed.
double SoftStepWorld::correctionOf(const SoftContact& contact, double thickness, double dt) const {
    // Every pair has its time for it, so that a pile comes to rest with what it cannot get rid of.
    const double overlap = contact.correctedFor < m_settings.overlapTime ? contact.offset : 0.0;
    // Only where overlap at birth pushes bodies about; elsewhere contacts alone decide how deep they carry.
    const auto points = std::span(contact.points).first(static_cast<std::size_t>(contact.count));
    double push = 0.0;
    for (const SoftContact::Point& point : points) {
        push = std::max(push, point.push);
    }
    const auto lightness = [&](const Collider& x) { return x.kind == ColliderKind::Body ? solidOf(x).inverseMass : 0.0; };
    const bool pushed = push > 0.0 && push > jammingPush / std::max(lightness(*contact.a), lightness(*contact.b));
    const double jammed = contact.depth - contact.offset - jammedDepth * thickness;
    return std::clamp(pushed ? std::max(overlap, jammed) : overlap, 0.0, m_settings.overlapSpeed * dt);
}

void SoftStepWorld::fillContact(const SoftContact& contact, SolverContact& c, double frequency, double h) {
    Side stillA, stillB;
    const Side& a = sideOf(c.a, *contact.a, stillA);
    const Side& b = sideOf(c.b, *contact.b, stillB);
    const PairProperties& pair = m_settings.pairs.of(a.material, b.material);
    const auto moves = [&](std::uint32_t slot) { return slot >= m_awake.size() && slot != m_stillSlot; };
    const bool pieceIsA = moves(c.a);
    c.normal = contact.normal;
    c.friction = pair.friction;
    c.driven = pieceIsA || moves(c.b);
    // What is limited or still overlaps does not bounce.
    c.restitution = contact.offset > 0.0 || c.driven ? 0.0 : pair.restitution;
    // What a body in overlap does to others, overlap does.
    c.countsWork = !c.driven && (contact.offset > 0.0 || a.swelling || b.swelling);
    c.impulseLimit = -1.0;
    const double thickness = std::min(a.thickness, b.thickness);
    c.correction = c.driven ? 0.0 : correctionOf(contact, thickness, h * m_substeps);
    const bool immovable = c.a >= m_awake.size() || c.b >= m_awake.size();
    c.lift = immovable ? (c.a >= m_awake.size() ? 1.0 : -1.0) * m_settings.gravity * h : 0.0;
    c.frequency = immovable ? 2.0 * frequency : frequency;
    c.sinkAllowed = sinkAllowed(thickness);
    c.weight = m_settings.gravity * h / std::max(a.inverseMass, b.inverseMass);
    if (c.driven) {
        const double mass = 1.0 / solidOf(pieceIsA ? *contact.b : *contact.a).inverseMass;
        const double dt = h * m_substeps;
        const bool carrying = (pieceIsA ? 1.0 : -1.0) * contact.normal.z() >= carryingNormal;
        const double speed = contact.pressing ? std::max(0.0, piecePressSpeed - contact.pressed)
                             : carrying       ? softCarryFactor * contact.approach + carryAcceleration * dt
                                              : contact.approach + nudgeAcceleration * dt;
        // Several pieces of one structure share what they may do to a body.
        const int pieces = solidOf(pieceIsA ? *contact.b : *contact.a).drivers;
        c.impulseLimit = mass * speed / (contact.count * (carrying ? 1 : m_substeps * std::max(1, pieces)));
    }
    // What a body carried while it counted as heavier must not hit it when it no longer does.
    const double yielded = std::min(1.0, contact.yield / std::min(a.yield, b.yield));
    const double carried = (m_substepLength > 0.0 ? h / m_substepLength : 1.0) * yielded;
    // Any direction off the normal will do for the first tangent, as long as it depends on the normal alone.
    const Vec3& n = c.normal;
    const Vec3 off = std::abs(n.x()) < 0.57735 ? Vec3(0.0, n.z(), -n.y()) : Vec3(n.y(), -n.x(), 0.0);
    c.tangent[0] = off / std::sqrt(off.squaredNorm());
    c.tangent[1] = n.cross(c.tangent[0]);
    for (std::uint32_t k = 0; k < c.points; ++k) {
        const SoftContact::Point& point = contact.points[k];
        SolverPoint p;
        p.fromA = point.position - a.centre;
        p.fromB = point.position - b.centre;
        p.separation = point.separation + contact.offset;
        p.normalImpulse = c.impulseLimit < 0.0 ? carried * point.impulse : std::min(carried * point.impulse, c.impulseLimit);
        p.push = yielded * point.push;
        p.tangentImpulse[0] = carried * c.tangent[0].dot(point.friction);
        p.tangentImpulse[1] = carried * c.tangent[1].dot(point.friction);
        m_solver.points[c.firstPoint + k] = p;
    }
}

/// A light body that stands on something cannot be pressed away by a heavy one above it; passes over pairs alone would take as many
/// rounds as the ratio of the masses to find that out. It counts as heavier, from the top of a stack down, and in all its contacts
/// alike: were it heavy in one and light in another, their impulses would outgrow each other.
void SoftStepWorld::limitMassRatios() {
    for (auto entry = m_taken.rbegin(); entry != m_taken.rend(); ++entry) {
        if (entry->a >= m_awake.size() || entry->b >= m_awake.size() || entry->support == Support::None) {
            continue;
        }
        const std::uint32_t below = entry->support == Support::ByA ? entry->a : entry->b;
        const double share = mostMassRatio * m_inverse[entry->a + entry->b - below] / m_inverse[below];
        // One that moves would hand on more momentum than it has.
        if (share < 1.0 && m_supported[below] != 0 && m_reach[below] <= standingSpeed) {
            SolverBody& body = m_solver.bodies[below];
            body.inverseMass *= share;
            body.inverseInertia *= share;
            m_sides[below].yield *= share;
            m_inverse[below] = m_sides[below].inverseMass = body.inverseMass;
        }
    }
}

double SoftStepWorld::yieldOf(const SolverContact& c) const {
    const auto of = [&](std::uint32_t slot) { return slot < m_awake.size() ? m_sides[slot].yield : 1.0; };
    return std::min(of(c.a), of(c.b));
}

void SoftStepWorld::noteSupport(const SolverContact& c) {
    const double up = c.normal.z();
    if (std::abs(up) < supportingNormal) {
        return;
    }
    const std::uint32_t below = up > 0.0 ? c.a : c.b;
    const std::uint32_t above = up > 0.0 ? c.b : c.a;
    if (m_supported[below] != 0) {
        std::atomic_ref(m_supportedNow[above]).store(1, std::memory_order_relaxed);
    }
}

Vec3 SoftStepWorld::loadOf(const SoftContact& contact) const {
    Vec3 impulse = Vec3::Zero();
    for (const SoftContact::Point& point : std::span(contact.points).first(static_cast<std::size_t>(contact.count))) {
        impulse += point.impulse * contact.normal + point.friction;
    }
    return impulse / m_substepLength;
}

/// A frozen body was at rest under the loads of its contacts; it thaws when one of them is no longer what it was.
bool SoftStepWorld::unloads(const SoftContact& contact) const {
    const bool a = contact.a->kind == ColliderKind::Body && !awake(*contact.a);
    const bool b = contact.b->kind == ColliderKind::Body && !awake(*contact.b);
    if (a == b) {
        return false;
    }
    const Solid& sleeper = solidOf(a ? *contact.a : *contact.b);
    const double rest = contact.restLoad.norm();
    const double lost = rest > 0.0 ? rest - contact.load.dot(contact.restLoad) / rest : 0.0;
    return lost > thawLoad * (m_settings.gravity / sleeper.inverseMass + rest);
}

/// m by which what came apart elsewhere has pressed these two together, by position only: overlap at birth that has moved here. It
/// comes apart like all of it; taken for a load, it would be fought by impulses. The ground does not take any: what is pressed into
/// it is pushed up again. Nor does less than jammingPush count: columns that only touch would stand and spread otherwise than
/// grains.
double SoftStepWorld::pressedByCorrection(const SolverContact& c, const SoftContact& contact) const {
    if (contact.a->kind == ColliderKind::Ground) {
        return 0.0;
    }
    const auto wayOf = [&](std::uint32_t slot, const Vec3& arm) {
        if (slot >= m_awake.size()) {
            return Vec3(Vec3::Zero());
        }
        const SolverWay way = m_solver.correctionOf(slot);
        return Vec3(way.moved + way.turned.cross(arm));
    };
    double pressed = 0.0;
    for (std::uint32_t k = 0; k < c.points; ++k) {
        const SolverPoint& p = m_solver.points[c.firstPoint + k];
        const double closed = c.normal.dot(wayOf(c.a, p.fromA) - wayOf(c.b, p.fromB));
        pressed = std::max(pressed, closed - std::max(0.0, contact.points[k].separation));
    }
    return pressed > jammingPush ? pressed : 0.0;
}

void SoftStepWorld::takeResult(const SolverContact& c, Outcome& outcome) {
    SoftContact& contact = m_contacts[c.found];
    contact.yield = yieldOf(c);
    outcome = {};
    double pushed = 0.0;  // N s along the normal, over the substeps
    for (std::uint32_t k = 0; k < c.points; ++k) {
        const SolverPoint& p = m_solver.points[c.firstPoint + k];
        contact.points[k].impulse = p.normalImpulse;
        contact.points[k].push = p.push;
        contact.points[k].friction = p.tangentImpulse[0] * c.tangent[0] + p.tangentImpulse[1] * c.tangent[1];
        pushed += p.impulseSum;
        outcome.points = outcome.points > 0 || p.largestImpulse > 0.0 ? c.points : 0;
    }
    if (outcome.points > 0) {
        noteSupport(c);
    }
    if (m_correcting) {
        contact.offset += pressedByCorrection(c, contact);
    }
    contact.correctedFor += c.correction > 0.0 ? m_substepLength * m_substeps : 0.0;
    contact.load += loadMemory * (loadOf(contact) - contact.load);
    if ((c.a == m_stillSlot || c.b == m_stillSlot) && unloads(contact)) {
        const bool sleeperIsA = contact.a->kind == ColliderKind::Body && !awake(*contact.a);
        outcome.unloaded = (sleeperIsA ? contact.a : contact.b)->index;
    }
    outcome.work = c.driven || c.countsWork ? c.work : 0.0;
    outcome.driven = c.driven;
    if (c.driven) {
        accountForPiece(contact, c, pushed);
    }
}

/// Takes in what the contacts have become. Sums are made in their order.
void SoftStepWorld::takeResults() {
    m_outcomes.resize(m_solver.contacts.size());
    m_solver.takeBack({.take = [&](std::uint32_t k) { takeResult(m_solver.contacts[k], m_outcomes[k]); },
                       .prefetch = [&](std::uint32_t k) { prefetchFor(m_solver.contacts[k]); }});
    m_report.pairs = 0;
    m_report.points = 0;
    for (const Outcome& outcome : m_outcomes) {
        m_report.pairs += outcome.points > 0;
        m_report.points += outcome.points;
        if (outcome.unloaded != nobody) {
            m_unloaded.push_back(outcome.unloaded);
        }
        if (outcome.work != 0.0) {
            (outcome.driven ? m_report.pieceWork : m_report.overlapWork) += outcome.work;
        }
    }
}

void SoftStepWorld::accountForPiece(SoftContact& contact, const SolverContact& c, double pushed) {
    const bool pieceIsA = contact.a->kind == ColliderKind::Piece;
    Collider& body = pieceIsA ? *contact.b : *contact.a;
    if (pushed <= 0.0) {
        contact.pushes = 0;
        return;
    }
    std::atomic_ref(body.pushed).store(true, std::memory_order_relaxed);
    if (contact.approach <= pieceYieldSpeed) {
        // Pressing as hard as it may and still coming deeper: it has given way, however slowly.
        const double most = c.impulseLimit * c.points * m_substeps;
        const bool carrying = (pieceIsA ? 1.0 : -1.0) * contact.normal.z() >= carryingNormal;
        if (!carrying && pushed > 0.5 * most) {
            contact.offset = std::max(contact.offset, contact.depth);
        }
        return;
    }
    bool gaveWay = false;
    if (contact.pressing) {
        contact.pressed += pushed * solidOf(body).inverseMass;
        gaveWay = contact.pressed >= 0.99 * piecePressSpeed;
    } else {
        double left = 0.0;
        for (std::uint32_t k = 0; k < c.points; ++k) {
            const SolverPoint& p = m_solver.points[c.firstPoint + k];
            const SolverBody& a = m_solver.bodies[c.a];
            const SolverBody& b = m_solver.bodies[c.b];
            left = std::max(left, -c.normal.dot(b.velocity + b.spin.cross(p.fromB) - a.velocity - a.spin.cross(p.fromA)));
        }
        contact.pushes = left > 0.5 * contact.approach ? contact.pushes + 1 : 0;
        gaveWay = contact.pushes >= piecePushes;
    }
    if (gaveWay && !contact.yielded) {
        contact.yielded = true;
        std::atomic_ref(m_report.piecesYielded).fetch_add(1, std::memory_order_relaxed);
    }
    if (gaveWay) {
        contact.offset = std::max(contact.offset, contact.depth);
    }
}

/// No body gets faster in a step than what it touches, directly or through others, could make it: a light body between heavy ones
/// keeps what is left over where their passes have not converged, and would be shot out.
void SoftStepWorld::boundSpeeds(double dt) {
    const std::size_t movable = m_awake.size();
    std::vector<double>& reach = m_reach;
    const std::vector<double>& inverse = m_inverse;
    const auto hand = [&](std::uint32_t from, std::uint32_t to) {
        if (to < movable) {
            // Of a blow in the middle, two masses m and M: at most 2 M / (m + M) of the speed.
            const double share = std::min(1.0, 2.0 * inverse[to] / (inverse[to] + inverse[from]));
            reach[to] = std::max(reach[to], share * reach[from]);
        }
    };
    const auto spread = [&](const SlotPair& ends) {
        hand(ends.first, ends.second);
        hand(ends.second, ends.first);
    };
    for (int sweep = 0; sweep < 2; ++sweep) {
        std::for_each(m_ends.begin(), m_ends.end(), spread);
        std::for_each(m_ends.rbegin(), m_ends.rend(), spread);
    }
    std::vector<double> struck(movable, 0.0);  // what is far lighter than what it meets
    for (std::size_t k = 0; k < m_ends.size(); ++k) {
        const auto [a, b] = m_ends[k];
        for (const auto& [to, from] : {SlotPair{a, b}, SlotPair{b, a}}) {
            if (to < movable && from != m_stillSlot && inverse[to] > mostMassRatio * inverse[from]) {
                // Seen from what strikes it, it leaves no faster than it came.
                const Vec3& strikes = m_solver.bodies[from].velocity;
                const double own = strikes.norm();
                struck[to] = std::max(struck[to], own + (m_solver.bodies[to].velocity - strikes).norm() +
                                                      (1.0 + m_solver.contacts[k].restitution) * std::max(0.0, reach[from] - own));
            }
        }
    }
    for (std::size_t i = 0; i < movable; ++i) {
        m_solver.bound(i, (struck[i] > 0.0 ? struck[i] : 2.0 * reach[i]) + pushOutSpeed + 2.0 * m_settings.gravity * dt);
    }
}

/// After the substeps, which hold back what is too fast by themselves.
void SoftStepWorld::holdBack(SolverBody& body) {
    if (!body.active) {
        return;
    }
    const double speed = body.velocity.norm();
    const double turning = body.spin.norm() * body.radius;
    if (speed > body.fastest) {
        body.velocity *= body.fastest / speed;
    }
    if (turning > body.fastest) {
        body.spin *= body.fastest / turning;
    }
    if (speed > body.fastest || turning > body.fastest) {
        std::atomic_ref(m_report.speedLimits).fetch_add(1, std::memory_order_relaxed);
    }
}

void SoftStepWorld::shareSolveTime(double seconds) {
    const double all = m_points[Ground] + m_points[Structure] + m_points[Fragments];
    if (all > 0.0) {
        m_costs.groundContact += seconds * m_points[Ground] / all;
        m_costs.structureContact += seconds * m_points[Structure] / all;
        m_costs.fragmentContact += seconds * m_points[Fragments] / all;
        m_costs.motion -= seconds;
    }
}

}  // namespace rubble
