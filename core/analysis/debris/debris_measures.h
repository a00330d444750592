#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/analysis/debris/cell_map.h"
#include "core/analysis/debris/collapse_plan.h"
#include "core/analysis/debris/debris.h"

namespace rubble {

/// How debris is measured (DESIGN.md 2.6).
struct MeasureSettings {
    double massCell = 2.0;                          ///< m, of the mass map
    double footprintCell = 1.0;                     ///< m, of footprint and height map
    double coreShare = 0.95;                        ///< of the mass, in the core
    double runOutShare = 0.95;                      ///< of the mass, within the run-out
    std::vector<double> tolerances{0.1, 0.2, 0.3};  ///< m, of the accuracy rate
};

/// Figures of one debris field. Those that need mass are NaN where there is none.
struct DebrisFigures {
    std::int64_t fragments = 0;  ///< present
    double mass = 0.0;           ///< kg
    double footprintArea = 0.0;  ///< m2: cells that the outline of any fragment reaches into
    double coreArea =
        0.0;              ///< m2: the fewest cells of the mass map that hold the core's share of the mass; equal cells go together
    double runOut = 0.0;  ///< m: the distance from the plan of what collapsed within which its share of the mass lies
    double meanHeight = 0.0;       ///< m: of the mass, above the ground below each fragment's centre
    double pileHeight = 0.0;       ///< m: highest cell of the height map
    Vec3 centroid = Vec3::Zero();  ///< m, of the mass
};

/// Debris with its maps and figures, ready to be compared.
struct DebrisField {
    Debris debris;
    CellMap mass;               ///< kg
    std::vector<MapCell> core;  ///< ascending
    CellMap heights;            ///< m; its cells are the footprint
    DebrisFigures figures;
    MeasureSettings settings;
};

/// Maps debris and takes its figures. Run-out: a fragment counts with its mass at the horizontal distance of its centre from the
/// plan; the run-out is the smallest distance within which the share lies. Throws UsageError for debris with a number that is none,
/// for cells, shares or tolerances out of range, and for maps too large.
DebrisField measureDebris(Debris debris, const CollapsePlan& plan, const SiteSurface& ground, const MeasureSettings& settings);

/// What can be compared, in the order in which it is listed.
enum class Measure : std::uint8_t {
    MassMap,         ///< half the sum of |difference| over the cells, per mean total mass: 0 same, 1 nowhere the same
    CoreIou,         ///< cells in both cores over cells in either
    FootprintIou,    ///< cells in both footprints over cells in either
    RunOut,          ///< m, second less first
    HeightRms,       ///< m, root of the mean square difference of the height maps over the cells of either footprint
    MeanHeight,      ///< m, second less first
    CentroidShift,   ///< m, distance of the centroids in space
    MedianDistance,  ///< m, of each fragment between its two places; of those present in both
};
inline constexpr std::size_t measureCount = 8;

/// "mass_map_difference", "core_iou", "footprint_iou", "run_out_m", "height_rms_m", "mean_height_m", "centroid_shift_m",
/// "median_distance_m": keys for programs, unit included.
std::string_view measureKey(Measure measure);

/// How a second debris field differs from a first. Exchanging the two changes signs only.
struct DebrisDifference {
    std::array<double, measureCount> values{};  ///< by Measure; NaN where one of the two has no such figure
    std::vector<double> tolerances;             ///< m
    std::vector<double> accuracy;  ///< share of the fragments present in either that lie within each tolerance; NaN without any

    double of(Measure measure) const { return values[static_cast<std::size_t>(measure)]; }
    double& of(Measure measure) { return values[static_cast<std::size_t>(measure)]; }
    /// How far a measure is from what two equal fields give, never negative: 1 - IoU, the amount of a signed difference.
    double departure(Measure measure) const;
};

/// Compares two fields that were measured with the same settings.
/// Throws UsageError if they are not of the same number of fragments, or the settings differ.
DebrisDifference compareDebris(const DebrisField& first, const DebrisField& second);

/// Distance of each fragment between its two places, m; NaN where it is absent from either. This is what a view colours by and what
/// the accuracy rate counts. Throws UsageError if the two are not of the same number of fragments.
std::vector<double> fragmentErrors(const Debris& first, const Debris& second);

/// The larger departure of each measure, the smaller accuracy rate; what is NaN in one is taken from the other.
DebrisDifference largerOf(const DebrisDifference& a, const DebrisDifference& b);

}  // namespace rubble
