#include "io/fe/series/mesh_union.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "io/fe/mesh_builder.h"

namespace rubble::io {

namespace {

std::size_t kindOf(ElementShape shape) {
    return isSolid(shape) ? 0 : isShell(shape) ? 1 : 2;
}

bool countsUp(const std::vector<std::uint32_t>& positions) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (positions[i] != i) {
            return false;
        }
    }
    return true;
}

std::uint32_t pieceOf(const std::vector<MeshPiece>& pieces, std::size_t node) {
    const auto piece = std::find_if(pieces.begin(), pieces.end(), [node](const MeshPiece& end) { return node < end.nodes; });
    return static_cast<std::uint32_t>(piece - pieces.begin());
}

}  // namespace

void MeshUnion::add(const Mesh& mesh, const std::vector<MeshPiece>& pieces, const std::vector<std::size_t>& cells,
                    std::size_t state) {
    const bool first = m_epochs.empty();
    if (first) {
        decideNumbers(mesh, cells);
        decideNodeNumbers(mesh, pieces);
        m_mesh.offsets.push_back(0);
    }
    MeshEpoch epoch;
    epoch.nodeCount = mesh.nodeCount();
    epoch.elementCount = mesh.elementCount();
    epoch.nodes = nodesByHint(mesh);
    std::vector<std::uint32_t> elements(mesh.elementCount(), none);
    const bool byPlaces = !first && hintsRefuted(mesh, epoch.nodes, state);
    if (byPlaces) {
        matchByPlaces(mesh, epoch, elements);
    }
    const std::size_t nodesBefore = m_mesh.nodeCount();
    const bool numbered = m_nodesNumbered && !mesh.nodeIds.empty();
    for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
        if (epoch.nodes[n] == none && numbered && !byPlaces) {
            // Pieces share nodes by their numbers.
            const auto known = m_nodes.find(mesh.nodeIds[n]);
            epoch.nodes[n] = known == m_nodes.end() ? none : known->second;
        }
        if (epoch.nodes[n] == none) {
            epoch.nodes[n] = addNode(mesh, n, pieces);
        }
        if (numbered) {
            m_nodes[mesh.nodeIds[n]] = epoch.nodes[n];
        }
    }
    if (!first && !byPlaces) {
        matchByNodes(mesh, state, nodesBefore, epoch, elements);
    }
    addElements(mesh, epoch, elements);
    epoch.elements = std::move(elements);
    if (countsUp(epoch.elements)) {
        epoch.elements = {};
    }
    if (countsUp(epoch.nodes)) {
        epoch.nodes = {};
    }
    m_epochs.push_back(std::move(epoch));
}

// Pieces of one cell have its number, which tells no piece; it is shared by right.
void MeshUnion::decideNumbers(const Mesh& mesh, const std::vector<std::size_t>& cells) {
    std::array<std::unordered_map<std::int64_t, std::size_t>, 3> owners;
    bool twice = false;
    m_byNumber = !mesh.elementIds.empty();
    for (std::size_t e = 0; !twice && e < mesh.elementIds.size(); ++e) {
        const auto [known, isNew] = owners[kindOf(mesh.shapes[e])].try_emplace(mesh.elementIds[e], e);
        m_byNumber = m_byNumber && isNew;
        twice = !isNew && (cells.empty() || cells[known->second] != cells[e]);
    }
    if (twice) {
        m_findings.add({"fe.number_twice", "Elements share a number; they were told apart by their nodes", {}},
                       {"fe.number_twice.remedy", "Let the analysis number its elements uniquely.", {}}, m_path);
    }
}

void MeshUnion::decideNodeNumbers(const Mesh& mesh, const std::vector<MeshPiece>& pieces) {
    m_nodesNumbered = !mesh.nodeIds.empty();
    const double tolerance = placeTolerance(mesh.nodes);
    std::unordered_map<std::int64_t, std::size_t> firstOf;
    for (std::size_t n = 0; m_nodesNumbered && n < mesh.nodeIds.size(); ++n) {
        const auto [known, isNew] = firstOf.try_emplace(mesh.nodeIds[n], n);
        if (isNew) {
            continue;
        }
        m_sharesNodes = m_sharesNodes || pieceOf(pieces, known->second) != pieceOf(pieces, n);
        if ((mesh.nodes[known->second] - mesh.nodes[n]).cwiseAbs().maxCoeff() > tolerance) {
            m_nodesNumbered = false;
            m_sharesNodes = false;
            m_findings.add({"fe.node_number_twice", "Node numbers stand for several places at once: they were not used", {}},
                           {"fe.node_number_twice.remedy", "Let each processor write the numbers of the whole model.", {}},
                           "node " + englishInteger(mesh.nodeIds[n]));
        }
    }
}

std::uint32_t MeshUnion::addNode(const Mesh& mesh, std::size_t n, const std::vector<MeshPiece>& pieces) {
    m_mesh.nodes.push_back(mesh.nodes[n]);
    if (m_nodesNumbered && !mesh.nodeIds.empty()) {
        m_mesh.nodeIds.push_back(mesh.nodeIds[n]);
    }
    m_pieceOfNode.push_back(pieces.empty() ? 0 : pieceOf(pieces, n));
    return static_cast<std::uint32_t>(m_mesh.nodes.size() - 1);
}

