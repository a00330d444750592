#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/evidence/photographs/camera_match.h"
#include "core/scenario/photograph.h"
#include "core/scenario/scenario.h"
#include "core/simulation/health/passed_limits.h"
#include "core/simulation/run/simulation.h"

namespace rubble {

/// What a reader must know beside the figures of a run. Said here once: window, report, figures, maps and JSON show it.
struct Caution {
    std::string_view
        key;  ///< "tainted", "limits_passed", "other_settings", "units_unsaid", "not_complete", "still_moving",
              ///< "no_place", "place_doubt", "motion_doubt", "born_at_rest", "birth_doubt", "assumed", "single_run", "bodies",
              ///< "poor_camera", "not_at_rest", "stated_camera", "ensemble", "members", "no_evidence", "evidence_doubt"
    HealthGrade grade{};
    Message what;

    /// Pictures show what is graver than a notice, that limits were passed at all, and that they are of one set of assumptions.
    bool inPictures() const { return grade != HealthGrade::Notice || key == "single_run" || key == "limits_passed"; }
};

/// Beside whatever is written of a model that has no place in the coordinate system that its case names: its axes are its own.
/// @param system  that is named
Caution noPlaceCaution(const std::string& system);

/// Beside figures of one run, of one set of values.
Caution singleRunCaution();

/// Beside figures and maps of an ensemble.
/// @param members  that are done
/// @param mean, worst  standard error of the probability of a cell, in the mean of all and of the worst; not a number: not known
Caution ensembleCaution(std::size_t members, double mean, double worst);

/// How far a run has come and what it is worth.
struct RunStanding {
    bool complete = true;
    double reached = 0.0;        ///< s, last instant that there is
    std::int64_t fragments = 0;  ///< that were born or will be
    std::int64_t bodies = 0;     ///< that carry them
    std::int64_t moving = 0;     ///< of these, awake at `reached`
    std::vector<HealthBreach> breaches;
    bool acknowledged = false;            ///< someone vouches for it in spite of its breaches
    std::string unplaced{};               ///< coordinate system that the case names without a place of the model in it; empty: none
    std::string unsaidUnits{};            ///< systems of units that the FE result would fit as well; empty: its units are known
    std::vector<Message> placeDoubts{};   ///< what makes places and heights uncertain
    std::vector<Message> motionDoubts{};  ///< what the engine did to bodies that nothing in the collapse did
    std::vector<Message> assumed{};       ///< what masses rest on that nobody said
    bool bornAtRest = false;              ///< debris began without the velocity that the FE result gave it
    std::vector<Message> birthDoubts{};   ///< what of single births had to be guessed
    bool outgrown = false;                ///< the case that it is shown in has other settings by now
    std::optional<double> earlier{};      ///< s, instant that `bodies` and `moving` are of; unset: the last one
};

/// What of the findings of opened inputs makes every place or height of a run uncertain: the way between coordinate systems,
/// control points, the unit of heights, a terrain that was filled by more than a tenth, ends short of the structure or of debris.
std::vector<Message> placeDoubts(const Findings& findings);

/// What of the findings of a run says that the engine kept bodies from what they would have done: held back at an impossible
/// speed, or left whole for want of room.
std::vector<Message> motionDoubts(const Findings& findings);

/// What of the findings of a run says that its masses rest on assumptions: densities, thicknesses, sections,
/// elements without volume, each with their number.
std::vector<Message> assumedMasses(const Findings& findings);

/// What of the findings of a run says that fragments began otherwise than the FE result tells: their velocity or their time was not
/// known, or not to be believed. Each with their number.
std::vector<Message> birthDoubts(const Findings& findings);

/// Takes over what the inputs of a run left open. @param findings  all of the run  @param velocity  that debris begins with
void tellInputs(RunStanding& standing, const Findings& findings, BirthVelocity velocity);

/// Beside whatever was made from these inputs.
/// @param unsaidUnits  systems of units that the FE result would fit as well; empty: its units are known
std::vector<Caution> inputCautions(const std::string& unsaidUnits, const std::vector<Message>& placeDoubts);

/// Adds those that are not yet there.
void addCautions(std::vector<Caution>& list, const std::vector<Caution>& more);

/// Of a run that is complete.
RunStanding standingOf(const SimulationResult& result, std::size_t fragments, bool acknowledged);

/// The gravest first; the number of bodies stands at the end.
std::vector<Caution> runCautions(const RunStanding& run);

/// Of a photograph that the debris of a run is held against.
/// @param match  null: none was found
/// @param run    null: no debris is held against it
std::vector<Caution> photographCautions(const Photograph& photograph, const CameraMatch* match, const RunStanding* run);

/// Those that pictures show, in one line of English; empty: none.
std::string pictureCautions(const std::vector<Caution>& cautions);

}  // namespace rubble
