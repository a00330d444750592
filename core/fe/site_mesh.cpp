#include "core/fe/site_mesh.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

/// Nodes of a grid, raised triangle by triangle.
class RaisedNodes {
public:
    RaisedNodes(const TerrainGrid& terrain, std::size_t split)
        : m_cell(terrain.cell() / static_cast<double>(split)),
          m_x0(terrain.x0()),
          m_y0(terrain.y0()),
          m_nx((terrain.nx() - 1) * split + 1),
          m_ny((terrain.ny() - 1) * split + 1) {
        m_heights.reserve(m_nx * m_ny);
        for (std::size_t j = 0; j < m_ny; ++j) {
            for (std::size_t i = 0; i < m_nx; ++i) {
                const bool node = i % split == 0 && j % split == 0;
                m_heights.push_back(node ? terrain.node(i / split, j / split) : terrain.height(x(i), y(j)));
            }
        }
    }

    void raise(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 normal = (b - a).cross(c - a);
        const double area = normal.z();
        const auto [iFrom, iTo] = around(std::min({a.x(), b.x(), c.x()}), std::max({a.x(), b.x(), c.x()}), m_x0, m_nx);
        const auto [jFrom, jTo] = around(std::min({a.y(), b.y(), c.y()}), std::max({a.y(), b.y(), c.y()}), m_y0, m_ny);
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
        return std::make_shared<const TerrainGrid>(m_x0, m_y0, m_cell, m_nx, m_ny, std::move(m_heights));
    }

private:
    static constexpr double edge = 1e-9;
    double x(std::size_t i) const { return m_x0 + m_cell * static_cast<double>(i); }
    double y(std::size_t j) const { return m_y0 + m_cell * static_cast<double>(j); }
    std::pair<std::size_t, std::size_t> around(double low, double high, double first, std::size_t nodes) const {
        const auto clamped = [&](double u) { return static_cast<std::size_t>(std::clamp(u, 0.0, static_cast<double>(nodes))); };
        return {clamped(std::ceil((low - first) / m_cell - edge)), clamped(std::floor((high - first) / m_cell + edge) + 1.0)};
    }

    double m_cell;
    double m_x0, m_y0;
    std::size_t m_nx, m_ny;
    std::vector<double> m_heights;
};

std::size_t splitFor(const TerrainGrid& terrain, double cell, double nodesMax) {
    const auto wanted = static_cast<std::size_t>(std::clamp(std::ceil(terrain.cell() / cell - 1e-9), 1.0, 64.0));
    std::size_t split = wanted;
    const auto nodes = [&](std::size_t s) {
        return static_cast<double>((terrain.nx() - 1) * s + 1) * static_cast<double>((terrain.ny() - 1) * s + 1);
    };
    while (split > 1 && nodes(split) > nodesMax) {
        --split;
    }
    return split;
}

}  // namespace

std::shared_ptr<const TerrainGrid> terrainUnder(const TerrainGrid& terrain, const std::vector<SiteMesh>& meshes, double cell,
                                                double nodesMax, const Execution& execution) {
    RaisedNodes nodes(terrain, splitFor(terrain, cell, nodesMax));
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
