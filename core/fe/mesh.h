#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"

namespace rubble {

/// Shape of an element by its corner nodes; node order as in Exodus II and VTK.
enum class ElementShape : std::uint8_t { Hexahedron, Wedge, Pyramid, Tetrahedron, Quadrilateral, Triangle, Beam };

/// Number of corner nodes: 8, 6, 5, 4, 4, 3, 2.
int cornerCount(ElementShape shape);
/// "hexahedron", "wedge", ...
std::string_view shapeName(ElementShape shape);
constexpr bool isShell(ElementShape shape) {
    return shape == ElementShape::Quadrilateral || shape == ElementShape::Triangle;
}
constexpr bool isSolid(ElementShape shape) {
    return shape < ElementShape::Quadrilateral;
}

/// One part of the structure as the file has it.
struct Part {
    std::string name;
    std::int64_t fileId = 0;  ///< block or part number in the file
};

/// Finite-element mesh at rest; immutable once read. Lengths in m, z up, relative to the case's local origin.
/// Per-element arrays all have elementCount() entries.
struct Mesh {
    std::vector<std::int64_t> nodeIds;     ///< user's node numbers [nodes]
    std::vector<Vec3> nodes;               ///< initial coordinates [nodes] m
    std::vector<std::int64_t> elementIds;  ///< user's element numbers [elements]
    std::vector<ElementShape> shapes;      ///< [elements]
    std::vector<std::uint32_t> part;       ///< index into parts [elements]
    std::vector<std::uint32_t> offsets;    ///< first corner in corners [elements + 1]
    std::vector<std::uint32_t> corners;    ///< node indices, corner nodes only (midside nodes are left out)
    std::vector<double> density;           ///< kg/m3, NaN where the file does not say [elements]
    std::vector<double> section;           ///< shells: thickness m; beams: area m2; NaN where unknown or not applicable [elements]
    std::vector<Part> parts;               ///< names are unique and not empty

    std::size_t nodeCount() const { return nodes.size(); }
    std::size_t elementCount() const { return shapes.size(); }
    std::span<const std::uint32_t> cornersOf(ElementIndex e) const {
        return {corners.data() + offsets[at(e)], offsets[at(e) + 1] - offsets[at(e)]};
    }
};

/// Corner lists (local, 0-based) of the outward-facing faces of a solid, or the one face of a shell; a beam has none.
/// Triangles have -1 as fourth entry.
std::span<const std::array<std::int8_t, 4>> facesOf(ElementShape shape);

}  // namespace rubble
