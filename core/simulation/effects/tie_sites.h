#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/trajectory/trajectory.h"

namespace rubble {

/// Where two clusters of reinforced components hang together: the faces that their elements share.
struct TieSite {
    /// Face of two solids, edge of two shells or node of two beams; unused nodes are `none`.
    struct Joint {
        static constexpr std::uint32_t none = ~std::uint32_t{0};
        std::array<std::uint32_t, 4> nodes{none, none, none, none};
        double area = 0.0;  ///< m2, at rest; of shells the edge times the thickness, of beams the section
    };
    ClusterId first{};  ///< the lower one
    ClusterId second{};
    double area = 0.0;    ///< m2, shared
    double length = 0.0;  ///< m, between the centres of the two clusters at rest
    std::vector<Joint> joints;

    /// Centre of the shared area with the nodes at the given places.
    Vec3 centre(std::span<const Vec3> positions) const;
};

/// All pairs of clusters that share faces (solids), edges (shells) or nodes (beams) of elements of reinforced components, in the
/// order of their clusters. An element without a fragment has no part in it. O(n log n).
std::vector<TieSite> findTieSites(const RunDescription& description);

}  // namespace rubble
