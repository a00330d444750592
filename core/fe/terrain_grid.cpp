#include "core/fe/terrain_grid.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace rubble {

namespace {

/// One axis of the nodes.
struct Axis {
    double anchor;       ///< m, of the node that places are counted from
    double spacing;      ///< m
    std::size_t before;  ///< nodes below that one
    std::size_t nodes;

    double at(std::size_t i) const { return anchor + spacing * (static_cast<double>(i) - static_cast<double>(before)); }
    double first() const { return at(0); }
    double last() const { return at(nodes - 1); }
};

/// Cell and place within it along one axis; beyond the edges the place on the edge. Not a number stays one.
struct Along {
    std::size_t cell;
    double share;
};

Along along(double coordinate, const Axis& axis) {
    const double low = -static_cast<double>(axis.before);
    const double high = static_cast<double>(axis.nodes - 1) + low;
    double u = (coordinate - axis.anchor) / axis.spacing;
    if (!(u > low)) {
        return {0, std::isnan(u) ? u : 0.0};
    }
    u = std::min(u, high);
    auto whole = static_cast<std::int64_t>(u);
    whole -= static_cast<double>(whole) > u ? 1 : 0;
    const auto before = static_cast<std::int64_t>(axis.before);
    whole = std::min(whole, static_cast<std::int64_t>(axis.nodes) - 2 - before);
    return {static_cast<std::size_t>(whole + before), u - static_cast<double>(whole)};
}

/// Nodes around an interval along one axis, both included.
std::pair<std::size_t, std::size_t> nodesAround(double low, double high, const Axis& axis) {
    return {along(low, axis).cell, along(high, axis).cell + 1};
}

Axis xAxis(const HeightGrid& grid, const TerrainExtent& extent) {
    return {extent.x0, grid.dx, extent.column, grid.nx};
}

Axis yAxis(const HeightGrid& grid, const TerrainExtent& extent) {
    return {extent.y0, grid.dx, extent.row, grid.ny};
}

/// The mean difference of two normal deviates is 2 / sqrt(pi) of their standard deviation.
constexpr double deviationOfObstacles = 0.886226925452758;
/// Standard deviations that a node is away at most: sqrt(12).
constexpr double mostDeviations = 3.46410161513776;

/// A deviate of mean 0 and variance 1 for a node of a lattice, nearly normal: the sum of four even ones (Irwin-Hall).
double standardDeviate(std::uint64_t seed, std::int64_t i, std::int64_t j) {
    // SplitMix64 (Steele, Lea & Flood 2014) over the numbers of the node.
    std::uint64_t z = seed;
    for (const std::int64_t part : {i, j, std::int64_t{0}}) {
        z += 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(part);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        z ^= z >> 31;
    }
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) {
        sum += static_cast<double>((z >> (16 * k)) & 0xffffULL) / 65535.0 - 0.5;
    }
    // Four deviates of variance 1 / 12 each.
    return 0.5 * mostDeviations * sum;
}

[[noreturn]] void refuse(Message what) {
    throw UsageError(std::move(what),
                     {"terrain.grid.remedy", "Give a raster of finite heights with at least two rows and columns.", {}});
}

}  // namespace

TerrainGrid::TerrainGrid(double x0, double y0, double cell, std::size_t nx, std::size_t ny, std::vector<double> heights)
    : TerrainGrid(HeightGrid{x0, y0, cell, cell, nx, ny, std::move(heights)}) {}

TerrainGrid::TerrainGrid(HeightGrid grid, TerrainExtent extent) : m_grid(std::move(grid)), m_extent(std::move(extent)) {
    check();
    const auto [lowest, highest] = std::minmax_element(m_grid.heights.begin(), m_grid.heights.end());
    m_lowest = *lowest;
    m_highest = *highest;
    takeExtent();
    Hasher hasher;
    hasher.value(m_grid.x0).value(m_grid.y0).value(m_grid.dx).value(std::uint64_t{m_grid.nx});
    hasher.values(std::span<const double>(m_grid.heights));
    if (m_extent.columns != m_grid.nx || m_extent.rows != m_grid.ny) {
        hasher.value(m_extent.x0).value(m_extent.y0);
        for (const std::size_t n : {m_extent.column, m_extent.row, m_extent.columns, m_extent.rows}) {
            hasher.value(std::uint64_t{n});
        }
    }
    for (std::size_t side = 0; side < m_extent.unread.size(); ++side) {
        if (m_extent.unread[side] > 0) {
            hasher.value(std::uint64_t{side});
        }
    }
    if (!m_extent.missing.empty()) {
        hasher.values(std::span<const std::uint8_t>(m_extent.missing));
    }
    m_digest = hasher.finish();
}

