#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "io/site/clouds/cloud_file.h"
#include "io/site/clouds/cloud_summary.h"
#include "io/site/clouds/octree/octree_builder.h"

namespace rubble::io {

/// Ending that the path of a cloud gets for that of its octree.
inline constexpr const char* octreeEnding = ".octree";

/// A part of a cloud: the points of a cell of space that its coarser ones left out, thinned to about the same number everywhere.
struct OctreeNode {
    int level = 0;         ///< 0: the whole of its part, coarsest
    bool far = false;      ///< of the far points
    double spacing = 0.0;  ///< m, width of the cells of which it has one point each; a leaf may have more
    Aabb box;              ///< units of the file
    std::uint32_t points = 0;
    std::optional<std::size_t> parent;  ///< the next coarser one; it comes before
};

/// What the octree of a cloud says before its points.
struct OctreeHead {
    std::uint64_t points = 0;
    std::array<std::uint64_t, pointFateCount> fates{};  ///< of the points of the file
    OctreeColumns columns;
    OctreeCube cube;              ///< of the bulk of the points
    std::uint64_t farPoints = 0;  ///< so far from the bulk that they have a cube of their own, such as those at 0, 0, 0
    OctreeCube farCube;
    float intensityLeast = 0.0F;
    float intensityMost = 0.0F;
};

/// The points of a cloud on disk in levels of detail, so that few of them are read for a view. Each point lies in one node. A place
/// is exact to 2^-31 of the width of its part, the bulk or the far points; intensity and class are those of the file, colours have
/// 8 bits.
class CloudOctree {
public:
    /// Throws WorldError, ParseError (cut short or damaged).
    explicit CloudOctree(const std::string& path);

    const std::string& path() const { return m_file.path(); }
    std::uint64_t bytes() const { return m_file.size(); }
    const OctreeHead& head() const { return m_head; }
    /// By part, the bulk first, and level.
    const std::vector<OctreeNode>& nodes() const { return m_nodes; }
    /// Of the bulk.
    int levels() const;
    /// m, to which places of the bulk are kept.
    double placeStep() const;
    /// m, to which those of far points are.
    double farPlaceStep() const;
    /// The points of a node in units of the file; colours in steps of 255. From any thread. Throws ParseError (damaged),
    /// WorldError.
    CloudBlock read(std::size_t node) const;
    /// Whether it is of this file, read so. Bytes and time of the file decide; if the time alone differs, its content does, which
    /// is read once and remembered beside the octree. Throws WorldError, Cancelled.
    bool isOf(const std::string& cloud, const CloudRequest& request, const Execution& execution = Execution()) const;

private:
    CloudFile m_file;
    OctreeHead m_head;
    std::uint64_t m_cloudBytes = 0;
    std::int64_t m_cloudTime = 0;
    Digest m_cloudDigest;
    Digest m_request;
    std::vector<OctreeEntry> m_entries;
    std::vector<OctreeNode> m_nodes;
};

/// The octree that is kept of a cloud, beside it or in the cache folder; null: there is none of the file as it is now.
/// Throws WorldError (there is no such cloud), Cancelled.
std::shared_ptr<const CloudOctree> keptOctree(const std::string& cloud, const CloudRequest& request = {},
                                              const Execution& execution = Execution());

/// An octree that was opened.
struct OpenedOctree {
    std::shared_ptr<const CloudOctree> octree;
    bool made = false;                    ///< it was made just now
    std::optional<CloudSummary> summary;  ///< of the cloud, if it was made
};

/// The octree of a cloud, made if there is none of it as it is now: beside the cloud, or in the cache folder where its own cannot
/// be written to or the disk is full. Reads the cloud once, twice where its head does not say its bounds, once more where
/// points lie far from the others, with about 300 MB, beyond 1e9 points 200 MB more for each 1e9; then for its digest. What killed
/// processes left of octrees of this cloud is taken away.
/// Throws as openCloud() and PointCloud::next(), WorldError (no room), ParseError (no point is left).
OpenedOctree openOctree(const std::string& cloud, const CloudRequest& request, const Execution& execution);

}  // namespace rubble::io
