#include "core/engine/soft/solver_assembly.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>

#include "core/base/prefetch.h"
#include "core/engine/world/constants.h"

namespace rubble {

namespace {

/// A number that is the larger the higher, as bits.
std::uint64_t heightKey(double height) {
    const auto bits = std::bit_cast<std::uint64_t>(height + 0.0);  // no negative zero
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// Sorts by height, digit by digit from the last one on; what is equally high keeps its order.
template <class Entry>
void sortByHeight(std::vector<Entry>& entries) {
    constexpr unsigned digitBits = 11, digits = 6;
    constexpr std::uint64_t mask = (1u << digitBits) - 1;
    std::vector<std::array<std::uint32_t, mask + 1>> counts(digits);
    for (const Entry& entry : entries) {
        for (unsigned d = 0; d < digits; ++d) {
            ++counts[d][entry.height >> (d * digitBits) & mask];
        }
    }
    std::vector<Entry> sorted(entries.size());
    for (unsigned d = 0; d < digits && !entries.empty(); ++d) {
        const auto digitOf = [&](const Entry& entry) { return entry.height >> (d * digitBits) & mask; };
        if (counts[d][digitOf(entries[0])] == entries.size()) {
            continue;
        }
        std::exclusive_scan(counts[d].begin(), counts[d].end(), counts[d].begin(), 0u);
        for (const Entry& entry : entries) {
            sorted[counts[d][digitOf(entry)]++] = entry;
        }
        entries.swap(sorted);
    }
}

ContactKind kindOf(const SoftContact& contact) {
    if (contact.a->kind == ColliderKind::Ground) {
        return ContactKind::Ground;
    }
    return contact.piece().kind == ColliderKind::Piece ? ContactKind::Structure : ContactKind::Fragments;
}

/// It carried nothing in the step before and does not overlap.
bool isIdle(const SoftContact& contact) {
    const auto points = std::span(contact.points).first(static_cast<std::size_t>(contact.count));
    return contact.offset == 0.0 &&
           std::ranges::all_of(points, [](const SoftContact::Point& p) { return p.impulse == 0.0 && p.push == 0.0; });
}

double thicknessOf(const Collider& c) {
    return c.kind == ColliderKind::Body ? c.smallestSide : std::numeric_limits<double>::infinity();
}

/// m, for the thinner of the two.
double sinkAllowedOf(double thickness) {
    return std::max(1e-5, sinkShare * thickness);
}

}  // namespace

void SolverAssembly::begin(std::size_t contacts) {
    m_taken.resize(contacts);
    m_thinLoads.resize(contacts);
}

void SolverAssembly::take(std::size_t contact) {
    m_taken[contact] = taken(contact);
    m_thinLoads[contact] = thinLoad(m_scene.contacts[contact]);
}

SolverAssembly::Taken SolverAssembly::taken(std::size_t i) const {
    const SoftContact& contact = m_scene.contacts[i];
    const bool driven = contact.piece().moving && !contact.yielding;
    if (driven && (contact.depth > -contactMargin || contact.approach > 0.0)) {
        std::atomic_ref(m_scene.bodies.of(contact.body()).drivers).fetch_add(1, std::memory_order_relaxed);
    }
    const double up = contact.normal.z();
    const Vec3& where = contact.points[0].position;
    Taken taken;
    taken.height = heightKey(where.z());
    taken.x = static_cast<float>(where.x());
    taken.y = static_cast<float>(where.y());
    taken.contact = static_cast<std::uint32_t>(i);
    taken.a = m_scene.bodies.slotOf(*contact.a);
    taken.b = m_scene.bodies.slotOf(*contact.b);
    taken.points = static_cast<std::uint8_t>(contact.yielding ? 0 : contact.count);
    taken.kind = kindOf(contact);
    if (std::abs(up) > supportingNormal) {
        taken.support = up > 0.0 ? Support::ByA : Support::ByB;
    }
    taken.idle = isIdle(contact);
    return taken;
}

/// (rad/s)^2 that a thin contact takes to carry its load; zero: it is not thin.
double SolverAssembly::thinLoad(const SoftContact& contact) const {
    const double thickness = std::min(thicknessOf(*contact.a), thicknessOf(*contact.b));
    if (m_substepLength <= 0.0 || thickness >= thinSide) {
        return 0.0;
    }
    double load = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(contact.count); ++k) {
        load += contact.points[k].impulse / m_substepLength;
    }
    const auto inverseMass = [&](const Collider& c) { return m_scene.sleep.awake(c) ? m_scene.bodies.of(c).inverseMass : 0.0; };
    const double inverse = inverseMass(*contact.a) + inverseMass(*contact.b);
    return pointShare * load * inverse / sinkAllowedOf(thickness);
}

int SolverAssembly::substepsFor(double dt) const {
    int substeps = m_scene.settings.substeps;
    for (int doublings = 0; doublings < mostDoublings; ++doublings) {
        const double most = stiffestContact * substeps / dt;
        const auto tooSoft = std::count_if(m_thinLoads.begin(), m_thinLoads.end(), [&](double x) { return x > most * most; });
        if (static_cast<double>(tooSoft) <= softShare * static_cast<double>(m_scene.contacts.size())) {
            break;
        }
        substeps *= 2;
    }
    return substeps;
}

void SolverAssembly::takeBodies(SoftSolver& solver) {
    const SoftBodies& all = m_scene.bodies;
    const std::size_t slots = all.stillSlot + std::size_t{1};
    solver.resizeBodies(slots);
    m_supported.assign(slots, 0);
    m_supported.back() = 1;
    m_supportedNow.assign(slots, 0);
    m_sides.resize(all.stillSlot);
    m_speeds.begin(slots, all.awake.size());
    m_scene.pool.loop(all.awake.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const SoftBody& from = all.bodies[all.awake[i]];
            const Mat3 axes = from.pose.orientation.toRotationMatrix();
            SolverBody body;
            body.velocity = from.velocity;
            body.spin = from.spin;
            body.inverseMass = from.inverseMass;
            body.inverseInertia = axes * from.inertia.cwiseInverse().asDiagonal() * axes.transpose();
            body.inertia = from.inertia;
            body.radius = from.collider->radius;
            solver.bodies[i] = body;
            solver.place(i, from.pose);
            m_sides[i] = sideOf(*from.collider);
            m_speeds.set(i, from.inverseMass, from.speed());
            m_supported[i] = from.supported;
        }
    });
    for (std::size_t i = 0; i < all.moving.size(); ++i) {
        const SoftBody& piece = all.pieces[all.moving[i]];
        const std::size_t slot = all.awake.size() + i;
        solver.bodies[slot] = {};
        solver.bodies[slot].velocity = piece.velocity;
        solver.bodies[slot].spin = piece.spin;
        solver.place(slot, {});
        m_sides[slot] = sideOf(*piece.collider);
        m_speeds.set(slot, 0.0, piece.speed());
    }
    solver.bodies[all.stillSlot] = {};
    solver.place(all.stillSlot, {});
}

