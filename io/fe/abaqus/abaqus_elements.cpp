#include "io/fe/abaqus/abaqus_elements.h"

#include <array>
#include <string>

#include "io/fe/series/byte_window.h"

namespace rubble::io {

namespace {

struct Family {
    std::string_view prefix;
    ElementShape shape;
};

// Longer prefixes first: C3D10 is a tetrahedron, C3D15 a wedge.
constexpr std::array<Family, 32> families{
    {{"C3D10", ElementShape::Tetrahedron},  {"C3D15", ElementShape::Wedge},       {"C3D20", ElementShape::Hexahedron},
     {"C3D27", ElementShape::Hexahedron},   {"C3D4", ElementShape::Tetrahedron},  {"C3D5", ElementShape::Pyramid},
     {"C3D6", ElementShape::Wedge},         {"C3D8", ElementShape::Hexahedron},   {"CSS8", ElementShape::Hexahedron},
     {"SC6", ElementShape::Wedge},          {"SC8", ElementShape::Hexahedron},    {"DC3D8", ElementShape::Hexahedron},
     {"M3D3", ElementShape::Triangle},      {"M3D6", ElementShape::Triangle},     {"M3D4", ElementShape::Quadrilateral},
     {"M3D8", ElementShape::Quadrilateral}, {"STRI", ElementShape::Triangle},     {"S3", ElementShape::Triangle},
     {"S6", ElementShape::Triangle},        {"S4", ElementShape::Quadrilateral},  {"S8", ElementShape::Quadrilateral},
     {"S9", ElementShape::Quadrilateral},   {"DS4", ElementShape::Quadrilateral}, {"B31", ElementShape::Beam},
     {"B32", ElementShape::Beam},           {"B33", ElementShape::Beam},          {"T3D2", ElementShape::Beam},
     {"T3D3", ElementShape::Beam},          {"PIPE31", ElementShape::Beam},       {"PIPE32", ElementShape::Beam},
     {"FRAME3D", ElementShape::Beam},       {"ELBOW31", ElementShape::Beam}}};

}  // namespace

std::optional<ElementShape> shapeOfAbaqus(std::string_view type) {
    const std::string name = upperCase(std::string(type));
    for (const Family& family : families) {
        if (name.starts_with(family.prefix)) {
            return family.shape;
        }
    }
    return std::nullopt;
}

bool isFlatAbaqus(std::string_view type) {
    const std::string name = upperCase(std::string(type));
    return name.starts_with("CPE") || name.starts_with("CPS") || name.starts_with("CAX") || name.starts_with("CGAX");
}

}  // namespace rubble::io
