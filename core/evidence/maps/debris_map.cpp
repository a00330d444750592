#include "core/evidence/maps/debris_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/unknown.h"
#include "core/evidence/maps/map_cell.h"
#include "core/evidence/maps/piece_raster.h"

namespace rubble {

namespace {

std::vector<double>& layerOf(DebrisMap& map, MapLayer layer) {
    return map.layers[static_cast<std::size_t>(layer)];
}

/// Puts a list of one raster into the cells of the map, divided by something.
template <class T>
void place(DebrisMap& map, MapLayer layer, const PieceRaster& raster, const std::vector<T>& values, double divisor = 1.0) {
    std::vector<double>& target = layerOf(map, layer);
    target.assign(map.cells.size(), unknown);
    std::size_t to = 0;
    for (std::size_t k = 0; k < raster.cells.size(); ++k) {
        while (map.cells[to] != raster.cells[k]) {
            ++to;
        }
        target[to] = static_cast<double>(values[k]) / divisor;
    }
}

double areaOf(const PieceRaster& raster, double cell) {
    return static_cast<double>(raster.cells.size()) * cell * cell;
}

}  // namespace

const MapLayerRow& mapLayerRow(MapLayer layer) {
    static const std::array<MapLayerRow, mapLayerCount> rows{{
        {"height", "m", "Height", "mean height of the top of the debris above the ground", false},
        {"volume", "m3/m2", "Volume per area", "volume of material over the area of the cell", false},
        {"mass", "kg/m2", "Mass per area", "mass over the area of the cell", false},
        {"fragments", "", "Fragments", "how many fragments reach into the cell", false},
        {"largest", "m3", "Largest piece", "volume of the largest fragment that reaches into the cell", false},
        {"component", "", "Source component", "component that most of the mass in the cell comes from", false},
        {"arrival", "s", "Time of arrival", "when the first of what lies in the cell came there", false},
        {"impact_energy", "J/m2", "Impact energy", "kinetic energy before the hardest hit, over the area of the cell", false},
        {"live_height", "m", "Height, live structure", "mean height of the top of fallen live structure above the ground", true},
        {"live_volume", "m3/m2", "Volume per area, live structure", "volume of fallen live structure over the area of the cell",
         true},
        {"live_mass", "kg/m2", "Mass per area, live structure", "mass of fallen live structure over the area of the cell", true},
        {"probability", "", "Probability of debris", "share of the members of the ensemble whose debris reaches into the cell",
         false, true},
        {"above_first", "", "Probability above the first height",
         "share of the members whose debris is higher there than the first height", false, true},
        {"above_second", "", "Probability above the second height",
         "share of the members whose debris is higher there than the second height", false, true},
        {"above_third", "", "Probability above the third height",
         "share of the members whose debris is higher there than the third height", false, true},
        {"height_p05", "m", "Height, 5 % quantile", "height that 5 % of the members stay below, 0 where they have no debris", false,
         true},
        {"height_p50", "m", "Height, median", "height that half of the members stay below, 0 where they have no debris", false,
         true},
        {"height_p95", "m", "Height, 95 % quantile", "height that 95 % of the members stay below, 0 where they have no debris",
         false, true},
        {"mass_p05", "kg/m2", "Mass per area, 5 % quantile", "mass per area that 5 % of the members stay below", false, true},
        {"mass_p50", "kg/m2", "Mass per area, median", "mass per area that half of the members stay below", false, true},
        {"mass_p95", "kg/m2", "Mass per area, 95 % quantile", "mass per area that 95 % of the members stay below", false, true},
        {"probability_error", "", "Standard error of the probability",
         "how far the probability may be off because the members are so few, by Agresti and Coull", false, true},
        {"separation", "", "What tells the causes apart",
         "above 0 the cell speaks for the first hypothesis, below 0 for the second: logarithm of the ratio of their probabilities",
         false, true},
    }};
    return rows[static_cast<std::size_t>(layer)];
}

const std::array<MapLayer, mapLayerCount>& mapLayers() {
    static const std::array<MapLayer, mapLayerCount> all = [] {
        std::array<MapLayer, mapLayerCount> list{};
        for (std::size_t k = 0; k < mapLayerCount; ++k) {
            list[k] = static_cast<MapLayer>(k);
        }
        return list;
    }();
    return all;
}

Message mapLayerTitle(const DebrisMap& map, MapLayer layer) {
    if (layer >= MapLayer::AboveFirst && layer <= MapLayer::AboveThird) {
        const auto which = static_cast<std::size_t>(layer) - static_cast<std::size_t>(MapLayer::AboveFirst);
        return {"map.above", "Probability of debris higher than {0}", {Argument(map.thresholds[which], "m")}};
    }
    if (layer == MapLayer::Separation && map.hypotheses.size() == 2) {
        return {"map.separation", "Speaks for \"{0}\" (above 0) or for \"{1}\" (below 0)", {map.hypotheses[0], map.hypotheses[1]}};
    }
    return {"map.layer", std::string(mapLayerRow(layer).name), {}};
}

bool DebrisMap::expected(MapLayer which) const {
    if (mapLayerRow(which).ensemble || members > 0) {
        return mapLayerRow(which).ensemble && members > 0 && (which == MapLayer::Separation) == (hypotheses.size() == 2);
    }
    return mapLayerRow(which).live ? live : which != MapLayer::ImpactEnergy || impacts;
}

std::vector<MapLayer> DebrisMap::present() const {
    std::vector<MapLayer> list;
    std::copy_if(mapLayers().begin(), mapLayers().end(), std::back_inserter(list), [&](MapLayer which) { return has(which); });
    return list;
}

std::vector<MapPiece> mapPieces(const FragmentSet& fragments, const Debris& debris, const std::vector<double>& arrivals,
                                const std::vector<double>& energies) {
    assert(debris.fragments.size() == fragments.size() && arrivals.size() == fragments.size());
    std::vector<MapPiece> pieces;
    pieces.reserve(fragments.size());
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        const DebrisFragment& lies = debris.fragments[f];
        if (!lies.present) {
            continue;
        }
        MapPiece& piece = pieces.emplace_back();
        piece.box = lies.box;
        piece.centre = lies.centre;
        piece.mass = lies.mass;
        piece.volume = lies.volume;
        piece.component = static_cast<std::uint32_t>(at(fragments.list[f].component));
        piece.arrival = arrivals[f];
        piece.impactEnergy = energies.empty() ? unknown : energies[f];
    }
    return pieces;
}

