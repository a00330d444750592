#include "io/fe/mesh_builder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "core/fe/components.h"
#include "core/fe/material.h"

namespace rubble::io {

namespace {

/// A shape and its corners.
struct Cell {
    ElementShape shape = ElementShape::Hexahedron;
    std::vector<std::int64_t> corners;
};

bool allDistinct(std::span<const std::int64_t> corners) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
        if (std::find(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(i), corners[i]) !=
            corners.begin() + static_cast<std::ptrdiff_t>(i)) {
            return false;
        }
    }
    return true;
}

std::vector<std::int64_t> distinct(std::span<const std::int64_t> corners) {
    std::vector<std::int64_t> list;
    for (const std::int64_t corner : corners) {
        if (std::find(list.begin(), list.end(), corner) == list.end()) {
            list.push_back(corner);
        }
    }
    return list;
}

// Distinct corners of the six faces of a hexahedron, each in the order of the face.
std::vector<std::vector<std::int64_t>> facesOfHexahedron(std::span<const std::int64_t> corners) {
    std::vector<std::vector<std::int64_t>> faces;
    for (const auto& face : facesOf(ElementShape::Hexahedron)) {
        std::array<std::int64_t, 4> nodes{};
        for (std::size_t i = 0; i < 4; ++i) {
            nodes[i] = corners[static_cast<std::size_t>(face[i])];
        }
        faces.push_back(distinct(nodes));
    }
    return faces;
}

bool contains(const std::vector<std::int64_t>& list, std::int64_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

// A pyramid has one face of four corners; the fifth is its apex.
std::optional<Cell> asPyramid(std::span<const std::int64_t> corners, const std::vector<std::int64_t>& nodes) {
    for (const std::vector<std::int64_t>& face : facesOfHexahedron(corners)) {
        if (face.size() == 4) {
            Cell cell{ElementShape::Pyramid, face};
            for (const std::int64_t node : nodes) {
                if (!contains(face, node)) {
                    cell.corners.push_back(node);
                }
            }
            return cell;
        }
    }
    return std::nullopt;
}

// Whether an edge of the hexahedron joins two nodes, one of each.
bool joined(std::span<const std::int64_t> corners, std::int64_t a, std::int64_t b) {
    constexpr std::array<std::array<std::size_t, 2>, 12> edges{
        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    return std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
        const std::int64_t from = corners[edge[0]], to = corners[edge[1]];
        return (from == a && to == b) || (from == b && to == a);
    });
}

// A wedge has two triangles without a common node; edges join them one to one.
std::optional<Cell> asWedge(std::span<const std::int64_t> corners) {
    std::vector<std::vector<std::int64_t>> triangles;
    for (std::vector<std::int64_t>& face : facesOfHexahedron(corners)) {
        if (face.size() == 3) {
            triangles.push_back(std::move(face));
        }
    }
    if (triangles.size() != 2) {
        return std::nullopt;
    }
    Cell cell{ElementShape::Wedge, triangles.front()};
    for (const std::int64_t a : triangles.front()) {
        for (const std::int64_t b : triangles.back()) {
            if (a != b && joined(corners, a, b)) {
                cell.corners.push_back(b);
                break;
            }
        }
    }
    const bool whole = cell.corners.size() == 6 && distinct(cell.corners).size() == 6;
    return whole ? std::optional(cell) : std::nullopt;
}

Cell solidOf(std::span<const std::int64_t> corners) {
    const std::vector<std::int64_t> nodes = distinct(corners);
    std::optional<Cell> cell;
    if (nodes.size() == 4) {
        cell = Cell{ElementShape::Tetrahedron, nodes};
    } else if (nodes.size() == 5) {
        cell = asPyramid(corners, nodes);
    } else if (nodes.size() == 6) {
        cell = asWedge(corners);
    }
    return cell ? *cell : Cell{ElementShape::Hexahedron, {corners.begin(), corners.end()}};
}

void turn(ElementShape shape, std::vector<std::uint32_t>::iterator corner) {
    switch (shape) {
        case ElementShape::Hexahedron:
            std::swap_ranges(corner, corner + 4, corner + 4);
            break;
        case ElementShape::Wedge:
            std::swap_ranges(corner, corner + 3, corner + 3);
            break;
        default:  // pyramid and tetrahedron: the base the other way round
            std::swap(corner[1], corner[shape == ElementShape::Pyramid ? 3 : 2]);
            break;
    }
}

}  // namespace

