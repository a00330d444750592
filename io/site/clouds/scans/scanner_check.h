#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "io/site/clouds/cloud_head.h"

namespace rubble::io {

/// Finds poses at which no scanner can have stood. Programs write a pose without a turn where they know none, and the points of a
/// registered scan then lie anywhere about it. So only poses without a turn are doubted, for two reasons:
///  - the points lie farther from it than they reach among themselves, as map coordinates lie from their origin;
///  - in one direction lie points at several ranges, while a scanner sees what is nearest.
class ScannerCheck {
public:
    explicit ScannerCheck(const CloudHead& head);

    void add(const CloudBlock& block);
    /// Of each scan: the file states where its scanner stood, and it can have stood there.
    std::vector<bool> posed() const;

private:
    /// Nearest range of each direction, in cells of half a degree; 0: none yet.
    using Ranges = std::vector<float>;
    struct Looked {
        bool stated = false;
        bool doubted = false;  ///< it is to be looked at
        Vec3 place = Vec3::Zero();
        Aabb box;
        Ranges ranges;
        bool closed = false;          ///< enough was seen, the ranges are given back
        std::uint64_t compared = 0;   ///< points that lie in one direction with a nearer or a farther one
        std::uint64_t different = 0;  ///< of them at another range
        bool beyond() const;
        bool seesThrough() const;
    };

    void look(std::size_t scan, const Vec3& place);
    void open(std::size_t scan);

    std::vector<Looked> m_scans;
    std::deque<std::size_t> m_open;  ///< scans that have ranges
    bool m_each;                     ///< each point is of a scan
};

}  // namespace rubble::io
