#include "core/fe/terrain_grid.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace rubble {

namespace {

/// Cell and place within it along one axis; beyond the edges the place on the edge. Not a number stays one.
struct Along {
    std::size_t cell;
    double share;
};

Along along(double coordinate, double first, double spacing, std::size_t nodes) {
    const double last = static_cast<double>(nodes - 1);
    double u = (coordinate - first) / spacing;
    u = u < 0.0 ? 0.0 : u > last ? last : u;
    const std::size_t cell = u > 0.0 ? std::min(static_cast<std::size_t>(u), nodes - 2) : 0;
    return {cell, u - static_cast<double>(cell)};
}

/// Nodes around an interval along one axis, both included; all of them if it is not a proper interval.
std::pair<std::size_t, std::size_t> nodesAround(double low, double high, double first, double spacing, std::size_t nodes) {
    if (!(low <= high)) {
        return {0, nodes - 1};
    }
    return {along(low, first, spacing, nodes).cell, along(high, first, spacing, nodes).cell + 1};
}

[[noreturn]] void refuse(Message what) {
    throw UsageError(std::move(what),
                     {"terrain.grid.remedy", "Give a raster of finite heights with at least two rows and columns.", {}});
}

}  // namespace

TerrainGrid::TerrainGrid(double x0, double y0, double cell, std::size_t nx, std::size_t ny, std::vector<double> heights)
    : m_x0(x0), m_y0(y0), m_cell(cell), m_nx(nx), m_ny(ny), m_heights(std::move(heights)) {
    if (!std::isfinite(x0) || !std::isfinite(y0) || !std::isfinite(cell) || cell <= 0.0) {
        refuse({"terrain.grid.place",
                "A terrain with its first node at ({0}, {1}) and cells of {2} has no place",
                {{x0, "m"}, {y0, "m"}, {cell, "m"}}});
    }
    if (nx < 2 || ny < 2 || m_heights.size() / nx != ny || m_heights.size() % nx != 0) {
        refuse({"terrain.grid.counts", "{0} heights do not make a terrain of {1} by {2} nodes", {m_heights.size(), nx, ny}});
    }
    for (std::size_t k = 0; k < m_heights.size(); ++k) {
        if (!std::isfinite(m_heights[k])) {
            refuse({"terrain.grid.height",
                    "The terrain has no finite height at node {0} of row {1}, counted from the south-west",
                    {k % nx, k / nx}});
        }
    }
    const auto [lowest, highest] = std::minmax_element(m_heights.begin(), m_heights.end());
    m_lowest = *lowest;
    m_highest = *highest;
    m_digest =
        Hasher().value(x0).value(y0).value(cell).value(std::uint64_t{nx}).values(std::span<const double>(m_heights)).finish();
}

double TerrainGrid::height(double x, double y) const {
    const Along u = along(x, m_x0, m_cell, m_nx);
    const Along v = along(y, m_y0, m_cell, m_ny);
    const double* low = &m_heights[v.cell * m_nx + u.cell];
    const double* high = low + m_nx;
    // Weights of the corners rather than slopes: a node keeps its height to the last bit.
    if (u.share >= v.share) {
        return (1.0 - u.share) * low[0] + (u.share - v.share) * low[1] + v.share * high[1];
    }
    return (1.0 - v.share) * low[0] + (v.share - u.share) * high[0] + u.share * high[1];
}

Vec3 TerrainGrid::normal(double x, double y) const {
    const Along u = along(x, m_x0, m_cell, m_nx);
    const Along v = along(y, m_y0, m_cell, m_ny);
    const double* low = &m_heights[v.cell * m_nx + u.cell];
    const double* high = low + m_nx;
    const double xEnd = m_x0 + m_cell * static_cast<double>(m_nx - 1);
    const double yEnd = m_y0 + m_cell * static_cast<double>(m_ny - 1);
    // West and north of the grid the edge belongs to upper triangles, east and south of it to lower ones.
    const bool lower = u.share >= v.share && x >= m_x0 && y <= yEnd;
    double alongX = lower ? low[1] - low[0] : high[1] - high[0];
    double alongY = lower ? high[1] - low[1] : high[0] - low[0];
    if (x < m_x0 || x > xEnd) {
        alongX = 0.0;
    }
    if (y < m_y0 || y > yEnd) {
        alongY = 0.0;
    }
    return Vec3(-alongX, -alongY, m_cell).normalized();
}

double TerrainGrid::highestOver(double xMin, double yMin, double xMax, double yMax) const {
    const auto [iFrom, iTo] = nodesAround(xMin, xMax, m_x0, m_cell, m_nx);
    const auto [jFrom, jTo] = nodesAround(yMin, yMax, m_y0, m_cell, m_ny);
    double highest = node(iFrom, jFrom);
    for (std::size_t j = jFrom; j <= jTo; ++j) {
        for (std::size_t i = iFrom; i <= iTo; ++i) {
            highest = std::max(highest, node(i, j));
        }
    }
    return highest;
}

}  // namespace rubble
