#include "core/fe/site_mesh.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

/// Nodes of a grid, raised triangle by triangle.
class RaisedNodes {
public:
    /// @param kept  nodes of the terrain to each side of its window that are taken
    RaisedNodes(const TerrainGrid& terrain, std::size_t split, const GridSides& kept)
        : m_cell(terrain.cell() / static_cast<double>(split)) {
        const TerrainExtent& whole = terrain.extent();
        const std::size_t firstColumn = whole.column - kept[0];
        const std::size_t firstRow = whole.row - kept[2];
        m_extent.x0 = whole.x0;
        m_extent.y0 = whole.y0;
        m_extent.column = kept[0] * split;
        m_extent.row = kept[2] * split;
        m_extent.columns = (whole.columns - 1) * split + 1;
        m_extent.rows = (whole.rows - 1) * split + 1;
        const GridSides there = nodesAround(terrain);
        for (std::size_t side = 0; side < kept.size(); ++side) {
            m_extent.unread[side] = whole.unread[side] + there[side] - kept[side];
        }
        m_nx = m_extent.columns + (kept[0] + kept[1]) * split;
        m_ny = m_extent.rows + (kept[2] + kept[3]) * split;
        m_heights.reserve(m_nx * m_ny);
        for (std::size_t j = 0; j < m_ny; ++j) {
            for (std::size_t i = 0; i < m_nx; ++i) {
                const bool node = i % split == 0 && j % split == 0;
                m_heights.push_back(node ? terrain.node(firstColumn + i / split, firstRow + j / split)
                                         : terrain.height(x(i), y(j)));
                if (!whole.missing.empty()) {
                    const std::size_t column = firstColumn + (i + split / 2) / split;
                    const std::size_t row = firstRow + (j + split / 2) / split;
                    m_extent.missing.push_back(whole.missing[row * terrain.nx() + column]);
                }
            }
        }
    }

    void raise(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 normal = (b - a).cross(c - a);
        const double area = normal.z();
        const auto [iFrom, iTo] =
            around(std::min({a.x(), b.x(), c.x()}), std::max({a.x(), b.x(), c.x()}), m_extent.x0, m_extent.column, m_nx);
        const auto [jFrom, jTo] =
            around(std::min({a.y(), b.y(), c.y()}), std::max({a.y(), b.y(), c.y()}), m_extent.y0, m_extent.row, m_ny);
        // A wall has no outline from above; roofs and tops bound it.
        if (!normal.allFinite() || !(std::abs(area) > 1e-9 * normal.norm())) {
            return;
        }
        for (std::size_t j = jFrom; j < jTo; ++j) {
            for (std::size_t i = iFrom; i < iTo; ++i) {
                const double u = ((x(i) - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (y(j) - a.y())) / area;
                const double v = ((b.x() - a.x()) * (y(j) - a.y()) - (x(i) - a.x()) * (b.y() - a.y())) / area;
                if (u >= -edge && v >= -edge && u + v <= 1.0 + edge) {
                    double& height = m_heights[j * m_nx + i];
                    height = std::max(height, a.z() + u * (b.z() - a.z()) + v * (c.z() - a.z()));
                }
            }
        }
    }

    std::shared_ptr<const TerrainGrid> grid() && {
        HeightGrid grid{x(0), y(0), m_cell, m_cell, m_nx, m_ny, std::move(m_heights)};
        return std::make_shared<const TerrainGrid>(std::move(grid), std::move(m_extent));
    }

    /// Nodes of a terrain to each side of its window.
    static GridSides nodesAround(const TerrainGrid& terrain) {
        const TerrainExtent& extent = terrain.extent();
        return {extent.column, terrain.nx() - extent.column - extent.columns, extent.row, terrain.ny() - extent.row - extent.rows};
    }

private:
    static constexpr double edge = 1e-9;
    double x(std::size_t i) const { return m_extent.x0 + m_cell * (static_cast<double>(i) - static_cast<double>(m_extent.column)); }
    double y(std::size_t j) const { return m_extent.y0 + m_cell * (static_cast<double>(j) - static_cast<double>(m_extent.row)); }
    std::pair<std::size_t, std::size_t> around(double low, double high, double first, std::size_t before, std::size_t nodes) const {
        const auto clamped = [&](double u) {
            return static_cast<std::size_t>(std::clamp(u + static_cast<double>(before), 0.0, static_cast<double>(nodes)));
        };
        return {clamped(std::ceil((low - first) / m_cell - edge)), clamped(std::floor((high - first) / m_cell + edge) + 1.0)};
    }

    double m_cell;
    std::size_t m_nx = 0, m_ny = 0;
    std::vector<double> m_heights;
    TerrainExtent m_extent;
};

/// Of the window about the structure alone, so that what is read around it changes nothing within.
std::size_t splitFor(const TerrainExtent& window, double spacing, double cell, double nodesMax) {
    const auto wanted = static_cast<std::size_t>(std::clamp(std::ceil(spacing / cell - 1e-9), 1.0, 64.0));
    std::size_t split = wanted;
    const auto nodes = [&](std::size_t s) {
        return static_cast<double>((window.columns - 1) * s + 1) * static_cast<double>((window.rows - 1) * s + 1);
    };
    while (split > 1 && nodes(split) > nodesMax) {
        --split;
    }
    return split;
}

}  // namespace

std::shared_ptr<const TerrainGrid> terrainUnder(const TerrainGrid& terrain, const std::vector<SiteMesh>& meshes, double cell,
                                                double nodesMax, const Execution& execution) {
    const TerrainExtent& window = terrain.extent();
    const std::size_t split = splitFor(window, terrain.cell(), cell, nodesMax);
    const auto count = [split](std::size_t columns, std::size_t rows) {
        return static_cast<double>((columns - 1) * split + 1) * static_cast<double>((rows - 1) * split + 1);
    };
    RaisedNodes nodes(terrain, split, roomAround(window.columns, window.rows, RaisedNodes::nodesAround(terrain), nodesMax, count));
    for (const SiteMesh& mesh : meshes) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (t % 4096 == 0) {
                execution.check();
            }
            const auto& corner = mesh.triangles[t];
            nodes.raise(mesh.points[corner[0]], mesh.points[corner[1]], mesh.points[corner[2]]);
        }
    }
    return std::move(nodes).grid();
}

}  // namespace rubble
