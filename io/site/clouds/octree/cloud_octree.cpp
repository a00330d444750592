#include "io/site/clouds/octree/cloud_octree.h"

#include <sys/stat.h>

#include <cmath>
#include <cstring>
#include <map>

#include "core/base/error.h"
#include "io/base/file_words.h"
#include "io/site/clouds/octree/octree_file.h"

namespace rubble::io {

namespace {

[[noreturn]] void failDamaged(const std::string& path) {
    refuseContent({"octree.damaged", "{0} is no octree of a cloud, or damaged", {path}},
                  "Delete it: it is made anew from the cloud when it is needed.");
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
    const bool fits = foot.mark == octreeMark && foot.nodes < size && foot.table >= octreeStart && foot.table < size &&
                      foot.table + tableBytes + sizeof foot == size;
    if (!fits) {
        failDamaged(path);
    }
    bytes = m_file.bytes(foot.table, tableBytes + offsetof(OctreeFoot, digest));
    if (Hasher().bytes(bytes.data(), bytes.size()).finish().bytes != foot.digest) {
        failDamaged(path);
    }
    m_head.points = foot.points;
    m_head.fates = foot.fates;
    m_head.columns = {foot.columns[0] != 0, foot.columns[1] != 0, foot.columns[2] != 0};
    m_head.cube = OctreeCube(Vec3(foot.low.data()), Vec3(foot.step.data()), foot.side);
    m_head.intensityLeast = foot.intensityLeast;
    m_head.intensityMost = foot.intensityMost;
    m_cloudBytes = foot.cloudBytes;
    m_cloudTime = foot.cloudTime;
    m_cloudDigest.bytes = foot.cloudDigest;
    m_request.bytes = foot.request;
    std::map<std::pair<std::uint32_t, std::uint64_t>, std::size_t> known;
    std::uint64_t points = 0;
    for (std::size_t n = 0; n < foot.nodes; ++n) {
        const auto row = littleAt<OctreeRow>(&bytes[n * sizeof(OctreeRow)]);
        const std::uint64_t rowBytes = row.points * m_head.columns.pointBytes();
        const bool sound = row.level <= octreeDeepest && row.start >= octreeStart && row.start <= foot.table &&
                           rowBytes <= foot.table - row.start && row.prefix < std::uint64_t{1} << (3 * row.level);
        if (!sound) {
            failDamaged(path);
        }
        points += row.points;
        m_entries.push_back({row.prefix, row.start, row.level, row.points, Digest{row.digest}});
        OctreeNode node{static_cast<int>(row.level), m_head.cube.cell(row.prefix, static_cast<int>(row.level)), row.points, {}};
        for (std::uint32_t up = 1; up <= row.level && !node.parent; ++up) {
            const auto found = known.find({row.level - up, row.prefix >> (3 * up)});
            node.parent = found != known.end() ? std::optional(found->second) : std::nullopt;
        }
        known.try_emplace({row.level, row.prefix}, n);
        m_nodes.push_back(node);
    }
    if (points != foot.points) {
        failDamaged(path);
    }
}

double CloudOctree::spacing(int level) const {
    return std::ldexp(m_head.cube.side(), -(level + octreeCellLevels));
}

double CloudOctree::placeStep() const {
    return std::ldexp(m_head.cube.side(), -(octreeKeyLevels + octreeRestLevels));
}

CloudBlock CloudOctree::read(std::size_t node) const {
    const OctreeEntry& entry = m_entries.at(node);
    const OctreeColumns& columns = m_head.columns;
    const std::vector<unsigned char> bytes = m_file.bytes(entry.start, entry.points * columns.pointBytes());
    if (Hasher().bytes(bytes.data(), bytes.size()).finish() != entry.digest) {
        failDamaged(path());
    }
    CloudBlock block;
    block.resize(entry.points, {.intensity = columns.intensity, .colour = columns.colour, .classes = columns.classes});
    const unsigned char* at = bytes.data();
    for (std::size_t i = 0; i < entry.points; ++i) {
        block.places[i] =
            m_head.cube.placeOf({littleAt<std::uint32_t>(at), littleAt<std::uint32_t>(at + 4), littleAt<std::uint32_t>(at + 8)});
        at += 12;
        if (columns.intensity) {
            block.intensity[i] = littleAt<float>(at);
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

bool CloudOctree::isOf(const std::string& cloud, const CloudRequest& request) const {
    const CloudStamp stamp = stampOf(cloud);
    if (stamp.bytes != m_cloudBytes || requestDigest(request) != m_request) {
        return false;
    }
    return stamp.time == m_cloudTime || contentDigest(cloud) == m_cloudDigest;
}

}  // namespace rubble::io
