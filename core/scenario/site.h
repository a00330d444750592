#pragma once

#include <cstdint>
#include <vector>

#include "core/fe/control_points.h"

namespace rubble {

/// The greatest class that a point cloud may have.
inline constexpr int groundClassMost = 255;

/// How terrain, orthophoto, surroundings and surveys are brought to the local frame of a case.
struct Site {
    std::vector<ControlPoint> controlPoints;  ///< two or more that are used take the place of the frame's origin
    double heightShift = 0.0;                 ///< m, added to heights of terrain and surveys, as between two vertical datums
    bool collide = false;                     ///< surroundings are part of what debris falls on
    /// Classes of a point cloud whose points are the terrain; empty: 2, ground, or all but vegetation and wires if it has none.
    std::vector<std::uint16_t> groundClasses = {};
    friend bool operator==(const Site&, const Site&) = default;
};

}  // namespace rubble
