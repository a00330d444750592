#include "core/clusters/grid_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rubble {

namespace {

constexpr int bits = 20;                       // of one coordinate of a cell
constexpr double cellsMost = 1 << (bits - 1);  // along one axis
constexpr int cellsAroundEdge = 4;

using Cell = std::array<std::uint32_t, 3>;

std::uint64_t keyOf(const Cell& cell) {
    return (static_cast<std::uint64_t>(cell[0]) << (2 * bits)) | (static_cast<std::uint64_t>(cell[1]) << bits) | cell[2];
}

Cell cellOf(std::uint64_t key) {
    constexpr std::uint64_t mask = (1u << bits) - 1;
    return {static_cast<std::uint32_t>((key >> (2 * bits)) & mask), static_cast<std::uint32_t>((key >> bits) & mask),
            static_cast<std::uint32_t>(key & mask)};
}

/// Cells that hold the centre of a fragment's box, each once.
std::vector<std::uint64_t> cellsOf(const FragmentSet& fragments, const Vec3& low, const Vec3& size) {
    std::vector<std::uint64_t> cells;
    cells.reserve(fragments.size());
    for (const Fragment& fragment : fragments.list) {
        const Vec3 place = (fragment.bounds.center() - low).cwiseQuotient(size);
        Cell cell;
        for (int axis = 0; axis < 3; ++axis) {
            cell[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(std::max(0.0, std::floor(place[axis])));
        }
        cells.push_back(keyOf(cell));
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

/// Edges along one axis by their lower end, once for each cell around them, in order.
std::vector<std::uint64_t> edgesAlong(std::size_t axis, const std::vector<std::uint64_t>& cells) {
    std::vector<std::uint64_t> edges;
    edges.reserve(4 * cells.size());
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const std::uint64_t key : cells) {
        const Cell cell = cellOf(key);
        for (std::uint32_t corner = 0; corner < cellsAroundEdge; ++corner) {
            Cell end = cell;
            end[u] += corner & 1u;
            end[v] += corner >> 1u;
            edges.push_back(keyOf(end));
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

}  // namespace

std::vector<Eigen::Vector3f> gridOutline(const FragmentSet& fragments, const std::array<double, 3>& size) {
    Aabb all;
    for (const Fragment& fragment : fragments.list) {
        all.extend(fragment.bounds);
    }
    const Vec3 step(size[0], size[1], size[2]);
    if (all.isEmpty() || !step.allFinite() || !(step.minCoeff() > 0.0) ||
        !(all.sizes().cwiseQuotient(step).maxCoeff() < cellsMost)) {
        return {};
    }
    const Vec3 low = all.min();
    const std::vector<std::uint64_t> cells = cellsOf(fragments, low, step);
    std::vector<Eigen::Vector3f> lines;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<std::uint64_t> edges = edgesAlong(axis, cells);
        for (auto edge = edges.begin(); edge != edges.end();) {
            auto next = edge + 1;
            while (next != edges.end() && *next == *edge) {
                ++next;
            }
            // An edge with cells all around it lies inside.
            if (next - edge < cellsAroundEdge) {
                Cell end = cellOf(*edge);
                for (int side = 0; side < 2; ++side) {
                    const Vec3 corner(end[0], end[1], end[2]);
                    lines.emplace_back((low + corner.cwiseProduct(step)).cast<float>());
                    ++end[axis];
                }
            }
            edge = next;
        }
    }
    return lines;
}

}  // namespace rubble
