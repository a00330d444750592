#include "io/site/clouds/octree/octree_builder.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <tuple>
#include <utility>

namespace rubble::io {

namespace {

/// Points of a node that are written before it is whole: such as a million at one place.
constexpr std::size_t partPoints = std::size_t{1} << 18;

std::uint64_t prefixOf(std::uint64_t key, int level) {
    return key >> static_cast<unsigned>(3 * (octreeKeyLevels - level));
}

}  // namespace

OctreeBuilder::OctreeBuilder(std::ostream& out, std::uint64_t start, const OctreeCube& cube, const OctreeColumns& columns)
    : m_out(out), m_end(start), m_cube(cube), m_columns(columns) {
    open(0, 0);
}

void OctreeBuilder::open(std::uint64_t key, int level) {
    Node node;
    node.prefix = prefixOf(key, level);
    node.level = level;
    m_path.push_back(std::move(node));
}

void OctreeBuilder::add(const OctreePoint& point) {
    const int shared = m_begun ? sharedLevels(m_last, point.key) : -1;
    while (m_begun && m_path.back().level > shared) {
        close();
    }
    // The coarsest cell of which it is the first point is one halving finer than what it shares with the point before.
    const int level = std::clamp(shared + 1 - octreeCellLevels, 0, octreeDeepest);
    while (m_path.back().level < level) {
        open(point.key, m_path.back().level + 1);
    }
    Node& node = m_path[static_cast<std::size_t>(level)];
    node.points.push_back(point);
    if (node.points.size() == partPoints) {
        write(node);
        node.points.clear();
        node.written = true;
    }
    m_last = point.key;
    m_begun = true;
}

void OctreeBuilder::close() {
    Node node = std::move(m_path.back());
    m_path.pop_back();
    const std::size_t all = std::accumulate(node.leaves.begin(), node.leaves.end(), node.points.size(),
                                            [](std::size_t sum, const Leaf& leaf) { return sum + leaf.points.size(); });
    if (!node.written && all <= octreeLeafPoints) {
        for (const Leaf& leaf : node.leaves) {
            node.points.insert(node.points.end(), leaf.points.begin(), leaf.points.end());
        }
        if (m_path.empty()) {
            write(node);
        } else if (all > 0) {
            m_path.back().leaves.push_back({node.prefix, node.level, std::move(node.points)});
        }
        return;
    }
    write(node);
    for (const Leaf& leaf : node.leaves) {
        write(leaf);
    }
    if (!m_path.empty()) {
        m_path.back().written = true;
    }
}

void OctreeBuilder::write(const Leaf& leaf) {
    if (leaf.points.empty()) {
        return;
    }
    m_bytes.resize(leaf.points.size() * m_columns.pointBytes());
    unsigned char* at = m_bytes.data();
    const auto put = [&at](const auto& number) {
        std::memcpy(at, &number, sizeof number);
        at += sizeof number;
    };
    for (const OctreePoint& point : leaf.points) {
        put(m_cube.stepsOf(point));
        if (m_columns.intensity) {
            put(point.intensity);
        }
        if (m_columns.colour) {
            put(point.colour);
        }
        if (m_columns.classes) {
            put(point.kind);
        }
    }
    m_out.write(reinterpret_cast<const char*>(m_bytes.data()), static_cast<std::streamsize>(m_bytes.size()));
    m_nodes.push_back({leaf.prefix, m_end, static_cast<std::uint32_t>(leaf.level), 0,
                       static_cast<std::uint32_t>(leaf.points.size()), Hasher().bytes(m_bytes.data(), m_bytes.size()).finish()});
    m_end += m_bytes.size();
}

std::vector<OctreeEntry> OctreeBuilder::finish() {
    while (!m_path.empty()) {
        close();
    }
    const auto place = [](const OctreeEntry& node) { return std::tuple(node.level, node.prefix, node.start); };
    std::sort(m_nodes.begin(), m_nodes.end(),
              [&](const OctreeEntry& one, const OctreeEntry& other) { return place(one) < place(other); });
    return std::move(m_nodes);
}

}  // namespace rubble::io
