#include "core/engine/soft/contact_finder.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/prefetch.h"
#include "core/engine/world/constants.h"
#include "core/engine/world/ground_contact.h"

namespace rubble {

namespace {

/// Patches that one pair of parts may have.
constexpr std::uint32_t patchesPerPart = 64;
/// Pairs of parts above which those are looked for first that come near the other shape.
constexpr std::size_t partPairsMany = 1024;

/// In the frame of its body.
ConvexHull hullOfPart(const ConvexPart& part) {
    std::vector<Vec3> corners = part.points;
    if (corners.empty()) {
        for (int i = 0; i < 8; ++i) {
            const Vec3 sign(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
            corners.emplace_back(part.box.centre + part.box.orientation * sign.cwiseProduct(part.box.halfExtents));
        }
    }
    return hullFaces(corners);
}

bool apart(const PlacedBox& a, const PlacedBox& b, double margin) {
    const double reach = a.radius + b.radius + margin;
    return (a.centre - b.centre).squaredNorm() > reach * reach;
}

/// Parts that come near the box around another shape, in order.
std::vector<std::uint32_t> partsNear(const PlacedBox* parts, std::size_t count, const Aabb& other, double margin) {
    std::vector<std::uint32_t> near;
    for (std::size_t i = 0; i < count; ++i) {
        const double reach = parts[i].radius + margin;
        if (other.squaredExteriorDistance(parts[i].centre) <= reach * reach) {
            near.push_back(static_cast<std::uint32_t>(i));
        }
    }
    return near;
}

void append(const ContactPatch& patch, std::uint32_t part, Collider& a, Collider& b, std::vector<FoundContact>& found) {
    if (patch.count > 0) {
        found.push_back({&a, &b, part, patch});
    }
}

}  // namespace

ContactFinder::ContactFinder(const SiteSurface& surface, double gravity, bool faces, const SoftBodies& bodies, PairFinder& pairs,
                             WorkerPool& pool)
    : m_surface(surface), m_gravity(gravity), m_faces(faces), m_bodies(bodies), m_pairs(pairs), m_pool(pool) {
    m_ground.kind = ColliderKind::Ground;
    m_ground.newborn = false;
}

void ContactFinder::enter(Collider& collider) {
    m_pairs.enter(collider, static_cast<std::uint32_t>(m_placed.size()));
    m_placed.resize(m_placed.size() + collider.parts.size());
    m_paces.resize(std::max<std::size_t>(m_paces.size(), collider.number + 1));
    m_hulls.resize(m_paces.size());
}

void ContactFinder::forget(const Collider& collider) {
    m_pairs.forget(collider.number);
    m_hulls[collider.number].clear();
}

void ContactFinder::place(const SoftBody& body) {
    const std::span<PlacedBox> placed = placedOf(*body.collider);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const OrientedBox& box = body.collider->parts[i].box;
        placed[i].centre = body.pose * box.centre;
        placed[i].axes = (body.pose.orientation * box.orientation).toRotationMatrix();
        placed[i].halfExtents = box.halfExtents;
        placed[i].radius = std::sqrt(box.halfExtents.squaredNorm());
    }
}

Aabb ContactFinder::sweep(const SoftBody& body, double dt) {
    Aabb box;
    for (const PlacedBox& part : placedOf(*body.collider)) {
        const Vec3 reach = part.axes.cwiseAbs() * part.halfExtents;
        box.extend(part.centre - reach);
        box.extend(part.centre + reach);
    }
    const Vec3 travel = body.velocity * dt;
    const double rim = body.spin.norm() * body.collider->radius;
    m_paces[body.collider->number] = {body.velocity, rim};
    const double slack = contactMargin + rim * dt + m_gravity * dt * dt;
    box.min() += travel.cwiseMin(0.0) - Vec3::Constant(slack);
    box.max() += travel.cwiseMax(0.0) + Vec3::Constant(slack);
    return box;
}

double ContactFinder::marginOf(std::uint32_t a, std::uint32_t b, double dt) const {
    const double speed = (m_paces[b].velocity - m_paces[a].velocity).norm() + m_paces[a].rim + m_paces[b].rim;
    return contactMargin + speed * dt + m_gravity * dt * dt;
}

void ContactFinder::begin() {
    m_partsUsed = 0;
    m_runs.clear();
}

void ContactFinder::prepareHulls(const Collider& collider) {
    std::vector<ConvexHull>& hulls = m_hulls[collider.number];
    if (hulls.empty()) {
        for (const ConvexPart& part : collider.parts) {
            hulls.push_back(hullOfPart(part));
        }
    }
}

PlacedHull ContactFinder::placedHull(const Collider& of, std::size_t part) const {
    const Pose& pose = m_bodies.of(of).pose;
    return {&m_hulls[of.number][part], pose.position, pose.orientation.toRotationMatrix(),
            of.parts[part].box.halfExtents.minCoeff()};
}

/// Leaves out points that the two do not close in this step by the motion that they begin it with: those of bodies that fall side
/// by side, or that lie in a pile without touching: in the sample some third of all. Where one point of a patch closes, a hit there
/// may turn the others in as fast.
void ContactFinder::leaveOutApart(ContactPatch& patch, const Collider& a, const Collider& b, double dt) const {
    double reach = restingReach + m_gravity * dt * dt;
    const auto points = std::span(patch.points).first(static_cast<std::size_t>(patch.count));
    const auto within = [&](const PatchPoint& point) { return point.separation <= reach; };
    if (std::ranges::all_of(points, within)) {
        return;
    }
    const auto velocityAt = [&](const Collider& c, const Vec3& where) -> Vec3 {
        if (c.kind == ColliderKind::Ground) {
            return Vec3::Zero();
        }
        const SoftBody& body = m_bodies.of(c);
        return body.velocity + body.spin.cross(where - body.pose.position);
    };
    double closing = 0.0;  // m/s
    for (const PatchPoint& point : points) {
        closing = std::max(closing, patch.normal.dot(velocityAt(a, point.position) - velocityAt(b, point.position)));
    }
    reach += closing * dt;
    patch.count -= static_cast<int>(std::ranges::remove_if(points, std::not_fn(within)).size());
}

void ContactFinder::collidePair(const NearPair& pair, double dt, std::vector<FoundContact>& found) const {
    const BroadPhaseEntry& a = m_pairs.entry(pair.a);
    const BroadPhaseEntry& b = m_pairs.entry(pair.b);
    const double margin = marginOf(pair.a, pair.b, dt);
    const std::size_t partsA = a.collider->parts.size(), partsB = b.collider->parts.size();
    assert(partsA * partsB <= std::uint64_t{1} << 32);
    const auto meet = [&](std::size_t i, std::size_t j) {
        const PlacedBox& boxA = m_placed[a.part + i];
        const PlacedBox& boxB = m_placed[b.part + j];
        if (apart(boxA, boxB, margin)) {
            return;
        }
        ContactPatch patch;
        if (a.collider->parts[i].points.empty() && b.collider->parts[j].points.empty()) {
            patch = collideBoxes(boxA, boxB, margin, m_faces);
        } else {
            patch = collideHulls(placedHull(*a.collider, i), placedHull(*b.collider, j), margin);
        }
        leaveOutApart(patch, *a.collider, *b.collider, dt);
        append(patch, static_cast<std::uint32_t>(i * partsB + j), *a.collider, *b.collider, found);
    };
    if (partsA * partsB > partPairsMany) {
        const std::vector<std::uint32_t> nearA = partsNear(&m_placed[a.part], partsA, b.swept, margin);
        const std::vector<std::uint32_t> nearB = partsNear(&m_placed[b.part], partsB, a.swept, margin);
        for (const std::uint32_t i : nearA) {
            for (const std::uint32_t j : nearB) {
                meet(i, j);
            }
        }
        return;
    }
    for (std::size_t i = 0; i < partsA; ++i) {
        for (std::size_t j = 0; j < partsB; ++j) {
            meet(i, j);
        }
    }
}

void ContactFinder::collide(std::span<const NearPair> pairs, double dt) {
    for (const NearPair& pair : pairs) {
        if (m_pairs.entry(pair.a).hull || m_pairs.entry(pair.b).hull) {
            prepareHulls(*m_pairs.entry(pair.a).collider);
            prepareHulls(*m_pairs.entry(pair.b).collider);
        }
    }
    constexpr std::size_t grain = 256;
    const std::size_t begin = beginRun(pairs.size(), grain);
    m_pool.loop(pairs.size(), grain, [&](std::size_t first, std::size_t last) {
        std::vector<FoundContact>& found = m_parts[begin + first / grain];
        for (std::size_t i = first; i < last; ++i) {
            if (i + recordsAhead < last) {
                prefetch(m_placed[m_pairs.entry(pairs[i + recordsAhead].b).part]);
            }
            collidePair(pairs[i], dt, found);
        }
    });
}

/// Makes room for one more run of contacts in the order of their keys, found in parts of `grain`; returns its first part.
std::size_t ContactFinder::beginRun(std::size_t count, std::size_t grain) {
    const std::size_t first = m_partsUsed;
    m_partsUsed += count / grain + 1;
    m_parts.resize(std::max(m_parts.size(), m_partsUsed));
    for (std::size_t i = first; i < m_partsUsed; ++i) {
        m_parts[i].clear();
    }
    m_runs.push_back(first);
    return first;
}

void ContactFinder::collideBodyWithGround(const SoftBody& body, double dt, std::vector<FoundContact>& found) {
    const Collider& collider = *body.collider;
    const Aabb& swept = m_pairs.entry(collider.number).swept;
    const double highest = m_surface.terrain
                               ? m_surface.terrain->highestOver(swept.min().x(), swept.min().y(), swept.max().x(), swept.max().y())
                               : m_surface.levelHeight;
    if (swept.min().z() > highest) {
        return;
    }
    std::vector<ContactPatch> patches;
    const double margin = marginOf(m_ground.number, collider.number, dt);
    for (std::size_t part = 0; part < collider.parts.size(); ++part) {
        patches.clear();
        collideGround(m_surface, collider.parts[part], body.pose, body.velocity, dt, margin, patches);
        for (ContactPatch& patch : patches) {
            const std::uint32_t feature = m_surface.terrain ? patch.points[0].feature : 0;
            leaveOutApart(patch, m_ground, *body.collider, dt);
            assert(feature < 2 * patchesPerPart);
            append(patch, static_cast<std::uint32_t>(part) * 2 * patchesPerPart + feature, m_ground, *body.collider, found);
        }
    }
}

void ContactFinder::collideWithGround(std::span<const std::uint32_t> bodies, double dt) {
    if (!m_surface.present()) {
        return;
    }
    constexpr std::size_t grain = 128;
    const std::size_t begin = beginRun(bodies.size(), grain);
    m_pool.loop(bodies.size(), grain, [&](std::size_t first, std::size_t last) {
        std::vector<FoundContact>& found = m_parts[begin + first / grain];
        for (std::size_t i = first; i < last; ++i) {
            collideBodyWithGround(m_bodies.bodies[bodies[i]], dt, found);
        }
    });
}

std::vector<Found> ContactFinder::inOrder() const {
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

}  // namespace rubble
