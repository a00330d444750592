#pragma once

#include "core/simulation/rigid_world.h"
#include "core/simulation/simulation.h"

namespace rubble {

/// Keeps the account of energy over all bodies: what gravity, births, overlap and pieces put in, what is there, what contacts took.
/// A gain is any fall of what was dissipated below what it has been already.
class EnergyAccount {
public:
    EnergyAccount(double gravity, double groundHeight) : m_gravity(gravity), m_ground(groundHeight) {}

    /// A body has entered.
    void entered(const Momenta& body, double height);
    /// A body is about to leave.
    void leaving(const Momenta& body, double height);
    /// Takes stock: total kinetic energy [J] and the sum of mass times height above ground [kg m] of the bodies present.
    void update(double kinetic, double massHeight, const ContactReport& contacts);

    EnergyBalance balance() const { return m_balance; }
    double potential() const { return m_potential; }

private:
    double m_gravity;
    double m_ground;
    double m_potentialIn = 0.0;
    double m_kineticOut = 0.0;
    double m_potential = 0.0;
    double m_dissipatedMost = 0.0;
    EnergyBalance m_balance;
};

}  // namespace rubble
