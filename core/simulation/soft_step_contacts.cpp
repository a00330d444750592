#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/simulation/constants.h"
#include "core/simulation/hull_contact.h"
#include "core/simulation/soft_step_world.h"

namespace rubble {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
}

/// Patches that one pair of parts may have.
constexpr std::uint32_t patchesPerPart = 64;
/// Parts of a shape that are told apart.
constexpr std::uint32_t partsPerShape = 4096;

std::unique_ptr<btPolyhedralConvexShape> hullOfPart(const ConvexPart& part) {
    std::unique_ptr<btPolyhedralConvexShape> shape;
    if (part.points.empty()) {
        shape = std::make_unique<btBoxShape>(toBullet(part.box.halfExtents));
    } else {
        auto hull = std::make_unique<btConvexHullShape>();
        for (const Vec3& p : part.points) {
            hull->addPoint(toBullet(p), false);
        }
        hull->setMargin(part.margin);
        hull->recalcLocalAabb();
        shape = std::move(hull);
    }
    shape->initializePolyhedralFeatures();
    return shape;
}

btTransform placeOfPart(const Pose& body, const ConvexPart& part) {
    const btTransform place = toBullet(body);
    return part.points.empty() ? place * toBullet(Pose{part.box.centre, part.box.orientation}) : place;
}

bool apart(const PlacedBox& a, const PlacedBox& b, double margin) {
    const double reach = std::sqrt(a.halfExtents.squaredNorm()) + std::sqrt(b.halfExtents.squaredNorm()) + margin;
    return (a.centre - b.centre).squaredNorm() > reach * reach;
}

void append(const ContactPatch& patch, std::uint32_t part, Collider& a, Collider& b, std::vector<SoftContact>& found) {
    if (patch.count == 0) {
        return;
    }
    SoftContact& contact = found.emplace_back();
    contact.pair = colliderPair(a.number, b.number);
    contact.part = part;
    contact.a = &a;
    contact.b = &b;
    contact.normal = patch.normal;
    contact.count = patch.count;
    contact.depth = -patch.separation;
    for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
        const PatchPoint& point = patch.points[i];
        contact.points[i].position = point.position;
        contact.points[i].separation = point.separation;
        contact.points[i].feature = point.feature;
    }
}

}  // namespace

void SoftStepWorld::findPairs() {
    const auto update = [&](Solid& solid) {
        m_broadphasePairCache->setAabb(solid.collider->object->getBroadphaseHandle(), toBullet(solid.swept.min()),
                                       toBullet(solid.swept.max()), m_dispatcher1);
    };
    for (const std::uint32_t i : m_awake) {
        update(m_bodies[i]);
    }
    for (Solid& piece : m_pieces) {
        if (piece.collider != nullptr && (piece.collider->moving || piece.collider->newborn)) {
            update(piece);
        }
    }
    m_broadphasePairCache->calculateOverlappingPairs(m_dispatcher1);
    for (std::vector<Pair>& list : m_pairs) {
        list.clear();
    }
    m_sleepingPairs.clear();
    const btBroadphasePairArray& broad = m_broadphasePairCache->getOverlappingPairCache()->getOverlappingPairArray();
    for (int i = 0; i < broad.size(); ++i) {
        Collider* a = &colliderOf(static_cast<const btCollisionObject*>(broad[i].m_pProxy0->m_clientObject));
        Collider* b = &colliderOf(static_cast<const btCollisionObject*>(broad[i].m_pProxy1->m_clientObject));
        if (a->number > b->number) {
            std::swap(a, b);
        }
        if (!stirs(*a) && !stirs(*b)) {
            m_sleepingPairs.push_back({a, b});
            continue;
        }
        if (!solidOf(*a).swept.intersects(solidOf(*b).swept)) {
            continue;
        }
        const bool structure = a->kind == ColliderKind::Piece || b->kind == ColliderKind::Piece;
        m_pairs[structure ? Structure : Fragments].push_back({a, b});
    }
}

void SoftStepWorld::prepareHulls(Solid& solid) {
    if (solid.hulls.empty()) {
        for (const ConvexPart& part : solid.collider->parts) {
            solid.hulls.push_back(hullOfPart(part));
        }
    }
}