SolverAssembly::Side SolverAssembly::sideOf(const Collider& collider) const {
    Side side;
    side.thickness = thicknessOf(collider);
    side.material = collider.material;
    side.swelling = collider.kind == ColliderKind::Body && collider.overlapping;
    if (collider.kind != ColliderKind::Ground) {
        const SoftBody& body = m_scene.bodies.of(collider);
        side.centre = body.pose.position;
        side.inverseMass = m_scene.sleep.awake(collider) ? body.inverseMass : 0.0;
    }
    return side;
}

/// @param still  room for what has no slot of its own
const SolverAssembly::Side& SolverAssembly::sideOf(std::uint32_t slot, const Collider& collider, Side& still) const {
    if (slot != m_scene.bodies.stillSlot) {
        return m_sides[slot];
    }
    return still = sideOf(collider);
}

/// A light body that stands on something cannot be pressed away by a heavy one above it; passes over pairs alone would take as many
/// rounds as the ratio of the masses to find that out. It counts as heavier, from the top of a stack down, and in all its contacts
/// alike: were it heavy in one and light in another, their impulses would outgrow each other.
void SolverAssembly::limitMassRatios(SoftSolver& solver) {
    for (auto entry = m_taken.rbegin(); entry != m_taken.rend(); ++entry) {
        if (!moves(entry->a) || !moves(entry->b) || entry->support == Support::None) {
            continue;
        }
        const std::uint32_t below = entry->support == Support::ByA ? entry->a : entry->b;
        const double share = mostMassRatio * m_speeds.inverseMass(entry->a + entry->b - below) / m_speeds.inverseMass(below);
        // One that moves would hand on more momentum than it has.
        if (share < 1.0 && m_supported[below] != 0 && m_speeds.speed(below) <= standingSpeed) {
            SolverBody& body = solver.bodies[below];
            body.inverseMass *= share;
            body.inverseInertia *= share;
            m_sides[below].yield *= share;
            m_sides[below].inverseMass = body.inverseMass;
            m_speeds.setInverseMass(below, body.inverseMass);
        }
    }
}

