#include "core/fe/mesh.h"

#include <cassert>

namespace rubble {

namespace {

using Face = std::array<std::int8_t, 4>;

constexpr std::array<Face, 6> hexahedronFaces{{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
constexpr std::array<Face, 5> wedgeFaces{{{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
constexpr std::array<Face, 5> pyramidFaces{{{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}};
constexpr std::array<Face, 4> tetrahedronFaces{{{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}}};
constexpr std::array<Face, 1> quadrilateralFaces{{{0, 1, 2, 3}}};
constexpr std::array<Face, 1> triangleFaces{{{0, 1, 2, -1}}};

}  // namespace

int cornerCount(ElementShape shape) {
    constexpr std::array<int, 7> counts{8, 6, 5, 4, 4, 3, 2};
    return counts[static_cast<std::size_t>(shape)];
}

std::string_view shapeName(ElementShape shape) {
    constexpr std::array<std::string_view, 7> names{"hexahedron",    "wedge",    "pyramid", "tetrahedron",
                                                    "quadrilateral", "triangle", "beam"};
    return names[static_cast<std::size_t>(shape)];
}

std::span<const std::array<std::int8_t, 4>> facesOf(ElementShape shape) {
    switch (shape) {
        case ElementShape::Hexahedron:
            return hexahedronFaces;
        case ElementShape::Wedge:
            return wedgeFaces;
        case ElementShape::Pyramid:
            return pyramidFaces;
        case ElementShape::Tetrahedron:
            return tetrahedronFaces;
        case ElementShape::Quadrilateral:
            return quadrilateralFaces;
        case ElementShape::Triangle:
            return triangleFaces;
        case ElementShape::Beam:
            return {};
    }
    assert(false);
    return {};
}

}  // namespace rubble
