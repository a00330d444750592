#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/evidence/clouds/cloud_distance.h"
#include "io/site/clouds/cloud_head.h"
#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Core points at most, and points of both clouds that are held in memory at a time: 1.6 GB while they are ordered.
inline constexpr std::size_t coresMost = 10'000'000;
inline constexpr std::uint64_t heldPointsMost = 20'000'000;

/// Two clouds to be held against each other.
struct CloudComparisonRequest {
    std::string first;
    std::string second;
    std::string cores;  ///< cloud of core points; empty: the points of the first, one to each cube as wide as the projection radius
    CloudRequest read;  ///< how the first is read, and the others where they say nothing themselves
    bool metres = false;  ///< places are brought to metres first; else all lengths are in units of the files
    CloudDistanceSettings settings;
    std::uint64_t heldPoints = heldPointsMost;
};

/// A cloud that took part.
struct ComparedCloud {
    std::string path;
    CloudHead head;
    std::uint64_t points = 0;  ///< that were taken of it
    std::uint64_t near = 0;    ///< of them, so near to the cores that they may count
};

/// Distances from the first cloud to the second.
struct CloudComparison {
    ComparedCloud first;
    ComparedCloud second;
    std::string coresFrom;    ///< path; empty: they are points of the first cloud
    std::vector<Vec3> cores;  ///< units of the file, or m
    std::vector<CoreDistance> distances;
    double unit = 0.0;          ///< m to each unit of length; NaN: those of heights differ from those of x and y
    bool metresStated = false;  ///< the files say so, for plan and heights
    int parts = 0;              ///< strips that the cores were taken in, so that memory stays bounded
    Findings findings;
};

/// Reads two clouds and measures from one to the other at the core points. Clouds that do not fit into memory are read once for
/// each strip of cores; no result depends on that. What is assumed or has no answer is a counted finding.
/// Throws ParseError (other systems, degrees, clouds that do not meet, no points), UsageError (too many cores), WorldError,
/// Cancelled.
CloudComparison compareClouds(const CloudComparisonRequest& request, const Execution& execution);

}  // namespace rubble::io
