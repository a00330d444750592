#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Particles as a mesh has them: cubes of their volume around their node, which move with it. Their corners stand behind the nodes
/// of the file, eight for each.
struct Particles {
    std::vector<std::int64_t> nodes;  ///< places of the nodes [particles]
    std::vector<double> halfEdges;    ///< file unit [particles]

    /// @param volume  file unit, positive
    void add(std::int64_t node, double volume);
    /// Appends the eight corners of every particle.
    void appendCorners(std::vector<Vec3>& positions) const;
    /// Appends the velocity of its node to every corner.
    void appendVelocities(std::vector<Vec3>& velocities) const;
    /// Appends the number of its node to every corner.
    void appendIds(std::vector<std::int64_t>& ids) const;
    /// Corners of particle p in a mesh whose file has `fileNodes` nodes.
    static std::vector<std::int64_t> cornersOf(std::size_t p, std::size_t fileNodes);
};

/// The space there is for each of some particles: their box, half a spacing larger on all sides, over their number; file unit.
double spacingVolume(const Aabb& bounds, std::size_t count);

}  // namespace rubble::io
