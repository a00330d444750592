#include "core/engine/soft/rest_offsets.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/engine/world/constants.h"

namespace rubble {

void RestOffsets::find(std::span<SoftContact> pair, double dt) const {
    Collider& a = *pair.front().a;
    Collider& b = *pair.front().b;
    for (SoftContact& contact : pair) {
        if (a.newborn || b.newborn) {
            contact.offset = contact.depth > touchingDepth ? contact.depth : 0.0;
            contact.yielded = contact.offset > 0.0;
        }
        if (contact.fresh && contact.depth > contactMargin) {
            // Nothing comes into being deep: what lies deeper than the way of one step was there, under another part's name.
            contact.offset = std::max(contact.offset, contact.depth - m_finder.marginOf(a.number, b.number, dt));
        }
        contact.passing = contact.passing || passes(contact);
        noteBirthDepth(a, b, contact.depth);
        limitPiece(contact);
        giveWayToJam(contact, dt);
        if (contact.offset > 0.0) {
            std::atomic_ref(a.overlapping).store(true, std::memory_order_relaxed);
            std::atomic_ref(b.overlapping).store(true, std::memory_order_relaxed);
        }
        noteOverlapLeft(a, b, contact.offset, m_sleep);
        // How deep a piece sweeps into what may not resist it is how far it went, not what the solver let through.
        const bool swept = contact.pressed > 0.0 && (a.moving || b.moving);
        if (!contact.yielding && !swept) {
            notePenetration(a, b, contact.depth - contact.offset, m_sleep, m_report);
        }
    }
}

/// What has come loose lies in the structure beside it by as much as their boxes are coarser than their elements.
bool RestOffsets::passes(const SoftContact& contact) const {
    const bool piece = contact.a->kind == ColliderKind::Piece || contact.b->kind == ColliderKind::Piece;
    if (!piece || !contact.body().loose) {
        return false;
    }
    const bool entered = contact.a->newborn || contact.b->newborn || contact.fresh;
    return entered && contact.depth > std::max(contactMargin, occupiedShare * contact.body().smallestSide);
}

/// A body that a piece and something else hold between them cannot get out of both: after a while the piece gives way, since the FE
/// analysis never felt the body.
void RestOffsets::giveWayToJam(SoftContact& contact, double dt) const {
    const bool piece = contact.a->kind == ColliderKind::Piece || contact.b->kind == ColliderKind::Piece;
    const bool bodies = contact.a->kind == ColliderKind::Body && contact.b->kind == ColliderKind::Body;
    const double deepest = piece ? jamDepth : jammedDepth * std::min(contact.a->smallestSide, contact.b->smallestSide);
    const bool jammed = (piece || bodies) && !contact.fresh && contact.depth - contact.offset > deepest;
    contact.jammedFor = jammed ? contact.jammedFor + dt : 0.0;
    if (piece && contact.jammedFor > jamTime) {
        contact.jammedFor = 0.0;
        contact.offset = contact.depth;
        giveWay(contact);
    }
}

void RestOffsets::giveWay(SoftContact& contact) const {
    if (!std::exchange(contact.yielded, true)) {
        std::atomic_ref(m_report.piecesYielded).fetch_add(1, std::memory_order_relaxed);
    }
}

void RestOffsets::limitPiece(SoftContact& contact) const {
    contact.yielding = contact.pressing = false;
    contact.approach = 0.0;
    if (contact.passing) {
        contact.yielding = true;
        contact.offset = std::max(contact.offset, contact.depth);
        return;
    }
    if (!contact.piece().moving) {
        return;
    }
    const SoftBody& p = m_bodies.of(contact.piece());
    const SoftBody& q = m_bodies.of(contact.body());
    const double towards = contact.pieceIsA() ? 1.0 : -1.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(contact.count); ++k) {
        const Vec3& where = contact.points[k].position;
        const Vec3 relative =
            p.velocity + p.spin.cross(where - p.pose.position) - q.velocity - q.spin.cross(where - q.pose.position);
        contact.approach = std::max(contact.approach, towards * contact.normal.dot(relative));
    }
    const PieceAction action = pieceAction(contact.approach, towards * contact.normal.z(), contact.yielded);
    contact.yielding = action.yielding;
    contact.pressing = action.pressing;
    if (contact.yielding) {
        contact.offset = std::max(contact.offset, contact.depth);
    }
}

double RestOffsets::pieceLimit(const SoftContact& contact, int substeps, double dt) const {
    const SoftBody& body = m_bodies.of(contact.body());
    const double mass = 1.0 / body.inverseMass;
    const bool carrying = contact.carries();
    const double speed = contact.pressing ? pressLeft(contact.pressed)
                         : carrying       ? softCarryFactor * contact.approach + carryAcceleration * dt
                                          : contact.approach + nudgeAcceleration * dt;
    // Several pieces of one structure share what they may do to a body.
    return mass * speed / (contact.count * (carrying ? 1 : substeps * std::max(1, body.drivers)));
}

void RestOffsets::accountForPiece(SoftContact& contact, double pushed, double most, double left) const {
    if (pushed <= 0.0) {
        contact.pushes = 0;
        return;
    }
    Collider& body = contact.body();
    std::atomic_ref(body.pushed).store(true, std::memory_order_relaxed);
    if (contact.approach <= pieceYieldSpeed) {
        // Pressing as hard as it may and still coming deeper: it has given way, however slowly.
        if (!contact.carries() && pushed > 0.5 * most) {
            contact.offset = std::max(contact.offset, contact.depth);
        }
        return;
    }
    bool gaveWay = false;
    if (contact.pressing) {
        gaveWay = givesWayToPress(contact.pressed, pushed * m_bodies.of(body).inverseMass);
    } else {
        contact.pushes = inVain(left, contact.approach) ? contact.pushes + 1 : 0;
        gaveWay = givesWayToPushes(contact.pushes);
    }
    if (gaveWay) {
        giveWay(contact);
        contact.offset = std::max(contact.offset, contact.depth);
    }
}

double overlapToPart(const SoftContact& contact, const WorldSettings& settings, double now) {
    const double later = std::max(contact.a->entered, contact.b->entered);
    const double since = settings.overlapTimeFromEntry ? now - later : contact.correctedFor;
    return since < settings.overlapTime ? contact.offset : 0.0;
}

}  // namespace rubble
