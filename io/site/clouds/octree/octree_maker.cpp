#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>

#include "core/base/error.h"
#include "io/base/file_words.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/site/clouds/octree/cloud_octree.h"
#include "io/site/clouds/octree/octree_file.h"
#include "io/site/clouds/octree/point_sorter.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

/// Number of a full colour of 8 bits.
constexpr double bytesBrightest = 255.0;
/// Bytes by which an octree of any version begins.
constexpr std::size_t octreeName = 5;

std::string besideCloud(const std::string& cloud) {
    return cloud + octreeEnding;
}

std::string inCache(const std::string& cloud) {
    const std::string path = fs::absolute(cloud).lexically_normal().string();
    const std::string name = Hasher().text(path).finish().hex() + octreeEnding;
    return (fs::path(cacheFolder()) / "clouds" / name).string();
}

/// Null: there is none there, or it is of another file, or damaged.
std::shared_ptr<const CloudOctree> currentAt(const std::string& path, const std::string& cloud, const CloudRequest& request) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
        return nullptr;
    }
    try {
        auto octree = std::make_shared<const CloudOctree>(path);
        return octree->isOf(cloud, request) ? octree : nullptr;
    } catch (const ParseError&) {
        return nullptr;  // it is made anew
    } catch (const WorldError&) {
        return nullptr;
    }
}

/// Nothing lies there that is not an octree of ours, and no link leads elsewhere.
bool mayReplace(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(path, ignored);
    if (!fs::exists(status)) {
        return true;
    }
    std::array<char, octreeName> mark{};
    std::ifstream file(path, std::ios::binary);
    file.read(mark.data(), mark.size());
    // One that was cut short is ours as far as it goes.
    return fs::is_regular_file(status) && std::equal(mark.begin(), mark.begin() + file.gcount(), octreeMark.begin());
}

/// Where one is to be written.
std::string placeFor(const std::string& cloud) {
    const fs::path folder = fs::absolute(cloud).parent_path();
    if (::access(folder.c_str(), W_OK) == 0 && mayReplace(besideCloud(cloud))) {
        return besideCloud(cloud);
    }
    std::string path = inCache(cloud);
    makeFolderOf(path);
    return path;
}

/// What one reading of a cloud for its octree found.
struct Laid {
    CloudSummary summary;
    std::uint64_t outside = 0;  ///< points beyond the cube
};

Laid layPoints(const std::string& path, const CloudRequest& request, const OctreeCube& cube, double brightest, PointSorter& sorter,
               const Execution& execution) {
    const std::unique_ptr<PointCloud> cloud = openCloud(path, request);
    Laid laid;
    laid.summary = summariseCloud(*cloud, execution, [&](const CloudBlock& block) {
        for (std::size_t i = 0; i < block.size() && laid.outside == 0; ++i) {
            OctreePoint point;
            laid.outside += cube.put(block.places[i], point) ? 0 : 1;
            if (!block.intensity.empty() && std::isfinite(block.intensity[i])) {
                point.intensity = block.intensity[i];
            }
            for (std::size_t c = 0; c < 3 && !block.colours.empty(); ++c) {
                const double bright = std::min(1.0, block.colours[i][c] / brightest);
                point.colour[c] = static_cast<std::uint8_t>(std::lround(255.0 * bright));
            }
            if (!block.classes.empty()) {
                point.kind = static_cast<std::uint8_t>(std::min<int>(255, block.classes[i]));
            }
            sorter.add(point);
        }
    });
    return laid;
}

template <std::size_t Size>
void putOut(std::ostream& out, const std::array<char, Size>& bytes) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Makes octrees of one cloud until the cube fits.
class OctreeMaker {
public:
    OctreeMaker(const std::string& cloud, const CloudRequest& request, const Execution& execution)
        : m_cloud(cloud), m_request(request), m_execution(execution), m_stamp(stampOf(cloud)) {
        const std::unique_ptr<PointCloud> opened = openCloud(cloud, request);
        const CloudHead& head = opened->head();
        m_units = head.units;
        m_columns = {head.columns.intensity, head.columns.colour, head.columns.classes};
        m_box = head.stated;
        m_brightest = std::max(1.0, head.fullColour);
    }

