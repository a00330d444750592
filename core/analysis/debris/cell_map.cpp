#include "core/analysis/debris/cell_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/analysis/debris/box_outline.h"
#include "core/base/error.h"

namespace rubble {

namespace {

/// Pairs of a fragment and a cell at most: what a map may cost (32 bytes each).
constexpr double coveredMax = 16e6;
/// Cells are numbered within this, either way.
constexpr double cellsEitherWay = 1e9;
/// Share of a cell that an outline has to reach into: less is rounding on the edge between two cells.
constexpr double reachedShare = 1e-9;
/// Points along each side of a cell at which heights are taken.
constexpr int pointsPerSide = 4;

/// A cell that the outline of a fragment reaches into.
struct Covered {
    MapCell cell;
    std::uint32_t fragment = 0;
    double share = 0.0;  ///< of the outline
};

MapCell cellOf(double x, double y, double cell) {
    return {static_cast<std::int32_t>(std::floor(y / cell)), static_cast<std::int32_t>(std::floor(x / cell))};
}

[[noreturn]] void refuseCells(double cell) {
    throw UsageError({"analysis.too_many_cells",
                      "A map with cells of {0} would take too many of them: the debris is too large or too far away for it.",
                      {Argument(cell, "m")}},
                     {"analysis.too_many_cells.remedy", "Choose larger cells, or look for bodies that left the site.", {}});
}

/// Finds the cells that outlines reach into.
class Cover {
public:
    explicit Cover(double cell) : m_cell(cell) {}

    void add(std::uint32_t fragment, const DebrisFragment& lies) {
        const SmallPolygon outline = outlineOf(lies.box);
        const double area = outline.area();
        Eigen::Vector2d low = lies.centre.head<2>();
        Eigen::Vector2d high = low;
        if (area > 0.0) {
            low = high = outline.corners[0];
            for (std::size_t k = 1; k < outline.size; ++k) {
                low = low.cwiseMin(outline.corners[k]);
                high = high.cwiseMax(outline.corners[k]);
            }
        }
        if (std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) > cellsEitherWay * m_cell) {
            refuseCells(m_cell);
        }
        const MapCell first = cellOf(low.x(), low.y(), m_cell);
        const MapCell last = cellOf(high.x(), high.y(), m_cell);
        const double cells = (1.0 + last.i - first.i) * (1.0 + last.j - first.j);
        if (cells + static_cast<double>(m_covered.size()) > coveredMax) {
            refuseCells(m_cell);
        }
        if (cells == 1.0) {
            m_covered.push_back({first, fragment, 1.0});
        } else {
            addParts(fragment, outline, area, first, last);
        }
    }

    /// By cell, then fragment.
    const std::vector<Covered>& sorted() {
        std::sort(m_covered.begin(), m_covered.end(),
                  [](const Covered& a, const Covered& b) { return a.cell != b.cell ? a.cell < b.cell : a.fragment < b.fragment; });
        return m_covered;
    }

private:
    void addParts(std::uint32_t fragment, const SmallPolygon& outline, double area, MapCell first, MapCell last) {
        const double least = reachedShare * std::min(area, m_cell * m_cell);
        for (std::int32_t j = first.j; j <= last.j; ++j) {
            const SmallPolygon strip = first.j == last.j ? outline : clipped(outline, 1, j * m_cell, (j + 1.0) * m_cell);
            for (std::int32_t i = first.i; strip.size > 2 && i <= last.i; ++i) {
                const SmallPolygon part = first.i == last.i ? strip : clipped(strip, 0, i * m_cell, (i + 1.0) * m_cell);
                const double partArea = part.area();
                if (partArea > least) {
                    m_covered.push_back({{j, i}, fragment, partArea / area});
                }
            }
        }
    }

