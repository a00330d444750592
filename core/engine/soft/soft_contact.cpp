#include "core/engine/soft/soft_contact.h"

#include <algorithm>

#include "core/engine/world/constants.h"

namespace rubble {

namespace {

/// m. A point without its feature takes the impulse of one this near.
constexpr double nearPoint = 0.05;

void takePoint(const SoftContact::Point& from, const SoftContact& to, SoftContact::Point& point) {
    point.impulse = from.impulse;
    point.push = from.push;
    point.friction = from.friction - from.friction.dot(to.normal) * to.normal;
}

}  // namespace

bool SoftContactState::carries() const {
    return (pieceIsA() ? 1.0 : -1.0) * normal.z() >= carryingNormal;
}

void SoftContact::keep(Archive& archive) {
    archive(pair, part, normal, count, depth, yield, load, restLoad, offset, correctedFor, approach, pressed, jammedFor, pushes,
            fresh, yielded, yielding, pressing, passing);
    if (count < 0 || count > static_cast<int>(points.size())) {
        Archive::fail();
    }
    for (Point& point : std::span(points).first(static_cast<std::size_t>(count))) {
        archive(point);
    }
}

void take(const FoundContact& found, SoftContact& contact) {
    const ContactPatch& patch = found.patch;
    static_cast<SoftContactState&>(contact) = {};
    contact.pair = colliderPair(found.a->number, found.b->number);
    contact.part = found.part;
    contact.a = found.a;
    contact.b = found.b;
    contact.normal = patch.normal;
    contact.count = patch.count;
    contact.depth = -patch.separation;
    for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
        contact.points[i] = {};
        contact.points[i].position = patch.points[i].position;
        contact.points[i].separation = patch.points[i].separation;
        contact.points[i].feature = patch.points[i].feature;
    }
}

void carryOver(const SoftContact& from, SoftContact& to, bool byAngle) {
    to.offset = std::min(to.depth, from.offset);
    if (!(to.offset > touchingDepth)) {
        to.offset = 0.0;
    }
    to.fresh = false;
    to.pressed = from.pressed;
    to.correctedFor = from.correctedFor;
    to.jammedFor = from.jammedFor;
    to.yield = from.yield;
    to.load = from.load;
    to.restLoad = from.restLoad;
    to.pushes = from.pushes;
    to.yielded = from.yielded;
    to.passing = from.passing;
    std::array<bool, 4> fromDone{}, toDone{};
    for (int i = 0; i < to.count; ++i) {
        for (int j = 0; j < from.count; ++j) {
            const auto ti = static_cast<std::size_t>(i), fj = static_cast<std::size_t>(j);
            if (!fromDone[fj] && from.points[fj].feature == to.points[ti].feature) {
                takePoint(from.points[fj], to, to.points[ti]);
                fromDone[fj] = toDone[ti] = true;
                break;
            }
        }
    }
    const double along = byAngle ? std::max(0.0, from.normal.dot(to.normal)) : 1.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(to.count); ++i) {
        if (toDone[i]) {
            continue;
        }
        double nearest = nearPoint * nearPoint;
        std::size_t best = 4;
        for (std::size_t j = 0; j < static_cast<std::size_t>(from.count); ++j) {
            const double distance = (from.points[j].position - to.points[i].position).squaredNorm();
            if (!fromDone[j] && distance < nearest) {
                nearest = distance;
                best = j;
            }
        }
        if (best < 4) {
            takePoint(from.points[best], to, to.points[i]);
            to.points[i].impulse *= along;
            to.points[i].push *= along;
            fromDone[best] = true;
        }
    }
}

}  // namespace rubble