/// By colours, and within those from the ground up, so that one pass carries the support of the lower contacts to the upper ones.
void SolverAssembly::order(SoftSolver& solver) {
    std::vector<SpeedBound::SlotPair> ends(m_taken.size());
    std::transform(m_taken.begin(), m_taken.end(), ends.begin(), [](const Taken& x) { return SpeedBound::SlotPair{x.a, x.b}; });
    if (m_scene.settings.splitsMass) {
        m_split.split(ends, m_scene.bodies.awake.size());
    }
    solver.split = m_split.bodies();
    ContactColours colours;
    colourContacts(ends, m_scene.bodies.awake.size() + m_split.added(), colours);
    solver.firstOfGroup = colours.first;
    solver.lastInOrder = colours.lastInOrder;
    m_points.fill(0.0);
    m_ends.resize(m_taken.size());
    for (std::size_t k = 0; k < m_taken.size(); ++k) {
        const Taken& from = m_taken[colours.order[k]];
        m_points[static_cast<std::size_t>(from.kind)] += from.points;
        m_ends[k] = {from.a, from.b};
    }
    m_struck.resize(m_taken.size());
    solver.contacts.resize(m_taken.size());
    solver.copies.clear();
    if (m_split.added() > 0) {
        std::transform(colours.order.begin(), colours.order.end(), std::back_inserter(solver.copies),
                       [&](std::uint32_t contact) { return ends[contact]; });
    }
    m_scene.pool.loop(m_taken.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const Taken& from = m_taken[colours.order[k]];
            solver.contacts[k] = {from.a, from.b, from.points, from.x, from.y, from.contact, from.idle};
        }
    });
}

void SolverAssembly::build(SoftSolver& solver, int substeps, double dt, double now) {
    m_now = now;
    m_substeps = substeps;
    m_h = dt / substeps;
    takeBodies(solver);
    std::erase_if(m_taken, [&](const Taken& x) { return x.points == 0 || (!moves(x.a) && !moves(x.b)); });
    sortByHeight(m_taken);
    limitMassRatios(solver);
    order(solver);
    solver.begin(m_scene.bodies.awake.size());
    m_speeds.spread(m_ends);
    solver.layOut(m_h,
                  {.make = [this, &solver](std::uint32_t k, ContactConstraint& c) { makeConstraint(solver.contacts[k], c); },
                   .prefetch = [this, &solver](std::uint32_t k) { prefetchFor(solver.contacts[k]); }},
                  [&](std::uint32_t k, const ContactConstraint& c) {
                      m_struck[k] = m_speeds.struck(m_ends[k], c, solver.contacts[k].points, solver.bodies);
                  });
    const std::vector<double> bounds = m_speeds.bounds(m_ends, m_struck, 2.0 * m_scene.settings.gravity * dt);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        solver.bound(i, bounds[i]);
    }
}

void SolverAssembly::prefetchFor(const SolverContact& c) const {
    prefetch(m_scene.contacts[c.found], SoftContact::bytes(c.points));
}

/// m by which the two are brought apart by position only in this step: overlap at birth, or what others have jammed.
double SolverAssembly::correctionOf(const SoftContact& contact, double thickness, double dt) const {
    const double overlap = overlapToPart(contact, m_scene.settings, m_now);
    // Where overlap at birth pushes bodies about; elsewhere contacts alone decide how deep they carry.
    double push = 0.0;
    for (const SoftContact::Point& point : std::span(contact.points).first(static_cast<std::size_t>(contact.count))) {
        push = std::max(push, point.push);
    }
    const auto lightness = [&](const Collider& x) { return x.kind == ColliderKind::Body ? m_scene.bodies.of(x).inverseMass : 0.0; };
    const bool pushed = push > 0.0 && push > jammingPush / std::max(lightness(*contact.a), lightness(*contact.b));
    // A light body between spans stays squeezed, for impulses take as many passes as the ratio of the masses.
    const bool held = m_scene.settings.partsJammed && contact.jammedFor > jamPatience && contact.b->kind == ColliderKind::Body &&
                      contact.a->kind == ColliderKind::Body;
    const double jammed = contact.depth - contact.offset - jammedDepth * thickness;
    return std::clamp(pushed || held ? std::max(overlap, jammed) : overlap, 0.0, m_scene.settings.overlapSpeed * dt);
}

