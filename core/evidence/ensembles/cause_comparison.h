#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/evidence/ensembles/cause_ranking.h"
#include "core/evidence/ensembles/probability_map.h"
#include "core/evidence/photographs/photo_comparison.h"
#include "core/evidence/surveys/survey_noise.h"

namespace rubble {

enum class EvidenceKind : std::uint8_t { Footprint, Heights, Photograph, Time };
/// "footprint", "heights", "photograph", "time"
std::string_view evidenceKindName(EvidenceKind kind);

/// Where debris was seen on the ground, on the cells that hypotheses are mapped on. An outline covers a cell, on either side, if
/// half of it lies within; a height below `least` counts, on either side, as the ground.
struct SurfaceEvidence {
    std::string name;
    EvidenceKind kind = EvidenceKind::Footprint;  ///< or Heights
    MemberSurface seen;                           ///< cells with debris; of a footprint the heights are 1
    bool everywhere = true;                       ///< what is not among `seen` holds no debris
    std::vector<MapCell> looked;                  ///< else the cells that were looked at, ascending; no others count
    std::vector<MapCell> leftOut = {};            ///< cells that do not count in any case, ascending
    double least = 0.0;                           ///< m, from where on heights count
    bool reached = false;                         ///< an outline of all cells that debris reaches into at all
    bool surveyed = false;                        ///< heights with noise; `seen` holds all that were surveyed, of the ground too
    /// m, standard deviations of the heights and of those of the ground; unset: not stated.
    std::optional<double> noise = {};
    std::optional<double> groundNoise = {};
    SurveyNoise found = {};  ///< of a cell, by withDetection()

    bool counts(const MapCell& cell) const;
    /// Debris lies in a cell of a surface; -1: nothing does.
    bool holds(const MemberSurface& surface, std::ptrdiff_t at) const;
};

/// A surface as if it had been surveyed as that evidence was.
SurfaceEvidence seenAs(const MemberSurface& surface, const SurfaceEvidence& like);

/// A photograph with an outline of the debris and the camera that took it.
struct PhotoEvidence {
    std::string name;
    Photograph photograph;
    CameraMatch match;
};

/// When debris reached a place: by a witness, a video, a gauge. Counted from the first debris that came down anywhere, because no
/// clock of the site shows when an FE result begins.
struct TimeEvidence {
    std::string name;
    Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< m
    double radius = 0.0;                              ///< m, around it
    double time = 0.0;                                ///< s, after the first debris that came down anywhere
    double accuracy = 0.0;                            ///< s, plus or minus
};

inline constexpr double usualTimeRadius = 5.0;    ///< m
inline constexpr double usualTimeAccuracy = 0.5;  ///< s
/// Named as the command line has it: "time=3.2,12,0,5,0.5". @param seconds  after the first debris that came down anywhere
TimeEvidence timeEvidence(double seconds, const Eigen::Vector2d& place, double radius, double accuracy);

/// What hypotheses are held against.
struct CauseEvidence {
    std::vector<SurfaceEvidence> surfaces;
    std::vector<PhotoEvidence> photographs;
    std::vector<TimeEvidence> times;

    std::size_t count() const { return surfaces.size() + photographs.size() + times.size(); }
    std::string name(std::size_t evidence) const;
    EvidenceKind kind(std::size_t evidence) const;
};

/// How far debris is from evidence, 0 the same, 1 nothing in common. Footprint: 1 less the overlap of the cells (IoU). Heights: the
/// sum of the differences of height over the sum of both heights (Bray & Curtis 1957). NaN if neither holds anything.
double departureFrom(const SurfaceEvidence& evidence, const MemberSurface& surface);

/// How far a time is from when debris reached the place, 0 within its accuracy, 1 where none did: d / (d + 1 s), d being what lies
/// beyond the accuracy. NaN if nothing came down at all.
double departureFrom(const TimeEvidence& evidence, const DebrisArrivals& arrivals);
/// The same of two times that may be unknown: no debris came there. @param accuracy  s, plus or minus
double timesApart(double a, double b, double accuracy);

/// 1 less the overlap of silhouettes, mean over cameras that the match allows. Of a photograph that was not taken at rest NaN: what
/// a member keeps is its debris at rest. Throws as compareWithPhoto().
double departureFrom(const PhotoEvidence& evidence, const MemberSite& site, const SurfaceSettings& settings,
                     const Execution& execution);

/// Looks at a member with the photographs of the evidence, for EnsembleOptions::look.
std::vector<double> lookedAt(const CauseEvidence& evidence, const MemberSite& site, const SurfaceSettings& settings,
                             const Execution& execution);

/// One supposed cause, with its ensemble. Its members were looked at by lookedAt() if there are photographs.
struct Hypothesis {
    std::string name;
    std::shared_ptr<const EnsembleReport> ensemble;
};

/// Part of the site that speaks most for the closest hypothesis and against the next one.
struct TellingPlace {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< m
    double area = 0.0;                                 ///< m2
    double share = 0.0;                                ///< of all that speaks for it on the map

    /// m, of a circle of that area.
    double radius() const { return std::sqrt(area / std::numbers::pi); }
};

/// Hypotheses of one collapse, held against the same evidence.
struct CauseComparison {
    std::vector<std::string> hypotheses;
    std::vector<std::string> evidence;
    std::vector<EvidenceKind> kinds;  ///< [evidence]
    std::vector<Departures> departures;
    CauseRanking ranking;
    std::vector<std::string> alike;  ///< hypotheses that cannot be told from the closest one, that one not among them
    std::size_t telling = 0;         ///< piece of evidence that tells the first two apart best
    /// Chance that one more member of the closest hypothesis would be as far from the others as the evidence is, least over the
    /// surveys and times, multiplied by their number, at most 1; NaN without those or with fewer than two members.
    double fit = 0.0;
    /// The evidence lies outside of what the closest hypothesis does: fit below 1 %, where there are members enough to judge by.
    bool unexplained = false;
    std::optional<DebrisMap> separation;  ///< of the first two hypotheses; unset without surface evidence
    std::optional<TellingPlace> place;
    Message verdict;
    Findings findings;
};

/// Throws UsageError for ensembles that are not mapped alike.
void checkAlike(std::span<const Hypothesis> hypotheses);

/// Compares hypotheses. Heights of a survey count from its level of detection on (withDetection()). Throws UsageError for ensembles
/// on other cells or with other counting of fallen structure, no evidence, and as rankCauses().
CauseComparison compareCauses(std::span<const Hypothesis> hypotheses, const CauseEvidence& evidence);

/// What comes of it if each member in turn is what was observed, and left out of its own ensemble: how far evidence of a kind can
/// tell these causes apart at all.
struct BlindTest {
    EvidenceKind kind = EvidenceKind::Heights;
    std::vector<std::vector<std::int64_t>> named;  ///< [true cause][cause that was named] trials
    std::vector<std::int64_t> undecided;           ///< [true cause]
    std::vector<std::int64_t> closest;             ///< [true cause] trials in which it was the closest, named or not
    /// [true cause] trials in which, with that cause not among the hypotheses, the evidence lies outside of what the closest of the
    /// others does: what would not be noticed is a wrong cause named. Empty with fewer than eight members of any.
    std::vector<std::int64_t> noticed;
    Findings findings;

    std::int64_t trials() const;
    std::int64_t right() const;  ///< named, and rightly
    std::int64_t wrong() const;  ///< named, and wrongly
};
/// @param kind  Footprint or Heights. Throws as compareCauses(), Cancelled.
BlindTest blindTest(std::span<const Hypothesis> hypotheses, EvidenceKind kind, const Execution& execution);

}  // namespace rubble
