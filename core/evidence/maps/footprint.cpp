#include "core/evidence/maps/footprint.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>

namespace rubble {

namespace {

constexpr std::size_t nowhere = ~std::size_t{0};

/// East, north, west, south: each a quarter turn to the left of the one before.
constexpr std::array<MapCell, 4> steps{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};

MapCell moved(MapCell from, MapCell by) {
    return {from.j + by.j, from.i + by.i};
}

/// A set of cells and the sides on which they end.
class CellSet {
public:
    explicit CellSet(std::span<const MapCell> cells) : m_cells(cells), m_part(cells.size()) {
        std::iota(m_part.begin(), m_part.end(), std::size_t{0});
        for (std::size_t c = 0; c < cells.size(); ++c) {
            join(c, find(moved(cells[c], steps[0])));
            join(c, find(moved(cells[c], steps[1])));
        }
    }

    std::size_t find(MapCell cell) const {
        const auto found = std::lower_bound(m_cells.begin(), m_cells.end(), cell);
        return found != m_cells.end() && *found == cell ? static_cast<std::size_t>(found - m_cells.begin()) : nowhere;
    }
    /// The first cell of the part that a cell belongs to.
    std::size_t partOf(std::size_t cell) {
        while (m_part[cell] != cell) {
            m_part[cell] = m_part[m_part[cell]];
            cell = m_part[cell];
        }
        return cell;
    }

private:
    void join(std::size_t a, std::size_t b) {
        if (b == nowhere) {
            return;
        }
        const std::size_t rootA = partOf(a);
        const std::size_t rootB = partOf(b);
        m_part[std::max(rootA, rootB)] = std::min(rootA, rootB);
    }

    std::span<const MapCell> m_cells;
    std::vector<std::size_t> m_part;
};

/// The cell beyond the side of a cell that is walked in a direction, the cell itself to the left.
MapCell neighbourAcross(MapCell cell, std::size_t direction) {
    return moved(cell, steps[(direction + 3) % 4]);
}

/// Where that side begins.
MapCell startOf(MapCell cell, std::size_t direction) {
    static constexpr std::array<MapCell, 4> corners{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};
    return moved(cell, corners[direction]);
}

/// Follows the sides of cells; each is walked once.
class Walk {
public:
    explicit Walk(std::span<const MapCell> cells) : m_set(cells), m_cells(cells), m_walked(cells.size()) {}

    /// The ring along a side that has not been walked, nothing if there is none there.
    FootprintRing from(std::size_t cell, std::size_t direction) {
        FootprintRing ring;
        if (!open(cell, direction)) {
            return ring;
        }
        std::size_t before = 4;
        for (std::size_t c = cell, d = direction; !(m_walked[c] & (1u << d));) {
            m_walked[c] |= static_cast<std::uint8_t>(1u << d);
            if (d != before) {
                ring.push_back(startOf(m_cells[c], d));
            }
            before = d;
            next(c, d);
        }
        // The first corner lies on a straight stretch if the ring comes in as it went out.
        if (before == direction) {
            ring.erase(ring.begin());
        }
        return ring;
    }
    std::size_t partOf(std::size_t cell) { return m_set.partOf(cell); }

private:
    bool open(std::size_t cell, std::size_t direction) const {
        return !(m_walked[cell] & (1u << direction)) && m_set.find(neighbourAcross(m_cells[cell], direction)) == nowhere;
    }
    /// The side that follows: around the same cell, straight on, or to the right, so that cells that meet by a corner stay apart.
    void next(std::size_t& cell, std::size_t& direction) const {
        const MapCell ahead = moved(m_cells[cell], steps[direction]);
        const std::size_t straight = m_set.find(ahead);
        const std::size_t right = straight == nowhere ? nowhere : m_set.find(neighbourAcross(ahead, direction));
        if (straight == nowhere) {
            direction = (direction + 1) % 4;
        } else if (right == nowhere) {
            cell = straight;
        } else {
            cell = right;
            direction = (direction + 3) % 4;
        }
    }

