#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "io/base/abandoned.h"
#include "io/base/file_words.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/site/clouds/octree/cloud_bulk.h"
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
/// Of a file that cannot be written.
constexpr const char* unwritable = "io.file.unwritable";

std::string besideCloud(const std::string& cloud) {
    return cloud + octreeEnding;
}

std::string inCache(const std::string& cloud) {
    const std::string path = fs::absolute(cloud).lexically_normal().string();
    const std::string name = Hasher().text(path).finish().hex() + octreeEnding;
    return (fs::path(cacheFolder()) / "clouds" / name).string();
}

/// Null: there is none there, or it is of another file, or damaged.
std::shared_ptr<const CloudOctree> currentAt(const std::string& path, const std::string& cloud, const CloudRequest& request,
                                             const Execution& execution) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
        return nullptr;
    }
    try {
        auto octree = std::make_shared<const CloudOctree>(path);
        return octree->isOf(cloud, request, execution) ? octree : nullptr;
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

/// Whether one may be written beside the cloud.
bool mayLieBeside(const std::string& cloud) {
    const fs::path folder = fs::absolute(cloud).parent_path();
    return ::access(folder.c_str(), W_OK) == 0 && mayReplace(besideCloud(cloud));
}

/// What one reading of a cloud for its octree found.
struct Laid {
    CloudSummary summary;
    CloudBulk bulk;
    std::uint64_t outside = 0;  ///< points beyond the cube
};

Laid layPoints(const std::string& path, const CloudRequest& request, const OctreeCube& cube, const OctreeCube* far,
               double brightest, PointSorter& sorter, const Execution& execution) {
    const std::unique_ptr<PointCloud> cloud = openCloud(path, request);
    Laid laid;
    laid.summary = summariseCloud(*cloud, execution, [&](const CloudBlock& block) {
        for (std::size_t i = 0; i < block.size(); ++i) {
            OctreePoint point;
            laid.bulk.add(block.places[i]);
            if (!cube.put(block.places[i], point)) {
                ++laid.outside;
                if (far == nullptr || !far->put(block.places[i], point)) {
                    continue;  // the cube was that of a head that is wrong: all is read again
                }
                point.key |= octreeFarKey;
            }
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

OctreeFootCube footOf(const OctreeCube& cube) {
    OctreeFootCube foot;
    Eigen::Map<Vec3>(foot.low.data()) = cube.low();
    Eigen::Map<Vec3>(foot.step.data()) = cube.step();
    foot.side = cube.side();
    return foot;
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
        m_promised = head.promised.value_or(0);
        m_brightest = std::max(1.0, head.fullColour);
    }

    CloudSummary make(const std::string& path) {
        removeAbandoned(path);
        const bool stated = !m_box.isEmpty() && m_box.sizes().allFinite();
        if (!stated || !layIn(path)) {
            if (!stated) {
                const std::unique_ptr<PointCloud> opened = openCloud(m_cloud, m_request);
                m_laid = {};
                m_laid.summary = summariseCloud(*opened, m_execution, [&](const CloudBlock& block) {
                    std::for_each(block.places.begin(), block.places.end(), [&](const Vec3& place) { m_laid.bulk.add(place); });
                });
            }
            if (m_laid.summary.bounds.isEmpty()) {
                refuseContent({"octree.no_points", "No point is left of {0}", {m_cloud}},
                              "Give a cloud that has points, and check what was left out and why.");
            }
            // What was read tells all there is to know of the boxes: it fits now.
            m_box = m_laid.summary.bounds;
            const Aabb bulk = m_laid.bulk.box(m_units, m_execution);
            m_split = OctreeCube(m_box, m_units).side() > farTimes * OctreeCube(bulk, m_units).side();
            if (m_split) {
                divideBox(m_laid.bulk.reach(m_units, m_execution));
            }
            m_known = true;
            layIn(path);
        }
        return std::move(m_laid.summary);
    }

    /// Bytes that an octree takes on the disk while it is made, as far as is known.
    std::uint64_t room() const {
        // A first reading that found the disk full left nothing but what the head promised.
        return std::max(m_promised, m_laid.summary.points()) * (sizeof(OctreePoint) + m_columns.pointBytes());
    }

private:
    /// The boxes of all points within another and of the others: a draw knows the bulk, not all that stands about it.
    void divideBox(const Aabb& reach) {
        m_box.setEmpty();
        m_farBox.setEmpty();
        const std::unique_ptr<PointCloud> opened = openCloud(m_cloud, m_request);
        summariseCloud(*opened, m_execution, [&](const CloudBlock& block) {
            for (const Vec3& place : block.places) {
                (reach.contains(place) ? m_box : m_farBox).extend(place);
            }
        });
        m_split = !m_farBox.isEmpty();
    }

    /// @return false: the box is not that of the points, or some lie far from the others, or there are none
    bool layIn(const std::string& path) {
        m_cube = OctreeCube(m_box, m_units);
        m_farCube = m_split ? OctreeCube(m_farBox, m_units) : m_cube;
        PointSorter sorter(path);
        m_laid = layPoints(m_cloud, m_request, m_cube, m_split ? &m_farCube : nullptr, m_brightest, sorter, m_execution);
        const Aabb& all = m_laid.summary.bounds;
        constexpr double loose = 4.0;  // a box so much too wide costs levels
        if (all.isEmpty()) {
            return false;
        }
        if (!m_known && (m_laid.outside > 0 || OctreeCube(all, m_units).side() * loose < m_cube.side() ||
                         OctreeCube(m_laid.bulk.box(m_units, m_execution), m_units).side() * farTimes < m_cube.side())) {
            return false;
        }
        const double colourMost = m_laid.summary.colourMost;
        if (colourMost > 0.0 && colourMost <= bytesBrightest && m_brightest > bytesBrightest) {
            m_brightest = bytesBrightest;  // 8 bits where the format has 16, as the summary says
            return layIn(path);
        }
        // Before the file is begun: one that is not written to for long is taken for abandoned.
        if (!m_digest) {
            m_digest = contentDigest(m_cloud, m_execution);
        }
        writeAtomically(path, [&](std::ostream& out) { write(out, sorter); });
        return true;
    }

    void write(std::ostream& out, PointSorter& sorter) const {
        putOut(out, octreeMark);
        OctreeBuilder bulk(out, octreeStart, m_cube, m_columns);
        std::optional<OctreeBuilder> far;
        std::vector<OctreeEntry> nodes;
        sorter.forEach(m_execution, [&](OctreePoint point) {
            if ((point.key & octreeFarKey) == 0) {
                bulk.add(point);
                return;
            }
            if (!far) {
                nodes = bulk.finish();
                far.emplace(out, bulk.end(), m_farCube, m_columns);
            }
            point.key &= ~octreeFarKey;
            far->add(point);
        });
        if (far) {
            for (OctreeEntry& node : far->finish()) {
                node.part = 1;
                nodes.push_back(node);
            }
        } else {
            nodes = bulk.finish();
        }
        OctreeFoot foot;
        foot.points = m_laid.summary.points();
        foot.nodes = nodes.size();
        foot.table = far ? far->end() : bulk.end();
        foot.fates = m_laid.summary.fates;
        foot.cube = footOf(m_cube);
        foot.farCube = footOf(m_farCube);
        foot.farPoints = m_laid.outside;
        foot.intensityLeast = m_laid.summary.intensityLeast;
        foot.intensityMost = m_laid.summary.intensityMost;
        foot.cloudBytes = m_stamp.bytes;
        foot.cloudTime = m_stamp.time;
        foot.cloudDigest = m_digest->bytes;
        if (const CloudStamp now = stampOf(m_cloud); now.bytes != m_stamp.bytes || now.time != m_stamp.time) {
            refuseContent({"octree.changed", "{0} changed while its octree was made", {m_cloud}}, "Try again once it is complete.");
        }
        foot.request = requestDigest(m_request).bytes;
        foot.columns = {m_columns.intensity, m_columns.colour, m_columns.classes};
        Hasher hasher;
        for (const OctreeEntry& node : nodes) {
            const OctreeRow row{
                node.prefix, node.start,       static_cast<std::uint16_t>(node.level), static_cast<std::uint16_t>(node.part),
                node.points, node.digest.bytes};
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
    std::uint64_t m_promised = 0;    ///< points, by the head
    std::optional<Digest> m_digest;  ///< of the content
    Aabb m_box;
    Aabb m_farBox;
    bool m_known = false;  ///< the box was found by reading the points
    bool m_split = false;  ///< far points have a cube of their own
    OctreeCube m_cube;
    OctreeCube m_farCube;
    double m_brightest = 1.0;  ///< number of a full colour
    Laid m_laid;
};

}  // namespace

std::shared_ptr<const CloudOctree> keptOctree(const std::string& cloud, const CloudRequest& request, const Execution& execution) {
    if (auto octree = currentAt(besideCloud(cloud), cloud, request, execution)) {
        return octree;
    }
    return currentAt(inCache(cloud), cloud, request, execution);
}

OpenedOctree openOctree(const std::string& cloud, const CloudRequest& request, const Execution& execution) {
    if (auto octree = keptOctree(cloud, request, execution)) {
        return {std::move(octree), false, {}};
    }
    OctreeMaker maker(cloud, request, execution);
    const std::string beside = besideCloud(cloud);
    if (mayLieBeside(cloud)) {
        try {
            CloudSummary summary = maker.make(beside);
            return {std::make_shared<const CloudOctree>(beside), true, std::move(summary)};
        } catch (const WorldError& error) {
            // A full disk, say: the cache folder may lie on another one.
            if (error.message().id != unwritable) {
                throw;
            }
        }
    }
    const std::string path = inCache(cloud);
    try {
        makeFolderOf(path);
        CloudSummary summary = maker.make(path);
        return {std::make_shared<const CloudOctree>(path), true, std::move(summary)};
    } catch (const WorldError& error) {
        if (error.message().id != unwritable) {
            throw;
        }
        throw WorldError({"octree.no_room",
                          "The octree of {0} can be written neither beside it nor to {1}: {2}",
                          {cloud, path, error.message().arguments.back()}},
                         {"octree.no_room.remedy",
                          "Make room on either disk: about {0} MB are needed while it is made. RUBBLE_CACHE names another folder.",
                          {std::to_string(maker.room() / 1'000'000 + 1)}});
    }
}

}  // namespace rubble::io
