#include "core/engine/world/scene_rules.h"

#include <algorithm>
#include <atomic>

#include "core/engine/world/constants.h"

namespace rubble {

namespace {

/// Raises a number that threads share to at least this; in which order they come does not matter.
void raise(double& number, double least) {
    std::atomic_ref<double> shared(number);
    double now = shared.load(std::memory_order_relaxed);
    while (now < least && !shared.compare_exchange_weak(now, least, std::memory_order_relaxed)) {
    }
}

/// Whether two share a node of the mesh.
bool joined(const Collider& a, const Collider& b) {
    const Collider& few = a.nodes.size() <= b.nodes.size() ? a : b;
    const Collider& many = &few == &a ? b : a;
    return std::ranges::any_of(few.nodes, [&](std::uint32_t node) { return std::ranges::binary_search(many.nodes, node); });
}

}  // namespace

void noteBirthDepth(Collider& a, Collider& b, double depth) {
    for (auto [born, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        const bool older = other->kind == ColliderKind::Piece || (other->kind == ColliderKind::Body && !other->newborn);
        if (born->newborn && older) {
            raise(born->birthDepth, depth);
            // Most contacts of a newborn are no overlap: nobody has to compare nodes for those.
            if (depth > 0.0 && !joined(*born, *other)) {
                raise(born->birthDepthApart, depth);
            }
        }
    }
}

void noteOverlapLeft(Collider& a, Collider& b, double offset, const Sleep& sleep) {
    if (a.kind != ColliderKind::Body || b.kind != ColliderKind::Body) {
        return;
    }
    for (Collider* side : {&a, &b}) {
        if (sleep.awake(*side)) {
            raise(side->overlapLeft, offset);
        }
    }
}

void notePenetration(Collider& a, Collider& b, double depth, const Sleep& sleep, ContactReport& report) {
    raise(report.penetrationMax, depth);
    for (Collider* side : {&a, &b}) {
        if (sleep.awake(*side)) {
            raise(side->penetration, depth);
        }
    }
}

PieceAction pieceAction(double approach, double up, bool gaveWay) {
    const bool closing = approach > pieceYieldSpeed;
    return {gaveWay && closing, closing && up < carryingNormal};
}

double pressLeft(double pressed) {
    return std::max(0.0, piecePressSpeed - pressed);
}

bool givesWayToPress(double& pressed, double speed) {
    pressed += speed;
    return pressed >= 0.99 * piecePressSpeed;
}

bool givesWayToPushes(int pushes) {
    return pushes >= piecePushes;
}

bool inVain(double left, double approach) {
    return left > 0.5 * approach;
}

GroundRise riseAboveGround(const SiteSurface& surface, const Vec3& centre, bool bornBelow, double dt) {
    GroundRise rise;
    rise.way = surface.above(centre) - centre;
    const double most = separationSpeed * dt, length = rise.way.norm();
    rise.share = bornBelow && length > most ? most / length : 1.0;
    rise.normal = surface.normal(centre.x(), centre.y());
    return rise;
}

}  // namespace rubble
