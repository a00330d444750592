#include "io/fe/opensees/mpco_classes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace rubble::io {

namespace {

bool nameHolds(const std::string& name, std::string_view word) {
    return name.find(word) != std::string::npos;
}

// The numbers that SRC/recorder/MPCORecorder.cpp of OpenSees gives to geometries.
std::optional<ElementShape> shapeOfGeometry(std::int64_t geometry) {
    switch (geometry) {
        case 1:
        case 2:
            return ElementShape::Beam;
        case 100:
        case 101:
            return ElementShape::Triangle;
        case 200:
        case 201:
        case 202:
        case 500:  // walls of macro-elements
            return ElementShape::Quadrilateral;
        case 300:
        case 301:
            return ElementShape::Tetrahedron;
        case 400:
        case 401:
        case 402:
            return ElementShape::Hexahedron;
        default:
            return std::nullopt;
    }
}

// Whether nodes lie near one plane, such as those of a warped shell.
bool nearlyPlane(std::span<const Vec3> nodes) {
    constexpr double warped = 0.1;  // of the largest extent
    const Vec3 normal = (nodes[1] - nodes[0]).cross(nodes[2] - nodes[0]);
    const double length = normal.norm();
    double away = 0.0, extent = 0.0;
    for (const Vec3& node : nodes) {
        away = std::max(away, length > 0.0 ? std::abs((node - nodes[0]).dot(normal)) / length : 0.0);
        extent = std::max(extent, (node - nodes[0]).norm());
    }
    return away <= warped * extent;
}

std::optional<ElementShape> shapeOfNodes(const std::string& className, std::span<const Vec3> nodes) {
    const bool shell = nameHolds(className, "Shell") || nameHolds(className, "Quad") || nameHolds(className, "MVLEM");
    switch (nodes.size()) {
        case 2:
            return ElementShape::Beam;
        case 3:
        case 6:
            return ElementShape::Triangle;
        case 4:
            return !nameHolds(className, "Tetra") && (shell || nearlyPlane(nodes)) ? ElementShape::Quadrilateral
                                                                                   : ElementShape::Tetrahedron;
        case 8:
            return !nameHolds(className, "Brick") && (shell || nearlyPlane(nodes)) ? ElementShape::Quadrilateral
                                                                                   : ElementShape::Hexahedron;
        case 9:
            return ElementShape::Quadrilateral;
        case 10:
            return ElementShape::Tetrahedron;
        case 20:
        case 27:
        case 28:
            return ElementShape::Hexahedron;
        default:
            return std::nullopt;
    }
}

}  // namespace

MpcoClass mpcoClass(const std::string& table) {
    MpcoClass result{0, table};
    const auto [end, error] = std::from_chars(table.data(), table.data() + table.size(), result.tag);
    const auto dash = static_cast<std::size_t>(end - table.data());
    if (error != std::errc{} || dash >= table.size() || table[dash] != '-') {
        return {0, table};
    }
    const std::size_t bracket = table.rfind('[');
    result.name = table.substr(dash + 1, bracket == std::string::npos || bracket <= dash ? std::string::npos : bracket - dash - 1);
    return result.name.empty() ? MpcoClass{0, table} : result;
}

bool isNoStructure(const std::string& className) {
    constexpr std::array<std::string_view, 12> words{"ZeroLength",  "Contact",  "SurfaceLoad", "AbsorbingBoundary",
                                                     "Lysmer",      "Embedded", "FSI",         "Impact",
                                                     "TwoNodeLink", "Actuator", "Adapter",     "PML"};
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return nameHolds(className, word); });
}

std::optional<ElementShape> mpcoShape(std::int64_t geometry, const std::string& className, std::span<const Vec3> nodes) {
    if (nodes.size() < 2) {
        return std::nullopt;
    }
    const std::optional<ElementShape> named = shapeOfGeometry(geometry);
    return named && nodes.size() >= static_cast<std::size_t>(cornerCount(*named)) ? named : shapeOfNodes(className, nodes);
}

}  // namespace rubble::io
