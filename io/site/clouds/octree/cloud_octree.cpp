#include "io/site/clouds/octree/cloud_octree.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>

#include "core/base/error.h"
#include "io/base/file_words.h"
#include "io/site/clouds/octree/octree_file.h"

namespace rubble::io {

namespace {

[[noreturn]] void failDamaged(const std::string& path) {
    refuseContent({"octree.damaged", "{0} is no octree of a cloud, or damaged", {path}},
                  "Delete it: it is made anew from the cloud when it is needed.");
}

/// Places in it are numbers, and it is no smaller than any is made.
bool isSound(const OctreeFootCube& cube) {
    bool sound = std::isfinite(cube.side) && cube.side >= 1e-3;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // 2^31 steps lead to its far end.
        sound = sound && cube.step[axis] > 0.0 && std::isfinite(cube.low[axis] + 2147483648.0 * cube.step[axis]);
    }
    return sound;
}

OctreeCube cubeOf(const OctreeFootCube& cube) {
    return {Vec3(cube.low.data()), Vec3(cube.step.data()), cube.side};
}

}  // namespace

CloudOctree::CloudOctree(const std::string& path) : m_file(path) {
    OctreeFoot foot;
    const std::uint64_t size = m_file.size();
    if (size < octreeStart + sizeof foot) {
        failDamaged(path);
    }
    std::vector<unsigned char> bytes = m_file.bytes(size - sizeof foot, sizeof foot);
    std::memcpy(&foot, bytes.data(), sizeof foot);
    const std::uint64_t tableBytes = foot.nodes * sizeof(OctreeRow);
    const bool fits = foot.mark == octreeMark && foot.nodes > 0 && foot.nodes < size && foot.table >= octreeStart &&
                      foot.table < size && foot.table + tableBytes + sizeof foot == size;
    if (!fits) {
        failDamaged(path);
    }
    bytes = m_file.bytes(foot.table, tableBytes + offsetof(OctreeFoot, digest));
    if (Hasher().bytes(bytes.data(), bytes.size()).finish().bytes != foot.digest) {
        failDamaged(path);
    }
    if (!isSound(foot.cube) || !isSound(foot.farCube) || !std::isfinite(foot.intensityLeast) ||
        !std::isfinite(foot.intensityMost)) {
        failDamaged(path);
    }
    m_head.points = foot.points;
    m_head.fates = foot.fates;
    m_head.columns = {foot.columns[0] != 0, foot.columns[1] != 0, foot.columns[2] != 0};
    m_head.cube = cubeOf(foot.cube);
    m_head.farCube = cubeOf(foot.farCube);
    m_head.farPoints = foot.farPoints;
    m_head.intensityLeast = foot.intensityLeast;
    m_head.intensityMost = foot.intensityMost;
    m_cloudBytes = foot.cloudBytes;
    m_cloudTime = foot.cloudTime;
    m_cloudDigest.bytes = foot.cloudDigest;
    m_request.bytes = foot.request;
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>, std::size_t> known;
    std::array<std::uint64_t, 2> points{};
    for (std::size_t n = 0; n < foot.nodes; ++n) {
        const auto row = littleAt<OctreeRow>(&bytes[n * sizeof(OctreeRow)]);
        const std::uint64_t rowBytes = row.points * m_head.columns.pointBytes();
        const bool sound = row.level <= octreeDeepest && row.part < points.size() && row.start >= octreeStart &&
                           row.start <= foot.table && rowBytes <= foot.table - row.start &&
                           row.prefix < std::uint64_t{1} << (3 * row.level) && (n > 0 || (row.part == 0 && row.level == 0));
        if (!sound) {
            failDamaged(path);
        }
        points[row.part] += row.points;
        m_entries.push_back({row.prefix, row.start, row.level, row.part, row.points, Digest{row.digest}});
        const bool far = row.part == 1;
        const OctreeCube& cube = far ? m_head.farCube : m_head.cube;
        const int level = row.level;
        OctreeNode node{level,      far, std::ldexp(cube.side(), -(level + octreeCellLevels)), cube.cell(row.prefix, level),
                        row.points, {}};
        for (unsigned up = 1; up <= row.level && !node.parent; ++up) {
            const auto found = known.find({row.part, row.level - up, row.prefix >> (3 * up)});
            node.parent = found != known.end() ? std::optional(found->second) : std::nullopt;
        }
        known.try_emplace({row.part, row.level, row.prefix}, n);
        m_nodes.push_back(node);
    }
    if (points[0] + points[1] != foot.points || points[1] != foot.farPoints) {
        failDamaged(path);
    }
}

int CloudOctree::levels() const {
    int levels = 0;
    for (const OctreeNode& node : m_nodes) {
        levels = node.far ? levels : std::max(levels, node.level + 1);
    }
    return levels;
}

double CloudOctree::placeStep() const {
    return std::ldexp(m_head.cube.side(), -(octreeKeyLevels + octreeRestLevels));
}

double CloudOctree::farPlaceStep() const {
    return std::ldexp(m_head.farCube.side(), -(octreeKeyLevels + octreeRestLevels));
}

CloudBlock CloudOctree::read(std::size_t node) const {
    const OctreeEntry& entry = m_entries.at(node);
    const OctreeColumns& columns = m_head.columns;
    const std::vector<unsigned char> bytes = m_file.bytes(entry.start, entry.points * columns.pointBytes());
    if (Hasher().bytes(bytes.data(), bytes.size()).finish() != entry.digest) {
        failDamaged(path());
    }
    const OctreeCube& cube = m_nodes[node].far ? m_head.farCube : m_head.cube;
    CloudBlock block;
    block.resize(entry.points, {.intensity = columns.intensity, .colour = columns.colour, .classes = columns.classes});
    const unsigned char* at = bytes.data();
    for (std::size_t i = 0; i < entry.points; ++i) {
        block.places[i] =
            cube.placeOf({littleAt<std::uint32_t>(at), littleAt<std::uint32_t>(at + 4), littleAt<std::uint32_t>(at + 8)});
        at += 12;
        if (columns.intensity) {
            block.intensity[i] = littleAt<float>(at);
            if (!std::isfinite(block.intensity[i])) {
                failDamaged(path());
            }
            at += 4;
        }
        if (columns.colour) {
            block.colours[i] = {at[0], at[1], at[2]};
            at += 3;
        }
        if (columns.classes) {
            block.classes[i] = *at++;
        }
    }
    return block;
}

bool CloudOctree::isOf(const std::string& cloud, const CloudRequest& request, const Execution& execution) const {
    const CloudStamp stamp = stampOf(cloud);
    if (stamp.bytes != m_cloudBytes || requestDigest(request) != m_request) {
        return false;
    }
    return stamp.time == m_cloudTime || rememberedDigest(cloud, path(), execution) == m_cloudDigest;
}

}  // namespace rubble::io