MeshUnion::Tuple MeshUnion::cornersIn(const Mesh& mesh, std::size_t e, const MeshEpoch& epoch) const {
    Tuple corners;
    for (const std::uint32_t corner : mesh.cornersOf(idAt<ElementIndex>(e))) {
        corners.push_back(static_cast<std::uint32_t>(epoch.node(corner)));
    }
    return corners;
}

void MeshUnion::addElements(const Mesh& mesh, const MeshEpoch& epoch, std::vector<std::uint32_t>& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
        if (elements[e] == none) {
            elements[e] = addElement(mesh, e, cornersIn(mesh, e, epoch));
        }
        if (m_byNumber && !mesh.elementIds.empty()) {
            m_elements[kindOf(mesh.shapes[e])][mesh.elementIds[e]] = elements[e];
        }
    }
}

std::uint32_t MeshUnion::elementByNumber(const Mesh& mesh, std::size_t e) const {
    if (!m_byNumber || mesh.elementIds.empty()) {
        return none;
    }
    const auto& table = m_elements[kindOf(mesh.shapes[e])];
    const auto found = table.find(mesh.elementIds[e]);
    return found == table.end() ? none : found->second;
}

void MeshUnion::joinNodes(const std::vector<std::uint32_t>& standsFor) {
    std::vector<std::uint32_t> place(standsFor.size(), 0);
    std::size_t kept = 0;
    for (std::size_t n = 0; n < standsFor.size(); ++n) {
        if (standsFor[n] != n) {
            place[n] = place[standsFor[n]];
            continue;
        }
        place[n] = static_cast<std::uint32_t>(kept);
        m_mesh.nodes[kept] = m_mesh.nodes[n];
        m_pieceOfNode[kept] = m_pieceOfNode[n];
        if (n < m_mesh.nodeIds.size()) {
            m_mesh.nodeIds[kept] = m_mesh.nodeIds[n];
        }
        ++kept;
    }
    m_mesh.nodes.resize(kept);
    m_pieceOfNode.resize(kept);
    m_mesh.nodeIds.resize(std::min(kept, m_mesh.nodeIds.size()));
    for (std::uint32_t& corner : m_mesh.corners) {
        corner = place[corner];
    }
    for (MeshEpoch& epoch : m_epochs) {
        std::vector<std::uint32_t> nodes(epoch.nodeCount);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            nodes[i] = place[epoch.node(i)];
        }
        epoch.nodes = std::move(nodes);
    }
}

std::uint32_t MeshUnion::addElement(const Mesh& mesh, std::size_t e, const Tuple& corners) {
    m_mesh.shapes.push_back(mesh.shapes[e]);
    m_mesh.part.push_back(partOf(mesh.parts[mesh.part[e]]));
    m_mesh.corners.insert(m_mesh.corners.end(), corners.begin(), corners.end());
    m_mesh.offsets.push_back(static_cast<std::uint32_t>(m_mesh.corners.size()));
    if (!mesh.elementIds.empty()) {
        m_mesh.elementIds.push_back(mesh.elementIds[e]);
    }
    m_mesh.density.push_back(mesh.density.empty() ? unknown : mesh.density[e]);
    m_mesh.section.push_back(mesh.section.empty() ? unknown : mesh.section[e]);
    return static_cast<std::uint32_t>(m_mesh.shapes.size() - 1);
}

std::uint32_t MeshUnion::partOf(const Part& part) {
    for (std::size_t p = 0; p < m_mesh.parts.size(); ++p) {
        if (m_mesh.parts[p].fileId == part.fileId && m_mesh.parts[p].name == part.name) {
            return static_cast<std::uint32_t>(p);
        }
    }
    m_mesh.parts.push_back(part);
    return static_cast<std::uint32_t>(m_mesh.parts.size() - 1);
}

Mesh MeshUnion::finish(Findings& findings) {
    findings.append(m_findings);
    MeshBuilder builder(m_path);
    for (std::size_t n = m_mesh.nodeIds.size(); n < m_mesh.nodes.size(); ++n) {
        m_mesh.nodeIds.push_back(static_cast<std::int64_t>(n) + 1);
    }
    builder.setNodes(std::move(m_mesh.nodeIds), std::move(m_mesh.nodes));
    for (const Part& part : m_mesh.parts) {
        builder.addPart(part.name, part.fileId);
    }
    for (std::size_t e = 0; e < m_mesh.elementCount(); ++e) {
        const std::span<const std::uint32_t> places = m_mesh.cornersOf(idAt<ElementIndex>(e));
        const std::vector<std::int64_t> corners(places.begin(), places.end());
        const double section = m_mesh.section[e] > 0.0 ? m_mesh.section[e] : unknown;
        const ElementShape shape = m_mesh.shapes[e];
        if (shape == ElementShape::Hexahedron) {
            builder.addSolid(elementNumber(e), m_mesh.part[e], corners);
        } else if (shape == ElementShape::Quadrilateral) {
            builder.addShell(elementNumber(e), m_mesh.part[e], corners, section);
        } else {
            builder.add(shape, elementNumber(e), m_mesh.part[e], corners, section);
        }
        if (m_mesh.density[e] > 0.0 && std::isfinite(m_mesh.density[e])) {
            builder.setDensity(e, m_mesh.density[e]);
        }
    }
    return builder.finish(findings);
}

}  // namespace rubble::io
