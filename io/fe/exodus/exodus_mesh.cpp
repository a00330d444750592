#include "io/fe/exodus/exodus_mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "io/fe/exodus/exodus_material.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/straight_edges.h"

namespace rubble::io {

namespace {

std::string nameOf(const ExodusBlock& block) {
    return block.name.empty() ? "block " + std::to_string(block.id) : block.name;
}

/// Builds the mesh block by block.
class MeshReader {
public:
    explicit MeshReader(const ExodusFile& file) : m_file(file), m_builder(file.path()) {}

    ExodusMesh read() {
        readNodes();
        m_elementNumbers = m_file.numbers(ExodusEntity::Element);
        for (std::size_t b = 0; b < m_file.blocks().size(); ++b) {
            readBlock(b);
        }
        m_result.first.push_back(m_builder.elementCount());
        m_straight.note(m_result.findings);
        m_result.mesh = m_builder.finish(m_result.findings);
        return std::move(m_result);
    }

private:
    void readNodes() {
        std::vector<Vec3> nodes(m_file.nodeCount(), Vec3::Zero());
        for (int axis = 0; axis < 3; ++axis) {
            const std::vector<double> values = m_file.coordinates(axis);
            for (std::size_t n = 0; n < values.size(); ++n) {
                nodes[n][axis] = values[n];
            }
        }
        m_places = nodes;
        m_builder.setNodes(m_file.numbers(ExodusEntity::Node), std::move(nodes));
    }

    std::uint32_t partOf(std::size_t b) {
        const ExodusBlock& block = m_file.blocks()[b];
        if (m_file.partsOfBlocks().empty()) {
            return m_builder.addPart(nameOf(block), block.id);
        }
        const std::int64_t number = m_file.partsOfBlocks()[b];
        const auto found = m_parts.find(number);
        return found != m_parts.end() ? found->second
                                      : m_parts.emplace(number, m_builder.addPart(nameOf(block), block.id)).first->second;
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
                                  nameOf(block) + " of type " + (block.topology.empty() ? "(none)" : block.topology) + " with " +
                                      englishInteger(block.nodesPerElement) + " nodes an element",
                                  block.elements);
            return;
        }
        m_result.blocks.push_back(b);
        m_result.first.push_back(m_builder.elementCount());
        const std::uint32_t part = partOf(b);
        const std::vector<std::int64_t> connectivity = m_file.connectivity(b);
        const auto corners = static_cast<std::size_t>(cornerCount(*shape));
        std::vector<std::int64_t> nodes(corners);
        for (std::size_t e = 0; e < static_cast<std::size_t>(block.elements); ++e) {
            const auto first = e * static_cast<std::size_t>(block.nodesPerElement);
            for (std::size_t c = 0; c < corners; ++c) {
                nodes[c] = std::max<std::int64_t>(connectivity[first + c], 0) - 1;
            }
            const std::int64_t number = m_elementNumbers[static_cast<std::size_t>(block.first) + e];
            m_builder.add(*shape, number, part, nodes, std::numeric_limits<double>::quiet_NaN());
            if (corners < static_cast<std::size_t>(block.nodesPerElement)) {
                const auto all = std::span(connectivity).subspan(first, static_cast<std::size_t>(block.nodesPerElement));
                m_straight.add(*shape, EdgeOrder::SidesBeforeTop, placesOf(all), "element " + englishInteger(number));
            }
        }
        readExodusMaterial(m_file, b, *shape, nameOf(block), m_result.first.back(), m_builder, m_result.findings);
    }

    std::vector<Vec3> placesOf(std::span<const std::int64_t> nodes) const {
        std::vector<Vec3> places;
        for (const std::int64_t node : nodes) {
            const bool there = node >= 1 && static_cast<std::size_t>(node) <= m_places.size();
            places.push_back(there ? m_places[static_cast<std::size_t>(node) - 1] : Vec3(Vec3::Constant(unknown)));
        }
        return places;
    }

    const ExodusFile& m_file;
    MeshBuilder m_builder;
    StraightEdges m_straight;
    std::vector<Vec3> m_places;  // of the nodes
    std::vector<std::int64_t> m_elementNumbers;
    std::map<std::int64_t, std::uint32_t> m_parts;  // by what the file says of its blocks
    ExodusMesh m_result;
};

}  // namespace

ExodusMesh readExodusMesh(const ExodusFile& file) {
    return MeshReader(file).read();
}

}  // namespace rubble::io
