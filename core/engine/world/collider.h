#pragma once

#include <algorithm>
#include <cstdint>

#include "core/engine/world/rigid_world.h"

namespace rubble {

enum class ColliderKind : std::uint8_t { Ground, Body, Piece };

/// What every engine knows of a body, a piece or the ground: its place in the order of entry, and what contacts did to it. Where it
/// is and how it moves stands in the engine.
struct Collider {
    virtual ~Collider() = default;

    ColliderKind kind = ColliderKind::Body;
    std::uint32_t number = 0;  ///< among all colliders, in order of entry
    std::uint32_t index = 0;   ///< among those of its kind
    bool newborn = true;       ///< not yet stepped
    bool moving = false;       ///< a piece that moves in this step
    bool pushed = false;       ///< a body that a moving piece has pushed
    bool bornBelow = false;    ///< a body whose centre was below ground when it entered
    bool leaving = false;      ///< to be taken out before the next step
    bool overlapping = false;  ///< a body that is in overlap from birth in this step
    bool justThawed = false;   ///< its frozen neighbours are not noted yet
    bool loose = false;        ///< a body that was a part of the structure: see NewBody
    bool broken = false;       ///< a body that was given a velocity that is no number; it goes on without
    Material material = Material::Concrete;
    double radius = 0.0;           ///< m, of the farthest corner
    double entered = 0.0;          ///< s, of the world's own time
    double birthDepth = 0.0;       ///< m, inside older colliders
    double birthDepthApart = 0.0;  ///< m, inside those of them that it was not joined to
    double penetration = 0.0;      ///< m, of a body: its deepest contact in its latest step awake, overlap at birth excepted
    double overlapLeft = 0.0;      ///< m, of a body: what is left of overlap at birth with other bodies, in its latest step awake
    double lifted = 0.0;           ///< m, of a body: by being brought out of overlap at birth
    double smallestSide = 0.0;     ///< m, of a body
    double volume = 0.0;           ///< m3, of its material
    double mass = 0.0;             ///< kg, of a body
    double birthEnergy = 0.0;      ///< J/kg, of a body when it entered: kinetic, spin included, and g z
    double handedEnergy = noPush;  ///< J/kg, see RigidWorld::handedEnergy()
    Vec3 inertia = Vec3::Zero();   ///< kg m2, likewise
    CollisionShape parts;
    std::vector<std::uint32_t> nodes;  ///< see NewBody
    OrientedBox box;                   ///< around the parts

    /// J/kg, kinetic and g z, that a body may have by its birth and by what pushed it so far.
    double allowedEnergy() const { return std::max(birthEnergy, handedEnergy); }

    /// All but what follows from kind, place and parts.
    void keep(Archive& archive);
};

/// J/kg.
/// @param velocity  m/s
/// @param spin      rad/s, about the principal axes
/// @param inertia   kg m2, principal
/// @param mass      kg
double specificKineticEnergy(const Vec3& velocity, const Vec3& spin, const Vec3& inertia, double mass);

/// Distance of the farthest corner from the origin of the frame, m.
double outerRadius(const CollisionShape& parts);

/// The box around all parts of a shape in the axes of its only part, else along the axes of its frame.
OrientedBox boxAround(const CollisionShape& parts);

}  // namespace rubble
