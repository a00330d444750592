#include "core/engine/soft/soft_bodies.h"

#include "core/engine/world/bullet_shapes.h"
#include "core/engine/world/rigid_state.h"

namespace rubble {

namespace {

Vec3 inverse(const Vec3& inertia) {
    return inertia.unaryExpr([](double x) { return x != 0.0 ? 1.0 / x : 0.0; });
}

void keepSolids(Archive& archive, std::vector<SoftBody>& solids, std::span<const std::unique_ptr<Collider>> colliders) {
    if (archive.reading()) {
        solids.resize(colliders.size());
    }
    for (std::size_t i = 0; i < solids.size(); ++i) {
        bool there = solids[i].collider != nullptr;
        archive(there, solids[i]);
        if (archive.reading() && there) {
            solids[i].collider = colliders[i].get();
        }
    }
}

}  // namespace

Pose throughAxes(const Pose& pose) {
    return fromBullet(toBullet(pose));
}

RigidState SoftBody::state(const Collider& of) const {
    return {toBullet(pose), toBullet(velocity), toBullet(spin), toBullet(inverse(of.inertia)), inverseMass};
}

std::uint32_t SoftBodies::slotOf(const Collider& c) const {
    const std::int32_t slot = c.kind == ColliderKind::Ground ? -1 : of(c).slot;
    return slot < 0 ? stillSlot : static_cast<std::uint32_t>(slot);
}

SoftBody& SoftBodies::add(Collider& collider, const Pose& pose) {
    SoftBody body;
    body.collider = &collider;
    body.pose = pose;
    if (collider.kind == ColliderKind::Piece) {
        body.pose = throughAxes(pose);
        standing.push_back(collider.index);
        goals.push_back(body.pose);
        pieces.push_back(body);
        return pieces.back();
    }
    body.inertia = inverse(collider.inertia).cwiseInverse();
    body.inverseMass = 1.0 / collider.mass;
    bodies.push_back(body);
    return bodies.back();
}

void SoftBodies::clearSlots() {
    for (const std::uint32_t i : awake) {
        bodies[i].slot = -1;
    }
    std::erase_if(standing, [&](std::uint32_t i) { return pieces[i].collider == nullptr; });
    for (const std::uint32_t i : standing) {
        pieces[i].slot = -1;
    }
}

void SoftBodies::listAwake(const std::vector<char>& still) {
    awake.clear();
    for (std::uint32_t i = 0; i < still.size(); ++i) {
        if (still[i] == 0) {
            bodies[i].slot = static_cast<std::int32_t>(awake.size());
            awake.push_back(i);
        }
    }
}

void SoftBodies::listMoving() {
    moving.clear();
    for (const std::uint32_t i : standing) {
        if (pieces[i].collider->moving) {
            pieces[i].slot = static_cast<std::int32_t>(awake.size() + moving.size());
            moving.push_back(i);
        }
    }
    stillSlot = static_cast<std::uint32_t>(awake.size() + moving.size());
}

void SoftBodies::keep(Archive& archive, std::span<const std::unique_ptr<Collider>> held,
                      std::span<const std::unique_ptr<Collider>> heldPieces) {
    keepSolids(archive, bodies, held);
    keepSolids(archive, pieces, heldPieces);
    archive(goals);
    if (goals.size() != pieces.size()) {
        Archive::fail();
    }
    for (std::uint32_t i = 0; archive.reading() && i < pieces.size(); ++i) {
        if (pieces[i].collider != nullptr) {
            standing.push_back(i);
        }
    }
}

}  // namespace rubble
