#pragma once

#include "core/engine/world/rigid_world.h"
#include "core/trajectory/record_archive.h"

namespace rubble {

inline void keep(Archive& archive, ConvexPart& of) {
    archive(of.box, of.points, of.margin);
}

inline void keep(Archive& archive, BodyMotion& of) {
    archive(of.pose, of.velocity, of.angularVelocity);
}

inline void keep(Archive& archive, ContactReport& of) {
    archive(of.pairs, of.points, of.penetrationMax, of.overlapWork, of.pieceWork, of.piecesYielded, of.speedLimits);
}

inline void keep(Archive& archive, StepCosts& of) {
    archive(of.motion, of.groundContact, of.structureContact, of.fragmentContact, of.substepHook, of.total);
}

}  // namespace rubble
