#pragma once

#include <vector>

#include "core/analysis/debris/debris.h"
#include "core/base/execution.h"
#include "core/simulation/run/simulation.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// When each fragment came to where it lies at the time of the debris, s: the last time before it at which its centre came within
/// `distance` [m] of that place, between two frames by linear interpolation; its birth if it was never farther away. NaN for
/// fragments that are not there. Reads every frame up to that time once. Throws Cancelled and what the trajectory throws.
std::vector<double> arrivalTimes(const FragmentSet& fragments, const TrajectoryReader& trajectory, const Debris& debris,
                                 double distance, const Execution& execution);

/// When the body of each fragment took its hardest hit, s: the frame at which its velocity, by differences of places, changes most
/// beyond what gravity [m/s2] does. NaN for a fragment that no body carried over three frames. Reads every frame once.
std::vector<double> hardestHitTimes(const FragmentSet& fragments, const TrajectoryReader& trajectory, double gravity,
                                    const Execution& execution);

/// Kinetic energy of each fragment's centre just before its hardest hit, J; 0 where nothing hit it. This is what it brought, not
/// what the ground took.
/// @param outcomes  [fragments]
std::vector<double> impactEnergies(const FragmentSet& fragments, const std::vector<FragmentOutcome>& outcomes);

}  // namespace rubble