void SoftStepWorld::collideParts(const Solid& a, std::size_t i, const Solid& b, std::size_t j, double margin,
                                 ContactPatch& patch) const {
    const ConvexPart& partA = a.collider->parts[i];
    const ConvexPart& partB = b.collider->parts[j];
    if (partA.points.empty() && partB.points.empty()) {
        patch = collideBoxes(a.placed[i], b.placed[j], margin);
    } else {
        patch = collideHulls(*a.hulls[i], placeOfPart(a.pose, partA), *b.hulls[j], placeOfPart(b.pose, partB), margin);
    }
}

void SoftStepWorld::collidePair(const Pair& pair, double dt, std::vector<SoftContact>& found) const {
    const Solid& a = solidOf(*pair.a);
    const Solid& b = solidOf(*pair.b);
    const double margin = marginOf(*pair.a, *pair.b, dt);
    for (std::size_t i = 0; i < a.placed.size(); ++i) {
        for (std::size_t j = 0; j < b.placed.size(); ++j) {
            if (apart(a.placed[i], b.placed[j], margin)) {
                continue;
            }
            ContactPatch patch;
            collideParts(a, i, b, j, margin, patch);
            append(patch, static_cast<std::uint32_t>(i * partsPerShape + j), *pair.a, *pair.b, found);
        }
    }
}

void SoftStepWorld::collidePairs(std::vector<Pair>& pairs, Kind kind, double dt) {
    const auto from = Clock::now();
    for (const Pair& pair : pairs) {
        if (solidOf(*pair.a).hull || solidOf(*pair.b).hull) {
            prepareHulls(solidOf(*pair.a));
            prepareHulls(solidOf(*pair.b));
        }
    }
    constexpr std::size_t grain = 256;
    m_parts.resize(std::max(m_parts.size(), pairs.size() / grain + 1));
    for (std::vector<SoftContact>& part : m_parts) {
        part.clear();
    }
    m_pool.loop(pairs.size(), grain, [&](std::size_t first, std::size_t last) {
        std::vector<SoftContact>& found = m_parts[first / grain];
        for (std::size_t i = first; i < last; ++i) {
            collidePair(pairs[i], dt, found);
        }
    });
    for (const std::vector<SoftContact>& part : m_parts) {
        m_contacts.insert(m_contacts.end(), part.begin(), part.end());
    }
    const double seconds = since(from);
    (kind == Structure ? m_costs.structureContact : m_costs.fragmentContact) += seconds;
    m_costs.motion -= seconds;
}

void SoftStepWorld::collideWithGround(double dt) {
    if (!m_surface.present()) {
        return;
    }
    const auto from = Clock::now();
    std::vector<ContactPatch> patches;
    for (const std::uint32_t i : m_awake) {
        Solid& solid = m_bodies[i];
        const double highest = m_surface.terrain ? m_surface.terrain->highestOver(solid.swept.min().x(), solid.swept.min().y(),
                                                                                  solid.swept.max().x(), solid.swept.max().y())
                                                 : m_surface.levelHeight;
        if (solid.swept.min().z() > highest) {
            continue;
        }
        const double margin = marginOf(m_ground, *solid.collider, dt);
        for (std::size_t part = 0; part < solid.collider->parts.size(); ++part) {
            patches.clear();
            collideGround(m_surface, solid.collider->parts[part], solid.pose, solid.velocity, dt, margin, patches);
            for (std::size_t k = 0; k < patches.size(); ++k) {
                const std::uint32_t feature = m_surface.terrain ? patches[k].points[0].feature : 0;
                append(patches[k], static_cast<std::uint32_t>(part) * 2 * patchesPerPart + feature, m_ground, *solid.collider,
                       m_contacts);
            }
        }
    }
    const double seconds = since(from);
    m_costs.groundContact += seconds;
    m_costs.motion -= seconds;
}

void SoftStepWorld::collideAll(double dt) {
    const auto from = Clock::now();
    m_previous.swap(m_contacts);
    m_contacts.clear();
    findPairs();
    const double broad = since(from);
    const double pairs = std::max<double>(1.0, static_cast<double>(m_pairs[Structure].size() + m_pairs[Fragments].size()));
    m_costs.structureContact += broad * static_cast<double>(m_pairs[Structure].size()) / pairs;
    m_costs.fragmentContact += broad * static_cast<double>(m_pairs[Fragments].size()) / pairs;
    m_costs.motion -= m_pairs[Structure].empty() && m_pairs[Fragments].empty() ? 0.0 : broad;

    collideWithGround(dt);
    collidePairs(m_pairs[Structure], Structure, dt);
    collidePairs(m_pairs[Fragments], Fragments, dt);
    if (wakeByContacts()) {
        wakeAndCollideAgain(dt);
    }
    sortContacts(m_contacts);
    remember();
    rest();
}

