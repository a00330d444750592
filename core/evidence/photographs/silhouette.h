#pragma once

#include <cstdint>
#include <vector>

#include "core/evidence/photographs/site_picture.h"
#include "core/scenario/photograph.h"

namespace rubble {

/// Two silhouettes on one grid of pixels.
struct SilhouettePair {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> simulated;  ///< [height * width], 1: debris
    std::vector<std::uint8_t> observed;   ///< likewise, as drawn
    std::vector<std::uint8_t> left;       ///< 1: left out of the comparison
};

/// How far two silhouettes agree.
struct SilhouetteScore {
    double iou = 0.0;  ///< pixels in both over pixels in either; NaN if there are none
    double edgeDistance =
        0.0;  ///< px of the grid: mean distance from the edge of each to the nearest of the other; NaN without both
    std::int64_t simulated = 0;  ///< px of the grid that count
    std::int64_t observed = 0;
    std::int64_t both = 0;
};

/// Compares two silhouettes over the pixels that are not left out. Edges are pixels of a silhouette with a neighbour by side that
/// is outside of it; those that owe this to the rim of the picture or to what is left out do not count. Distances are exact
/// (Felzenszwalb & Huttenlocher 2012), and the mean is that of the two directions.
SilhouetteScore scoreOf(const SilhouettePair& pair);

/// What a photograph is said to show, on the grid of a picture of the site: the debris as drawn less what is none, and what is left
/// out. A pixel belongs to a polygon if its middle does.
SilhouettePair observedOn(const SitePicture& grid, const std::vector<PhotoMask>& masks);

/// The simulated debris as a picture shows it.
/// @param withFallen  whether fallen live structure is debris; else it hides what is behind it
std::vector<std::uint8_t> debrisIn(const SitePicture& picture, bool withFallen);

/// Outlines of a silhouette along the sides of its pixels: rings of corners in px of the photograph, holes too.
std::vector<std::vector<Eigen::Vector2d>> outlinesOf(const SitePicture& grid, const std::vector<std::uint8_t>& silhouette);

}  // namespace rubble