    CloudSummary make(const std::string& path) {
        const bool stated = !m_box.isEmpty() && m_box.sizes().allFinite();
        if (!stated || !layIn(path)) {
            if (!stated) {
                const std::unique_ptr<PointCloud> opened = openCloud(m_cloud, m_request);
                m_laid.summary = summariseCloud(*opened, m_execution);
            }
            m_box = m_laid.summary.bounds;
            if (m_box.isEmpty() || !layIn(path)) {
                refuseContent({"octree.no_points", "No point is left of {0}", {m_cloud}},
                              "Give a cloud that has points, and check what was left out and why.");
            }
        }
        return std::move(m_laid.summary);
    }

private:
    /// @return false: the box is not that of the points, or there are none
    bool layIn(const std::string& path) {
        m_cube = OctreeCube(m_box, m_units);
        PointSorter sorter(path);
        m_laid = layPoints(m_cloud, m_request, m_cube, m_brightest, sorter, m_execution);
        const Aabb& all = m_laid.summary.bounds;
        constexpr double loose = 4.0;  // a box so much too wide costs levels
        if (all.isEmpty() || m_laid.outside > 0 || OctreeCube(all, m_units).side() * loose < m_cube.side()) {
            return false;
        }
        const double colourMost = m_laid.summary.colourMost;
        if (colourMost > 0.0 && colourMost <= bytesBrightest && m_brightest > bytesBrightest) {
            m_brightest = bytesBrightest;  // 8 bits where the format has 16, as the summary says
            return layIn(path);
        }
        writeAtomically(path, [&](std::ostream& out) { write(out, sorter); });
        return true;
    }

    void write(std::ostream& out, PointSorter& sorter) const {
        putOut(out, octreeMark);
        OctreeBuilder builder(out, octreeStart, m_cube, m_columns);
        sorter.forEach(m_execution, [&](const OctreePoint& point) { builder.add(point); });
        const std::vector<OctreeEntry> nodes = builder.finish();
        OctreeFoot foot;
        foot.points = m_laid.summary.points();
        foot.nodes = nodes.size();
        foot.table = builder.end();
        foot.fates = m_laid.summary.fates;
        Eigen::Map<Vec3>(foot.low.data()) = m_cube.low();
        Eigen::Map<Vec3>(foot.step.data()) = m_cube.step();
        foot.side = m_cube.side();
        foot.intensityLeast = m_laid.summary.intensityLeast;
        foot.intensityMost = m_laid.summary.intensityMost;
        foot.cloudBytes = m_stamp.bytes;
        foot.cloudTime = m_stamp.time;
        foot.cloudDigest = contentDigest(m_cloud).bytes;
        if (const CloudStamp now = stampOf(m_cloud); now.bytes != m_stamp.bytes || now.time != m_stamp.time) {
            refuseContent({"octree.changed", "{0} changed while its octree was made", {m_cloud}}, "Try again once it is complete.");
        }
        foot.request = requestDigest(m_request).bytes;
        foot.columns = {m_columns.intensity, m_columns.colour, m_columns.classes};
        Hasher hasher;
        for (const OctreeEntry& node : nodes) {
            const OctreeRow row{node.prefix, node.start, node.level, node.points, node.digest.bytes};
            hasher.bytes(&row, sizeof row);
            out.write(reinterpret_cast<const char*>(&row), sizeof row);
        }
        hasher.bytes(&foot, offsetof(OctreeFoot, digest));
        foot.digest = hasher.finish().bytes;
        out.write(reinterpret_cast<const char*>(&foot), sizeof foot);
    }

    const std::string& m_cloud;
    const CloudRequest& m_request;
    const Execution& m_execution;
    CloudStamp m_stamp;
    CloudUnits m_units;
    OctreeColumns m_columns;
    Aabb m_box;
    OctreeCube m_cube;
    double m_brightest = 1.0;  ///< number of a full colour
    Laid m_laid;
};

}  // namespace

std::shared_ptr<const CloudOctree> keptOctree(const std::string& cloud, const CloudRequest& request) {
    if (auto octree = currentAt(besideCloud(cloud), cloud, request)) {
        return octree;
    }
    return currentAt(inCache(cloud), cloud, request);
}

OpenedOctree openOctree(const std::string& cloud, const CloudRequest& request, const Execution& execution) {
    if (auto octree = keptOctree(cloud, request)) {
        return {std::move(octree), false, {}};
    }
    OctreeMaker maker(cloud, request, execution);
    const std::string path = placeFor(cloud);
    CloudSummary summary = maker.make(path);
    return {std::make_shared<const CloudOctree>(path), true, std::move(summary)};
}

}  // namespace rubble::io
