#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/site/clouds/octree/cloud_octree.h"

namespace rubble::io {

/// Nodes of octrees that are seen together.
struct OctreeChoice {
    std::vector<std::size_t> nodes;  ///< parents before their children
    std::uint64_t points = 0;
    bool whole = true;  ///< no node was left out for the budget
};

/// The nodes that a view needs, the coarsest on the screen first: each is followed by those below it while its points lie more than
/// so many pixels apart, until the budget is spent. A parent is always there with its children.
/// @param pixels  of a node: how far apart its points lie on the screen; 0 or less: it is out of sight
/// @param finest  pixels
OctreeChoice chooseNodes(std::span<const OctreeNode> nodes, const std::function<double(std::size_t)>& pixels, std::uint64_t budget,
                         double finest = 1.0);

}  // namespace rubble::io
