#include "core/engine/soft/contact_wakes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/engine/world/constants.h"

namespace rubble {

namespace {

struct Woken {
    std::vector<std::uint32_t> all;
    std::vector<std::uint32_t> lifted;  ///< by a piece below
};

void wakeByContact(const FoundContact& contact, const SoftBodies& bodies, const Sleep& sleep, Woken& woken) {
    const ContactPatch& patch = contact.patch;
    for (auto [sleeper, other] : {std::pair{contact.a, contact.b}, std::pair{contact.b, contact.a}}) {
        if (!sleep.frozen(*sleeper) || other->kind == ColliderKind::Ground) {
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
        const SoftBody& body = bodies.of(*other);
        const double along = patch.normal.dot(body.velocity + body.spin.cross(where - body.pose.position));
        const double towards = other == contact.a ? 1.0 : -1.0;
        const double approach = towards * along;
        const bool touches = closest < contactMargin;
        if (!sleep.wakes(*other, approach, touches)) {
            continue;
        }
        woken.all.push_back(sleeper->index);
        if (other->kind == ColliderKind::Piece && approach > 0.0 && towards * patch.normal.z() >= carryingNormal) {
            woken.lifted.push_back(sleeper->index);
        }
    }
}

void wakeAbove(Woken& woken, const SoftBodies& bodies, const Sleep& sleep, const SleepingContacts& asleep) {
    std::vector<char> seen(bodies.bodies.size(), 0);
    while (!woken.lifted.empty()) {
        const std::uint32_t body = woken.lifted.back();
        woken.lifted.pop_back();
        if (std::exchange(seen[body], 1) != 0) {
            continue;
        }
        woken.all.push_back(body);
        asleep.forEachPairOf(bodies.bodies[body].collider->number, [&](const SoftContact& c) {
            if (c.a->kind != ColliderKind::Body || c.b->kind != ColliderKind::Body || std::abs(c.normal.z()) <= supportingNormal) {
                return;
            }
            const Collider& lower = c.normal.z() > 0.0 ? *c.a : *c.b;
            const Collider& upper = c.normal.z() > 0.0 ? *c.b : *c.a;
            if (lower.index == body && sleep.frozen(upper)) {
                woken.lifted.push_back(upper.index);
            }
        });
    }
}

}  // namespace

std::vector<std::uint32_t> wokenByContacts(std::span<const std::vector<FoundContact>> parts, const SoftBodies& bodies,
                                           const Sleep& sleep, const SleepingContacts& asleep, WorkerPool& pool) {
    std::vector<char> hasSleepers(parts.size());
    pool.loop(parts.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t part = first; part < last; ++part) {
            hasSleepers[part] =
                std::ranges::any_of(parts[part], [&](const FoundContact& c) { return sleep.frozen(*c.a) || sleep.frozen(*c.b); });
        }
    });
    Woken woken;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        for (std::size_t i = 0; hasSleepers[part] != 0 && i < parts[part].size(); ++i) {
            wakeByContact(parts[part][i], bodies, sleep, woken);
        }
    }
    wakeAbove(woken, bodies, sleep, asleep);
    std::sort(woken.all.begin(), woken.all.end());
    woken.all.erase(std::unique(woken.all.begin(), woken.all.end()), woken.all.end());
    return woken.all;
}

}  // namespace rubble
