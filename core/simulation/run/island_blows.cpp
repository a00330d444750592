#include "core/simulation/run/island_blows.h"

#include <algorithm>

namespace rubble {

namespace {

/// m/s. Less is no blow.
constexpr double leastBlow = 1.0;
/// Share of the blow in the FE result below which one is softer.
constexpr double softerShare = 0.5;

}  // namespace

void IslandBlows::begin(ElementIndex element, const Vec3& velocity) {
    m_elements.resize(std::max(m_elements.size(), at(element) + 1));
    m_elements[at(element)] = {velocity, velocity, 0.0, 0.0};
}

void IslandBlows::advance(ElementIndex element, const Vec3& inFe, const Vec3& inEngine, const Vec3& fall) {
    Followed& of = m_elements[at(element)];
    of.feBlow = std::max(of.feBlow, (inFe - of.inFe - fall).norm());
    of.engineBlow = std::max(of.engineBlow, (inEngine - of.inEngine - fall).norm());
    of.inFe = inFe;
    of.inEngine = inEngine;
}

bool IslandBlows::softer(ElementIndex element) const {
    const Followed& of = m_elements[at(element)];
    return of.feBlow >= leastBlow && of.engineBlow < softerShare * of.feBlow;
}

}  // namespace rubble
