#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/fe/terrain_grid.h"

namespace rubble {

/// A surface of the surroundings in the local frame: a building, a wall, a bank.
struct SiteMesh {
    std::string name;
    std::vector<Vec3> points;                             ///< m
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of points
};

/// A terrain raised to the highest surface of meshes over each node: what falls meets roofs and walls as it meets the ground, and
/// nothing gets below an overhang. Cells are split evenly so that they are `cell` or less where that takes no more than `nodesMax`
/// nodes over the window about the structure, and as much around it is kept as they then allow. Where no mesh lies, the surface
/// stays as it was to rounding.
/// @param cell  m
std::shared_ptr<const TerrainGrid> terrainUnder(const TerrainGrid& terrain, const std::vector<SiteMesh>& meshes, double cell,
                                                double nodesMax, const Execution& execution);

}  // namespace rubble