/// What lies on a lifted body is lifted in the same instant: as long as it sleeps it is a wall above the piece.
void SoftStepWorld::wakeAbove(std::vector<std::uint32_t> lifted) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> above;  // lower, upper
    for (const auto& [pair, contacts] : m_asleep) {
        const SoftContact& c = contacts.front();
        if (c.a->kind == ColliderKind::Body && c.b->kind == ColliderKind::Body && std::abs(c.normal.z()) > supportingNormal) {
            above.emplace_back(c.normal.z() > 0.0 ? c.a->index : c.b->index, c.normal.z() > 0.0 ? c.b->index : c.a->index);
        }
    }
    std::sort(above.begin(), above.end());
    std::vector<char> seen(m_bodies.size(), 0);
    while (!lifted.empty()) {
        const std::uint32_t body = lifted.back();
        lifted.pop_back();
        if (std::exchange(seen[body], 1) != 0) {
            continue;
        }
        m_justThawed.push_back(body);
        for (auto i = std::lower_bound(above.begin(), above.end(), std::pair{body, 0u}); i != above.end() && i->first == body;
             ++i) {
            if (m_bodies[i->second].collider != nullptr && m_freeze.frozen(i->second)) {
                lifted.push_back(i->second);
            }
        }
    }
}

bool SoftStepWorld::wakeByContacts() {
    std::vector<std::uint32_t> lifted;
    for (const SoftContact& contact : m_contacts) {
        for (auto [sleeper, other] : {std::pair{contact.a, contact.b}, std::pair{contact.b, contact.a}}) {
            if (sleeper->kind != ColliderKind::Body || awake(*sleeper) || other->kind == ColliderKind::Ground) {
                continue;
            }
            double closest = 1e300;
            Vec3 where = Vec3::Zero();
            for (std::size_t i = 0; i < static_cast<std::size_t>(contact.count); ++i) {
                if (contact.points[i].separation < closest) {
                    closest = contact.points[i].separation;
                    where = contact.points[i].position;
                }
            }
            const Solid& solid = solidOf(*other);
            const double along = contact.normal.dot(solid.velocity + solid.spin.cross(where - solid.pose.position));
            const double approach = other == contact.a ? along : -along;
            const bool carriedOff =
                other->kind == ColliderKind::Piece && (other->moving || other->newborn) && closest < contactMargin;
            if (carriedOff || (awake(*other) && approach > thawSpeed)) {
                m_justThawed.push_back(sleeper->index);
                const double up = (other == contact.a ? 1.0 : -1.0) * contact.normal.z();
                if (carriedOff && approach > 0.0 && up >= carryingNormal) {
                    lifted.push_back(sleeper->index);
                }
            }
        }
    }
    if (!lifted.empty()) {
        wakeAbove(std::move(lifted));
    }
    std::sort(m_justThawed.begin(), m_justThawed.end());
    m_justThawed.erase(std::unique(m_justThawed.begin(), m_justThawed.end()), m_justThawed.end());
    return !m_justThawed.empty();
}

void SoftStepWorld::wakeAndCollideAgain(double dt) {
    const std::vector<std::uint32_t> woken = std::exchange(m_justThawed, {});
    for (const std::uint32_t i : woken) {
        thaw(*m_bodies[i].collider);
        m_bodies[i].active = false;
    }
    // Slots follow the order of entry, whoever woke late.
    m_awake.clear();
    for (std::uint32_t i = 0; i < m_bodies.size(); ++i) {
        if (m_bodies[i].collider != nullptr && !m_freeze.frozen(i)) {
            m_bodies[i].slot = static_cast<std::int32_t>(m_awake.size());
            m_awake.push_back(i);
        }
    }
    for (std::size_t i = 0; i < m_moving.size(); ++i) {
        m_pieces[m_moving[i]].slot = static_cast<std::int32_t>(m_awake.size() + i);
    }
    m_stillSlot = static_cast<std::uint32_t>(m_awake.size() + m_moving.size());
    std::vector<Pair> structure, fragments;
    std::erase_if(m_sleepingPairs, [&](const Pair& pair) {
        if (!stirs(*pair.a) && !stirs(*pair.b)) {
            return false;
        }
        (pair.a->kind == ColliderKind::Piece || pair.b->kind == ColliderKind::Piece ? structure : fragments).push_back(pair);
        return true;
    });
    collidePairs(structure, Structure, dt);
    collidePairs(fragments, Fragments, dt);
    if (!m_surface.present()) {
        return;
    }
    const std::vector<std::uint32_t> all = std::exchange(m_awake, woken);
    collideWithGround(dt);
    m_awake = all;
}

