#include "core/analysis/debris/debris_measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/base/unknown.h"

namespace rubble {

namespace {

/// Relative: sums that reach a share up to rounding reach it, masses that differ by rounding are equal.
constexpr double rounding = 1e-9;

void checkSettings(const MeasureSettings& settings) {
    const auto positive = [](double number) { return number > 0.0 && std::isfinite(number); };
    const auto share = [](double number) { return number > 0.0 && number <= 1.0; };
    if (!share(settings.coreShare) || !share(settings.runOutShare)) {
        throw UsageError({"analysis.share", "The shares of the core and of the run-out must lie above 0 and at most at 1.", {}},
                         {"analysis.share.remedy", "0.95 is what is usual.", {}});
    }
    for (const double tolerance : settings.tolerances) {
        if (!positive(tolerance)) {
            throw UsageError({"analysis.tolerance", "{0} is no tolerance for the accuracy rate.", {Argument(tolerance, "m")}},
                             {"analysis.tolerance.remedy", "Give a distance above zero.", {}});
        }
    }
}

std::vector<MapCell> coreOf(const CellMap& mass, double share) {
    std::vector<std::size_t> order(mass.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return mass.values[a] > mass.values[b]; });
    const double wanted = share * mass.sum() * (1.0 - rounding);
    std::vector<MapCell> core;
    double held = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t k : order) {
        // Cells that hold as much as the last one taken belong to the core too: no order of cells decides.
        const bool equal = mass.values[k] >= least * (1.0 - rounding);
        if ((held >= wanted && !equal) || mass.values[k] <= 0.0) {
            break;
        }
        if (held < wanted) {
            least = mass.values[k];
        }
        held += mass.values[k];
        core.push_back(mass.cells[k]);
    }
    std::sort(core.begin(), core.end());
    return core;
}

double runOutOf(const Debris& debris, const CollapsePlan& plan, double share, double total) {
    struct Row {
        double distance;
        double mass;
    };
    std::vector<Row> rows;
    for (const DebrisFragment& lies : debris.fragments) {
        if (lies.present && lies.mass > 0.0) {
            rows.push_back({plan.distance(lies.centre.head<2>()), lies.mass});
        }
    }
    if (rows.empty() || plan.outline().empty()) {
        return unknown;
    }
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.distance < b.distance; });
    double within = 0.0;
    for (const Row& row : rows) {
        within += row.mass;
        if (within >= share * total * (1.0 - rounding)) {
            return row.distance;
        }
    }
    return rows.back().distance;
}

DebrisFigures figuresOf(const DebrisField& field, const CollapsePlan& plan, const SiteSurface& ground) {
    DebrisFigures figures;
    Vec3 moment = Vec3::Zero();
    double heightMoment = 0.0;
    for (const DebrisFragment& lies : field.debris.fragments) {
        if (lies.present) {
            ++figures.fragments;
            figures.mass += lies.mass;
            moment += lies.mass * lies.centre;
            heightMoment += lies.mass * (lies.centre.z() - ground.height(lies.centre.x(), lies.centre.y()));
        }
    }
    const bool heavy = figures.mass > 0.0;
    figures.centroid = heavy ? Vec3(moment / figures.mass) : Vec3::Constant(unknown);
    figures.meanHeight = heavy ? heightMoment / figures.mass : unknown;
    figures.runOut = runOutOf(field.debris, plan, field.settings.runOutShare, figures.mass);
    figures.footprintArea = field.heights.area();
    figures.coreArea = static_cast<double>(field.core.size()) * field.mass.cell * field.mass.cell;
    for (const double height : field.heights.values) {
        figures.pileHeight = std::max(figures.pileHeight, height);
    }
    return figures;
}

/// Calls visit(a, b) for each cell of either map with the places in their lists; -1 where a map holds nothing.
template <class Visit>
void forCellsOfEither(const std::vector<MapCell>& a, const std::vector<MapCell>& b, Visit visit) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
        const bool inA = i < a.size() && (j == b.size() || a[i] <= b[j]);
        const bool inB = j < b.size() && (i == a.size() || b[j] <= a[i]);
        visit(inA ? static_cast<std::ptrdiff_t>(i) : -1, inB ? static_cast<std::ptrdiff_t>(j) : -1);
        i += inA;
        j += inB;
    }
}

double iou(const std::vector<MapCell>& a, const std::vector<MapCell>& b) {
    std::size_t both = 0;
    std::size_t either = 0;
    forCellsOfEither(a, b, [&](std::ptrdiff_t i, std::ptrdiff_t j) {
        ++either;
        both += i >= 0 && j >= 0;
    });
    return either > 0 ? static_cast<double>(both) / static_cast<double>(either) : 1.0;
}

double valueAt(const CellMap& map, std::ptrdiff_t k) {
    return k < 0 ? 0.0 : map.values[static_cast<std::size_t>(k)];
}

double massMapDifference(const CellMap& a, const CellMap& b) {
    double sum = 0.0;
    double total = 0.0;
    forCellsOfEither(a.cells, b.cells, [&](std::ptrdiff_t i, std::ptrdiff_t j) {
        sum += std::abs(valueAt(a, i) - valueAt(b, j));
        total += valueAt(a, i) + valueAt(b, j);
    });
    return total > 0.0 ? sum / total : 0.0;
}

