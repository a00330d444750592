#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "core/base/elapsed.h"
#include "core/base/prefetch.h"
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

void append(const ContactPatch& patch, std::uint32_t part, Collider& a, Collider& b, std::vector<FoundContact>& found) {
    if (patch.count > 0) {
        found.push_back({&a, &b, part, patch});
    }
}

}  // namespace

void SoftStepWorld::prepareHulls(const Collider& collider) {
    Solid& solid = solidOf(collider);
    if (solid.hulls.empty()) {
        for (const ConvexPart& part : collider.parts) {
            solid.hulls.push_back(hullOfPart(part));
        }
    }
}

void SoftStepWorld::collideHullParts(const Collider& a, std::size_t i, const Collider& b, std::size_t j, double margin,
                                     ContactPatch& patch) const {
    const Solid& solidA = solidOf(a);
    const Solid& solidB = solidOf(b);
    patch = collideHulls(*solidA.hulls[i], placeOfPart(solidA.pose, a.parts[i]), *solidB.hulls[j],
                         placeOfPart(solidB.pose, b.parts[j]), margin);
}

void SoftStepWorld::collidePair(const Pair& pair, double dt, std::vector<FoundContact>& found) const {
    const BroadPhaseEntry& a = m_entries[pair.a];
    const BroadPhaseEntry& b = m_entries[pair.b];
    const double margin = marginOf(pair.a, pair.b, dt);
    const std::size_t partsA = a.collider->parts.size(), partsB = b.collider->parts.size();
    assert(partsA <= std::numeric_limits<std::uint32_t>::max() / partsPerShape && partsB <= partsPerShape);
    for (std::size_t i = 0; i < partsA; ++i) {
        for (std::size_t j = 0; j < partsB; ++j) {
            const PlacedBox& boxA = m_placed[a.part + i];
            const PlacedBox& boxB = m_placed[b.part + j];
            if (apart(boxA, boxB, margin)) {
                continue;
            }
            ContactPatch patch;
            if (a.collider->parts[i].points.empty() && b.collider->parts[j].points.empty()) {
                patch = collideBoxes(boxA, boxB, margin);
            } else {
                collideHullParts(*a.collider, i, *b.collider, j, margin, patch);
            }
            append(patch, static_cast<std::uint32_t>(i * partsPerShape + j), *a.collider, *b.collider, found);
        }
    }
}

