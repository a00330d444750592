#pragma once

#include <span>
#include <string>

#include "io/case/terrain_reader.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// All that stands around the structure of a case, with what checkPlace() finds: its terrain as openTerrainOfCase(), its
/// orthophotos (the first is used) and its meshes of surroundings. Where the case says so these raise the terrain; then one that
/// cannot be read is an error. Any other that cannot be read is a finding, for nothing rests on it. Throws as openTerrain(), and as
/// readSiteMesh() where debris is to fall on them.
TerrainInput openSiteOfCase(const Case& theCase, const std::string& casePath, const Mesh& fe, const Execution& execution);

/// Only what is drawn around the structure: orthophoto and meshes, without terrain. What cannot be read is a finding.
/// @param site     of the local frame, as a run had it
/// @param terrain  of the run, on which surroundings may stand however far off; null: none
TerrainInput openSurroundingsOfCase(Case theCase, const std::string& casePath, const Mesh& fe, const Frame& frame, const Site& site,
                                    const TerrainGrid* terrain, const Execution& execution);

/// A terrain raised by meshes as a run had it, with the offsets it put down. Throws as readSiteMesh().
std::shared_ptr<const TerrainGrid> raisedTerrain(const TerrainGrid& terrain, std::span<const RecordedInput> meshes,
                                                 const Frame& frame, const Site& site, const Execution& execution);

/// Puts down in a run how its local frame lies in the world, and the meshes that debris falls on.
void recordSite(RunOrigin& origin, const TerrainInput& input, const Site& site);

}  // namespace rubble::io
