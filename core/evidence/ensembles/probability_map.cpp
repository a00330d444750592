#include "core/evidence/ensembles/probability_map.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace rubble {

namespace {

/// z^2 of 95 %, rounded as Agresti and Coull do: two members more with debris and two without.
constexpr double added = 4.0;

double probabilityError(double hits, double members) {
    const double n = members + added;
    const double p = (hits + 0.5 * added) / n;
    return std::sqrt(p * (1.0 - p) / n);
}

double quantile(const std::vector<float>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double low = sorted[below];
    return low + (place - static_cast<double>(below)) * (double{sorted[above]} - low);
}

void checkThresholds(const HeightThresholds& thresholds) {
    const bool ascending = thresholds[0] < thresholds[1] && thresholds[1] < thresholds[2];
    if (!ascending || !(thresholds[0] >= 0.0) || !std::isfinite(thresholds[2])) {
        throw UsageError(
            {"ensemble.thresholds", "Heights that a map has the probability of must be ascending, and none below zero.", {}},
            {"ensemble.thresholds.remedy", "Give three, such as 0.25, 0.5 and 1 m.", {}});
    }
}

/// Values of one cell over all members, and the layers that follow from them.
class CellStatistics {
public:
    explicit CellStatistics(DebrisMap& map) : m_map(map) {
        for (const MapLayer layer : mapLayers()) {
            if (mapLayerRow(layer).ensemble && layer != MapLayer::Separation) {
                of(layer).reserve(map.cells.size());
            }
        }
    }

    void add(std::vector<float>& heights, std::vector<float>& masses, double hits) {
        const auto members = static_cast<double>(heights.size());
        of(MapLayer::Probability).push_back(hits / members);
        of(MapLayer::ProbabilityError).push_back(probabilityError(hits, members));
        for (std::size_t t = 0; t < m_map.thresholds.size(); ++t) {
            const auto above = std::count_if(heights.begin(), heights.end(), [&](float h) { return h > m_map.thresholds[t]; });
            of(static_cast<MapLayer>(static_cast<std::size_t>(MapLayer::AboveFirst) + t))
                .push_back(static_cast<double>(above) / members);
        }
        std::sort(heights.begin(), heights.end());
        std::sort(masses.begin(), masses.end());
        of(MapLayer::HeightLow).push_back(quantile(heights, 0.05));
        of(MapLayer::HeightMiddle).push_back(quantile(heights, 0.5));
        of(MapLayer::HeightHigh).push_back(quantile(heights, 0.95));
        of(MapLayer::MassLow).push_back(quantile(masses, 0.05));
        of(MapLayer::MassMiddle).push_back(quantile(masses, 0.5));
        of(MapLayer::MassHigh).push_back(quantile(masses, 0.95));
    }

private:
    std::vector<double>& of(MapLayer layer) { return m_map.layers[static_cast<std::size_t>(layer)]; }
    DebrisMap& m_map;
};

/// Walks through the cells of a surface as a list of all cells is gone through.
struct Walk {
    const MemberSurface* surface;
    std::size_t next = 0;

    /// Its place in the lists; -1 where it has nothing.
    std::ptrdiff_t at(const MapCell& cell) {
        while (next < surface->cells.size() && surface->cells[next] < cell) {
            ++next;
        }
        return next < surface->cells.size() && surface->cells[next] == cell ? static_cast<std::ptrdiff_t>(next) : -1;
    }
};

void takeLedger(DebrisMap& map, std::span<const EnsembleMember* const> members) {
    const auto count = static_cast<double>(members.size());
    for (const EnsembleMember* member : members) {
        map.time = std::max(map.time, member->endTime);
        map.ledger.mass += member->of(MemberMeasure::Mass) / count;
        map.ledger.footprintArea += member->of(MemberMeasure::Footprint) / count;
    }
}

}  // namespace

std::vector<MapCell> cellsOfAny(std::span<const EnsembleMember* const> members) {
    std::vector<MapCell> all;
    std::vector<MapCell> merged;
    for (const EnsembleMember* member : members) {
        merged.clear();
        std::set_union(all.begin(), all.end(), member->surface->cells.begin(), member->surface->cells.end(),
                       std::back_inserter(merged));
        all.swap(merged);
    }
    return all;
}

DebrisMap probabilityMap(const EnsembleReport& report, const HeightThresholds& thresholds) {
    checkThresholds(thresholds);
    const std::vector<const EnsembleMember*> members = report.done();
    if (members.empty()) {
        throw UsageError({"ensemble.nothing", "No member of the ensemble is there: there is nothing to map.", {}},
                         {"ensemble.nothing.remedy", "Simulate the ensemble first.", {}});
    }
    DebrisMap map;
    map.cell = report.surface.cell;
    map.live = false;
    map.liveThreshold = report.surface.liveThreshold;
    map.members = static_cast<std::int64_t>(members.size());
    map.thresholds = thresholds;
    map.cells = cellsOfAny(members);
    takeLedger(map, members);
    std::vector<Walk> walks;
    for (const EnsembleMember* member : members) {
        walks.push_back({member->surface.get()});
    }
    CellStatistics statistics(map);
    std::vector<float> heights(members.size());
    std::vector<float> masses(members.size());
    for (const MapCell& cell : map.cells) {
        double hits = 0.0;
        for (std::size_t m = 0; m < walks.size(); ++m) {
            const std::ptrdiff_t at = walks[m].at(cell);
            const auto place = static_cast<std::size_t>(at);
            heights[m] = at < 0 ? 0.0F : walks[m].surface->heights[place];
            masses[m] = at < 0 ? 0.0F : walks[m].surface->masses[place];
            hits += at < 0 ? 0.0 : 1.0;
        }
        statistics.add(heights, masses, hits);
    }
    return map;
}

std::vector<ConvergenceRow> convergenceOf(const EnsembleReport& report) {
    const std::vector<const EnsembleMember*> members = report.done();
    const std::vector<MapCell> cells = cellsOfAny(members);
    std::vector<std::size_t> hits(cells.size(), 0);
    std::vector<ConvergenceRow> rows;
    std::size_t next = 2;
    for (std::size_t m = 0; m < members.size(); ++m) {
        Walk walk{members[m]->surface.get()};
        for (std::size_t c = 0; c < cells.size(); ++c) {
            hits[c] += walk.at(cells[c]) < 0 ? 0 : 1;
        }
        const std::size_t count = m + 1;
        if (count != next && count != members.size()) {
            continue;
        }
        next *= count == next ? 2 : 1;
        ConvergenceRow row;
        row.members = count;
        for (std::size_t k = 0; k < memberMeasureCount; ++k) {
            row.figures[k] = spreadOf(report, static_cast<MemberMeasure>(k), count);
        }
        double reached = 0.0;
        for (const std::size_t hit : hits) {
            // What no member has reached yet is no cell of the map at this number.
            if (hit > 0) {
                const double error = probabilityError(static_cast<double>(hit), static_cast<double>(count));
                row.probabilityError += error;
                row.worstError = std::max(row.worstError, error);
                reached += 1.0;
            }
        }
        row.probabilityError /= std::max(reached, 1.0);
        rows.push_back(row);
    }
    return rows;
}

}  // namespace rubble
