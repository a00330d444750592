#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/fe/terrain_grid.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/basics/colours.h"

namespace rubble::render {

/// A terrain as it is drawn: triangles over chosen rows and columns, fine around the model and coarse beyond, with the level that
/// goes on outside the raster.
struct Relief {
    std::vector<Vec3> points;
    std::vector<double> shade;  ///< [points] light on the slope over that on level ground
    std::vector<std::array<std::int32_t, 3>> triangles;
};

/// @param bounds  of the model, m
/// @param reach   how far from its centre the surface is drawn, m
Relief reliefOf(const TerrainGrid& terrain, const Aabb& bounds, double reach);

/// Where a ray first goes below the terrain, m along it; nothing if it does not.
/// @param reach  m along the ray at most
std::optional<double> meetTerrain(const TerrainGrid& terrain, const Ray& ray, double reach);

}  // namespace rubble::render
