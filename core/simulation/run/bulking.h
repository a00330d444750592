#pragma once

#include <limits>
#include <vector>

#include "core/fe/site_surface.h"
#include "core/simulation/run/simulation.h"

namespace rubble {

/// A fragment's solid as a box, at its final place.
struct DebrisBox {
    OrientedBox box;
    double volume = 0.0;  ///< m3 of material
};

/// How much room debris takes up.
struct PileMeasure {
    double bulking = std::numeric_limits<double>::quiet_NaN();  ///< NaN without debris
    double layers = 0.0;  ///< mean depth where debris lies, over the cube root of a fragment's mean volume
};

/// The box along the axes around a box.
Aabb outline(const OrientedBox& box);

/// The bulking factor is the volume between the ground and the surface of a pile over the volume of its material; broken rock
/// swells by 1.3 to 1.7. The surface is the highest debris above each point of a 0.25 m raster, averaged over cells of 1 m. Places
/// where structure stands, or lies in large pieces that bridge hollows, are left out, and the debris that lies there with them.
/// @param structure  m, outlines of live elements seen from above
PileMeasure measurePile(const std::vector<DebrisBox>& debris, const std::vector<Aabb>& structure, const SiteSurface& ground);

}  // namespace rubble
