#pragma once

#include <optional>
#include <string>

#include "core/fe/control_points.h"

namespace rubble {

/// Whether something says where in the world a model stands: control points, or an origin other than zero. A coordinate system that
/// is only named does not.
inline bool hasPlace(const SiteFit& place) {
    return place.used > 0 || place.angle != 0.0 || !place.shift.isZero();
}

/// The system that coordinates are in; empty: they are the model's own, or those of control points of no system.
/// @param named  the coordinate system that the case names; empty: none
inline std::string placedSystem(const SiteFit& place, const std::string& named) {
    return hasPlace(place) ? named : std::string();
}

/// Where north lies in the local frame: rad from +y, clockwise. Nothing where neither a coordinate system that the model has a
/// place in nor a turn by control points says so.
/// @param named  as for placedSystem()
inline std::optional<double> northOf(const SiteFit& place, const std::string& named) {
    return placedSystem(place, named).empty() && place.angle == 0.0 ? std::nullopt : std::optional(place.angle);
}

}  // namespace rubble
