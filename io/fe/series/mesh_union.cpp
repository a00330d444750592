#include "io/fe/series/mesh_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

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

}  // namespace

void MeshUnion::add(const Mesh& mesh, std::size_t state) {
    MeshEpoch epoch;
    epoch.nodeCount = mesh.nodeCount();
    epoch.elementCount = mesh.elementCount();
    if (m_epochs.empty()) {
        decideKey(mesh);
        m_mesh.offsets.push_back(0);
    }
    addNodes(mesh, state, epoch);
    addElements(mesh, state, epoch);
    m_epochs.push_back(std::move(epoch));
}

void MeshUnion::decideKey(const Mesh& mesh) {
    std::array<std::unordered_set<std::int64_t>, 3> seen;
    m_byNumber = !mesh.elementIds.empty();
    for (std::size_t e = 0; m_byNumber && e < mesh.elementCount(); ++e) {
        m_byNumber = seen[kindOf(mesh.shapes[e])].insert(mesh.elementIds[e]).second;
    }
    if (!mesh.elementIds.empty() && !m_byNumber) {
        m_findings.add({"fe.number_twice", "Elements share a number; they were told apart by their nodes", {}},
                       {"fe.number_twice.remedy", "Let the analysis number its elements uniquely.", {}}, m_path);
    }
}

void MeshUnion::addNodes(const Mesh& mesh, std::size_t state, MeshEpoch& epoch) {
    const bool numbered = !mesh.nodeIds.empty();
    if (!numbered && !m_epochs.empty() && mesh.nodeCount() != m_mesh.nodeCount()) {
        throw ParseError({"fe.unnumbered_nodes",
                          "{0}: state {1} has {2} nodes instead of {3}, and no numbers that say which",
                          {m_path, state, mesh.nodeCount(), m_mesh.nodeCount()}},
                         {"fe.unnumbered_nodes.remedy",
                          "Write the series with node numbers (point data NODE_ID or GlobalNodeId), or keep all points.",
                          {}});
    }
    epoch.nodes.resize(mesh.nodeCount());
    for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
        const auto next = static_cast<std::uint32_t>(m_mesh.nodes.size());
        if (!numbered) {
            epoch.nodes[n] = static_cast<std::uint32_t>(n);
        } else {
            epoch.nodes[n] = m_nodes.try_emplace(mesh.nodeIds[n], next).first->second;
        }
        if (epoch.nodes[n] == next) {
            m_mesh.nodes.push_back(mesh.nodes[n]);
            if (numbered) {
                m_mesh.nodeIds.push_back(mesh.nodeIds[n]);
            }
        }
    }
    if (countsUp(epoch.nodes)) {
        epoch.nodes = {};
    }
}

MeshUnion::Tuple MeshUnion::cornersInUnion(const Mesh& mesh, std::size_t e, const MeshEpoch& epoch) const {
    Tuple corners;
    for (const std::uint32_t corner : mesh.cornersOf(idAt<ElementIndex>(e))) {
        corners.push_back(static_cast<std::uint32_t>(epoch.node(corner)));
    }
    return corners;
}

void MeshUnion::addElements(const Mesh& mesh, std::size_t state, MeshEpoch& epoch) {
    epoch.elements.resize(mesh.elementCount());
    std::vector<bool> here(m_mesh.elementCount() + mesh.elementCount(), false);
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const Tuple corners = cornersInUnion(mesh, e, epoch);
        const auto next = static_cast<std::uint32_t>(m_mesh.elementCount());
        std::uint32_t position = next;
        if (m_byNumber && !mesh.elementIds.empty()) {
            position = m_elements[kindOf(mesh.shapes[e])].try_emplace(mesh.elementIds[e], next).first->second;
        } else {
            Tuple key = corners;
            std::sort(key.begin(), key.end());
            position = m_tuples.try_emplace(std::move(key), next).first->second;
        }
        if (here[position] && !m_epochs.empty()) {
            throw ParseError(
                {"fe.element_twice", "{0}: two elements of state {1} cannot be told apart (entry {2})", {m_path, state, e}},
                {"fe.element_twice.remedy", "Write the series with a unique number for every element.", {}});
        }
        if (here[position]) {
            position =
                next;  // in the first mesh twins may stay: the same order tells them apart as long as the mesh does not change
        }
        here[position] = true;
        if (position == next) {
            addElement(mesh, e, corners);
        }
        epoch.elements[e] = position;
    }
    if (countsUp(epoch.elements)) {
        epoch.elements = {};
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
