#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/fe/mesh.h"
#include "core/trajectory/trajectory.h"

namespace rubble::render {

/// Released islands of live structure as drawn: their nodes ride on the bodies that carry them. Islands share no nodes.
class IslandMotion {
public:
    static constexpr std::uint32_t none = 0xffffffffu;

    /// Learns which nodes ride on which body; to be called again when a run has grown. Islands that name what does not exist are
    /// left out.
    void bind(const Mesh& mesh, std::span<const IslandRecord> islands, std::span<const BodyRecord> bodies);

    bool empty() const { return m_islands.empty(); }
    /// s, when they are released; all at once.
    double from() const { return m_from; }
    /// Of all islands.
    std::size_t elements() const { return m_elements; }
    /// The island of a node, or `none`.
    std::uint32_t of(std::uint32_t node) const { return m_islandOf[node]; }

    /// Moves to a frame; bodies that are not in it stand where they were released.
    void moveTo(const TrajectoryFrame& frame);
    /// Where a point of an island lies [m] that lay at `released` at the release.
    Eigen::Vector3f place(std::uint32_t island, const Eigen::Vector3f& released) const {
        return m_islands[island].turn * (released - m_islands[island].pivot) + m_islands[island].position;
    }

private:
    struct Island {
        std::size_t body = 0;
        Quat fromBirth = Quat::Identity();                   ///< inverse of the orientation at the release
        Eigen::Vector3f pivot = Eigen::Vector3f::Zero();     ///< m, centre of mass at the release
        Eigen::Matrix3f turn = Eigen::Matrix3f::Identity();  ///< since then
        Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< m, of the centre of mass
    };
    std::vector<Island> m_islands;
    std::vector<std::uint32_t> m_islandOf;  ///< [nodes]
    std::size_t m_elements = 0;
    double m_from = 0.0;
};

}  // namespace rubble::render
