#pragma once

#include "core/base/archive.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

inline void keep(Archive& archive, Momenta& of) {
    archive(of.mass, of.linear, of.angular, of.kineticEnergy);
}

inline void keep(Archive& archive, BodyRecord& of) {
    archive(of.body, of.cluster, of.from, of.to, of.mass, of.atBirth, of.inFe, of.part);
}

inline void keep(Archive& archive, IslandRecord& of) {
    archive(of.body, of.state, of.inFe, of.elements);
}

inline void keep(Archive& archive, Carrier& of) {
    archive(of.fragment, of.body, of.from, of.to, of.handOverToBody);
}

inline void keep(Archive& archive, TrajectoryFrame& of) {
    archive(of.time, of.kind, of.positions, of.orientations, of.speeds, of.states);
}

inline void keep(Archive& archive, LedgerRow& of) {
    archive(of.time, of.state, of.fe, of.fragments, of.clusters, of.bodies, of.droppedKineticEnergy, of.all, of.potentialEnergy,
            of.pieceWork, of.overlapWork);
}

inline void keep(Archive& archive, IslandLoss& of) {
    archive(of.time, of.state, of.before, of.born, of.left);
}

}  // namespace rubble
