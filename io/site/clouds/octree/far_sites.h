#pragma once

#include <vector>

#include "core/base/execution.h"
#include "core/base/geometry.h"
#include "io/site/clouds/octree/placed_octree.h"

namespace rubble::io {

/// Where the far points of a cloud really lie: their cube may hold all that lies between them, the bulk as well.
class FarSites {
public:
    FarSites() = default;
    /// Reads the coarsest of their nodes, of 1,000,000 points in all; of the others it takes the boxes. Throws as CloudOctree,
    /// Cancelled.
    FarSites(const PlacedOctree& placed, const Execution& execution);

    /// Whether a place, m, local, lies outside of the cube of the bulk and nearer to a dense site of far points: strays are none.
    /// All different places within the distance of the bulk count as one site.
    bool nearer(const Vec3& place) const;

private:
    struct Heap {
        Aabb box;             ///< m, local
        double places = 0.0;  ///< different ones
    };
    Aabb m_bulk;  ///< m, local
    double m_dense = 0.0;
    std::vector<Heap> m_heaps;
};

}  // namespace rubble::io
