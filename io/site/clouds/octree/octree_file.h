#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/base/execution.h"
#include "core/base/hash.h"
#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

// The file of an octree: a mark, the points of the nodes one after another, the table of the nodes, and a foot. The foot comes
// last, so a file that was cut short has none. Numbers lie little end first.

inline constexpr std::array<char, 8> octreeMark{'R', 'B', 'O', 'C', 'T', '0', '0', '3'};
/// Of the first points, bytes.
inline constexpr std::uint64_t octreeStart = octreeMark.size();

/// A node.
struct OctreeRow {
    std::uint64_t prefix = 0;
    std::uint64_t start = 0;
    std::uint16_t level = 0;
    std::uint16_t part = 0;  ///< 0: the bulk of the points, 1: far ones
    std::uint32_t points = 0;
    std::array<std::uint8_t, 16> digest{};
};
static_assert(sizeof(OctreeRow) == 40);

/// The cube of a part.
struct OctreeFootCube {
    std::array<double, 3> low{};
    std::array<double, 3> step{};
    double side = 0.0;
};

struct OctreeFoot {
    std::uint64_t points = 0;
    std::uint64_t nodes = 0;
    std::uint64_t table = 0;  ///< where it begins, bytes
    std::array<std::uint64_t, pointFateCount> fates{};
    OctreeFootCube cube;
    OctreeFootCube farCube;  ///< of the same side if there are no far points
    std::uint64_t farPoints = 0;
    float intensityLeast = 0.0F;
    float intensityMost = 0.0F;
    std::uint64_t cloudBytes = 0;
    std::int64_t cloudTime = 0;  ///< ns, of its last change
    std::array<std::uint8_t, 16> cloudDigest{};
    std::array<std::uint8_t, 16> request{};
    std::array<std::uint8_t, 8> columns{};  ///< intensity, colour, classes; the others are 0
    std::array<std::uint8_t, 16> digest{};  ///< of the table and of the foot up to here
    std::array<char, 8> mark = octreeMark;
};
static_assert(sizeof(OctreeFoot) == 280);

/// By which a file is known again without reading it.
struct CloudStamp {
    std::uint64_t bytes = 0;
    std::int64_t time = 0;  ///< ns, of its last change
    friend bool operator==(const CloudStamp&, const CloudStamp&) = default;
};
/// Throws WorldError.
CloudStamp stampOf(const std::string& path);
/// Of all its bytes. Throws WorldError, Cancelled.
Digest contentDigest(const std::string& path, const Execution& execution);
/// The same, read once as long as the file keeps its bytes and time: the outcome lies beside its octree.
/// @param octree  path of the octree
Digest rememberedDigest(const std::string& path, const std::string& octree, const Execution& execution);
/// Of how a cloud is read.
Digest requestDigest(const CloudRequest& request);

}  // namespace rubble::io
