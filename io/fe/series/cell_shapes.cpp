#include "io/fe/series/cell_shapes.h"

#include <utility>

namespace rubble::io {

std::optional<ElementShape> shapeOfVtkCell(int type) {
    switch (type) {
        case 3:   // line
        case 21:  // quadratic edge
        case 35:  // cubic line
            return ElementShape::Beam;
        case 5:
        case 22:
        case 34:
            return ElementShape::Triangle;
        case 8:  // pixel
        case 9:
        case 23:
        case 28:
        case 30:
            return ElementShape::Quadrilateral;
        case 10:
        case 24:
            return ElementShape::Tetrahedron;
        case 11:  // voxel
        case 12:
        case 25:
        case 29:
        case 33:
            return ElementShape::Hexahedron;
        case 13:
        case 26:
        case 31:
        case 32:
            return ElementShape::Wedge;
        case 14:
        case 27:
        case 37:
            return ElementShape::Pyramid;
        default:
            return std::nullopt;
    }
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
