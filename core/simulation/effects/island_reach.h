#pragma once

#include <vector>

#include "core/fe/site_surface.h"
#include "core/simulation/effects/reach.h"

namespace rubble {

/// What is left of the structure when the FE result ends, as the effects meet it.
struct LiveReach {
    std::vector<Reach> released;  ///< of each loose island that is to be released; empty where they are held
    std::vector<Aabb> standing;   ///< m, of each island that is held or supported, at the last state
    Aabb site;                    ///< m, of all that is released
};

LiveReach liveReach(const EffectScene& scene, const SiteSurface& ground, const FallLimits& limits);

/// How deep the reach of a released island overlaps any of the boxes, m: the largest of the smallest overlaps along the axes;
/// negative where all stay clear of each other.
double deepestOverlap(const std::vector<Reach>& released, const std::vector<Aabb>& boxes);

}  // namespace rubble