void SoftStepWorld::remember() {
    const auto find = [&](std::size_t& next, const SoftContact& contact) -> const SoftContact* {
        while (next < m_previous.size() && m_previous[next].key() < contact.key()) {
            ++next;
        }
        if (next < m_previous.size() && m_previous[next].key() == contact.key()) {
            return &m_previous[next];
        }
        return nullptr;
    };
    m_pool.loop(m_contacts.size(), 2048, [&](std::size_t first, std::size_t last) {
        std::size_t next = static_cast<std::size_t>(
            std::lower_bound(m_previous.begin(), m_previous.end(), m_contacts[first],
                             [](const SoftContact& x, const SoftContact& y) { return x.key() < y.key(); }) -
            m_previous.begin());
        for (std::size_t i = first; i < last; ++i) {
            if (const SoftContact* before = find(next, m_contacts[i])) {
                carryOver(*before, m_contacts[i]);
            }
        }
    });
    if (m_asleep.empty()) {
        return;
    }
    for (SoftContact& contact : m_contacts) {
        const auto kept = m_asleep.find(contact.pair);
        if (kept == m_asleep.end()) {
            continue;
        }
        const auto& parts = kept->second;
        const auto same = std::find_if(parts.begin(), parts.end(), [&](const SoftContact& c) { return c.part == contact.part; });
        if (same != parts.end()) {
            carryOver(*same, contact);
        }
    }
    for (const SoftContact& contact : m_contacts) {
        m_asleep.erase(contact.pair);
    }
}

