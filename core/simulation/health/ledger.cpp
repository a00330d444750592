#include "core/simulation/health/ledger.h"

#include <algorithm>

#include "core/clusters/rigid_motion.h"
#include "core/simulation/health/value_archive.h"

namespace rubble {

namespace {

/// What errors are relative to.
struct Scale {
    double mass = 0.0;
    double linear = 0.0;   ///< sum of m |v|
    double angular = 0.0;  ///< sum of |x| m |v|
};

void raise(double& most, double error) {
    most = std::max(most, error);
}

}  // namespace

void Ledger::keep(Archive& archive) {
    archive(m_errors);
}

LedgerRow Ledger::handedOver(std::size_t state, double time, const HandOver& handOver, const RigidWorld& world) {
    LedgerRow row;
    row.time = time;
    row.state = static_cast<std::uint32_t>(state);
    Scale scale;
    for (const Carrier& carrier : handOver.carriers) {
        const Fragment& f = m_description.fragments->list[at(carrier.fragment)];
        row.fe += f.fe;
        row.fragments += rigidMomenta(f.mass, f.centre, f.inertia, f.velocity, f.angularVelocity);
        scale.mass += f.mass;
        scale.linear += f.mass * f.velocity.norm();
        scale.angular += f.centre.norm() * f.mass * f.velocity.norm();
    }
    row.clusters = handOver.clusters;
    for (const BodyRecord& body : handOver.bodies) {
        row.bodies += world.momenta(body.body);
    }
    row.droppedKineticEnergy = row.fe.kineticEnergy - row.bodies.kineticEnergy;

    raise(m_errors.mass, relativeError(std::abs(row.fragments.mass - row.fe.mass), scale.mass));
    raise(m_errors.momentum, relativeError((row.fragments.linear - row.fe.linear).norm(), scale.linear));
    raise(m_errors.angularMomentum, relativeError((row.fragments.angular - row.fe.angular).norm(), scale.angular));
    raise(m_errors.bodyMass, relativeError(std::abs(row.bodies.mass - row.fe.mass), scale.mass));
    raise(m_errors.bodyMomentum, relativeError((row.bodies.linear - row.fe.linear).norm(), scale.linear));
    raise(m_errors.bodyAngularMomentum, relativeError((row.bodies.angular - row.fe.angular).norm(), scale.angular));
    return row;
}

}  // namespace rubble
