#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/elapsed.h"
#include "core/base/near.h"
#include "core/simulation/constants.h"
#include "core/simulation/hull_contact.h"
#include "core/simulation/soft_step_world.h"

namespace rubble {

namespace {

using Clock = std::chrono::steady_clock;

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
    const std::size_t begin = beginRun(pairs.size(), grain);
    m_pool.loop(pairs.size(), grain, [&](std::size_t first, std::size_t last) {
        std::vector<SoftContact>& found = m_parts[begin + first / grain];
        for (std::size_t i = first; i < last; ++i) {
            collidePair(pairs[i], dt, found);
        }
    });
    const double seconds = secondsSince(from);
    (kind == Structure ? m_costs.structureContact : m_costs.fragmentContact) += seconds;
    m_costs.motion -= seconds;
}

/// Makes room for one more run of contacts in the order of their keys, found in parts of `grain`; returns its first part.
std::size_t SoftStepWorld::beginRun(std::size_t count, std::size_t grain) {
    const std::size_t first = m_partsUsed;
    m_partsUsed += count / grain + 1;
    m_parts.resize(std::max(m_parts.size(), m_partsUsed));
    for (std::size_t i = first; i < m_partsUsed; ++i) {
        m_parts[i].clear();
    }
    m_runs.push_back(first);
    return first;
}

void SoftStepWorld::collideWithGround(Solid& solid, double dt, std::vector<SoftContact>& found) {
    const double highest = m_surface.terrain ? m_surface.terrain->highestOver(solid.swept.min().x(), solid.swept.min().y(),
                                                                              solid.swept.max().x(), solid.swept.max().y())
                                             : m_surface.levelHeight;
    if (solid.swept.min().z() > highest) {
        return;
    }
    std::vector<ContactPatch> patches;
    const double margin = marginOf(m_ground, *solid.collider, dt);
    for (std::size_t part = 0; part < solid.collider->parts.size(); ++part) {
        patches.clear();
        collideGround(m_surface, solid.collider->parts[part], solid.pose, solid.velocity, dt, margin, patches);
        for (const ContactPatch& patch : patches) {
            const std::uint32_t feature = m_surface.terrain ? patch.points[0].feature : 0;
            append(patch, static_cast<std::uint32_t>(part) * 2 * patchesPerPart + feature, m_ground, *solid.collider, found);
        }
    }
}

void SoftStepWorld::collideWithGround(std::span<const std::uint32_t> bodies, double dt) {
    if (!m_surface.present()) {
        return;
    }
    const auto from = Clock::now();
    constexpr std::size_t grain = 128;
    const std::size_t begin = beginRun(bodies.size(), grain);
    m_pool.loop(bodies.size(), grain, [&](std::size_t first, std::size_t last) {
        std::vector<SoftContact>& found = m_parts[begin + first / grain];
        for (std::size_t i = first; i < last; ++i) {
            collideWithGround(m_bodies[bodies[i]], dt, found);
        }
    });
    const double seconds = secondsSince(from);
    m_costs.groundContact += seconds;
    m_costs.motion -= seconds;
}

void SoftStepWorld::collideAll(double dt) {
    const auto from = Clock::now();
    m_partsUsed = 0;
    m_runs.clear();
    findPairs();
    const double broad = secondsSince(from);
    const double pairs = std::max<double>(1.0, static_cast<double>(m_pairs[Structure].size() + m_pairs[Fragments].size()));
    m_costs.structureContact += broad * static_cast<double>(m_pairs[Structure].size()) / pairs;
    m_costs.fragmentContact += broad * static_cast<double>(m_pairs[Fragments].size()) / pairs;
    m_costs.motion -= m_pairs[Structure].empty() && m_pairs[Fragments].empty() ? 0.0 : broad;

    collideWithGround(m_awake, dt);
    collidePairs(m_pairs[Structure], Structure, dt);
    collidePairs(m_pairs[Fragments], Fragments, dt);
    if (wakeByContacts()) {
        wakeAndCollideAgain(dt);
    }
    takeFound();
    recallSleeping();
    rest(dt);
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

void SoftStepWorld::wakeByContact(const SoftContact& contact, std::vector<std::uint32_t>& lifted) {
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
        const bool carriedOff = other->kind == ColliderKind::Piece && (other->moving || other->newborn) && closest < contactMargin;
        if (carriedOff || (awake(*other) && approach > thawSpeed)) {
            m_justThawed.push_back(sleeper->index);
            const double up = (other == contact.a ? 1.0 : -1.0) * contact.normal.z();
            if (carriedOff && approach > 0.0 && up >= carryingNormal) {
                lifted.push_back(sleeper->index);
            }
        }
    }
}

bool SoftStepWorld::wakeByContacts() {
    const auto sleeps = [&](const Collider& c) { return c.kind == ColliderKind::Body && !awake(c); };
    std::vector<char> hasSleepers(m_partsUsed);
    m_pool.loop(m_partsUsed, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t part = first; part < last; ++part) {
            hasSleepers[part] =
                std::ranges::any_of(m_parts[part], [&](const SoftContact& c) { return sleeps(*c.a) || sleeps(*c.b); });
        }
    });
    std::vector<std::uint32_t> lifted;
    for (std::size_t part = 0; part < m_partsUsed; ++part) {
        for (std::size_t i = 0; hasSleepers[part] != 0 && i < m_parts[part].size(); ++i) {
            wakeByContact(m_parts[part][i], lifted);
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
    std::vector<std::uint32_t> woken = std::exchange(m_justThawed, {});
    // Who was woken before the step has been looked at already.
    const auto before = std::stable_partition(woken.begin(), woken.end(), [&](std::uint32_t i) { return m_freeze.frozen(i); });
    m_justThawed.assign(before, woken.end());
    woken.erase(before, woken.end());
    for (const std::uint32_t i : woken) {
        thaw(*m_bodies[i].collider);
        m_bodies[i].active = false;
    }
    listAwake();
    for (std::size_t i = 0; i < m_moving.size(); ++i) {
        m_pieces[m_moving[i]].slot = static_cast<std::int32_t>(m_awake.size() + i);
    }
    m_stillSlot = static_cast<std::uint32_t>(m_awake.size() + m_moving.size());
    std::vector<Pair> structure, fragments;
    findPairsOfWoken(woken, dt, structure, fragments);
    collidePairs(structure, Structure, dt);
    collidePairs(fragments, Fragments, dt);
    collideWithGround(woken, dt);
}

/// What was found, in the order of the keys.
std::vector<SoftStepWorld::Found> SoftStepWorld::foundInOrder() const {
    const auto byKey = [](const Found& x, const Found& y) { return x.pair != y.pair ? x.pair < y.pair : x.part < y.part; };
    std::vector<Found> all;
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        const auto begin = static_cast<std::ptrdiff_t>(all.size());
        const std::size_t end = run + 1 < m_runs.size() ? m_runs[run + 1] : m_partsUsed;
        for (std::size_t i = m_runs[run]; i < end; ++i) {
            for (const SoftContact& contact : m_parts[i]) {
                all.push_back({contact.pair, contact.part, &contact});
            }
        }
        // On terrain and after a body woke a run may not be in order.
        if (!std::is_sorted(all.begin() + begin, all.end(), byKey)) {
            std::stable_sort(all.begin() + begin, all.end(), byKey);
        }
        std::inplace_merge(all.begin(), all.begin() + begin, all.end(), byKey);
    }
    return all;
}

