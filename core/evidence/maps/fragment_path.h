#pragma once

#include <optional>
#include <vector>

#include "core/base/execution.h"
#include "core/fragments/fragment_set.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Where a fragment's centre was at a frame.
struct PathPoint {
    double time = 0.0;          ///< s
    Vec3 place = Vec3::Zero();  ///< m
    double speed = 0.0;         ///< m/s, in the mean since the frame before; 0 at the first
};

/// A hit, as the frames show it: within a few frames its velocity changed by more than gravity does.
struct FragmentImpact {
    double time = 0.0;    ///< s, of the frame at which it changed most
    double speed = 0.0;   ///< m/s, of its centre just before
    double change = 0.0;  ///< m/s, of its velocity, gravity taken out
    double energy = 0.0;  ///< J, kinetic energy of its centre just before
};

/// The way of one fragment from its birth to the end of the run.
struct FragmentPath {
    std::vector<PathPoint> points;        ///< by frame, ascending
    std::vector<FragmentImpact> impacts;  ///< in the order of time
    double restTime = 0.0;                ///< s, since when it has stayed within 5 cm of its last place
    bool removed = false;                 ///< its last body has left the engine without another in its place
};

/// Follows a fragment through the frames of a run. A hit is a change of velocity of more than 1 m/s between two intervals of frames
/// beyond what gravity [m/s2] does; those of frames one after another are one hit. Reads every frame from the fragment's hand-over
/// on once. Throws Cancelled and what the trajectory throws.
FragmentPath fragmentPath(const FragmentSet& fragments, const TrajectoryReader& trajectory, FragmentId fragment, double gravity,
                          const Execution& execution);

/// Where a fragment's centre is at a time of a run [m]; nothing before its hand-over and after its last body has left.
std::optional<Vec3> fragmentPlace(const FragmentSet& fragments, const TrajectoryReader& trajectory, FragmentId fragment,
                                  double time);

}  // namespace rubble