void SoftStepWorld::collidePairs(const std::vector<Pair>& pairs, Kind kind, double dt) {
    const auto from = Clock::now();
    for (const Pair& pair : pairs) {
        if (m_entries[pair.a].hull || m_entries[pair.b].hull) {
            prepareHulls(*m_entries[pair.a].collider);
            prepareHulls(*m_entries[pair.b].collider);
        }
    }
    constexpr std::size_t grain = 256;
    const std::size_t begin = beginRun(pairs.size(), grain);
    m_pool.loop(pairs.size(), grain, [&](std::size_t first, std::size_t last) {
        std::vector<FoundContact>& found = m_parts[begin + first / grain];
        for (std::size_t i = first; i < last; ++i) {
            if (i + recordsAhead < last) {
                prefetch(m_placed[m_entries[pairs[i + recordsAhead].b].part]);
            }
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

void SoftStepWorld::collideWithGround(Solid& solid, double dt, std::vector<FoundContact>& found) {
    const double highest = m_surface.terrain ? m_surface.terrain->highestOver(solid.swept.min().x(), solid.swept.min().y(),
                                                                              solid.swept.max().x(), solid.swept.max().y())
                                             : m_surface.levelHeight;
    if (solid.swept.min().z() > highest) {
        return;
    }
    std::vector<ContactPatch> patches;
    const double margin = marginOf(m_ground.number, solid.collider->number, dt);
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
        std::vector<FoundContact>& found = m_parts[begin + first / grain];
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
    takeFound(dt);
}

/// What lies on a lifted body is lifted in the same instant: as long as it sleeps it is a wall above the piece.
void SoftStepWorld::wakeAbove(std::vector<std::uint32_t> lifted) {
    std::vector<char> seen(m_bodies.size(), 0);
    while (!lifted.empty()) {
        const std::uint32_t body = lifted.back();
        lifted.pop_back();
        if (std::exchange(seen[body], 1) != 0) {
            continue;
        }
        m_justThawed.push_back(body);
        m_asleep.forEachPairOf(m_bodies[body].collider->number, [&](const SoftContact& c) {
            if (c.a->kind != ColliderKind::Body || c.b->kind != ColliderKind::Body || std::abs(c.normal.z()) <= supportingNormal) {
                return;
            }
            const Collider& lower = c.normal.z() > 0.0 ? *c.a : *c.b;
            const Collider& upper = c.normal.z() > 0.0 ? *c.b : *c.a;
            if (lower.index == body && m_freeze.frozen(upper.index)) {
                lifted.push_back(upper.index);
            }
        });
    }
}

void SoftStepWorld::wakeByContact(const FoundContact& contact, std::vector<std::uint32_t>& lifted) {
    const ContactPatch& patch = contact.patch;
    for (auto [sleeper, other] : {std::pair{contact.a, contact.b}, std::pair{contact.b, contact.a}}) {
        if (sleeper->kind != ColliderKind::Body || awake(*sleeper) || other->kind == ColliderKind::Ground) {
            continue;
        }
        double closest = std::numeric_limits<double>::infinity();
        Vec3 where = Vec3::Zero();
        for (const PatchPoint& point : std::span(patch.points).first(static_cast<std::size_t>(patch.count))) {
            if (point.separation < closest) {
                closest = point.separation;
                where = point.position;
            }
        }
        const Solid& solid = solidOf(*other);
        const double along = patch.normal.dot(solid.velocity + solid.spin.cross(where - solid.pose.position));
        const double approach = other == contact.a ? along : -along;
        const bool carriedOff = other->kind == ColliderKind::Piece && (other->moving || other->newborn) && closest < contactMargin;
        if (carriedOff || (awake(*other) && approach > thawSpeed)) {
            m_justThawed.push_back(sleeper->index);
            const double up = (other == contact.a ? 1.0 : -1.0) * patch.normal.z();
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
                std::ranges::any_of(m_parts[part], [&](const FoundContact& c) { return sleeps(*c.a) || sleeps(*c.b); });
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
        m_bodies[i].drivers = 0;
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
            for (const FoundContact& contact : m_parts[i]) {
                all.push_back({colliderPair(contact.a->number, contact.b->number), contact.part, &contact});
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

/// Puts the contacts found into their order, hands on to each what it carried in the step before, and looks at what rests on what:
/// pair by pair, so that memory is gone through once.
void SoftStepWorld::takeFound(double dt) {
    const auto from = Clock::now();
    const std::vector<Found> found = foundInOrder();
    m_previous.swap(m_contacts);
    m_contacts.resize(found.size());
    m_taken.resize(found.size());
    m_thinLoads.resize(found.size());
    constexpr std::size_t grain = 256;
    m_recalled.resize(std::max(m_recalled.size(), found.size() / grain + 1));
    m_pool.loop(found.size(), grain, [&](std::size_t first, std::size_t last) {
        std::vector<std::pair<ColliderPair, std::uint32_t>>& recalled = m_recalled[first / grain];
        recalled.clear();
        // A pair belongs to the part in which it begins.
        while (first > 0 && first < last && found[first].pair == found[first - 1].pair) {
            ++first;
        }
        if (first == last) {
            return;
        }
        const auto isBefore = [](const SoftContact& x, const Found& y) {
            return x.pair != y.pair ? x.pair < y.pair : x.part < y.part;
        };
        auto before = std::lower_bound(m_previous.begin(), m_previous.end(), found[first], isBefore);
        while (first < last) {
            const ColliderPair pair = found[first].pair;
            std::size_t end = first;
            for (; end < found.size() && found[end].pair == pair; ++end) {
                if (end + recordsAhead < found.size()) {
                    prefetch(*found[end + recordsAhead].contact);
                }
                SoftContact& contact = m_contacts[end];
                take(*found[end].contact, contact);
                while (before != m_previous.end() && isBefore(*before, found[end])) {
                    ++before;
                }
                if (before != m_previous.end() && before->key() == contact.key() && !before->aside) {
                    carryOver(*before, contact);
                } else if (recall(contact)) {
                    recalled.push_back(contact.key());
                }
            }
            restPair(first, end, dt);
            for (; first < end; ++first) {
                m_taken[first] = taken(first);
                m_thinLoads[first] = thinLoad(m_contacts[first]);
            }
        }
    });
    for (std::size_t part = 0; part * grain < found.size(); ++part) {
        for (const auto& [pair, which] : m_recalled[part]) {
            m_asleep.remove(pair, which);
        }
    }
    m_takingSeconds = secondsSince(from);
}

/// A contact that was not there in the step before may have been put aside when both of its bodies came to rest.
bool SoftStepWorld::recall(SoftContact& contact) const {
    const std::vector<SoftContact>* const kept = m_asleep.of(contact.pair);
    if (kept == nullptr) {
        return false;
    }
    const auto same = std::find_if(kept->begin(), kept->end(), [&](const SoftContact& c) { return c.part == contact.part; });
    if (same == kept->end()) {
        return false;
    }
    carryOver(*same, contact);
    return true;
}

}  // namespace rubble
