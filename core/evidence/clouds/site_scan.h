#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/clouds/surface_tree.h"

namespace rubble {

/// Points of a scan at most, held in memory: 0.7 GB.
inline constexpr std::size_t scanPointsMost = 20'000'000;
/// Rays of a scan at most.
inline constexpr double scanRaysMost = 2e9;

/// How a site is scanned.
struct ScanSettings {
    std::vector<Vec3> scanners;  ///< m
    double step = 3.5e-3;        ///< rad; one ray falls to each square of this side
    double range = 100.0;        ///< m
    double noise = 0.005;        ///< m, standard deviation along the ray
    std::uint64_t seed = 1;
};

/// Points that rays met, one after another.
struct SiteScan {
    std::vector<Vec3> places;              ///< m
    std::vector<std::uint32_t> triangles;  ///< each met
    std::vector<std::uint16_t> scanners;   ///< each was met from
    std::vector<std::uint64_t> rays;       ///< [scanners] sent
    std::vector<std::uint64_t> echoes;     ///< [scanners] that met something within the range
};

/// Scans a site. Directions are drawn at random, evenly over the sphere, so that points are independent of each other; a scanner
/// with a regular raster sees as much. What nothing stands in front of is met; what is hidden has no points. No result depends on
/// the number of threads. Throws UsageError (no scanner, too many, settings that are no size, too many rays or points), Cancelled.
SiteScan scanSite(const SurfaceTree& site, const ScanSettings& settings, const Execution& execution);

/// What a scan saw each point from.
struct PointSights {
    std::span<const Vec3> scanners;        ///< m; empty: straight from above
    std::span<const std::uint16_t> which;  ///< [points] of the scanners; empty: all from the nearest one
};

/// What the rays of a scan meet of a site, one ray to each point, without noise.
struct MetAlike {
    std::vector<Vec3> places;              ///< [points] m; not a number: the ray meets nothing
    std::vector<std::uint32_t> triangles;  ///< [points] each met; noTriangle: none
};
inline constexpr std::uint32_t noTriangle = 0xFFFF'FFFF;

/// A site as a scan would have seen it: a ray through each point of the scan, from where that was seen. What no point of the scan
/// looks at stays unseen here as well. No result depends on the number of threads. Throws Cancelled.
MetAlike seenAlike(const SurfaceTree& site, std::span<const Vec3> points, const PointSights& sights, const Execution& execution);

}  // namespace rubble