    double m_cell;
    std::vector<Covered> m_covered;
};

Cover coverOf(const Debris& debris, double cell) {
    checkDebris(debris);
    if (!(cell > 0.0) || !std::isfinite(cell)) {
        throw UsageError({"analysis.cell_size", "A map cannot have cells of {0}.", {Argument(cell, "m")}},
                         {"analysis.cell_size.remedy", "Give a size above zero, 1 m or 2 m for example.", {}});
    }
    Cover cover(cell);
    for (std::size_t f = 0; f < debris.fragments.size(); ++f) {
        if (debris.fragments[f].present) {
            cover.add(static_cast<std::uint32_t>(f), debris.fragments[f]);
        }
    }
    return cover;
}

/// Calls visit(first, last) for the run of entries of each cell.
template <class Visit>
void forEachCell(const std::vector<Covered>& covered, Visit visit) {
    for (auto first = covered.begin(); first != covered.end();) {
        auto last = first;
        while (last != covered.end() && last->cell == first->cell) {
            ++last;
        }
        visit(first, last);
        first = last;
    }
}

}  // namespace

double CellMap::sum() const {
    double total = 0.0;
    for (const double value : values) {
        total += value;
    }
    return total;
}

double CellMap::at(MapCell wanted) const {
    const auto found = std::lower_bound(cells.begin(), cells.end(), wanted);
    return found != cells.end() && *found == wanted ? values[static_cast<std::size_t>(found - cells.begin())] : 0.0;
}

CellMap massMap(const Debris& debris, double cell) {
    Cover cover = coverOf(debris, cell);
    CellMap map;
    map.cell = cell;
    forEachCell(cover.sorted(), [&](auto first, auto last) {
        double mass = 0.0;
        for (auto entry = first; entry != last; ++entry) {
            mass += entry->share * debris.fragments[entry->fragment].mass;
        }
        map.cells.push_back(first->cell);
        map.values.push_back(mass);
    });
    return map;
}

CellMap heightMap(const Debris& debris, double cell, const SiteSurface& ground) {
    Cover cover = coverOf(debris, cell);
    std::vector<BoxTop> tops;
    tops.reserve(debris.fragments.size());
    for (const DebrisFragment& lies : debris.fragments) {
        tops.emplace_back(lies.box);
    }
    CellMap map;
    map.cell = cell;
    std::vector<const BoxTop*> here;
    forEachCell(cover.sorted(), [&](auto first, auto last) {
        here.clear();
        for (auto entry = first; entry != last; ++entry) {
            here.push_back(&tops[entry->fragment]);
        }
        std::sort(here.begin(), here.end(), [](const BoxTop* a, const BoxTop* b) { return a->highest() > b->highest(); });
        double sum = 0.0;
        for (int point = 0; point < pointsPerSide * pointsPerSide; ++point) {
            const double x = (first->cell.i + (point % pointsPerSide + 0.5) / pointsPerSide) * cell;
            const double y = (first->cell.j + (point / pointsPerSide + 0.5) / pointsPerSide) * cell;
            const double from = ground.height(x, y);
            double top = from;
            for (const BoxTop* box : here) {
                // What follows lies lower still.
                if (box->highest() <= top) {
                    break;
                }
                top = std::max(top, box->at(x, y).value_or(top));
            }
            sum += top - from;
        }
        map.cells.push_back(first->cell);
        map.values.push_back(sum / (pointsPerSide * pointsPerSide));
    });
    return map;
}

void checkDebris(const Debris& debris) {
    for (std::size_t f = 0; f < debris.fragments.size(); ++f) {
        const DebrisFragment& lies = debris.fragments[f];
        if (!lies.present) {
            continue;
        }
        const bool sound = lies.centre.allFinite() && lies.box.centre.allFinite() && lies.box.halfExtents.allFinite() &&
                           (lies.box.halfExtents.array() >= 0.0).all() && lies.box.orientation.coeffs().allFinite() &&
                           std::isfinite(lies.mass) && lies.mass >= 0.0 && std::isfinite(lies.volume) && lies.volume >= 0.0;
        if (!sound) {
            throw UsageError(
                {"analysis.not_a_number",
                 "The place, size or mass of fragment {0} at {1} is not a number, or negative: this debris cannot be measured.",
                 {f, Argument(debris.time, "s")}},
                {"analysis.not_a_number.remedy", "Look at the health of the run; a higher step rate may keep it sound.", {}});
        }
    }
}

}  // namespace rubble
