#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/debris/cell_map.h"
#include "core/base/execution.h"
#include "core/evidence/maps/live_structure.h"
#include "core/evidence/maps/map_piece.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// What a debris map tells of each cell.
enum class MapLayer : std::uint8_t {
    Height,
    Volume,
    Mass,
    Fragments,
    LargestPiece,
    Component,
    Arrival,
    ImpactEnergy,
    LiveHeight,
    LiveVolume,
    LiveMass,
    Probability,
    AboveFirst,
    AboveSecond,
    AboveThird,
    HeightLow,
    HeightMiddle,
    HeightHigh,
    MassLow,
    MassMiddle,
    MassHigh,
    ProbabilityError,
    Separation,
};
inline constexpr std::size_t mapLayerCount = 23;

/// A row of the table of layers.
struct MapLayerRow {
    std::string_view key;   ///< "mass": names the layer on the command line and in files
    std::string_view unit;  ///< "kg/m2"; empty for a number of things
    std::string_view name;  ///< for people
    std::string_view help;  ///< what it is, one sentence
    bool live = false;      ///< of the fallen live structure
    bool ensemble = false;  ///< of an ensemble, not of one run
};
const MapLayerRow& mapLayerRow(MapLayer layer);
/// Every layer, in the order of MapLayer.
const std::array<MapLayer, mapLayerCount>& mapLayers();

/// Heights that an ensemble's map has the probability of, m, ascending.
using HeightThresholds = std::array<double, 3>;
inline constexpr HeightThresholds usualThresholds{0.25, 0.5, 1.0};

/// Sums over what was mapped, as the ledger has them.
struct MapLedger {
    std::int64_t fragments = 0;  ///< present
    double mass = 0.0;           ///< kg
    double volume = 0.0;         ///< m3 of material
    double impactEnergy = 0.0;   ///< J; 0 where not known
    double footprintArea = 0.0;  ///< m2, cells that fragments reach into
    std::int64_t liveElements = 0;
    double liveMass = 0.0;           ///< kg
    double liveVolume = 0.0;         ///< m3
    double liveFootprintArea = 0.0;  ///< m2
    bool highestStands = false;      ///< the highest debris lies where live structure of the run still stands
    /// m, of the highest cell farther than 1 m from structure that stands, in the mean; not a number: there is none
    double pileHeight = std::numeric_limits<double>::quiet_NaN();
};

/// Debris by cells at one instant. Cells that neither fragments nor fallen live structure reach into are left out.
struct DebrisMap {
    double time = 0.0;                    ///< s
    double cell = 1.0;                    ///< m
    bool live = false;                    ///< the layers of the fallen live structure are there
    bool impacts = false;                 ///< impact energies are known
    double liveThreshold = 0.0;           ///< m, how far live structure has moved to count
    double arrivalDistance = 0.0;         ///< m, from where it lies within which debris has arrived
    std::vector<MapCell> cells;           ///< ascending
    std::vector<std::string> components;  ///< names behind the numbers of MapLayer::Component
    MapLedger ledger;
    std::int64_t members = 0;                       ///< of the ensemble that it is a map of; 0: of one run
    HeightThresholds thresholds = usualThresholds;  ///< m, of an ensemble
    std::vector<std::string> hypotheses;            ///< the two that MapLayer::Separation is between

    /// Values of a layer by cell: per area where the unit says so, NaN where the cell has none. Empty if the layer is not there.
    const std::vector<double>& layer(MapLayer which) const { return layers[static_cast<std::size_t>(which)]; }
    bool has(MapLayer which) const { return !layer(which).empty() || (cells.empty() && expected(which)); }
    /// The layers that are there, in order.
    std::vector<MapLayer> present() const;

    std::array<std::vector<double>, mapLayerCount> layers;

private:
    bool expected(MapLayer which) const;
};

/// Name of a layer of a map, with the height that it is about and the hypotheses that it is between.
Message mapLayerTitle(const DebrisMap& map, MapLayer layer);

/// How a map is made.
struct MapSettings {
    std::optional<double> cell{};  ///< m; unset: of a run as usualMapCell(), of pieces alone 0.25 m
    double liveThreshold = 1.0;    ///< m, farther than this live structure has fallen
    double arrivalDistance = 0.5;  ///< m
};

/// Fragments as pieces of a map, those that are there, in their order.
/// @param arrivals  s, [fragments]
/// @param energies  J, [fragments]; empty: not known
std::vector<MapPiece> mapPieces(const FragmentSet& fragments, const Debris& debris, const std::vector<double>& arrivals,
                                const std::vector<double>& energies);

/// Maps fragments, and beside them, never among them, the live structure that fell. Volume, mass and energy agree with the ledger:
/// summed over the cells and times the area of a cell they are those of the pieces, to rounding.
/// @param live      null: its layers are left out
/// @param settings  a run says the side of its cells
/// Throws as rasterOf().
DebrisMap makeDebrisMap(double time, std::span<const MapPiece> pieces, bool impactsKnown, const LiveStructure* live,
                        std::vector<std::string> components, const SiteSurface& ground, const MapSettings& settings,
                        const Execution& execution);

}  // namespace rubble
