#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/pieces/place_index.h"
#include "io/fe/series/mesh_series.h"

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

/// Joins the meshes of a series, in the file's units. An element is what its nodes and its shape say. Numbers of elements and
/// nodes, and places in a list of points, are hints: a number whose nodes are others than before is another element; a node whose
/// number or place in the list stands for another place, while the points keep their places, is the node at that place. Both are
/// counted. A node keeps its first place, an element its first nodes.
class MeshUnion {
public:
    /// @param timed  whether somebody says when the states are; else a mesh of other points is no later state of the first
    MeshUnion(std::string path, bool timed) : m_path(std::move(path)), m_timed(timed) {}

    /// Adds the mesh of a state. Throws ParseError where it cannot be matched with those before; names the state.
    /// @param cells  see SeriesStep
    void add(const Mesh& mesh, const std::vector<MeshPiece>& pieces, const std::vector<std::size_t>& cells, std::size_t state);

    const std::vector<MeshEpoch>& epochs() const { return m_epochs; }
    std::size_t elementCount() const { return m_mesh.elementCount(); }
    /// The user's number of an element of the union, its place where the file has none.
    std::int64_t elementNumber(std::size_t e) const {
        return m_mesh.elementIds.empty() ? static_cast<std::int64_t>(e) + 1 : m_mesh.elementIds[e];
    }
    /// True where the number of an element does not stay with it.
    bool renumbered() const { return m_renumbered; }
    /// What has been joined so far, as it lies in the files.
    const Mesh& mesh() const { return m_mesh; }
    /// Piece of the first mesh that each node was written in.
    const std::vector<std::uint32_t>& pieceOfNode() const { return m_pieceOfNode; }
    bool numbersNodes() const { return m_nodesNumbered; }
    /// True where pieces share nodes by their numbers.
    bool sharesNodes() const { return m_sharesNodes; }
    /// Takes several nodes for one. @param standsFor  of each node the one that stands for it, none behind it
    void joinNodes(const std::vector<std::uint32_t>& standsFor);
    /// The union, checked and mended; to be called once, after the last mesh.
    Mesh finish(Findings& findings);

private:
    using Tuple = std::vector<std::uint32_t>;
    using Twins = std::vector<std::uint32_t>;
    static constexpr std::uint32_t none = PlaceIndex::nowhere;

    void decideNumbers(const Mesh& mesh, const std::vector<std::size_t>& cells);
    void decideNodeNumbers(const Mesh& mesh, const std::vector<MeshPiece>& pieces);
    std::uint32_t addNode(const Mesh& mesh, std::size_t n, const std::vector<MeshPiece>& pieces);
    std::uint32_t addElement(const Mesh& mesh, std::size_t e, const Tuple& corners);
    std::uint32_t partOf(const Part& part);

    void addElements(const Mesh& mesh, const MeshEpoch& epoch, std::vector<std::uint32_t>& elements);
    std::uint32_t elementByNumber(const Mesh& mesh, std::size_t e) const;
    Tuple cornersIn(const Mesh& mesh, std::size_t e, const MeshEpoch& epoch) const;

    std::vector<std::uint32_t> nodesByHint(const Mesh& mesh) const;
    bool hintsRefuted(const Mesh& mesh, const std::vector<std::uint32_t>& hints, std::size_t state);
    void requirePlaces(const Mesh& mesh, std::size_t state);
    void indexPlaces();
    std::size_t countElsewhere(const Mesh& mesh, const std::vector<std::size_t>& nodes, const std::vector<bool>& kept) const;
    void matchByNodes(const Mesh& mesh, std::size_t state, std::size_t nodesBefore, const MeshEpoch& epoch,
                      std::vector<std::uint32_t>& elements);
    void matchByPlaces(const Mesh& mesh, MeshEpoch& epoch, std::vector<std::uint32_t>& elements);
    void matchNodesAtPlaces(const Mesh& mesh, const std::vector<std::uint32_t>& elements, const std::vector<std::uint32_t>& places,
                            MeshEpoch& epoch) const;
    bool hasSplit(const Mesh& mesh, std::size_t e, const Tuple& corners, std::uint32_t known, std::size_t nodesBefore) const;
    void noteRenumbered(const Mesh& mesh, std::size_t e, std::uint32_t element);
    void noteReused(const Mesh& mesh, std::size_t state, const std::vector<std::uint32_t>& elements);
    Tuple sortedCorners(std::uint32_t element, bool places) const;
    const std::map<Tuple, Twins>& sorted(bool places);

    std::string m_path;
    bool m_timed;
    Mesh m_mesh;
    Findings m_findings;
    bool m_byNumber = true, m_nodesNumbered = false, m_sharesNodes = false, m_renumbered = false;
    std::vector<std::uint32_t> m_pieceOfNode;
    std::unordered_map<std::int64_t, std::uint32_t> m_nodes;                    ///< by number, as it was used last
    std::array<std::unordered_map<std::int64_t, std::uint32_t>, 3> m_elements;  ///< solids, shells, beams by number
    std::array<std::map<Tuple, Twins>, 2> m_sorted;                             ///< elements by sorted nodes and by places
    std::array<std::size_t, 2> m_sortedDone{};                                  ///< how many of them are in there
    std::optional<PlaceIndex> m_places;
    std::vector<std::uint32_t> m_placeOf;  ///< the node that stands for the first place of each node
    std::vector<MeshEpoch> m_epochs;
};

}  // namespace rubble::io
