#pragma once

#include <cstdint>
#include <vector>

#include "core/base/execution.h"
#include "core/base/geometry.h"
#include "io/site/clouds/cloud_head.h"

namespace rubble::io {

/// So many times as wide as the bulk of its points a cloud is before the others are far points: three levels of detail.
inline constexpr double farTimes = 8.0;

/// A cube so wide tells 5 cm apart in levels of detail: dense sites that lie within one are of one bulk.
inline constexpr double bulkWidthMost = 1e5;  // m
/// Share of the different places of a cloud from which on they are a dense site, and no strays.
inline constexpr double denseShare = 0.01;
/// Fewer different places are never one.
inline constexpr double denseLeast = 16.0;

/// Finds where the bulk of the points of a cloud lies, from 65,536 of them at most, drawn by a hash of their numbers: rows of a
/// scan and the draw have no beat.
class CloudBulk {
public:
    void add(const Vec3& place);
    /// The box of the bulk, half as wide again to each side, units of the file; empty: nothing was added. Places that are equal
    /// count once, so that points at 0, 0, 0 are never the bulk. It grows from the shortest range of an eighth of the places along
    /// each axis until a gap follows that is eight times as wide as what was taken. What is left may be another dense site, found
    /// in the same way: it belongs to the bulk, as long as both lie within 100 km. Throws Cancelled.
    /// @param units  heights have units of their own
    Aabb box(const CloudUnits& units, const Execution& execution = Execution()) const;
    /// Beyond it lie far points: farTimes the width of the widest site to each side of all; empty: nothing was added. Throws
    /// Cancelled.
    Aabb reach(const CloudUnits& units, const Execution& execution = Execution()) const;

private:
    struct Drawn {
        std::uint64_t lot = 0;
        Vec3 place;
    };
    struct Bulk {
        Aabb sites;          ///< about dense sites, units of the file
        Aabb all;            ///< about all that lies within the reach of one as well
        double width = 0.0;  ///< m, of the widest site
    };
    Bulk find(const CloudUnits& units, const Execution& execution) const;

    std::vector<Drawn> m_drawn;
    std::uint64_t m_every = 1;
    std::uint64_t m_seen = 0;
};

}  // namespace rubble::io