void SoftStepWorld::rest() {
    for (std::size_t first = 0; first < m_contacts.size();) {
        std::size_t last = first + 1;
        while (last < m_contacts.size() && m_contacts[last].pair == m_contacts[first].pair) {
            ++last;
        }
        Collider& a = *m_contacts[first].a;
        Collider& b = *m_contacts[first].b;
        for (std::size_t i = first; i < last; ++i) {
            SoftContact& contact = m_contacts[i];
            if (a.newborn || b.newborn) {
                contact.offset = std::max(0.0, contact.depth);
                contact.yielded = contact.offset > 0.0;
            }
            for (auto [born, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
                const bool older = other->kind == ColliderKind::Piece || (other->kind == ColliderKind::Body && !other->newborn);
                if (born->newborn && older) {
                    born->birthDepth = std::max(born->birthDepth, contact.depth);
                }
            }
        }
        limitPiece(first, last);
        for (std::size_t i = first; i < last; ++i) {
            SoftContact& contact = m_contacts[i];
            if (!contact.yielding) {
                const double depth = contact.depth - contact.offset;
                m_report.penetrationMax = std::max(m_report.penetrationMax, depth);
                for (Collider* side : {&a, &b}) {
                    side->penetration = awake(*side) ? std::max(side->penetration, depth) : side->penetration;
                }
            }
        }
        first = last;
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

void SoftStepWorld::buildSolver(double h) {
    m_solver.bodies.resize(m_stillSlot + 1);
    m_pool.loop(m_awake.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Solid& solid = m_bodies[m_awake[i]];
            const Mat3 axes = solid.pose.orientation.toRotationMatrix();
            SolverBody body;
            body.velocity = solid.velocity;
            body.spin = solid.spin;
            body.inverseMass = solid.inverseMass;
            body.inverseInertia = axes * solid.inertia.cwiseInverse().asDiagonal() * axes.transpose();
            m_solver.bodies[i] = body;
        }
    });
    for (std::size_t i = 0; i < m_moving.size(); ++i) {
        SolverBody body;
        body.velocity = m_pieces[m_moving[i]].velocity;
        body.spin = m_pieces[m_moving[i]].spin;
        m_solver.bodies[m_awake.size() + i] = body;
    }
    m_solver.bodies[m_stillSlot] = {};

    const auto slotOf = [&](const Collider& c) {
        const std::int32_t slot = c.kind == ColliderKind::Ground ? -1 : solidOf(c).slot;
        return slot < 0 ? m_stillSlot : static_cast<std::uint32_t>(slot);
    };
    for (const std::uint32_t i : m_awake) {
        m_bodies[i].drivers = 0;
    }
    for (const SoftContact& contact : m_contacts) {
        const bool pieceIsA = contact.a->kind == ColliderKind::Piece;
        const Collider& piece = pieceIsA ? *contact.a : *contact.b;
        const bool driven = piece.kind == ColliderKind::Piece && piece.moving && !contact.yielding;
        if (driven && (contact.depth > -contactMargin || contact.approach > 0.0)) {
            ++solidOf(pieceIsA ? *contact.b : *contact.a).drivers;
        }
    }
    std::vector<std::uint32_t> taken;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    for (std::uint32_t i = 0; i < m_contacts.size(); ++i) {
        const SoftContact& contact = m_contacts[i];
        const std::uint32_t a = slotOf(*contact.a), b = slotOf(*contact.b);
        if (!contact.yielding && (a < m_awake.size() || b < m_awake.size())) {
            taken.push_back(i);
            ends.emplace_back(a, b);
        }
    }
    // From the ground up, so that one pass carries the support of the lower ones to the upper ones.
    std::vector<std::uint32_t> order(taken.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t x, std::uint32_t y) {
        return m_contacts[taken[x]].points[0].position.z() < m_contacts[taken[y]].points[0].position.z();
    });
    std::vector<std::uint32_t> sortedTaken(taken.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sortedEnds(ends.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        sortedTaken[i] = taken[order[i]];
        sortedEnds[i] = ends[order[i]];
    }
    taken.swap(sortedTaken);
    ends.swap(sortedEnds);
    ContactColours colours;
    colourContacts(ends, m_awake.size(), colours);
    m_solver.firstOfGroup = colours.first;
    m_solver.lastInOrder = colours.lastInOrder;
    m_solver.contacts.resize(taken.size());
    std::uint32_t points = 0;
    for (std::size_t k = 0; k < taken.size(); ++k) {
        m_solver.contacts[k].firstPoint = points;
        points += static_cast<std::uint32_t>(m_contacts[taken[colours.order[k]]].count);
    }
    m_solver.points.resize(points);
    const double frequency = std::min(contactFrequency, 0.25 / h);
    m_pool.loop(taken.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const std::uint32_t from = taken[colours.order[k]];
            const SoftContact& contact = m_contacts[from];
            SolverContact& c = m_solver.contacts[k];
            const std::uint32_t firstPoint = c.firstPoint;
            c = {};
            c.firstPoint = firstPoint;
            c.found = from;
            std::tie(c.a, c.b) = ends[colours.order[k]];
            fillContact(contact, c, frequency, h);
        }
    });
}

