#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/mesh.h"

namespace rubble::io {

/// Points of a series that were joined into one mesh, and what is known of them.
struct WrittenPoints {
    const Mesh& mesh;                               ///< as it lies in the files
    const std::vector<std::uint32_t>& pieceOfNode;  ///< [nodes]
    bool numbered = false;                          ///< nodes have numbers that hold in all pieces
    bool sharedByNumber = false;                    ///< some numbers stand in several pieces: they say what is one node
    std::size_t states = 0;
    /// Places of the nodes at a state [nodes]; what is no number is not there.
    std::function<std::vector<Vec3>(std::size_t)> placesAt;
};

/// Points that pieces or cells repeat although they are one node: those at one place at every state, in different pieces; in a grid
/// without numbers whose cells share no point at all, in different cells. Surfaces in contact and cracks that part at some state
/// stay apart. Other points that lie at one place without being joined are counted.
/// @return  of each node the one that stands for it, none behind it; empty: there are none. Throws as placesAt does, Cancelled.
std::vector<std::uint32_t> doubledPoints(const WrittenPoints& points, const Execution& execution, Findings& findings);

}  // namespace rubble::io