namespace {

/// Which cells of a map live structure stands in, or beside, where what lies on it juts out [cells].
std::vector<bool> standingCells(const DebrisMap& map, std::span<const PlanBox> standing) {
    constexpr double beside = 1.0;  // m
    std::vector<bool> stands(map.cells.size(), false);
    const auto at = [side = map.cell](double place) { return static_cast<std::int32_t>(std::floor(place / side)); };
    for (const PlanBox& box : standing) {
        for (std::int32_t j = at(box.min().y() - beside); j <= at(box.max().y() + beside); ++j) {
            const auto first = std::lower_bound(map.cells.begin(), map.cells.end(), MapCell{j, at(box.min().x() - beside)});
            const auto end = std::upper_bound(first, map.cells.end(), MapCell{j, at(box.max().x() + beside)});
            std::fill(stands.begin() + (first - map.cells.begin()), stands.begin() + (end - map.cells.begin()), true);
        }
    }
    return stands;
}

/// The highest debris, and whether structure stands there.
void measureHeights(DebrisMap& map, std::span<const PlanBox> standing) {
    const std::vector<double>& heights = map.layer(MapLayer::Height);
    const std::vector<bool> stands = standingCells(map, standing);
    double highest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < heights.size(); ++k) {
        if (!std::isfinite(heights[k])) {
            continue;
        }
        if (heights[k] > highest) {
            highest = heights[k];
            map.ledger.highestStands = stands[k];
        }
        if (!stands[k] && !(heights[k] <= map.ledger.pileHeight)) {
            map.ledger.pileHeight = heights[k];
        }
    }
}

}  // namespace

DebrisMap makeDebrisMap(double time, std::span<const MapPiece> pieces, bool impactsKnown, const LiveStructure* live,
                        std::vector<std::string> components, const SiteSurface& ground, const MapSettings& settings,
                        const Execution& execution) {
    const double cell = settings.cell.value_or(usualMapCell(FragmentSet{}, 0.0).side);
    const PieceRaster debris = rasterOf(pieces, cell, ground, execution);
    PieceRaster fallen;
    DebrisMap map;
    map.time = time;
    map.cell = cell;
    map.impacts = impactsKnown;
    map.live = live != nullptr;
    map.liveThreshold = settings.liveThreshold;
    map.arrivalDistance = settings.arrivalDistance;
    map.components = std::move(components);
    if (live) {
        fallen = rasterOf(live->pieces, cell, ground, execution);
        map.ledger.liveElements = static_cast<std::int64_t>(live->pieces.size());
        map.ledger.liveMass = live->mass;
        map.ledger.liveVolume = live->volume;
        map.ledger.liveFootprintArea = areaOf(fallen, cell);
    }
    std::set_union(debris.cells.begin(), debris.cells.end(), fallen.cells.begin(), fallen.cells.end(),
                   std::back_inserter(map.cells));
    const double area = cell * cell;
    place(map, MapLayer::Height, debris, debris.height);
    place(map, MapLayer::Volume, debris, debris.volume, area);
    place(map, MapLayer::Mass, debris, debris.mass, area);
    place(map, MapLayer::Fragments, debris, debris.pieces);
    place(map, MapLayer::LargestPiece, debris, debris.largest);
    place(map, MapLayer::Component, debris, debris.component);
    place(map, MapLayer::Arrival, debris, debris.arrival);
    if (impactsKnown) {
        place(map, MapLayer::ImpactEnergy, debris, debris.impactEnergy, area);
    }
    if (live) {
        place(map, MapLayer::LiveHeight, fallen, fallen.height);
        place(map, MapLayer::LiveVolume, fallen, fallen.volume, area);
        place(map, MapLayer::LiveMass, fallen, fallen.mass, area);
    }
    map.ledger.fragments = static_cast<std::int64_t>(pieces.size());
    map.ledger.footprintArea = areaOf(debris, cell);
    measureHeights(map, live != nullptr ? std::span<const PlanBox>(live->standing) : std::span<const PlanBox>());
    for (const MapPiece& piece : pieces) {
        map.ledger.mass += piece.mass;
        map.ledger.volume += piece.volume;
        map.ledger.impactEnergy += std::isfinite(piece.impactEnergy) ? piece.impactEnergy : 0.0;
    }
    return map;
}

}  // namespace rubble