MeshBuilder::MeshBuilder(std::string path) : m_path(std::move(path)) {
    m_mesh.offsets.push_back(0);
}

void MeshBuilder::setNodes(std::vector<std::int64_t> ids, std::vector<Vec3> places) {
    assert(ids.size() == places.size() && !m_places);
    m_mesh.nodeIds = std::move(ids);
    m_mesh.nodes = std::move(places);
    m_places = true;
}

std::uint32_t MeshBuilder::addPart(std::string name, std::int64_t fileId) {
    if (name.empty()) {
        name = "part " + std::to_string(fileId);
    }
    if (!m_names.insert(name).second) {
        m_findings.add({"fe.name_twice", "Parts share a name; their numbers were added to it", {}},
                       {"fe.name_twice.remedy", "Rename them by regrouping.", {}}, name);
        name += " (" + std::to_string(fileId) + ")";
        while (!m_names.insert(name).second) {
            name += "*";
        }
    }
    m_mesh.parts.push_back({std::move(name), fileId});
    return static_cast<std::uint32_t>(m_mesh.parts.size() - 1);
}

void MeshBuilder::addSolid(std::int64_t id, std::uint32_t part, std::span<const std::int64_t> corners) {
    assert(corners.size() == 8);
    if (allDistinct(corners)) {
        add(ElementShape::Hexahedron, id, part, corners, unknown);
        return;
    }
    const Cell cell = solidOf(corners);
    add(cell.shape, id, part, cell.corners, unknown);
}

void MeshBuilder::addShell(std::int64_t id, std::uint32_t part, std::span<const std::int64_t> corners, double thickness) {
    assert(corners.size() == 4);
    const std::vector<std::int64_t> nodes = distinct(corners);
    if (nodes.size() == 3) {
        add(ElementShape::Triangle, id, part, nodes, thickness);
    } else {
        add(ElementShape::Quadrilateral, id, part, corners, thickness);
    }
}

void MeshBuilder::addBeam(std::int64_t id, std::uint32_t part, std::span<const std::int64_t> corners, double area) {
    add(ElementShape::Beam, id, part, corners, area);
}

