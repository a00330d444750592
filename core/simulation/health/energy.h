#pragma once

#include "core/engine/world/rigid_world.h"
#include "core/simulation/bodies/run_account.h"

namespace rubble {

/// Keeps the account of energy over all bodies: what gravity, births, overlap, pieces and effects put in, what is there, what
/// contacts took. A gain is any fall of what was dissipated below what it has been already.
class EnergyAccount {
public:
    explicit EnergyAccount(double gravity) : m_gravity(gravity) {}

    /// A body has entered at a height above zero [m].
    void entered(const Momenta& body, double height);
    /// A body is about to leave.
    void leaving(const Momenta& body, double height);
    /// Others have taken the place of a body: nothing comes in or goes out but the kinetic energy [J] and the mass times height [kg
    /// m] that they lack.
    void replaced(double kineticLost, double massHeightLost);
    /// Takes stock: total kinetic energy [J] and the sum of mass times height above zero [kg m] of the bodies present.
    /// @param effectWork  J, done on bodies by water, drag and ties so far
    void update(double kinetic, double massHeight, const ContactReport& contacts, double effectWork);

    EnergyBalance balance() const { return m_balance; }
    /// What has been gained and not been lost again since, over the most work of gravity so far or the kinetic energy that births
    /// brought in, whichever is more; 0 if nothing.
    double gain() const { return m_gain; }
    void keep(Archive& archive);

private:
    double m_gravity;
    double m_potentialIn = 0.0;
    double m_kineticOut = 0.0;
    double m_dissipatedMost = 0.0;
    double m_gain = 0.0;
    double m_workMost = 0.0;  ///< J
    EnergyBalance m_balance;
};

}  // namespace rubble
