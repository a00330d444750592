#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Highest box above each cell of 5 cm of a rectangle around the origin.
class HeapSurface {
public:
    HeapSurface(const std::vector<OrientedBox>& boxes, double halfX, double halfY);
    /// Calls visit(x, y, top) for every cell [m]; the top is negative where there is no box.
    template <class Visit>
    void each(Visit visit) const {
        for (std::size_t j = 0; j < m_ny; ++j) {
            for (std::size_t i = 0; i < m_nx; ++i) {
                visit(x(i), y(j), m_top[j * m_nx + i]);
            }
        }
    }

private:
    static constexpr double cell = 0.05;  ///< m

    double x(std::size_t i) const { return -m_halfX + cell * (static_cast<double>(i) + 0.5); }
    double y(std::size_t j) const { return -m_halfY + cell * (static_cast<double>(j) + 0.5); }

    double m_halfX, m_halfY;
    std::size_t m_nx, m_ny;
    std::vector<double> m_top;
};

/// Mean height of a surface by distance from its centre (or along x).
class HeapProfile {
public:
    /// @param width  m, of a bin of distance
    explicit HeapProfile(double width) : m_width(width) {}

    /// Bare cells count as height 0.
    void add(double distance, double top);
    /// To be called once, after the last cell.
    void finish();
    /// [bins] m, mean over all cells
    const std::vector<double>& height() const { return m_height; }

private:
    double m_width;
    std::vector<double> m_cells;
    std::vector<double> m_height;
};

/// The boxes that hang together with the one nearest to a point: the deposit without what rolled off alone. Its edge is the run-out
/// of Lube et al. 2004 and Staron & Hinch 2005; the front is a single layer of blocks that barely touch.
/// @param gap  m, that counts as touching
std::vector<OrientedBox> joinedBoxes(const std::vector<OrientedBox>& boxes, const Vec3& heart, double gap);

/// Mean over sectors of the farthest reach in each.
/// @param sectorOf  index of a box's sector; beyond the last it counts for the last
template <class Sector, class Reach>
double meanFront(const std::vector<OrientedBox>& boxes, std::size_t sectors, Sector sectorOf, Reach reachOf) {
    std::vector<double> farthest(sectors, 0.0);
    for (const OrientedBox& box : boxes) {
        double& most = farthest[std::min(sectorOf(box), sectors - 1)];
        most = std::max(most, reachOf(box));
    }
    double sum = 0.0;
    for (const double reach : farthest) {
        sum += reach;
    }
    return sum / static_cast<double>(sectors);
}

/// y = factor x^exponent.
struct PowerLaw {
    double exponent = 0.0;
    double factor = 0.0;
};
/// By least squares in the logarithms; no number with fewer than two x or where one is not positive.
PowerLaw powerLawThrough(const std::vector<std::pair<double, double>>& points);

/// Factor by which two positive numbers differ; infinity where one is not positive.
double factorApart(double a, double b);

}  // namespace rubble
