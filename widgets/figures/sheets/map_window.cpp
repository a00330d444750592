#include "widgets/figures/sheets/map_window.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "widgets/figures/sheets/map_words.h"

namespace rubble::figures {
namespace {

/// Of the mass, shown whatever the rest does.
constexpr double shownShare = 0.999;
/// The whole map is shown unless it is so many times as long or wide as that.
constexpr double mostStretched = 2.0;
constexpr double topShare = 0.99;

/// The stretch of an axis that holds the share of the mass, or all if that is not much longer.
std::pair<std::int32_t, std::int32_t> stretchOf(const DebrisMap& map, bool alongX) {
    std::vector<std::pair<std::int32_t, double>> places;
    double total = 0.0;
    for (std::size_t c = 0; c < map.cells.size(); ++c) {
        double mass = map.members > 0 ? 1.0 : map.layer(MapLayer::Mass)[c];
        if (map.has(MapLayer::LiveMass) && !std::isnan(map.layer(MapLayer::LiveMass)[c])) {
            mass = (std::isnan(mass) ? 0.0 : mass) + map.layer(MapLayer::LiveMass)[c];
        }
        places.emplace_back(alongX ? map.cells[c].i : map.cells[c].j, mass);
        total += mass;
    }
    std::sort(places.begin(), places.end());
    std::pair<std::int32_t, std::int32_t> shown{places.front().first, places.back().first};
    double sum = 0.0;
    bool begun = false;
    for (const auto& [place, mass] : places) {
        sum += mass;
        if (!begun && sum >= 0.5 * (1.0 - shownShare) * total) {
            shown.first = place;
            begun = true;
        }
        if (sum <= (0.5 + 0.5 * shownShare) * total) {
            shown.second = place;
        }
    }
    const double all = 1.0 + places.back().first - places.front().first;
    const double most = 1.0 + shown.second - shown.first;
    return all <= mostStretched * most ? std::pair(places.front().first, places.back().first) : shown;
}

/// The shortest range of three to five steps of 1, 2, 2.5 or 5 times a power of ten, from a whole number of steps, that holds two
/// numbers.
MapRange steppedRange(double low, double high) {
    MapRange best;
    best.high = std::numeric_limits<double>::infinity();
    best.low = 0.0;
    const double power = std::pow(10.0, std::floor(std::log10(high - low)) - 1.0);
    for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0, 20.0, 25.0, 50.0}) {
        const double step = factor * power;
        const double from = std::floor(low / step + 1e-9);
        const double steps = std::max(3.0, std::ceil(high / step - 1e-9) - from);
        if (steps <= 5.0 && steps * step < (1.0 - 1e-9) * (best.high - best.low)) {
            best = {from * step, (from + steps) * step, false, step};
        }
    }
    return best;
}

}  // namespace

MapWindow windowOf(const DebrisMap& map, const std::vector<MapOutline>& outlines) {
    if (map.cells.empty()) {
        return {};
    }
    const auto [west, east] = stretchOf(map, true);
    const auto [south, north] = stretchOf(map, false);
    MapWindow window{{south, west}, {north, east}};
    for (const MapOutline& outline : outlines) {
        if (outline.of != MapOutline::Of::Structure) {
            continue;
        }
        for (const OutlineRing& ring : outline.rings) {
            for (const Eigen::Vector2d& corner : ring) {
                const auto i = static_cast<std::int32_t>(std::floor(corner.x() / map.cell));
                const auto j = static_cast<std::int32_t>(std::floor(corner.y() / map.cell));
                window.low = {std::min(window.low.j, j), std::min(window.low.i, i)};
                window.high = {std::max(window.high.j, j), std::max(window.high.i, i)};
            }
        }
    }
    return window;
}

MapRange rangeOf(const std::vector<double>& values, MapLayer layer) {
    std::vector<double> known;
    std::copy_if(values.begin(), values.end(), std::back_inserter(known), [](double v) { return std::isfinite(v); });
    MapRange range;
    if (known.empty()) {
        return range;
    }
    std::sort(known.begin(), known.end());
    if (layer >= MapLayer::Probability && layer <= MapLayer::AboveThird) {
        return range;
    }
    if (layer == MapLayer::Separation) {
        const double most = steppedRange(0.0, std::max({std::abs(known.front()), std::abs(known.back()), 1e-6})).high;
        return {-most, most, false, 0.5 * most};
    }
    const double low = layer == MapLayer::Arrival ? known.front() : 0.0;
    double high = known[static_cast<std::size_t>(topShare * static_cast<double>(known.size() - 1))];
    if (!(high > low)) {
        high = known.back() > low ? known.back() : low + 1.0;
    }
    // The steps are round where they are read.
    const double scale = shownScale(layer);
    range = steppedRange(scale * low, scale * high);
    range = {range.low / scale, range.high / scale, false, range.step / scale};
    range.cut = known.back() > range.high;
    return range;
}

}  // namespace rubble::figures
