#include "core/engine/world/collider.h"

#include "core/engine/world/world_archive.h"

namespace rubble {

void Collider::keep(Archive& archive) {
    archive(number, newborn, moving, pushed, bornBelow, leaving, overlapping, justThawed, loose, broken, material, entered,
            birthDepth, birthDepthApart, penetration, overlapLeft, lifted, smallestSide, volume, mass, birthEnergy, handedEnergy,
            inertia, parts, nodes);
}

double specificKineticEnergy(const Vec3& velocity, const Vec3& spin, const Vec3& inertia, double mass) {
    return 0.5 * (velocity.squaredNorm() + inertia.dot(spin.cwiseAbs2()) / mass);
}

OrientedBox boxAround(const CollisionShape& parts) {
    if (parts.size() == 1) {
        return parts.front().box;
    }
    Aabb bounds;
    for (const ConvexPart& part : parts) {
        const Mat3 axes = part.box.orientation.toRotationMatrix();
        const Vec3 reach = axes.cwiseAbs() * part.box.halfExtents;
        bounds.extend(part.box.centre - reach);
        bounds.extend(part.box.centre + reach);
    }
    OrientedBox box;
    if (!bounds.isEmpty()) {
        box.centre = bounds.center();
        box.halfExtents = 0.5 * bounds.sizes();
    }
    return box;
}

double outerRadius(const CollisionShape& parts) {
    double radius = 0.0;
    for (const ConvexPart& part : parts) {
        const Mat3 axes = part.box.orientation.toRotationMatrix();
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 sign(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
            radius = std::max(radius, (part.box.centre + axes * sign.cwiseProduct(part.box.halfExtents)).norm());
        }
    }
    return radius;
}

}  // namespace rubble