/// Puts the contacts found into their order and hands on to each what it carried in the step before.
void SoftStepWorld::takeFound() {
    const std::vector<Found> found = foundInOrder();
    m_previous.swap(m_contacts);
    m_contacts.resize(found.size());
    m_fresh.assign(found.size(), 0);
    const auto isBefore = [](const SoftContact& x, const Found& y) { return x.pair != y.pair ? x.pair < y.pair : x.part < y.part; };
    m_pool.loop(found.size(), 512, [&](std::size_t first, std::size_t last) {
        auto before = std::lower_bound(m_previous.begin(), m_previous.end(), found[first], isBefore);
        for (std::size_t i = first; i < last; ++i) {
            if (i + recordsAhead < last) {
                bringNear(*found[i + recordsAhead].contact);
            }
            SoftContact& contact = m_contacts[i];
            contact = *found[i].contact;
            while (before != m_previous.end() && isBefore(*before, found[i])) {
                ++before;
            }
            if (before != m_previous.end() && before->key() == contact.key()) {
                carryOver(*before, contact);
            }
            m_fresh[i] = contact.fresh;
        }
    });
}

/// A contact that was not there in the step before may have been put aside when both of its bodies came to rest.
void SoftStepWorld::recallSleeping() {
    for (std::size_t i = 0; i < m_contacts.size() && !m_asleep.empty(); ++i) {
        if (m_fresh[i] == 0) {
            continue;
        }
        SoftContact& contact = m_contacts[i];
        const auto kept = m_asleep.find(contact.pair);
        if (kept == m_asleep.end()) {
            continue;
        }
        auto& parts = kept->second;
        const auto same = std::find_if(parts.begin(), parts.end(), [&](const SoftContact& c) { return c.part == contact.part; });
        if (same != parts.end()) {
            carryOver(*same, contact);
            parts.erase(same);
        }
        if (parts.empty()) {
            m_asleep.erase(kept);
        }
    }
}

}  // namespace rubble
