#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/outline.h"
#include "core/evidence/clouds/cloud_distance.h"
#include "core/evidence/clouds/cloud_fit.h"
#include "core/evidence/clouds/cloud_volumes.h"
#include "core/scenario/registration.h"
#include "core/scenario/survey_scope.h"
#include "io/site/clouds/cloud_head.h"
#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Core points at most, and points of both clouds that are held in memory at a time: 1.6 GB while they are ordered.
inline constexpr std::size_t coresMost = 10'000'000;
inline constexpr std::uint64_t heldPointsMost = 20'000'000;

/// Two clouds to be held against each other.
struct CloudComparisonRequest {
    std::string first;
    std::string second;
    std::string cores;  ///< cloud of core points; empty: the points of the first, one to each cube as wide as the projection radius
    CloudRequest read;  ///< how the first is read, and the others where they say nothing themselves
    /// Standard deviation of those in the first cloud where the table does not state it, in numbers of the files; unset: not known.
    std::optional<double> control = std::nullopt;
    std::string pairs = {};  ///< table of places in the second cloud and in the first, in numbers of the files; empty: none
    bool metres = false;     ///< places are brought to metres first; else all lengths are in units of the files
    CloudDistanceSettings settings;
    /// What did not move, as polygons in the unit of the comparison: the second cloud is fitted to the first there. Empty:
    /// everywhere. Unset: it lies where it lies.
    std::optional<Outline> stable;
    SurveyScope scope = {};  ///< cores beyond it are not measured, in the unit of the comparison
    double cell = 0.0;       ///< side of the cells that volumes are taken over, a length as the others; 0: none are
    std::uint64_t heldPoints = heldPointsMost;
};

/// A cloud that took part.
struct ComparedCloud {
    std::string path;
    CloudHead head;
    std::uint64_t points = 0;  ///< that were taken of it
    std::uint64_t near = 0;    ///< of them, so near to the cores that they may count
};

/// Distances from the first cloud to the second.
struct CloudComparison {
    ComparedCloud first;
    ComparedCloud second;
    std::string coresFrom;    ///< path; empty: they are points of the first cloud
    std::vector<Vec3> cores;  ///< units of the file, or m
    std::vector<CoreDistance> distances;
    double unit = 0.0;                    ///< m to each unit of length; NaN: those of heights differ from those of x and y
    bool metresStated = false;            ///< the files say so, for plan and heights
    bool againstRun = false;              ///< the second is a run, as the scan would have seen it
    std::uint64_t beyond = 0;             ///< cores out of the scope
    int parts = 0;                        ///< strips that the cores were taken in, so that memory stays bounded
    CloudDistanceSettings settings;       ///< with the registration error that was taken
    std::optional<Registration> placed;   ///< by which the second was moved first; set if there were pairs
    std::optional<CloudFit> fit;          ///< set if one cloud was fitted to the other, after the pairs
    std::optional<CloudVolumes> volumes;  ///< set if they were asked for
    double cubicMetres = 0.0;             ///< in a cube of the unit that they are in
    Findings findings;
};

/// Reads two clouds and measures from one to the other at the core points. Clouds that do not fit into memory are read once for
/// each strip of cores; no result depends on that. What is assumed or has no answer is a counted finding.
/// Throws ParseError (other systems, degrees, clouds that do not meet, no points), UsageError (too many cores), WorldError,
/// Cancelled.
CloudComparison compareClouds(const CloudComparisonRequest& request, const Execution& execution);

/// Says how many points of a cloud lie out of the scope: a counted finding.
void addBeyond(Findings& findings, const std::string& path, std::uint64_t points);

/// Refuses more core points than there is room for. Throws UsageError.
void checkCores(std::size_t count);

/// The middles of square cells in plan that points of two clouds lie in, in the order of the cells whatever the order of the
/// points.
class CellMiddles {
public:
    explicit CellMiddles(double side) : m_side(side) {}

    /// @param which  0: of the first cloud, 1: of the second. Throws UsageError (too many cells).
    void add(const std::vector<Vec3>& places, std::size_t which);
    /// As high as the points of the first cloud there are in the mean, else those of the second.
    std::vector<Vec3> places() const;

private:
    struct Cell {
        std::array<double, 2> sums{};
        std::array<std::uint32_t, 2> counts{};
    };
    double m_side;
    std::map<std::pair<std::int64_t, std::int64_t>, Cell> m_cells;
};

/// How volumes over cells of a side are measured: straight up, in a cylinder of the area of a cell.
CloudDistanceSettings volumeSettings(CloudDistanceSettings settings, double cell);

/// Says how many cells are in no volume, and why: a counted finding.
void addCellsLeft(CloudComparison& made);

/// Says of how wide cubes a fit took its points, if they are wider than its radius, and whether it settled: counted findings.
void addFitFindings(Findings& findings, const CloudFit& fit, double radius);

/// What the level of detection takes for the registration error: as stated, else that of the fit, else that of the pairs.
/// Says what speaks against the fit: counted findings.
CloudDistanceSettings settingsAfterFit(CloudComparison& made, const CloudDistanceSettings& settings);

/// Says which cores have no distance or no level of detection, and why: counted findings.
void judgeDistances(CloudComparison& made, const CloudDistanceSettings& settings);

}  // namespace rubble::io
