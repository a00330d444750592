#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>

#include "core/engine/world/bullet_shapes.h"
#include "core/engine/world/collider.h"

namespace rubble {

/// What stands behind an object of Bullet.
struct BulletCollider : Collider {
    bool touched = false;              ///< a body that a contact acted on in this step
    const PairTable* pairs = nullptr;  ///< friction and restitution by materials
    Vec3 shift = Vec3::Zero();         ///< m, by which this step's bleeding moves the body
    OwnedShape shape;
    std::unique_ptr<btRigidBody> object;  ///< where it is and how it moves
};

inline BulletCollider& bulletCollider(Collider& collider) {
    return static_cast<BulletCollider&>(collider);
}
inline const BulletCollider& bulletCollider(const Collider& collider) {
    return static_cast<const BulletCollider&>(collider);
}
inline BulletCollider& colliderOf(const btCollisionObject* object) {
    return *static_cast<BulletCollider*>(object->getUserPointer());
}

/// The state of a body as the substeps see it.
MovingBody movingBody(const BulletCollider& collider);

}  // namespace rubble