void SoftStepWorld::fillContact(const SoftContact& contact, SolverContact& c, double frequency, double h) {
    const PairProperties& pair = m_settings.pairs.of(contact.a->material, contact.b->material);
    const bool pieceIsA = contact.a->kind == ColliderKind::Piece;
    const Collider& piece = pieceIsA ? *contact.a : *contact.b;
    c.points = static_cast<std::uint32_t>(contact.count);
    c.normal = contact.normal;
    c.friction = pair.friction;
    c.driven = piece.kind == ColliderKind::Piece && piece.moving;
    // What is limited or still overlaps does not bounce.
    c.restitution = contact.offset > 0.0 || c.driven ? 0.0 : pair.restitution;
    c.booked = !c.driven && contact.offset > 0.0;
    c.impulseLimit = -1.0;
    if (c.booked) {
        c.parting = m_settings.overlapSpeed;
        const double inverse = std::max(m_solver.bodies[c.a].inverseMass, m_solver.bodies[c.b].inverseMass);
        c.partingLimit = partingAcceleration * h / (inverse * contact.count);
    }
    const bool immovable = c.a >= m_awake.size() || c.b >= m_awake.size();
    c.frequency = immovable ? 2.0 * frequency : frequency;
    c.sinkAllowed = sinkAllowed(contact);
    c.weight = m_settings.gravity * h / std::max(m_solver.bodies[c.a].inverseMass, m_solver.bodies[c.b].inverseMass);
    stiffenBelow(contact, c);
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
    const double carried =
        (m_substepLength > 0.0 ? h / m_substepLength : 1.0) * std::min(1.0, contact.yield / std::min(c.yieldA, c.yieldB));
    const auto centreOf = [&](const Collider& collider) {
        return collider.kind == ColliderKind::Ground ? Vec3(Vec3::Zero()) : solidOf(collider).pose.position;
    };
    const Vec3 a = centreOf(*contact.a), b = centreOf(*contact.b);
    // Any direction off the normal will do for the first tangent, as long as it depends on the normal alone.
    const Vec3& n = c.normal;
    const Vec3 off = std::abs(n.x()) < 0.57735 ? Vec3(0.0, n.z(), -n.y()) : Vec3(n.y(), -n.x(), 0.0);
    c.tangent[0] = off / std::sqrt(off.squaredNorm());
    c.tangent[1] = n.cross(c.tangent[0]);
    for (std::uint32_t k = 0; k < c.points; ++k) {
        const SoftContact::Point& point = contact.points[k];
        SolverPoint p;
        p.fromA = point.position - a;
        p.fromB = point.position - b;
        p.separation = point.separation + contact.offset;
        p.normalImpulse = c.impulseLimit < 0.0 ? carried * point.impulse : std::min(carried * point.impulse, c.impulseLimit);
        p.before = p.normalImpulse;
        p.tangentImpulse[0] = carried * c.tangent[0].dot(point.friction);
        p.tangentImpulse[1] = carried * c.tangent[1].dot(point.friction);
        m_solver.points[c.firstPoint + k] = p;
    }
}

/// A light body that stands on something cannot be pressed away by a heavy one above it; passes over pairs alone would take as many
/// rounds as the ratio of the masses to find that out.
void SoftStepWorld::stiffenBelow(const SoftContact& contact, SolverContact& c) {
    if (contact.a->kind != ColliderKind::Body || contact.b->kind != ColliderKind::Body) {
        return;
    }
    const bool aBelow = contact.normal.z() > 0.0;
    const Solid& below = solidOf(aBelow ? *contact.a : *contact.b);
    const Solid& above = solidOf(aBelow ? *contact.b : *contact.a);
    const double ratio = above.slot >= 0 ? below.inverseMass / above.inverseMass : 0.0;
    if (ratio > mostMassRatio && below.supported && std::abs(contact.normal.z()) > supportingNormal) {
        (aBelow ? c.yieldA : c.yieldB) = mostMassRatio / ratio;
    }
}

