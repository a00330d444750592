#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "io/site/clouds/cloud_head.h"

namespace rubble::io {

/// So many times as wide as the bulk of its points a cloud is before the others are far points: three levels of detail.
inline constexpr double farTimes = 8.0;

/// Finds where the bulk of the points of a cloud lies, from 65,536 of them at most, evenly over the file.
class CloudBulk {
public:
    void add(const Vec3& place);
    /// The box of the bulk, half as wide again to each side, units of the file; empty: nothing was added. Places that are equal
    /// count once, so that points at 0, 0, 0 are never the bulk. It grows from the shortest range of half of the places along each
    /// axis until a gap follows that is eight times as wide as what was taken.
    /// @param units  heights have units of their own
    Aabb box(const CloudUnits& units) const;

private:
    std::vector<Vec3> m_places;
    std::uint64_t m_every = 1;
    std::uint64_t m_seen = 0;
};

}  // namespace rubble::io
