#pragma once

#include <cstdint>
#include <limits>

#include "core/base/geometry.h"

namespace rubble {

/// Something that lies on the site, seen from above: a fragment, or an element of the live structure.
struct MapPiece {
    OrientedBox box;
    Vec3 centre = Vec3::Zero();                                      ///< m; of a piece without an outline the place that counts
    double mass = 0.0;                                               ///< kg
    double volume = 0.0;                                             ///< m3 of material
    std::uint32_t component = 0;                                     ///< index into Components::list
    double arrival = std::numeric_limits<double>::quiet_NaN();       ///< s, when it came to where it lies; NaN: not known
    double impactEnergy = std::numeric_limits<double>::quiet_NaN();  ///< J; NaN: not known
};

}  // namespace rubble