void SoftStepWorld::noteSupport(const SoftContact& contact) {
    const double up = contact.normal.z();
    if (std::abs(up) < supportingNormal) {
        return;
    }
    Collider& below = up > 0.0 ? *contact.a : *contact.b;
    Collider& above = up > 0.0 ? *contact.b : *contact.a;
    const bool firm = !awake(below) ? !below.moving : solidOf(below).supported;
    if (firm && awake(above)) {
        solidOf(above).supportedNow = true;
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
void SoftStepWorld::noteLoad(const SoftContact& contact) {
    const bool a = contact.a->kind == ColliderKind::Body && !awake(*contact.a);
    const bool b = contact.b->kind == ColliderKind::Body && !awake(*contact.b);
    if (a == b) {
        return;
    }
    const Solid& sleeper = solidOf(a ? *contact.a : *contact.b);
    const double rest = contact.restLoad.norm();
    const double lost = rest > 0.0 ? rest - contact.load.dot(contact.restLoad) / rest : 0.0;
    if (lost > thawLoad * (m_settings.gravity / sleeper.inverseMass + rest)) {
        m_unloaded.push_back((a ? contact.a : contact.b)->index);
    }
}

void SoftStepWorld::takeResults() {
    m_report.pairs = 0;
    m_report.points = 0;
    for (const SolverContact& c : m_solver.contacts) {
        SoftContact& contact = m_contacts[c.found];
        contact.yield = std::min(c.yieldA, c.yieldB);
        double pushed = 0.0;
        bool touching = false;
        for (std::uint32_t k = 0; k < c.points; ++k) {
            const SolverPoint& p = m_solver.points[c.firstPoint + k];
            contact.points[k].impulse = p.normalImpulse;
            contact.points[k].friction = p.tangentImpulse[0] * c.tangent[0] + p.tangentImpulse[1] * c.tangent[1];
            pushed += p.impulseSum;
            touching = touching || p.largestImpulse > 0.0;
        }
        if (touching) {
            noteSupport(contact);
        }
        contact.load += loadMemory * (loadOf(contact) - contact.load);
        noteLoad(contact);
        m_report.pairs += touching;
        m_report.points += touching ? c.points : 0;
        if (c.driven) {
            m_report.pieceWork += c.work;
            bookPiece(contact, c, pushed);
        } else if (c.booked) {
            m_report.overlapWork += c.work;
        }
    }
}

void SoftStepWorld::bookPiece(SoftContact& contact, const SolverContact& c, double pushed) {
    const bool pieceIsA = contact.a->kind == ColliderKind::Piece;
    Collider& body = pieceIsA ? *contact.b : *contact.a;
    if (pushed <= 0.0) {
        contact.pushes = 0;
        return;
    }
    body.pushed = true;
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
        ++m_report.piecesYielded;
    }
    if (gaveWay) {
        contact.offset = std::max(contact.offset, contact.depth);
    }
}

/// No body leaves a step faster than what it touches, directly or through others, could make it: a light body between heavy ones
/// keeps what is left over when their passes have not converged, and would be shot out.
void SoftStepWorld::limitSpeeds(double dt) {
    std::vector<double> reach(m_stillSlot + 1, 0.0);
    const auto speedOf = [](const Solid& solid) { return solid.velocity.norm() + solid.spin.norm() * solid.collider->radius; };
    for (std::size_t i = 0; i < m_awake.size(); ++i) {
        reach[i] = speedOf(m_bodies[m_awake[i]]);
    }
    for (std::size_t i = 0; i < m_moving.size(); ++i) {
        reach[m_awake.size() + i] = speedOf(m_pieces[m_moving[i]]);
    }
    const auto spread = [&](const SolverContact& c) {
        const double most = std::max(reach[c.a], reach[c.b]);
        for (const std::uint32_t end : {c.a, c.b}) {
            if (end < m_awake.size()) {
                reach[end] = most;
            }
        }
    };
    for (int sweep = 0; sweep < 2; ++sweep) {
        std::for_each(m_solver.contacts.begin(), m_solver.contacts.end(), spread);
        std::for_each(m_solver.contacts.rbegin(), m_solver.contacts.rend(), spread);
    }
    for (std::size_t i = 0; i < m_awake.size(); ++i) {
        SolverBody& body = m_solver.bodies[i];
        const Solid& solid = m_bodies[m_awake[i]];
        const double most = 2.0 * reach[i] + pushOutSpeed + 2.0 * m_settings.gravity * dt;
        const double speed = body.velocity.norm();
        const double turning = body.spin.norm() * solid.collider->radius;
        if (speed > most && solid.active) {
            body.velocity *= most / speed;
            ++m_report.speedLimits;
        }
        if (turning > most && solid.active) {
            body.spin *= most / turning;
            ++m_report.speedLimits;
        }
    }
}

void SoftStepWorld::shareSolveTime(double seconds) {
    double points[Kinds] = {0.0, 0.0, 0.0};
    double all = 0.0;
    for (const SolverContact& c : m_solver.contacts) {
        const SoftContact& contact = m_contacts[c.found];
        const Kind kind = contact.a->kind == ColliderKind::Ground                                            ? Ground
                          : contact.a->kind == ColliderKind::Piece || contact.b->kind == ColliderKind::Piece ? Structure
                                                                                                             : Fragments;
        points[kind] += c.points;
        all += c.points;
    }
    if (all > 0.0) {
        m_costs.groundContact += seconds * points[Ground] / all;
        m_costs.structureContact += seconds * points[Structure] / all;
        m_costs.fragmentContact += seconds * points[Fragments] / all;
        m_costs.motion -= seconds;
    }
}

}  // namespace rubble
