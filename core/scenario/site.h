#pragma once

#include <vector>

#include "core/fe/control_points.h"

namespace rubble {

/// How terrain, orthophoto, surroundings and surveys are brought to the local frame of a case.
struct Site {
    std::vector<ControlPoint> controlPoints;  ///< two or more that are used take the place of the frame's origin
    double heightShift = 0.0;                 ///< m, added to heights of terrain and surveys, as between two vertical datums
    bool collide = false;                     ///< surroundings are part of what debris falls on
    friend bool operator==(const Site&, const Site&) = default;
};

}  // namespace rubble
