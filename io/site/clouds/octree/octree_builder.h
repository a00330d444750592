#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "core/base/hash.h"
#include "io/site/clouds/octree/octree_cube.h"

namespace rubble::io {

/// Points of a leaf at most.
inline constexpr std::size_t octreeLeafPoints = 16'384;

/// A node as the table of the file has it.
struct OctreeEntry {
    std::uint64_t prefix = 0;  ///< the first halvings of its keys
    std::uint64_t start = 0;   ///< of its points in the file, bytes
    std::uint32_t level = 0;   ///< how many halvings these are
    std::uint32_t part = 0;    ///< 0: the bulk of the points, 1: far ones; the builder leaves it
    std::uint32_t points = 0;
    Digest digest;  ///< of the bytes of its points
};

/// What points have beside their places.
struct OctreeColumns {
    bool intensity = false;
    bool colour = false;
    bool classes = false;

    std::size_t pointBytes() const { return 12 + (intensity ? 4U : 0U) + (colour ? 3U : 0U) + (classes ? 1U : 0U); }
};

/// Lays points that come in the order of their keys into the nodes of an octree and writes each as soon as it is whole. The first
/// point of a cell goes to the coarsest node of which it is the first one there, so each lies in one node; a branch with few
/// points is one leaf. Memory is that of the nodes from the root to one leaf.
class OctreeBuilder {
public:
    OctreeBuilder(std::ostream& out, std::uint64_t start, const OctreeCube& cube, const OctreeColumns& columns);

    void add(const OctreePoint& point);
    /// Writes what is left. @return all nodes, by level and then by place; parts of one node follow each other
    std::vector<OctreeEntry> finish();
    /// Where the next byte goes.
    std::uint64_t end() const { return m_end; }

private:
    struct Leaf {
        std::uint64_t prefix = 0;
        int level = 0;
        std::vector<OctreePoint> points;
    };
    struct Node : Leaf {
        std::vector<Leaf> leaves;  ///< below it, not written yet
        bool written = false;      ///< something below it was, or a part of it
    };
    void open(std::uint64_t key, int level);
    void close();
    void write(const Leaf& leaf);

    std::ostream& m_out;
    std::uint64_t m_end;
    const OctreeCube& m_cube;
    OctreeColumns m_columns;
    std::vector<Node> m_path;  ///< from the root on
    std::vector<OctreeEntry> m_nodes;
    std::uint64_t m_last = 0;
    bool m_begun = false;
    std::vector<unsigned char> m_bytes;
};

}  // namespace rubble::io
