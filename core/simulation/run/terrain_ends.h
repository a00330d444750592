#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/base/finding.h"
#include "core/base/geometry.h"
#include "core/fe/terrain_grid.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// Says of debris that came to lie where the terrain has no heights of its raster: how much of it, where, and which raster it
/// takes.
/// @param places   m, where each piece of debris is at the end; what is no number counts nowhere
/// @param nameOf   of the piece with that index, for the example
void addTerrainEnds(const TerrainGrid& terrain, std::span<const Vec3> places, const std::function<std::string(std::size_t)>& nameOf,
                    Findings& findings);

/// Says of debris that came to lie below a level of water that was left out, since what flies does not get there: it ran there.
/// @param level  m, of the water
void addWaterMissed(double level, std::span<const Vec3> places, const std::function<std::string(std::size_t)>& nameOf,
                    Findings& findings);

/// Tells of roughness: how high, how far apart and from which seed; or that it lies on nothing.
/// @param terrain  that carries debris; null: there is none
void addTerrainRoughness(const TerrainGrid* terrain, const EffectSettings& effects, Findings& findings);

}  // namespace rubble
