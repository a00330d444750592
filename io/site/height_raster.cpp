#include "io/site/height_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble::io {

namespace {

/// Share of a cell that nodes may be off before cells count as not square, and that an edge may be missed by.
constexpr double aligned = 1e-3;

bool square(double dx, double dy, std::size_t nx, std::size_t ny) {
    return std::abs(dx - dy) * static_cast<double>(std::max(nx, ny)) < aligned * dx;
}

/// Nodes of spacing `cell` that span n nodes of spacing `step`, the last one on the edge or beyond it.
double nodesFor(double step, double cell, std::size_t n) {
    return std::ceil(static_cast<double>(n - 1) * step / cell - aligned) + 1.0;
}

double between(const HeightGrid& raster, double column, double row) {
    const double u = std::clamp(column, 0.0, static_cast<double>(raster.nx - 1));
    const double v = std::clamp(row, 0.0, static_cast<double>(raster.ny - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(u), raster.nx - 2);
    const std::size_t j = std::min(static_cast<std::size_t>(v), raster.ny - 2);
    const double s = u - static_cast<double>(i);
    const double t = v - static_cast<double>(j);
    const double* low = &raster.heights[j * raster.nx + i];
    const double* high = low + raster.nx;
    return (1.0 - t) * ((1.0 - s) * low[0] + s * low[1]) + t * ((1.0 - s) * high[0] + s * high[1]);
}

/// The gaps of a raster, filled ring by ring: a ring sees only what was there before it, so no order reaches the result.
class GapFilling {
public:
    explicit GapFilling(HeightGrid& raster) : m_raster(raster), m_queued(raster.heights.size(), 0) {}

    void fill() {
        std::vector<std::size_t> ring;
        for (std::size_t k = 0; k < m_raster.heights.size(); ++k) {
            if (!std::isnan(m_raster.heights[k])) {
                queueGapsAround(k, ring);
            }
        }
        std::vector<double> values;
        while (!ring.empty()) {
            values.clear();
            for (const std::size_t k : ring) {
                values.push_back(meanAround(k));
            }
            for (std::size_t n = 0; n < ring.size(); ++n) {
                m_raster.heights[ring[n]] = values[n];
            }
            std::vector<std::size_t> next;
            for (const std::size_t k : ring) {
                queueGapsAround(k, next);
            }
            ring = std::move(next);
        }
    }

private:
    template <class Visit>
    void visitAround(std::size_t k, Visit visit) const {
        const std::size_t i = k % m_raster.nx;
        const std::size_t j = k / m_raster.nx;
        for (std::size_t y = j > 0 ? j - 1 : 0; y <= std::min(j + 1, m_raster.ny - 1); ++y) {
            for (std::size_t x = i > 0 ? i - 1 : 0; x <= std::min(i + 1, m_raster.nx - 1); ++x) {
                visit(y * m_raster.nx + x);
            }
        }
    }
    void queueGapsAround(std::size_t k, std::vector<std::size_t>& ring) {
        visitAround(k, [&](std::size_t n) {
            if (std::isnan(m_raster.heights[n]) && m_queued[n] == 0) {
                m_queued[n] = 1;
                ring.push_back(n);
            }
        });
    }
    double meanAround(std::size_t k) const {
        double sum = 0.0;
        int count = 0;
        visitAround(k, [&](std::size_t n) {
            if (!std::isnan(m_raster.heights[n])) {
                sum += m_raster.heights[n];
                ++count;
            }
        });
        return sum / count;
    }

    HeightGrid& m_raster;
    std::vector<char> m_queued;
};

/// Nodes without a height, between two with one, that still lie within a raster: half of that.
constexpr std::size_t poreReach = 3;

/// A flag for each node of a grid, row by row.
struct NodeMap {
    std::size_t nx = 0;
    std::size_t ny = 0;
    std::vector<std::uint8_t> flags;
};

/// What is reached from some nodes by so many steps to one of eight neighbours, each onto a node that is open.
NodeMap reached(const NodeMap& from, const NodeMap& open, std::size_t steps) {
    NodeMap found = from;
    std::vector<std::size_t> front;
    for (std::size_t k = 0; k < from.flags.size(); ++k) {
        if (from.flags[k] != 0) {
            front.push_back(k);
        }
    }
    for (std::size_t step = 0; step < steps && !front.empty(); ++step) {
        std::vector<std::size_t> next;
        for (const std::size_t k : front) {
            const std::size_t i = k % from.nx;
            const std::size_t j = k / from.nx;
            for (std::size_t row = j > 0 ? j - 1 : 0; row <= std::min(j + 1, from.ny - 1); ++row) {
                for (std::size_t column = i > 0 ? i - 1 : 0; column <= std::min(i + 1, from.nx - 1); ++column) {
                    const std::size_t n = row * from.nx + column;
                    if (open.flags[n] != 0 && found.flags[n] == 0) {
                        found.flags[n] = 1;
                        next.push_back(n);
                    }
                }
            }
        }
        front = std::move(next);
    }
    return found;
}

NodeMap without(NodeMap nodes, const NodeMap& those) {
    for (std::size_t k = 0; k < nodes.flags.size(); ++k) {
        nodes.flags[k] = nodes.flags[k] != 0 && those.flags[k] == 0 ? 1 : 0;
    }
    return nodes;
}

/// Whether a node stands out from those around it; they are left in order.
bool standsOut(double height, std::vector<double>& around, double cell) {
    constexpr std::size_t least = 5;  // neighbours, to tell
    if (std::isnan(height) || around.size() < least) {
        return false;
    }
    std::sort(around.begin(), around.end());
    const double range = around[around.size() - 2] - around[1];
    return std::abs(height - around[around.size() / 2]) > std::max({4.0 * range, 0.5 * cell, 2.0});
}

}  // namespace

std::vector<HeightSpike> removeSpikes(HeightGrid& raster) {
    std::vector<HeightSpike> spikes;
    std::vector<double> around;
    around.reserve(8);
    for (std::size_t j = 0; j < raster.ny; ++j) {
        for (std::size_t i = 0; i < raster.nx; ++i) {
            around.clear();
            for (std::size_t row = j > 0 ? j - 1 : 0; row <= std::min(j + 1, raster.ny - 1); ++row) {
                for (std::size_t column = i > 0 ? i - 1 : 0; column <= std::min(i + 1, raster.nx - 1); ++column) {
                    const double height = raster.heights[row * raster.nx + column];
                    if ((row != j || column != i) && !std::isnan(height)) {
                        around.push_back(height);
                    }
                }
            }
            const std::size_t node = j * raster.nx + i;
            if (standsOut(raster.heights[node], around, std::max(raster.dx, raster.dy))) {
                spikes.push_back({node, raster.heights[node]});
            }
        }
    }
    // Only now, so that no order reaches the result.
    for (const HeightSpike& spike : spikes) {
        raster.heights[spike.node] = std::numeric_limits<double>::quiet_NaN();
    }
    return spikes;
}

std::vector<std::uint8_t> outerGaps(const HeightGrid& raster) {
    if (countGaps(raster) == 0) {
        return {};
    }
    // Around the raster lie gaps, so that its edge is one like any other.
    constexpr std::size_t margin = poreReach + 1;
    NodeMap gaps{raster.nx + 2 * margin, raster.ny + 2 * margin, {}};
    gaps.flags.assign(gaps.nx * gaps.ny, 1);
    const auto placeOf = [&](std::size_t k) { return (k / raster.nx + margin) * gaps.nx + k % raster.nx + margin; };
    NodeMap heights{gaps.nx, gaps.ny, std::vector<std::uint8_t>(gaps.flags.size(), 0)};
    for (std::size_t k = 0; k < raster.heights.size(); ++k) {
        gaps.flags[placeOf(k)] = std::isnan(raster.heights[k]) ? 1 : 0;
        heights.flags[placeOf(k)] = std::isnan(raster.heights[k]) ? 0 : 1;
    }
    const NodeMap all{gaps.nx, gaps.ny, std::vector<std::uint8_t>(gaps.flags.size(), 1)};
    const NodeMap far = without(gaps, reached(heights, all, poreReach));
    NodeMap corner{gaps.nx, gaps.ny, std::vector<std::uint8_t>(gaps.flags.size(), 0)};
    corner.flags.front() = 1;
    const NodeMap ended = reached(reached(corner, far, gaps.flags.size()), gaps, poreReach);
    std::vector<std::uint8_t> outer(raster.heights.size());
    for (std::size_t k = 0; k < outer.size(); ++k) {
        outer[k] = ended.flags[placeOf(k)];
    }
    return std::find(outer.begin(), outer.end(), 1) != outer.end() ? outer : std::vector<std::uint8_t>();
}

void flipRows(HeightGrid& raster) {
    for (std::size_t j = 0; j < raster.ny / 2; ++j) {
        const auto low = raster.heights.begin() + static_cast<std::ptrdiff_t>(j * raster.nx);
        const auto high = raster.heights.begin() + static_cast<std::ptrdiff_t>((raster.ny - 1 - j) * raster.nx);
        std::swap_ranges(low, low + static_cast<std::ptrdiff_t>(raster.nx), high);
    }
}

void flipColumns(HeightGrid& raster) {
    for (std::size_t j = 0; j < raster.ny; ++j) {
        const auto from = raster.heights.begin() + static_cast<std::ptrdiff_t>(j * raster.nx);
        std::reverse(from, from + static_cast<std::ptrdiff_t>(raster.nx));
    }
}

double heightOn(const HeightGrid& raster, const Eigen::Vector2d& place) {
    const double u = (place.x() - raster.x0) / raster.dx;
    const double v = (place.y() - raster.y0) / raster.dy;
    if (!(u >= 0.0 && v >= 0.0 && u <= static_cast<double>(raster.nx - 1) && v <= static_cast<double>(raster.ny - 1))) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const std::size_t i = std::min(static_cast<std::size_t>(u), raster.nx - 2);
    const std::size_t j = std::min(static_cast<std::size_t>(v), raster.ny - 2);
    const double s = u - static_cast<double>(i);
    const double t = v - static_cast<double>(j);
    const double* low = &raster.heights[j * raster.nx + i];
    const double* high = low + raster.nx;
    return s >= t ? (1.0 - s) * low[0] + (s - t) * low[1] + t * high[1] : (1.0 - t) * low[0] + (t - s) * high[0] + s * high[1];
}

std::int64_t countGaps(const HeightGrid& raster) {
    return std::count_if(raster.heights.begin(), raster.heights.end(), [](double height) { return std::isnan(height); });
}

void fillGaps(HeightGrid& raster) {
    GapFilling(raster).fill();
}

double squareNodeCount(double dx, double dy, std::size_t nx, std::size_t ny) {
    if (square(dx, dy, nx, ny)) {
        return static_cast<double>(nx) * static_cast<double>(ny);
    }
    const double cell = std::min(dx, dy);
    return nodesFor(dx, cell, nx) * nodesFor(dy, cell, ny);
}

bool squareCells(const HeightGrid& raster) {
    return square(raster.dx, raster.dy, raster.nx, raster.ny);
}

void sampleAt(HeightGrid& nodes, const HeightGrid& raster) {
    nodes.heights.clear();
    nodes.heights.reserve(nodes.nx * nodes.ny);
    const double column = (nodes.x0 - raster.x0) / raster.dx;
    const double row = (nodes.y0 - raster.y0) / raster.dy;
    for (std::size_t j = 0; j < nodes.ny; ++j) {
        for (std::size_t i = 0; i < nodes.nx; ++i) {
            nodes.heights.push_back(between(raster, column + static_cast<double>(i) * nodes.dx / raster.dx,
                                            row + static_cast<double>(j) * nodes.dy / raster.dy));
        }
    }
}

HeightGrid withSquareCells(HeightGrid raster) {
    if (squareCells(raster)) {
        raster.dy = raster.dx;
        return raster;
    }
    HeightGrid even;
    even.x0 = raster.x0;
    even.y0 = raster.y0;
    even.dx = even.dy = std::min(raster.dx, raster.dy);
    even.nx = static_cast<std::size_t>(nodesFor(raster.dx, even.dx, raster.nx));
    even.ny = static_cast<std::size_t>(nodesFor(raster.dy, even.dy, raster.ny));
    sampleAt(even, raster);
    return even;
}

}  // namespace rubble::io