void TerrainGrid::check() const {
    const auto& [x0, y0, cell, other, nx, ny, heights] = m_grid;
    if (!std::isfinite(x0) || !std::isfinite(y0) || !std::isfinite(cell) || cell <= 0.0 || other != cell) {
        refuse({"terrain.grid.place",
                "A terrain with its first node at ({0}, {1}) and cells of {2} has no place",
                {{x0, "m"}, {y0, "m"}, {cell, "m"}}});
    }
    if (nx < 2 || ny < 2 || heights.size() / nx != ny || heights.size() % nx != 0) {
        refuse({"terrain.grid.counts", "{0} heights do not make a terrain of {1} by {2} nodes", {heights.size(), nx, ny}});
    }
    for (std::size_t k = 0; k < heights.size(); ++k) {
        if (!std::isfinite(heights[k])) {
            refuse({"terrain.grid.height",
                    "The terrain has no finite height at node {0} of row {1}, counted from the south-west",
                    {k % nx, k / nx}});
        }
    }
}

void TerrainGrid::takeExtent() {
    if (m_extent.columns == 0 || m_extent.rows == 0) {
        m_extent.column = m_extent.row = 0;
        m_extent.columns = m_grid.nx;
        m_extent.rows = m_grid.ny;
        m_extent.x0 = m_grid.x0;
        m_extent.y0 = m_grid.y0;
    }
    const Axis x = xAxis(m_grid, m_extent);
    const Axis y = yAxis(m_grid, m_extent);
    const std::size_t lastColumn = m_extent.column + m_extent.columns - 1;
    const std::size_t lastRow = m_extent.row + m_extent.rows - 1;
    Vec3 low(m_extent.x0, m_extent.y0, m_highest);
    Vec3 high(x.at(lastColumn), y.at(lastRow), m_lowest);
    for (std::size_t j = m_extent.row; j <= lastRow; ++j) {
        for (std::size_t i = m_extent.column; i <= lastColumn; ++i) {
            low.z() = std::min(low.z(), node(i, j));
            high.z() = std::max(high.z(), node(i, j));
        }
    }
    m_window = Aabb(low, high);
}

TerrainGrid TerrainGrid::roughened(const TerrainRoughness& roughness) const {
    if (!std::isfinite(roughness.height) || roughness.height < 0.0 || !std::isfinite(roughness.spacing) ||
        roughness.spacing <= 0.0) {
        refuse({"terrain.grid.roughness",
                "A roughness of {0} on a lattice of {1} is none",
                {{roughness.height, "m"}, {roughness.spacing, "m"}}});
    }
    TerrainGrid rough = *this;
    rough.m_roughness = roughness;
    rough.m_lowest -= rough.mostRough();
    rough.m_highest += rough.mostRough();
    Hasher hasher;
    rough.m_digest =
        hasher.digest(m_digest).value(roughness.height).value(roughness.spacing).value(std::uint64_t{roughness.seed}).finish();
    return rough;
}

double TerrainGrid::mostRough() const {
    return m_roughness.height * deviationOfObstacles * mostDeviations;
}

/// Height of a node of the lattice of roughness, m. @param i, j  whole numbers
double TerrainGrid::roughNode(double i, double j) const {
    const double noise = m_roughness.height * deviationOfObstacles *
                         standardDeviate(m_roughness.seed, static_cast<std::int64_t>(i), static_cast<std::int64_t>(j));
    return smoothHeight(m_extent.x0 + i * m_roughness.spacing, m_extent.y0 + j * m_roughness.spacing) + noise;
}

double TerrainGrid::height(double x, double y) const {
    if (!(m_roughness.height > 0.0) || !std::isfinite(x) || !std::isfinite(y)) {
        return smoothHeight(x, y);
    }
    const double u = (x - m_extent.x0) / m_roughness.spacing, v = (y - m_extent.y0) / m_roughness.spacing;
    const double i = std::floor(u), j = std::floor(v);
    const double along = u - i, across = v - j;
    if (along >= across) {
        return (1.0 - along) * roughNode(i, j) + (along - across) * roughNode(i + 1, j) + across * roughNode(i + 1, j + 1);
    }
    return (1.0 - across) * roughNode(i, j) + (across - along) * roughNode(i, j + 1) + along * roughNode(i + 1, j + 1);
}

double TerrainGrid::smoothHeight(double x, double y) const {
    const Along u = along(x, xAxis(m_grid, m_extent));
    const Along v = along(y, yAxis(m_grid, m_extent));
    const double* low = &m_grid.heights[v.cell * m_grid.nx + u.cell];
    const double* high = low + m_grid.nx;
    // Weights of the corners rather than slopes: a node keeps its height to the last bit.
    if (u.share >= v.share) {
        return (1.0 - u.share) * low[0] + (u.share - v.share) * low[1] + v.share * high[1];
    }
    return (1.0 - v.share) * low[0] + (v.share - u.share) * high[0] + u.share * high[1];
}

