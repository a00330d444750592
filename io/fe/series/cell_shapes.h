#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/fe/mesh.h"

namespace rubble::io {

/// Shape of a VTK cell type; nothing for types that are no structure (vertices) or that piecesOfVtkCell() takes apart. Higher
/// orders, those of Lagrange and Bezier cells too, are known by their corners, which come first.
std::optional<ElementShape> shapeOfVtkCell(int type);

/// What people call a cell type: "Lagrange hexahedron"; the number of one that VTK does not have.
std::string nameOfVtkCell(int type);

/// A solid, shell or beam that a cell is made of; corners are places in the cell's list of points.
struct CellPiece {
    ElementShape shape = ElementShape::Hexahedron;
    std::vector<std::uint32_t> corners;
};

/// Whether cells of a type are taken apart by piecesOfVtkCell().
bool isTakenApart(int type);

/// Most points of a polyhedron that is taken apart.
inline constexpr std::size_t mostPolyhedronPoints = 64;

/// Takes apart a cell of a type without a shape: polylines into beams, polygons and strips into shells, prisms of five and six
/// sides into solids, polyhedra, as the convex body of their points, into the one solid that they are or into several. Empty for
/// other types and for bodies without volume. Pieces use the points of the cell, so its neighbours stay connected.
/// @param points  of the cell
std::vector<CellPiece> piecesOfVtkCell(int type, std::span<const Vec3> points);

/// Puts the corners of pixels (8) and voxels (11) into the order of quadrilaterals and hexahedra.
void orderVtkCorners(int type, std::vector<std::uint32_t>& corners);

}  // namespace rubble::io
