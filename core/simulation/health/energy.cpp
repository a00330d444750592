#include "core/simulation/health/energy.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/health/value_archive.h"

namespace rubble {

void EnergyAccount::entered(const Momenta& body, double height) {
    m_balance.kineticIn += body.kineticEnergy;
    m_potentialIn += body.mass * m_gravity * height;
}

void EnergyAccount::leaving(const Momenta& body, double height) {
    m_kineticOut += body.kineticEnergy;
    m_potentialIn -= body.mass * m_gravity * height;
}

void EnergyAccount::replaced(double kineticLost, double massHeightLost) {
    m_kineticOut += kineticLost;
    m_potentialIn -= m_gravity * massHeightLost;
}

void EnergyAccount::update(double kinetic, double massHeight, const ContactReport& contacts, double effectWork) {
    m_balance.kineticNow = kinetic;
    m_balance.gravityWork = m_potentialIn - m_gravity * massHeight;
    // An effect that failed on one body leaves no number; the account goes on with what was known.
    if (std::isfinite(effectWork)) {
        m_balance.effectWork = effectWork;
    }
    m_balance.dissipated = m_balance.kineticIn - m_kineticOut + m_balance.gravityWork + contacts.overlapWork + contacts.pieceWork +
                           m_balance.effectWork - m_balance.kineticNow;
    m_dissipatedMost = std::max(m_dissipatedMost, m_balance.dissipated);
    const double gain = m_dissipatedMost - m_balance.dissipated;
    // What rises and falls again leaves no net work, and what was born falling has most of its work of gravity behind it.
    m_workMost = std::max({m_workMost, std::abs(m_balance.gravityWork), m_balance.kineticIn});
    const double work = m_workMost;
    m_gain = gain > 0.0 && work > 0.0 ? gain / work : 0.0;
    m_balance.drift = std::max(m_balance.drift, m_gain);
}

void EnergyAccount::keep(Archive& archive) {
    archive(m_potentialIn, m_kineticOut, m_dissipatedMost, m_gain, m_workMost, m_balance);
}

}  // namespace rubble
