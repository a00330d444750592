#pragma once

#include "core/base/finding.h"
#include "core/engine/world/world_archive.h"
#include "core/simulation/bodies/island_bodies.h"
#include "core/simulation/bodies/run_account.h"
#include "core/simulation/health/health.h"
#include "core/simulation/health/outcomes.h"
#include "core/trajectory/record_archive.h"

namespace rubble {

inline void keep(Archive& archive, FragmentOutcome& of) {
    archive(of.birthPosition, of.birthSpeed, of.finalPosition, of.impactSpeed);
}

inline void keep(Archive& archive, LedgerErrors& of) {
    archive(of.mass, of.momentum, of.angularMomentum, of.bodyMass, of.bodyMomentum, of.bodyAngularMomentum);
}

inline void keep(Archive& archive, EnergyBalance& of) {
    archive(of.gravityWork, of.kineticIn, of.kineticNow, of.effectWork, of.dissipated, of.drift);
}

inline void keep(Archive& archive, LiveIslands& of) {
    archive(of.islands, of.elements, of.mass, of.moving, of.released, of.releasedElements, of.releasedMass, of.refused, of.occupied,
            of.stillMoving, of.droppedKineticEnergy, of.ledger);
}

inline void keep(Archive& archive, CarriedStructure& of) {
    archive(of.islands, of.elements, of.mass, of.refused, of.bodies, of.born, of.bornMass, of.bornAtRestMass, of.bornSofterMass,
            of.left, of.leftMass, of.stillMoving, of.droppedKineticEnergy, of.handOvers, of.losses);
}

inline void keep(Archive& archive, LiveIsland& of) {
    archive(of.elements, of.supported);
}

inline void keep(Archive& archive, MovingMass& of) {
    archive(of.mass, of.centre, of.inertia, of.velocity, of.angularVelocity);
}

inline void keep(Archive& archive, IslandElement& of) {
    archive(of.element, of.component, of.motion, of.rest, of.box, of.solid, of.vertices);
}

inline void keep(Archive& archive, IslandBody& of) {
    archive(of.elements, of.parts, of.motion, of.fe, of.rigid, of.volume, of.component, of.shape, of.pose, of.inertia);
}

inline void keep(Archive& archive, TrackedBody& of) {
    archive(of.firstCarrier, of.carriers, of.birthEnergy, of.birthHeight, of.mass, of.kinetic, of.hardest, of.before, of.latest,
            of.lost);
}

inline void keep(Archive& archive, HealthRemedy& of) {
    archive(of.from, of.to, of.steps);
}

inline void keep(Archive& archive, Message& of) {
    archive(of.id, of.pattern);
    of.arguments.resize(archive.count(of.arguments.size()), Argument(0));
    for (Argument& argument : of.arguments) {
        std::size_t kind = argument.value.index();
        archive(kind, argument.unit);
        if (archive.reading() && kind == 0) {
            argument.value.emplace<0>();
        } else if (archive.reading() && kind == 1) {
            argument.value.emplace<1>();
        } else if (archive.reading()) {
            argument.value.emplace<2>();
        }
        std::visit([&](auto& value) { archive(value); }, argument.value);
    }
}

inline void keep(Archive& archive, Findings& of) {
    const std::size_t count = archive.count(of.list().size());
    for (std::size_t i = 0; i < count; ++i) {
        Finding finding = archive.reading() ? Finding() : of.list()[i];
        archive(finding.what, finding.remedy, finding.count, finding.example);
        if (archive.reading()) {
            of.add(finding.what, finding.remedy, finding.example, finding.count);
        }
    }
}

}  // namespace rubble