void MeshBuilder::add(ElementShape shape, std::int64_t id, std::uint32_t part, std::span<const std::int64_t> corners,
                      double section) {
    assert(corners.size() == static_cast<std::size_t>(cornerCount(shape)) && part < m_mesh.parts.size());
    for (const std::int64_t node : corners) {
        if (node < 0 || node >= static_cast<std::int64_t>(nodeCount())) {
            throw ParseError({"fe.bad_node",
                              "{0}: element {1} of \"{2}\" uses the node at place {3} of {4}",
                              {m_path, id, m_mesh.parts[part].name, node + 1, nodeCount()}},
                             {"fe.bad_node.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
        }
        m_mesh.corners.push_back(static_cast<std::uint32_t>(node));
    }
    if (m_mesh.corners.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw ParseError({"fe.too_large", "{0} has more elements than can be held", {m_path}},
                         {"fe.too_large.remedy", "Give a part of the model.", {}});
    }
    m_mesh.elementIds.push_back(id);
    m_mesh.shapes.push_back(shape);
    m_mesh.part.push_back(part);
    m_mesh.offsets.push_back(static_cast<std::uint32_t>(m_mesh.corners.size()));
    m_mesh.density.push_back(unknown);
    m_mesh.section.push_back(isSolid(shape) ? unknown : section);
}

void MeshBuilder::setDensity(std::size_t element, double density) {
    m_mesh.density[element] = density;
}

void MeshBuilder::setSection(std::size_t element, double section) {
    m_mesh.section[element] = isSolid(m_mesh.shapes[element]) ? unknown : section;
}

std::vector<Vec3> MeshBuilder::cornersOf(std::size_t element) const {
    std::vector<Vec3> corners;
    for (const std::uint32_t node : m_mesh.cornersOf(idAt<ElementIndex>(element))) {
        corners.push_back(m_mesh.nodes[node]);
    }
    return corners;
}

Mesh MeshBuilder::finish(Findings& findings) {
    if (m_mesh.elementCount() == 0) {
        throw ParseError({"fe.no_elements", "{0} has no solids, shells or beams", {m_path}},
                         {"fe.no_elements.remedy", "Give an analysis whose structure is made of such elements.", {}});
    }
    requirePlaces(m_findings);
    turnReversed(m_findings);
    dropEmptyParts();
    findings.append(m_findings);
    return std::move(m_mesh);
}

// Nodes of no element may lie anywhere; those without a finite place are put where they harm nobody.
void MeshBuilder::requirePlaces(Findings& findings) {
    std::vector<bool> used(nodeCount(), false);
    for (const std::uint32_t node : m_mesh.corners) {
        used[node] = true;
    }
    const Vec3 harmless = m_mesh.nodes[m_mesh.corners.front()];
    for (std::size_t n = 0; n < nodeCount(); ++n) {
        Vec3& node = m_mesh.nodes[n];
        if (usablePlace(node)) {
            continue;
        }
        const std::string name = "node " + englishInteger(m_mesh.nodeIds[n]);
        if (used[n]) {
            throw ParseError(
                {"fe.bad_coordinate", "{0}: {1} lies at ({2}, {3}, {4})", {m_path, name, node.x(), node.y(), node.z()}},
                {"fe.bad_coordinate.remedy", "Coordinates must be finite: let the analysis write the file again.", {}});
        }
        findings.add({"fe.stray_node", "Nodes of no element have no finite place", {}},
                     {"fe.stray_node.remedy", "Nothing to do: they are not used.", {}}, name);
        node = harmless;
    }
}

void MeshBuilder::turnReversed(Findings& findings) {
    std::vector<Vec3> corners;
    for (std::size_t e = 0; e < m_mesh.elementCount(); ++e) {
        if (!isSolid(m_mesh.shapes[e])) {
            continue;
        }
        corners.clear();
        for (const std::uint32_t node : m_mesh.cornersOf(idAt<ElementIndex>(e))) {
            corners.push_back(m_mesh.nodes[node]);
        }
        if (elementVolume(m_mesh.shapes[e], corners, 0.0) >= 0.0) {
            continue;
        }
        turn(m_mesh.shapes[e], m_mesh.corners.begin() + m_mesh.offsets[e]);
        findings.add({"fe.reversed", "Solids were numbered inside out at rest; they were turned", {}},
                     {"fe.reversed.remedy", "Nothing to do if the elements look right.", {}},
                     "element " + englishInteger(m_mesh.elementIds[e]) + " (" + m_mesh.parts[m_mesh.part[e]].name + ")");
    }
}

void MeshBuilder::dropEmptyParts() {
    std::vector<std::uint32_t> place(m_mesh.parts.size(), 0);
    for (const std::uint32_t part : m_mesh.part) {
        place[part] = 1;
    }
    std::vector<Part> kept;
    for (std::size_t p = 0; p < place.size(); ++p) {
        if (place[p] != 0) {
            place[p] = static_cast<std::uint32_t>(kept.size());
            kept.push_back(std::move(m_mesh.parts[p]));
        }
    }
    m_mesh.parts = std::move(kept);
    for (std::uint32_t& part : m_mesh.part) {
        part = place[part];
    }
}

bool usableLength(double value) {
    return std::abs(value) < 1e9;
}

double densityInSi(double value, double metresPerUnit, Findings& findings, const std::string& part) {
    const bool metric = std::abs(metresPerUnit - 0.001) < 1e-9 || std::abs(metresPerUnit - 0.01) < 1e-9;
    if (!metric || !(value > 0.0)) {
        return value;
    }
    // From expanded plastics to gold; a factor of 1,000 lies between the units, so at most one of them fits.
    for (const double kilograms : {1000.0, 1.0, 0.001}) {
        const double density = value * kilograms / (metresPerUnit * metresPerUnit * metresPerUnit);
        if (isMaterialDensity(density)) {
            findings.add({"fe.density_unit", "The unit of mass was taken from the densities: t, kg or g per cubed length unit", {}},
                         {"fe.density_unit.remedy", "Check the masses, or set component[NAME].density.", {}},
                         "\"" + part + "\": " + englishNumber(value) + " is " + englishNumber(density) + " kg/m3");
            return density;
        }
    }
    return value;
}

}  // namespace rubble::io