Vec3 TerrainGrid::normal(double x, double y) const {
    if (m_roughness.height > 0.0 && std::isfinite(x) && std::isfinite(y)) {
        const double u = (x - m_extent.x0) / m_roughness.spacing, v = (y - m_extent.y0) / m_roughness.spacing;
        const double i = std::floor(u), j = std::floor(v);
        const double low = roughNode(i, j), high = roughNode(i + 1, j + 1);
        const bool lower = u - i >= v - j;
        const double other = lower ? roughNode(i + 1, j) : roughNode(i, j + 1);
        const double alongX = lower ? other - low : high - other;
        const double alongY = lower ? high - other : other - low;
        return Vec3(-alongX, -alongY, m_roughness.spacing).normalized();
    }
    const Axis xs = xAxis(m_grid, m_extent);
    const Axis ys = yAxis(m_grid, m_extent);
    const Along u = along(x, xs);
    const Along v = along(y, ys);
    const double* low = &m_grid.heights[v.cell * m_grid.nx + u.cell];
    const double* high = low + m_grid.nx;
    const double west = xs.first();
    const double east = xs.last();
    const double south = ys.first();
    const double north = ys.last();
    // West and north of the grid the edge belongs to upper triangles, east and south of it to lower ones.
    const bool lower = u.share >= v.share && x >= west && y <= north;
    double alongX = lower ? low[1] - low[0] : high[1] - high[0];
    double alongY = lower ? high[1] - low[1] : high[0] - low[0];
    if (x < west || x > east) {
        alongX = 0.0;
    }
    if (y < south || y > north) {
        alongY = 0.0;
    }
    return Vec3(-alongX, -alongY, m_grid.dx).normalized();
}

double TerrainGrid::highestOver(double xMin, double yMin, double xMax, double yMax) const {
    if (!(xMin <= xMax && yMin <= yMax)) {
        return m_highest;
    }
    if (m_roughness.height > 0.0) {
        const double beyond = m_roughness.spacing;
        xMin -= beyond;
        xMax += beyond;
        yMin -= beyond;
        yMax += beyond;
    }
    const auto [iFrom, iTo] = nodesAround(xMin, xMax, xAxis(m_grid, m_extent));
    const auto [jFrom, jTo] = nodesAround(yMin, yMax, yAxis(m_grid, m_extent));
    double highest = node(iFrom, jFrom);
    for (std::size_t j = jFrom; j <= jTo; ++j) {
        for (std::size_t i = iFrom; i <= iTo; ++i) {
            highest = std::max(highest, node(i, j));
        }
    }
    return highest + mostRough();
}

TerrainGrid::Source TerrainGrid::source(double x, double y) const {
    const Axis xs = xAxis(m_grid, m_extent);
    const Axis ys = yAxis(m_grid, m_extent);
    // A height stands for half a cell around its node.
    const double half = 0.5 * m_grid.dx;
    const std::array<bool, 4> beyond{x<xs.first() - half, x> xs.last() + half, y<ys.first() - half, y> ys.last() + half};
    Source source = Source::Raster;
    for (std::size_t side = 0; side < beyond.size(); ++side) {
        if (beyond[side]) {
            if (m_extent.unread[side] == 0) {
                return Source::Ended;
            }
            source = Source::Unread;
        }
    }
    if (m_extent.missing.empty() || source == Source::Unread) {
        return source;
    }
    const Along u = along(x, xs);
    const Along v = along(y, ys);
    const std::size_t i = u.cell + (u.share > 0.5 ? 1 : 0);
    const std::size_t j = v.cell + (v.share > 0.5 ? 1 : 0);
    return m_extent.missing[j * m_grid.nx + i] != 0 ? Source::Ended : Source::Raster;
}

GridSides roomAround(std::size_t columns, std::size_t rows, const GridSides& there, double nodesMax,
                     const std::function<double(std::size_t, std::size_t)>& nodes) {
    const auto taken = [&](std::size_t most) {
        GridSides sides = there;
        for (std::size_t& side : sides) {
            side = std::min(side, most);
        }
        return sides;
    };
    const auto fits = [&](std::size_t most) {
        const GridSides sides = taken(most);
        return nodes(columns + sides[0] + sides[1], rows + sides[2] + sides[3]) <= nodesMax;
    };
    std::size_t fitting = 0;
    std::size_t most = *std::max_element(there.begin(), there.end());
    if (fits(most)) {
        return there;
    }
    while (most - fitting > 1) {
        const std::size_t middle = fitting + (most - fitting) / 2;
        (fits(middle) ? fitting : most) = middle;
    }
    return taken(fitting);
}

}  // namespace rubble
