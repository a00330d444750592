#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/accuracy/settled_world.h"
#include "core/analysis/accuracy/study_tasks.h"
#include "core/evidence/ensembles/member_surface.h"
#include "core/scenario/ensemble.h"

namespace rubble {

/// A scenario that members of an ensemble may be of, with what it works on.
struct EnsembleScene {
    std::string id;  ///< as the setting "scenario" chooses it
    std::string name;
    Inputs inputs;
    Scenario scenario;
};

struct EnsembleReport;

/// How an ensemble is made and measured.
struct EnsembleOptions {
    DebrisInstant instant = DebrisInstant::AtRest;
    SurfaceSettings surface;
    int jobs = 0;     ///< members at a time; 0: one for each thread. No result depends on it
    int threads = 0;  ///< in all; 0: as many as the execution grants
    std::string machine;
    SettledStore* store = nullptr;  ///< keeps members; null: nothing is kept. Not owned
    WorldChoice choice;             ///< which members are simulated; a single one is kept but not measured
    /// Looks at a member that is there, on a thread of its own; what it gives is kept with the member. Null: nobody looks.
    std::function<std::vector<double>(const MemberSite&, const Execution&)> look;
    /// Called whenever a member is done, by one thread at a time. Null: nobody listens.
    std::function<void(const EnsembleReport&)> grown;
};

/// Figures of a member that an ensemble has a spread of.
enum class MemberMeasure : std::uint8_t { Footprint, PileVolume, RunOut, Mass, MeanHeight, PileHeight };
inline constexpr std::size_t memberMeasureCount = 6;
struct MemberMeasureRow {
    std::string_view key;  ///< "footprint_m2"
    std::string_view unit;
    std::string_view name;
    std::string_view toldUnit;  ///< that people are told it in
    double toldPerUnit;         ///< how many of it are one unit
};
const MemberMeasureRow& memberMeasureRow(MemberMeasure measure);

/// One member of an ensemble.
struct EnsembleMember {
    std::int64_t number = 0;
    std::size_t scene = 0;
    DrawnValues drawn;
    Scenario scenario;
    bool done = false;  ///< the rest only where true
    bool kept = false;  ///< it was there from an earlier start
    Message failure;    ///< why it was not simulated, if it could not be
    Digest trajectoryHash;
    double endTime = 0.0;       ///< s
    double wallSeconds = 0.0;   ///< of its simulation
    std::int64_t breaches = 0;  ///< of the limits of health
    std::int64_t moving = -1;   ///< bodies that still moved at its end; -1: not known
    std::int64_t bodies = 0;    ///< of so many
    std::array<double, memberMeasureCount> figures{};
    std::shared_ptr<const MemberSurface> surface;
    DebrisArrivals arrivals;
    std::vector<double> looked;  ///< what was seen on it

    double of(MemberMeasure measure) const { return figures[static_cast<std::size_t>(measure)]; }
};

/// A collapse simulated again and again.
struct EnsembleReport {
    EnsembleSettings settings;
    SurfaceSettings surface;
    DebrisInstant instant = DebrisInstant::AtRest;
    std::vector<EnsembleMember> members;  ///< all of them, done or not
    Findings findings;
    bool complete = false;  ///< false after a cancel or a failure: what is done is there

    std::vector<const EnsembleMember*> done() const;
};

/// Spread of one figure over the members that are done.
struct FigureSpread {
    std::size_t count = 0;
    double mean = 0.0;
    double deviation = 0.0;      ///< of members; NaN with fewer than two
    double standardError = 0.0;  ///< of the mean, deviation over the root of the number; likewise
    double low = 0.0;            ///< 5 % of the members lie below
    double middle = 0.0;
    double high = 0.0;  ///< 5 % lie above
    double least = 0.0;
    double most = 0.0;

    /// Among fewer there is no one in twenty: quantiles lie between two members, and the least and the most tell more.
    bool hasTwentieths() const { return count >= 20; }
    double lower() const { return hasTwentieths() ? low : least; }
    double upper() const { return hasTwentieths() ? high : most; }
};
FigureSpread spreadOf(std::vector<double> values);
/// Members that differ by the rounding of single precision alone, a millionth, are the same: their spread is 0.
/// @param first  only the first so many members that are done
FigureSpread spreadOf(const EnsembleReport& report, MemberMeasure measure, std::size_t first = static_cast<std::size_t>(-1));

/// Simulates the members of an ensemble in parallel and measures each. Members that the store keeps are not simulated again: after
/// a cancel, or with more members, the same call goes on from there. No figure depends on how many run at a time. A member that
/// fails takes no other with it; a store that is full is a finding.
/// @param scenes  one, or those that the setting "scenario" names; the first one is that of members that choose none
/// Returns what there is when cancelled. Throws UsageError for settings out of range and scenes that are not there, and what the
/// pipeline throws for a scene.
EnsembleReport ensembleStudy(std::span<const EnsembleScene> scenes, const EnsembleSettings& settings,
                             const EnsembleOptions& options, const Execution& execution);

/// The worlds of its members. Throws what ensembleStudy() throws, and Cancelled.
std::vector<StudyTask> ensembleTasks(std::span<const EnsembleScene> scenes, const EnsembleSettings& settings,
                                     const EnsembleOptions& options, const Execution& execution);

}  // namespace rubble
