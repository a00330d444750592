#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "io/site/clouds/point_cloud.h"

namespace rubble::io {

/// What the points of a cloud are, all of them read once.
struct CloudSummary {
    std::array<std::uint64_t, pointFateCount> fates{};  ///< points, by what became of them
    Aabb bounds;                                        ///< of those taken, units of the file
    Aabb metres;                                        ///< the same in m; empty: x and y are degrees
    std::map<std::uint16_t, std::uint64_t> classes;     ///< points of each; empty: the cloud has no classes
    std::map<std::uint8_t, std::uint64_t> returns;      ///< points of each echo
    std::vector<std::uint64_t> scans;                   ///< points taken of each scan of the head
    std::vector<bool> posed;                            ///< whether it is known where the scanner of each stood
    float intensityLeast = 0.0F;
    float intensityMost = 0.0F;
    std::uint16_t colourMost = 0;  ///< greatest step of any colour
    Findings findings;             ///< of the whole file

    std::uint64_t points() const { return fates[0]; }
};

/// Reads all points that are left of a cloud. Throws as PointCloud::next().
/// @param visit  called with each block; empty: nothing else looks at the points
CloudSummary summariseCloud(PointCloud& cloud, const Execution& execution,
                            const std::function<void(const CloudBlock&)>& visit = {});

}  // namespace rubble::io
