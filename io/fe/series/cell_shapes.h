#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/fe/mesh.h"

namespace rubble::io {

/// Shape of a VTK cell type; nothing for types that are no structure (vertices, polygons, polyhedra). Higher orders are known by
/// their corners, which come first.
std::optional<ElementShape> shapeOfVtkCell(int type);

/// Puts the corners of pixels (8) and voxels (11) into the order of quadrilaterals and hexahedra.
void orderVtkCorners(int type, std::vector<std::uint32_t>& corners);

}  // namespace rubble::io
