#pragma once

#include <optional>
#include <vector>

#include "core/evidence/maps/run_map.h"
#include "core/evidence/surveys/seen_debris.h"
#include "core/evidence/surveys/survey_grid.h"
#include "core/evidence/surveys/survey_noise.h"

namespace rubble {

struct SurveySettings {
    double cell = 0.5;                ///< m
    double leastHeight = 0.2;         ///< m above the ground from which a surveyed height is debris; what lies lower is noise
    bool withFallen = true;           ///< fallen live structure is debris
    double liveThreshold = 1.0;       ///< m, farther than this live structure has fallen
    std::optional<bool> showsFallen;  ///< whether the survey holds such structure too, as stated; unset: as its file says
    SurveyFit fit = SurveyFit::None;
    double shiftMost = 5.0;  ///< m, that the survey is moved in plan at most
    int sectors = 8;         ///< directions in which run-out is measured
    double turn = 0.0;       ///< rad, counter-clockwise from east to local x
    SurveyScope scope = {};  ///< what is compared
    /// m, standard deviations of the surveyed heights and of those of the ground; unset: not stated.
    std::optional<double> noise = std::nullopt;
    std::optional<double> groundNoise = std::nullopt;
    /// m, standard deviation of an offset that all surveyed heights above the ground may have together, as of a registration or a
    /// vertical datum; unset: nobody stated one.
    std::optional<double> offsetError = std::nullopt;
};

/// How the survey was moved.
struct SurveyShift {
    Vec3 by = Vec3::Zero();  ///< m
    std::size_t cells = 0;   ///< that took part
    double before = 0.0;     ///< m (of a footprint: share of a cell), root of the mean square of what is made small
    double after = 0.0;
    bool planKnown = true;  ///< false: the ground is too level for a shift in plan, only the height was moved
    bool atLimit = false;   ///< the best shift is as far as was looked
};

/// One side of a comparison.
struct SurveySide {
    double area = 0.0;                                   ///< m2 covered by debris
    double volume = 0.0;                                 ///< m3 between ground and top, voids included; NaN of a footprint
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  ///< m, of the volume, of a footprint of the area; NaN without debris
    std::vector<double> runOut;                          ///< m, [sectors]; 0 where nothing lies in the sector
};

/// Debris that does not belong to the comparison, and what does.
struct LeftOutDebris {
    double comparedArea = 0.0;    ///< m2, surveyed and compared
    double surveyedArea = 0.0;    ///< m2
    double surveyedVolume = 0.0;  ///< m3; NaN of a footprint
    double simulatedArea = 0.0;
    double simulatedVolume = 0.0;
};

/// What a volume may be off by (95 %).
struct VolumeError {
    double random = 0.0;      ///< m3, of noise: grows with the root of the area, correlation taken into account. NaN: not known
    double systematic = 0.0;  ///< m3, of an offset of all heights: grows with the area. NaN: nobody stated one
};

/// Volumes between the surveyed surface and the ground, of heights from the level of detection on.
struct SurveyVolumes {
    double fill = 0.0;            ///< m3, above the ground
    double cut = 0.0;             ///< m3, below it
    double undetectedFill = 0.0;  ///< m3, of heights below the level of detection: not counted
    double undetectedCut = 0.0;   ///< m3, likewise below the ground
    VolumeError fillError;
    VolumeError cutError;
    VolumeError netError;