void SolverAssembly::makeConstraint(const SolverContact& of, ContactConstraint& c) const {
    const SoftContact& contact = m_scene.contacts[of.found];
    const WorldSettings& settings = m_scene.settings;
    Side stillA, stillB;
    const Side& a = sideOf(of.a, *contact.a, stillA);
    const Side& b = sideOf(of.b, *contact.b, stillB);
    const PairProperties& pair = settings.pairs.of(a.material, b.material);
    const auto isPiece = [&](std::uint32_t slot) { return !moves(slot) && slot != m_scene.bodies.stillSlot; };
    c.normal = contact.normal;
    c.friction = pair.friction;
    c.driven = isPiece(of.a) || isPiece(of.b);
    // What is limited or still overlaps does not bounce.
    c.restitution = contact.offset > 0.0 || c.driven ? 0.0 : pair.restitution;
    // What a body in overlap does to others, overlap does.
    c.countsWork = !c.driven && (contact.offset > 0.0 || a.swelling || b.swelling);
    const double thickness = std::min(a.thickness, b.thickness);
    const double dt = m_h * m_substeps;
    c.correction = c.driven ? 0.0 : correctionOf(contact, thickness, dt);
    const bool immovable = !moves(of.a) || !moves(of.b);
    const double frequency = std::min(contactFrequency, 0.25 / m_h);
    c.lift = immovable ? (!moves(of.a) ? 1.0 : -1.0) * settings.gravity * m_h : 0.0;
    c.frequency = immovable ? 2.0 * frequency : frequency;
    c.sinkAllowed = sinkAllowedOf(thickness);
    c.weight = settings.gravity * m_h / std::max(a.inverseMass, b.inverseMass);
    c.impulseLimit = c.driven ? pieceLimit(contact) : -1.0;
    const std::array<Vec3, 2> tangents = tangentsOf(c.normal);
    c.tangent[0] = tangents[0];
    c.tangent[1] = tangents[1];
    makePoints(of, a, b, c);
}

void SolverAssembly::makePoints(const SolverContact& of, const Side& a, const Side& b, ContactConstraint& c) const {
    const SoftContact& contact = m_scene.contacts[of.found];
    // What a body carried while it counted as heavier must not hit it when it no longer does.
    const double yielded = std::min(1.0, contact.yield / std::min(a.yield, b.yield));
    const double carried = (m_substepLength > 0.0 ? m_h / m_substepLength : 1.0) * yielded;
    for (std::uint32_t k = 0; k < of.points; ++k) {
        const SoftContact::Point& point = contact.points[k];
        SolverPoint& p = c.points[k];
        p.fromA = point.position - a.centre;
        p.fromB = point.position - b.centre;
        p.separation = point.separation + contact.offset;
        p.impulses.normal = c.impulseLimit < 0.0 ? carried * point.impulse : std::min(carried * point.impulse, c.impulseLimit);
        p.impulses.push = yielded * point.push;
        p.impulses.tangent[0] = carried * c.tangent[0].dot(point.friction);
        p.impulses.tangent[1] = carried * c.tangent[1].dot(point.friction);
    }
}

std::array<Vec3, 2> SolverAssembly::tangentsOf(const Vec3& normal) {
    // Any direction off the normal will do for the first, as long as it depends on the normal alone.
    const Vec3& n = normal;
    const Vec3 off = std::abs(n.x()) < 0.57735 ? Vec3(0.0, n.z(), -n.y()) : Vec3(n.y(), -n.x(), 0.0);
    const Vec3 first = off / std::sqrt(off.squaredNorm());
    return {first, n.cross(first)};
}

Vec3 SolverAssembly::armOf(bool ofA, const SolverContact& c, std::size_t point) const {
    const SoftContact& contact = m_scene.contacts[c.found];
    Side still;
    const Side& side = ofA ? sideOf(c.a, *contact.a, still) : sideOf(c.b, *contact.b, still);
    return contact.points[point].position - side.centre;
}

double SolverAssembly::yieldOf(const SolverContact& c) const {
    const auto of = [&](std::uint32_t slot) { return moves(slot) ? m_sides[slot].yield : 1.0; };
    return std::min(of(c.a), of(c.b));
}

void SolverAssembly::noteSupport(const SolverContact& c, const Vec3& normal) {
    const double up = normal.z();
    if (std::abs(up) < supportingNormal) {
        return;
    }
    const std::uint32_t below = up > 0.0 ? c.a : c.b;
    const std::uint32_t above = up > 0.0 ? c.b : c.a;
    if (m_supported[below] != 0) {
        std::atomic_ref(m_supportedNow[above]).store(1, std::memory_order_relaxed);
    }
}

}  // namespace rubble
