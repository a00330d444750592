#pragma once

#include <optional>
#include <string>

#include "core/fe/control_points.h"

namespace rubble {

/// Where north lies in the local frame: rad from +y, clockwise. Nothing where neither a coordinate system nor control points say
/// so.
/// @param system  of coordinates, for people; empty: none
inline std::optional<double> northOf(const SiteFit& place, const std::string& system) {
    return system.empty() && place.angle == 0.0 ? std::nullopt : std::optional(place.angle);
}

}  // namespace rubble
