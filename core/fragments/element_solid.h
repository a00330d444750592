#pragma once

#include "core/fragments/consistent_mass.h"
#include "core/fragments/corner_motion.h"
#include "core/fragments/rigid_fit.h"
#include "core/fragments/solids.h"

namespace rubble {

/// One element at one instant as a solid: what its mass properties, its collision shape and its picture are made from.
struct ElementSolid {
    MovingSolid moving;   ///< shells and beams with their section
    Corners present;      ///< m, as asHexahedron() gives them
    ConsistentMass unit;  ///< of a mass of 1 kg
    SoundSolid sound;     ///< what an engine and a picture can use
};

/// Least half extents of a solid that an engine can bear.
struct LeastExtents {
    double ratio = 0.0;  ///< of the longest half extent
    double least = 0.0;  ///< m
};

/// @param motion   corners of the element, all positions finite
/// @param section  thickness m (shells) or area m2 (beams); unused for solids
ElementSolid elementSolid(const Mesh& mesh, ElementIndex element, const CornerMotion& motion, double section,
                          const LeastExtents& extents);

/// Fits a rigid motion to an element of a mass [kg]; a needle's mass is spread far enough that it does not spin on rounding.
RigidFit fitRigidMotion(const ElementSolid& solid, double mass, const LeastExtents& extents);

}  // namespace rubble
