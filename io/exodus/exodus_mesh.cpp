#include "io/exodus/exodus_mesh.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/error.h"
#include "core/fe/components.h"
#include "io/exodus/exodus_material.h"
#include "io/exodus/exodus_names.h"

namespace rubble::io {

namespace {

std::string nodeText(const Mesh& mesh, std::size_t node) {
    return "node " + englishInteger(mesh.nodeIds[node]);
}

std::string blockText(const ExodusBlock& block) {
    return block.name.empty() ? "block " + std::to_string(block.id) : "block " + std::to_string(block.id) + " (" + block.name + ")";
}

/// Builds the mesh block by block.
class MeshReader {
public:
    MeshReader(const ExodusFile& file, const FrameTransform& frame) : m_file(file), m_frame(frame) {}

    ExodusMesh read() {
        readNodes();
        m_elementNumbers = m_file.numbers(ExodusEntity::Element);
        m_result.mesh.offsets.push_back(0);
        for (std::size_t b = 0; b < m_file.blocks().size(); ++b) {
            readBlock(b);
        }
        m_result.first.push_back(m_result.mesh.elementCount());
        requireElements();
        requirePlaces();
        turnReversed();
        readExodusMaterial(m_file, m_frame, m_result);
        return std::move(m_result);
    }

private:
    void readNodes() {
        Mesh& mesh = m_result.mesh;
        mesh.nodeIds = m_file.numbers(ExodusEntity::Node);
        mesh.nodes.assign(m_file.nodeCount(), Vec3::Zero());
        for (int axis = 0; axis < 3; ++axis) {
            const std::vector<double> values = m_file.coordinates(axis);
            for (std::size_t n = 0; n < values.size(); ++n) {
                mesh.nodes[n][axis] = values[n];
            }
        }
    }

    std::string uniqueName(const ExodusBlock& block) {
        std::string name = block.name.empty() ? "block " + std::to_string(block.id) : block.name;
        if (!m_names.insert(name).second) {
            m_result.findings.add({"exodus.name_twice", "Blocks share a name; their numbers were added to it", {}},
                                  {"exodus.name_twice.remedy", "Rename them by regrouping.", {}}, blockText(block));
            name += " (" + std::to_string(block.id) + ")";
            while (!m_names.insert(name).second) {
                name += "*";
            }
        }
        return name;
    }

    void readBlock(std::size_t b) {
        const ExodusBlock& block = m_file.blocks()[b];
        if (block.elements == 0) {
            return;
        }
        const auto shape = shapeOf(block.topology, block.nodesPerElement);
        if (!shape) {
            m_result.findings.add({"exodus.skipped_block", "Elements of a type that makes no fragment were left out", {}},
                                  {"exodus.skipped_block.remedy", "Nothing to do if they are masses, contacts or particles.", {}},
                                  blockText(block) + " of type " + (block.topology.empty() ? "(none)" : block.topology) + " with " +
                                      englishInteger(block.nodesPerElement) + " nodes an element",
                                  block.elements);
            return;
        }
        Mesh& mesh = m_result.mesh;
        m_result.blocks.push_back(b);
        m_result.first.push_back(mesh.elementCount());
        mesh.parts.push_back({uniqueName(block), block.id});
        const std::vector<std::int64_t> connectivity = m_file.connectivity(b);
        const auto corners = static_cast<std::size_t>(cornerCount(*shape));
        for (std::size_t e = 0; e < static_cast<std::size_t>(block.elements); ++e) {
            const std::size_t inFile = static_cast<std::size_t>(block.first) + e;
            const std::int64_t number = m_elementNumbers[inFile];
            for (std::size_t c = 0; c < corners; ++c) {
                const std::int64_t node = connectivity[e * static_cast<std::size_t>(block.nodesPerElement) + c];
                if (node < 1 || node > static_cast<std::int64_t>(mesh.nodeCount())) {
                    throw ParseError(
                        {"exodus.bad_node",
                         "{0}: element {1} of {2} uses node {3} of {4}",
                         {m_file.path(), number, blockText(block), node, mesh.nodeCount()}},
                        {"exodus.bad_node.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
                }
                mesh.corners.push_back(static_cast<std::uint32_t>(node - 1));
            }
            mesh.elementIds.push_back(number);
            mesh.shapes.push_back(*shape);
            mesh.part.push_back(static_cast<std::uint32_t>(mesh.parts.size() - 1));
            mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        }
        if (mesh.corners.size() > std::numeric_limits<std::uint32_t>::max()) {
            throw ParseError({"exodus.too_large", "{0} has more elements than can be held", {m_file.path()}},
                             {"exodus.too_large.remedy", "Give a part of the model.", {}});
        }
    }

    void requireElements() const {
        if (m_result.mesh.elementCount() == 0) {
            throw ParseError({"exodus.no_elements",
                              "{0} has no solids, shells or beams among its {1} blocks",
                              {m_file.path(), m_file.blocks().size()}},
                             {"exodus.no_elements.remedy", "Give an analysis whose structure is made of such elements.", {}});
        }
    }

    // Nodes of no element may lie anywhere; those without a finite place are put where they harm nobody.
    void requirePlaces() {
        Mesh& mesh = m_result.mesh;
        std::vector<bool> used(mesh.nodeCount(), false);
        for (const std::uint32_t node : mesh.corners) {
            used[node] = true;
        }
        const Vec3 harmless = m_frame.point(mesh.nodes[mesh.corners.front()]);
        for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
            Vec3& node = mesh.nodes[n];
            if (usableLength(node.x()) && usableLength(node.y()) && usableLength(node.z())) {
                node = m_frame.point(node);
                continue;
            }
            if (used[n]) {
                throw ParseError(
                    {"exodus.bad_coordinate",
                     "{0}: {1} lies at ({2}, {3}, {4})",
                     {m_file.path(), nodeText(mesh, n), node.x(), node.y(), node.z()}},
                    {"exodus.bad_coordinate.remedy", "Coordinates must be finite: let the analysis write the file again.", {}});
            }
            m_result.findings.add({"exodus.stray_node", "Nodes of no element have no finite place", {}},
                                  {"exodus.stray_node.remedy", "Nothing to do: they are not used.", {}}, nodeText(mesh, n));
            node = harmless;
        }
    }

    void turnReversed() {
        Mesh& mesh = m_result.mesh;
        std::vector<Vec3> x;
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            if (!isSolid(mesh.shapes[e])) {
                continue;
            }
            x.clear();
            for (const std::uint32_t node : mesh.cornersOf(idAt<ElementIndex>(e))) {
                x.push_back(mesh.nodes[node]);
            }
            if (elementVolume(mesh.shapes[e], x, 0.0) >= 0.0) {
                continue;
            }
            turn(mesh.shapes[e], mesh.corners.begin() + mesh.offsets[e]);
            m_result.findings.add({"exodus.reversed", "Solids were numbered inside out at rest; they were turned", {}},
                                  {"exodus.reversed.remedy", "Nothing to do if the elements look right.", {}},
                                  "element " + englishInteger(mesh.elementIds[e]) + " (" + mesh.parts[mesh.part[e]].name + ")");
        }
    }

    static void turn(ElementShape shape, std::vector<std::uint32_t>::iterator corner) {
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

    const ExodusFile& m_file;
    const FrameTransform& m_frame;
    std::vector<std::int64_t> m_elementNumbers;
    std::set<std::string> m_names;
    ExodusMesh m_result;
};

}  // namespace

ExodusMesh readExodusMesh(const ExodusFile& file, const FrameTransform& frame) {
    return MeshReader(file, frame).read();
}

}  // namespace rubble::io