    double net() const { return fill - cut; }
    double undetected() const { return undetectedFill + undetectedCut; }
    double undetectedNet() const { return undetectedFill - undetectedCut; }
};

/// Surveyed debris in patches that come nowhere near the simulated debris.
struct ApartDebris {
    std::int64_t patches = 0;
    double area = 0.0;                                  ///< m2
    double volume = 0.0;                                ///< m3, of a footprint m2
    double nearest = 0.0;                               ///< m, from the simulated debris
    double farthest = 0.0;                              ///< m
    Eigen::Vector2d largest = Eigen::Vector2d::Zero();  ///< m, middle of the largest
};

/// The simulated debris, surveyed as the real one was: what a simulation that is right in every place would reach, and both sides
/// by one measure. Steep edges weigh the same in both.
struct SeenDebris {
    double area = 0.0;          ///< m2, that the survey would show of it
    double volume = 0.0;        ///< m3; NaN of a footprint
    double reachableIou = 0.0;  ///< of the simulated debris with itself as it would be surveyed
    double alikeIou = 0.0;      ///< of the surveyed debris with the simulated as it would be surveyed
};

/// Live structure of a run that fell, whether it is counted or not.
struct FallenStructure {
    std::int64_t elements = 0;  ///< that moved farther than the threshold
    double volume = 0.0;        ///< m3, of material
    std::int64_t held = 0;      ///< loose parts that the run held where the FE result ends
};

/// Structure of a run that stands where a survey of heights shows debris: most likely the survey shows that structure.
struct StandingStructure {
    double area = 0.0;    ///< m2, of surveyed debris in cells that it stands on or over; 0 of a footprint
    double volume = 0.0;  ///< m3, between surveyed heights and the ground there
};

/// The simulated debris held against a survey. Only cells that were surveyed count, on both sides alike.
struct SurveyComparison {
    double time = 0.0;  ///< s, of the simulated debris
    FrameKind shown = FrameKind::Simulated;
    bool isFootprint = false;
    SurveySettings settings;
    std::optional<bool> surveyShowsFallen;  ///< as stated, else as its file says; unset: not known
    FallenStructure fallen;                 ///< of the simulated side
    StandingStructure standing;             ///< within the surveyed debris, which it makes larger
    SurveyShift shift;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< m, of the structure's plan at rest: run-out counts from here
    double least = 0.0;  ///< m, from which heights are debris: the least height, or the level of detection if that is more
    SurveyNoise noise;
    SurveyVolumes volumes;  ///< of the survey; 0 of a footprint
    LeftOutDebris leftOut;
    ApartDebris apart;
    std::optional<SeenDebris> seen;  ///< unset: not asked for
    SurveySide survey;
    SurveySide simulated;
    double iou = 0.0;               ///< of the footprints
    double heightRms = 0.0;         ///< m, of the differences where either has debris; NaN of a footprint
    double heightMean = 0.0;        ///< m, simulated less surveyed there; NaN of a footprint
    double centroidDistance = 0.0;  ///< m
    double unsurveyedArea = 0.0;    ///< m2 of simulated debris where nothing was surveyed: left out
    double unsurveyedVolume = 0.0;  ///< m3
    CellGrid difference;            ///< m, simulated less surveyed; of a footprint 1 only simulated, -1 only surveyed, 0 both.
                                    ///< Not a number where neither has debris or nothing was surveyed
    CellGrid surveyedCells;         ///< m above the ground, of a footprint shares of cells; not a number where nothing was surveyed
    CellGrid simulatedCells;        ///< m above the ground
    std::vector<std::uint8_t> compared;  ///< [cells] 1: belongs to the comparison; where it is 0 nothing counts as surveyed
    Findings findings;
    Message words;  ///< what the comparison rests on, in a sentence
};

/// Compares heights of debris by cell with a survey.
/// @param centre  m, run-out counts from here; the bearing of a cell's middle decides its sector, the first one around east
/// @param fine    the debris on fine cells, for `seen`; null: leaves it out
/// Throws UsageError (no cells in common, an area of interest without any, settings that are no sizes), Cancelled.
SurveyComparison compareWithSurvey(const PieceRaster& debris, const Survey& survey, const SiteSurface& ground,
                                   const Eigen::Vector2d& centre, const SurveySettings& settings, const Execution& execution,
                                   const FineDebris* fine = nullptr);

/// The same for a run at a time within its span; unset means its end. Throws as above and as mapOfRun().
SurveyComparison compareRunWithSurvey(const MappedRun& run, std::optional<double> time, const Survey& survey,
                                      const SurveySettings& settings, const Execution& execution);

/// Whether a cell counts as debris on either side.
bool surveyedDebris(const SurveyComparison& made, std::size_t cell);
bool simulatedDebris(const SurveyComparison& made, std::size_t cell);

/// "E", "NE", "N" and so on for eight sectors, else the bearing of the middle in degrees from north.
std::string sectorName(int sector, int sectors);

}  // namespace rubble