double heightRms(const CellMap& a, const CellMap& b) {
    double sum = 0.0;
    std::size_t cells = 0;
    forCellsOfEither(a.cells, b.cells, [&](std::ptrdiff_t i, std::ptrdiff_t j) {
        const double difference = valueAt(a, i) - valueAt(b, j);
        sum += difference * difference;
        ++cells;
    });
    return cells > 0 ? std::sqrt(sum / static_cast<double>(cells)) : 0.0;
}

/// Middle value, the mean of the two in the middle of an even number; NaN of none.
double median(std::vector<double> values) {
    if (values.empty()) {
        return unknown;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

UsageError notComparable(const Debris& first, const Debris& second) {
    return UsageError({"analysis.not_comparable",
                       "Debris of {0} fragments cannot be compared with debris of {1}: they are of different collapses, or were "
                       "measured in different ways.",
                       {first.fragments.size(), second.fragments.size()}},
                      {"analysis.not_comparable.remedy", "Compare runs of the same FE result with the same cells and shares.", {}});
}

/// Distances of the fragments and the share of them within each tolerance.
void comparePlaces(const Debris& first, const Debris& second, DebrisDifference& difference) {
    std::vector<double> distances = fragmentErrors(first, second);
    std::erase_if(distances, [](double distance) { return std::isnan(distance); });
    std::size_t either = 0;
    for (std::size_t f = 0; f < first.fragments.size(); ++f) {
        either += first.fragments[f].present || second.fragments[f].present;
    }
    for (const double tolerance : difference.tolerances) {
        const auto within = std::count_if(distances.begin(), distances.end(), [&](double d) { return d < tolerance; });
        difference.accuracy.push_back(either > 0 ? static_cast<double>(within) / static_cast<double>(either) : unknown);
    }
    difference.of(Measure::MedianDistance) = median(std::move(distances));
}

bool sameSettings(const MeasureSettings& a, const MeasureSettings& b) {
    return a.massCell == b.massCell && a.footprintCell == b.footprintCell && a.coreShare == b.coreShare &&
           a.runOutShare == b.runOutShare && a.tolerances == b.tolerances;
}

}  // namespace

std::string_view measureKey(Measure measure) {
    static constexpr std::array<std::string_view, measureCount> keys{"mass_map_difference", "core_iou",         "footprint_iou",
                                                                     "run_out_m",           "height_rms_m",     "mean_height_m",
                                                                     "centroid_shift_m",    "median_distance_m"};
    return keys[static_cast<std::size_t>(measure)];
}

DebrisField measureDebris(Debris debris, const CollapsePlan& plan, const SiteSurface& ground, const MeasureSettings& settings) {
    checkSettings(settings);
    DebrisField field;
    field.settings = settings;
    field.mass = massMap(debris, settings.massCell);
    field.core = coreOf(field.mass, settings.coreShare);
    field.heights = heightMap(debris, settings.footprintCell, ground);
    field.debris = std::move(debris);
    field.figures = figuresOf(field, plan, ground);
    return field;
}

double DebrisDifference::departure(Measure measure) const {
    const bool likeness = measure == Measure::CoreIou || measure == Measure::FootprintIou;
    return likeness ? 1.0 - of(measure) : std::abs(of(measure));
}

DebrisDifference compareDebris(const DebrisField& first, const DebrisField& second) {
    if (first.debris.fragments.size() != second.debris.fragments.size() || !sameSettings(first.settings, second.settings)) {
        throw notComparable(first.debris, second.debris);
    }
    DebrisDifference difference;
    difference.tolerances = first.settings.tolerances;
    difference.of(Measure::MassMap) = massMapDifference(first.mass, second.mass);
    difference.of(Measure::CoreIou) = iou(first.core, second.core);
    difference.of(Measure::FootprintIou) = iou(first.heights.cells, second.heights.cells);
    difference.of(Measure::RunOut) = second.figures.runOut - first.figures.runOut;
    difference.of(Measure::HeightRms) = heightRms(first.heights, second.heights);
    difference.of(Measure::MeanHeight) = second.figures.meanHeight - first.figures.meanHeight;
    difference.of(Measure::CentroidShift) = (second.figures.centroid - first.figures.centroid).norm();
    comparePlaces(first.debris, second.debris, difference);
    return difference;
}

std::vector<double> fragmentErrors(const Debris& first, const Debris& second) {
    if (first.fragments.size() != second.fragments.size()) {
        throw notComparable(first, second);
    }
    std::vector<double> errors(first.fragments.size(), unknown);
    for (std::size_t f = 0; f < errors.size(); ++f) {
        const DebrisFragment& a = first.fragments[f];
        const DebrisFragment& b = second.fragments[f];
        if (a.present && b.present) {
            errors[f] = (b.centre - a.centre).norm();
        }
    }
    return errors;
}

DebrisDifference largerOf(const DebrisDifference& a, const DebrisDifference& b) {
    assert(a.tolerances == b.tolerances);
    DebrisDifference larger = a;
    for (std::size_t m = 0; m < measureCount; ++m) {
        const Measure measure = static_cast<Measure>(m);
        if (!(a.departure(measure) >= b.departure(measure)) && !std::isnan(b.of(measure))) {
            larger.of(measure) = b.of(measure);
        }
    }
    for (std::size_t t = 0; t < a.accuracy.size(); ++t) {
        larger.accuracy[t] = std::fmin(a.accuracy[t], b.accuracy[t]);
    }
    return larger;
}

}  // namespace rubble
