#include "io/fe/series/cell_shapes.h"

#include <array>
#include <string_view>
#include <utility>

namespace rubble::io {

std::optional<ElementShape> shapeOfVtkCell(int type) {
    switch (type) {
        case 3:   // line
        case 21:  // quadratic edge
        case 35:  // cubic line
        case 68:
        case 75:
            return ElementShape::Beam;
        case 5:
        case 22:
        case 34:
        case 69:
        case 76:
            return ElementShape::Triangle;
        case 8:  // pixel
        case 9:
        case 23:
        case 28:
        case 30:
        case 70:
        case 77:
            return ElementShape::Quadrilateral;
        case 10:
        case 24:
        case 71:
        case 78:
            return ElementShape::Tetrahedron;
        case 11:  // voxel
        case 12:
        case 25:
        case 29:
        case 33:
        case 72:
        case 79:
            return ElementShape::Hexahedron;
        case 13:
        case 26:
        case 31:
        case 32:
        case 73:
        case 80:
            return ElementShape::Wedge;
        case 14:
        case 27:
        case 37:
        case 74:
        case 81:
            return ElementShape::Pyramid;
        default:
            return std::nullopt;
    }
}

std::string nameOfVtkCell(int type) {
    constexpr std::array<std::string_view, 38> names{"empty cell",
                                                     "vertex",
                                                     "polyvertex",
                                                     "line",
                                                     "polyline",
                                                     "triangle",
                                                     "triangle strip",
                                                     "polygon",
                                                     "pixel",
                                                     "quadrilateral",
                                                     "tetrahedron",
                                                     "voxel",
                                                     "hexahedron",
                                                     "wedge",
                                                     "pyramid",
                                                     "pentagonal prism",
                                                     "hexagonal prism",
                                                     "",
                                                     "",
                                                     "",
                                                     "",
                                                     "quadratic edge",
                                                     "quadratic triangle",
                                                     "quadratic quadrilateral",
                                                     "quadratic tetrahedron",
                                                     "quadratic hexahedron",
                                                     "quadratic wedge",
                                                     "quadratic pyramid",
                                                     "biquadratic quadrilateral",
                                                     "triquadratic hexahedron",
                                                     "quadratic linear quadrilateral",
                                                     "quadratic linear wedge",
                                                     "biquadratic quadratic wedge",
                                                     "biquadratic quadratic hexahedron",
                                                     "biquadratic triangle",
                                                     "cubic line",
                                                     "quadratic polygon",
                                                     "triquadratic pyramid"};
    constexpr std::array<std::string_view, 7> orders{"curve",      "triangle", "quadrilateral", "tetrahedron",
                                                     "hexahedron", "wedge",    "pyramid"};
    constexpr int pointSet = 41, manyFaced = 42, lagrange = 68, bezier = 75, behind = 82;
    if (type == pointSet || type == manyFaced) {
        return type == manyFaced ? "polyhedron" : "convex set of points";
    }
    if (type >= lagrange && type < behind) {
        return (type < bezier ? "Lagrange " : "Bezier ") + std::string(orders[static_cast<std::size_t>(type - lagrange) % 7]);
    }
    const bool known = type >= 0 && static_cast<std::size_t>(type) < names.size() && !names[static_cast<std::size_t>(type)].empty();
    return known ? std::string(names[static_cast<std::size_t>(type)]) : "type " + std::to_string(type);
}

void orderVtkCorners(int type, std::vector<std::uint32_t>& corners) {
    if ((type == 8 || type == 11) && corners.size() >= 4) {
        std::swap(corners[2], corners[3]);
    }
    if (type == 11 && corners.size() >= 8) {
        std::swap(corners[6], corners[7]);
    }
}

}  // namespace rubble::io
