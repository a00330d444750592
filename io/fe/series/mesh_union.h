#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"

namespace rubble::io {

/// Where the nodes and elements of one mesh of a series stand in the union of all.
struct MeshEpoch {
    std::vector<std::uint32_t> nodes;     ///< position in the union; empty: the same positions
    std::vector<std::uint32_t> elements;  ///< position in the union; empty: the same positions
    std::size_t nodeCount = 0;
    std::size_t elementCount = 0;

    std::size_t node(std::size_t i) const { return nodes.empty() ? i : nodes[i]; }
    std::size_t element(std::size_t i) const { return elements.empty() ? i : elements[i]; }
};

/// Joins the meshes of a series, in the file's units. Elements are matched by kind and number, where the file has none by the
/// numbers of their nodes; nodes by number, where the file has none by position. A node keeps its first place, an element its first
/// nodes.
class MeshUnion {
public:
    explicit MeshUnion(std::string path) : m_path(std::move(path)) {}

    /// Adds the mesh of a state. Throws ParseError where it cannot be matched with those before; names the state.
    void add(const Mesh& mesh, std::size_t state);

    const std::vector<MeshEpoch>& epochs() const { return m_epochs; }
    std::size_t elementCount() const { return m_mesh.elementCount(); }
    /// The user's number of an element of the union, its place where the file has none.
    std::int64_t elementNumber(std::size_t e) const {
        return m_mesh.elementIds.empty() ? static_cast<std::int64_t>(e) + 1 : m_mesh.elementIds[e];
    }
    /// The union, checked and mended; to be called once, after the last mesh.
    Mesh finish(Findings& findings);

private:
    using Tuple = std::vector<std::uint32_t>;

    void addNodes(const Mesh& mesh, std::size_t state, MeshEpoch& epoch);
    void addElements(const Mesh& mesh, std::size_t state, MeshEpoch& epoch);
    std::uint32_t addElement(const Mesh& mesh, std::size_t e, const Tuple& corners);
    std::uint32_t partOf(const Part& part);
    Tuple cornersInUnion(const Mesh& mesh, std::size_t e, const MeshEpoch& epoch) const;
    void decideKey(const Mesh& mesh);

    std::string m_path;
    Mesh m_mesh;
    Findings m_findings;
    bool m_byNumber = true;
    std::unordered_map<std::int64_t, std::uint32_t> m_nodes;                    ///< by number
    std::array<std::unordered_map<std::int64_t, std::uint32_t>, 3> m_elements;  ///< solids, shells, beams by number
    std::map<Tuple, std::uint32_t> m_tuples;                                    ///< by sorted nodes
    std::vector<MeshEpoch> m_epochs;
};

}  // namespace rubble::io
