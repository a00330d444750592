#pragma once

#include <vector>

#include "core/fe/site_surface.h"
#include "core/simulation/simulation.h"

namespace rubble {

/// A fragment's solid as a box, at its final place.
struct DebrisBox {
    OrientedBox box;
    double volume = 0.0;  ///< m3 of material
};

/// Volume between the ground and the surface of a pile over the volume of its material; broken rock swells by 1.3 to 1.7. The
/// surface is the highest debris above each point of a 0.25 m raster, averaged over cells of 1 m. Places where the structure still
/// stands are left out, and the debris that lies there with them. NaN without debris.
/// @param standing  m, outlines of live elements seen from above
double bulkingFactor(const std::vector<DebrisBox>& debris, const std::vector<Aabb>& standing, const SiteSurface& ground);

}  // namespace rubble