    CellSet m_set;
    std::span<const MapCell> m_cells;
    std::vector<std::uint8_t> m_walked;  ///< a bit for each direction [cells]
};

/// Cuts a ring wherever it comes back to a corner, so that none of the rings touches itself.
std::vector<FootprintRing> simpleRings(const FootprintRing& ring) {
    std::vector<FootprintRing> rings;
    FootprintRing path;
    std::map<MapCell, std::size_t> placeOf;
    for (const MapCell& corner : ring) {
        const auto [known, fresh] = placeOf.emplace(corner, path.size());
        if (fresh) {
            path.push_back(corner);
            continue;
        }
        const auto from = path.begin() + static_cast<std::ptrdiff_t>(known->second);
        rings.emplace_back(from, path.end());
        std::for_each(from + 1, path.end(), [&](const MapCell& cut) { placeOf.erase(cut); });
        path.erase(from + 1, path.end());
    }
    rings.push_back(std::move(path));
    return rings;
}

}  // namespace

std::vector<FootprintPolygon> footprintOf(std::span<const MapCell> cells) {
    Walk walk(cells);
    std::map<std::size_t, FootprintPolygon> parts;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (std::size_t direction = 0; direction < steps.size(); ++direction) {
            const FootprintRing walked = walk.from(c, direction);
            if (walked.empty()) {
                continue;
            }
            FootprintPolygon& polygon = parts[walk.partOf(c)];
            for (FootprintRing& ring : simpleRings(walked)) {
                if (signedArea(ring) > 0.0) {
                    polygon.outer = std::move(ring);
                } else {
                    polygon.holes.push_back(std::move(ring));
                }
            }
        }
    }
    std::vector<FootprintPolygon> polygons;
    for (auto& [first, polygon] : parts) {
        polygons.push_back(std::move(polygon));
    }
    return polygons;
}

double signedArea(const FootprintRing& ring) {
    double twice = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const MapCell& a = ring[k];
        const MapCell& b = ring[k + 1 < ring.size() ? k + 1 : 0];
        twice += static_cast<double>(a.i) * b.j - static_cast<double>(b.i) * a.j;
    }
    return 0.5 * twice;
}

void addCrossings(const OutlineRing& ring, double y, std::vector<double>& crossings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Eigen::Vector2d& a = ring[k];
        const Eigen::Vector2d& b = ring[k + 1 < ring.size() ? k + 1 : 0];
        if ((a.y() <= y) != (b.y() <= y)) {
            crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
    }
}

OutlineFill::OutlineFill(const Outline& outline) : m_outline(outline) {
    for (const OutlinePolygon& polygon : outline.polygons) {
        Reach& reach =
            m_reaches.emplace_back(Reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
        for (const OutlineRing& ring : polygon) {
            for (const Eigen::Vector2d& corner : ring) {
                reach.low = std::min(reach.low, corner.y());
                reach.high = std::max(reach.high, corner.y());
            }
        }
    }
}

const std::vector<std::pair<double, double>>& OutlineFill::within(double y) {
    m_spans.clear();
    for (std::size_t p = 0; p < m_outline.polygons.size(); ++p) {
        if (y < m_reaches[p].low || y > m_reaches[p].high) {
            continue;
        }
        m_crossings.clear();
        for (const OutlineRing& ring : m_outline.polygons[p]) {
            addCrossings(ring, y, m_crossings);
        }
        std::sort(m_crossings.begin(), m_crossings.end());
        for (std::size_t k = 0; k + 1 < m_crossings.size(); k += 2) {
            m_spans.emplace_back(m_crossings[k], m_crossings[k + 1]);
        }
    }
    std::sort(m_spans.begin(), m_spans.end());
    std::size_t last = 0;
    for (std::size_t k = 1; k < m_spans.size(); ++k) {
        if (m_spans[k].first < m_spans[last].second) {
            m_spans[last].second = std::max(m_spans[last].second, m_spans[k].second);
        } else {
            m_spans[++last] = m_spans[k];
        }
    }
    m_spans.resize(std::min(m_spans.size(), last + 1));
    return m_spans;
}

}  // namespace rubble
