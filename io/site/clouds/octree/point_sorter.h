#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "io/site/clouds/octree/octree_cube.h"

namespace rubble::io {

/// Brings the points of a cloud of any size into the order of their keys with the memory of two runs of 4 million: what does not
/// fit lies in a file without a name, which the system removes whatever happens.
class PointSorter {
public:
    /// @param beside  path beside which the file is made once it is needed
    /// @param runPoints  points of a run
    explicit PointSorter(std::string beside, std::size_t runPoints = std::size_t{4} << 20);
    ~PointSorter();
    PointSorter(const PointSorter&) = delete;
    PointSorter& operator=(const PointSorter&) = delete;

    /// Throws WorldError.
    void add(const OctreePoint& point) {
        m_filling.push_back(point);
        if (m_filling.size() == m_runPoints) {
            putAway();
        }
    }
    /// Hands over all points in order, once. Throws WorldError, Cancelled.
    void forEach(const Execution& execution, const std::function<void(const OctreePoint&)>& visit);

private:
    struct Run;
    void putAway();
    void writeRun(const std::vector<OctreePoint>& points, std::uint64_t at);
    void merge(const Execution& execution, const std::function<void(const OctreePoint&)>& visit);

    std::string m_beside;
    std::size_t m_runPoints;
    int m_file = -1;
    std::vector<std::uint64_t> m_runs;  ///< points of each that was put away
    std::uint64_t m_kept = 0;           ///< points of all of them
    std::vector<OctreePoint> m_filling;
    std::vector<OctreePoint> m_sorting;
    std::future<void> m_work;
};

}  // namespace rubble::io
