#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/trajectory/trajectory.h"

namespace rubble::io {

/// Faces of a thing in one material, m.
struct SurfacePart {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> corners;  ///< three a triangle, seen from outside
};

/// The outer faces of an island in the frame of its body, by component. Beams have none.
std::map<ComponentId, SurfacePart> islandSurface(const IslandRecord& island, const FeResult& fe,
                                                 const std::vector<ComponentId>& componentOf);

}  // namespace rubble::io
