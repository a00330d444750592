#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/finding.h"
#include "core/base/geometry.h"
#include "core/fe/mesh.h"

namespace rubble::io {

/// How a format orders the nodes on the edges, which follow the corners: those of the base, of the top and between them, or those
/// between base and top before those of the top.
enum class EdgeOrder : std::uint8_t { TopBeforeSides, SidesBeforeTop };

/// Counts what it costs that elements are known by their corners alone: nodes on the edges are left out, so curved edges become
/// straight.
class StraightEdges {
public:
    /// Takes an element by the places of all its nodes: corners, then those on the edges; others are passed over. A place that is
    /// no number is that of a node which the element does not have. Elements without nodes on the edges count nothing: those in
    /// the middle of faces and of the whole say nothing of edges. Where nodes stand elsewhere than on the middles of edges, it is
    /// not known how curved they are.
    /// @param name  of the element, in the finding
    void add(ElementShape shape, EdgeOrder order, std::span<const Vec3> nodes, const std::string& name);
    /// Adds a finding for solids, shells and beams whose size differs, each with the share that is lost or won;
    /// not again where it stands already.
    void note(Findings& findings) const;

private:
    struct Sum {
        std::int64_t curved = 0, unknown = 0;
        double straight = 0.0, whole = 0.0;
        double worst = 0.0;
        std::string example, unknownExample;
    };
    std::array<Sum, 3> m_sums;  ///< solids, shells, beams
};

/// Places of the nodes of an element by their numbers; no number for one that is not there, which a number of zero stands for.
/// @param places  of the numbers in the list of nodes
/// @param listed  m, the list of nodes
std::vector<Vec3> placesOfNodes(std::span<const std::int64_t> numbers,
                                const std::unordered_map<std::int64_t, std::uint32_t>& places, const std::vector<Vec3>& listed);

/// Puts the node between the two ends of a beam last: of three nodes, the two that lie farthest apart are the ends.
void putMiddleLast(std::array<std::int64_t, 3>& nodes, const std::array<Vec3, 3>& places);

}  // namespace rubble::io
