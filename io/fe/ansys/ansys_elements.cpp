#include "io/fe/ansys/ansys_elements.h"

namespace rubble::io {

std::optional<ElementShape> shapeOfAnsys(std::int64_t routine, std::size_t nodes) {
    switch (routine) {
        case 5:
        case 45:
        case 46:
        case 62:
        case 64:
        case 65:
        case 69:
        case 70:
        case 73:
        case 95:
        case 96:
        case 164:
        case 185:
        case 186:
        case 190:
        case 226:
            return nodes >= 8   ? std::optional(ElementShape::Hexahedron)
                   : nodes == 4 ? std::optional(ElementShape::Tetrahedron)
                                : std::nullopt;
        case 72:
        case 87:
        case 92:
        case 98:
        case 168:
        case 187:
        case 227:
        case 285:
        case 291:
            return ElementShape::Tetrahedron;
        case 28:
        case 41:
        case 43:
        case 63:
        case 91:
        case 93:
        case 99:
        case 143:
        case 163:
        case 181:
        case 281:
            return nodes == 3 ? ElementShape::Triangle : ElementShape::Quadrilateral;
        case 4:
        case 8:
        case 10:
        case 16:
        case 20:
        case 24:
        case 44:
        case 160:
        case 161:
        case 180:
        case 188:
        case 189:
        case 288:
        case 289:
        case 290:
            return ElementShape::Beam;
        default:
            return std::nullopt;
    }
}

}  // namespace rubble::io
