#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/accuracy/prediction.h"
#include "core/analysis/accuracy/repeat_floor.h"
#include "core/analysis/debris/debris_measures.h"
#include "core/evidence/cautions.h"
#include "core/evidence/ensembles/ensemble.h"
#include "core/evidence/ensembles/telling_evidence.h"
#include "core/evidence/maps/run_map.h"
#include "core/evidence/photographs/photo_comparison.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "core/fe/control_points.h"
#include "core/scenario/journal.h"
#include "core/simulation/run/acknowledgement.h"
#include "core/validation/validation_record.h"

namespace rubble {

/// A file that a report rests on, as it was found when the report was made.
struct ReportFile {
    std::string role;  ///< "fe", "terrain", "photograph", "survey", "run", "case", "words", "causes", "cause"
    std::string path;
    std::string sha256;
};

/// A photograph of the case and what came of holding the debris against it.
struct ReportPhoto {
    std::string name;
    Photograph photograph;
    int width = 0;  ///< px, of the pixels below
    int height = 0;
    std::vector<std::uint8_t> rgb;  ///< [height * width * 3], the photograph made smaller, upright; empty: it cannot be read
    std::optional<CameraMatch> match;
    std::optional<PhotoComparison> comparison;
    std::vector<Caution> cautions;
    Message problem;  ///< why there is no match, no comparison or no picture; empty if there is
};

/// A survey of the case and what came of holding the debris against it.
struct ReportSurvey {
    std::string name;
    std::optional<SurveyComparison> comparison;
    std::vector<Caution> cautions;  ///< that it is no evidence
    Message problem;                ///< why there is no comparison; empty if there is
};

/// One case of the self-test on this machine.
struct ReportCheck {
    std::string id;
    std::string title;
    std::string criterion;
    bool passed = false;
    double measured = std::numeric_limits<double>::quiet_NaN();  ///< of the number closest to its limit
    double limit = std::numeric_limits<double>::quiet_NaN();
    std::string unit;
};

/// A mesh of the surroundings that debris fell on.
struct ReportMesh {
    std::string name;
    Vec3 offset = Vec3::Zero();  ///< m, by which its coordinates were moved
};

/// Where the model of a report lies, and on what its debris fell.
struct ReportPlace {
    std::string named;   ///< coordinate system that the case names; empty: none
    std::string system;  ///< the one that its places are in, as placedSystem(); empty: the model's own
    SiteFit fit;         ///< from the local frame to that system
    std::vector<ControlPoint> points;
    std::string terrain;  ///< its file; empty: none
    std::vector<ReportMesh> meshes;
};

/// What standards for the reports of experts ask for and no program can say, in the words of who answers for the report. Plain
/// text; a blank line ends a paragraph, a line that begins with "- " is a point of a list. Empty: not said.
struct OwnWords {
    std::string custody;             ///< who held the material before, and what was done to it
    std::string alternatives;        ///< other causes that were considered, and how each was excluded
    std::string change;              ///< what would change the opinion
    std::string summary;             ///< on one page, for readers who are no engineers
    std::string qualification = {};  ///< what qualifies the author, and what binds them to a party
};

/// A supposed cause, held against the evidence among others.
struct ReportCause {
    std::string name;
    std::int64_t members = 0;
    Superiority closestOver;  ///< in how many pairs of members the closest cause is closer; of that one itself without meaning
    bool apart = false;       ///< the evidence tells it from the closest one
};

/// What came of a comparison of causes.
struct ReportCauses {
    std::vector<ReportCause> ranked;  ///< the closest first
    std::vector<std::string> evidence;
    bool toldApart = false;
    bool unexplained = false;  ///< perhaps none of them is the cause
    BlindShare atHand;         ///< no trial: it was not asked which evidence would tell
    std::vector<FurtherEvidence> further;
    std::vector<Message> findings;  ///< of causes, members and evidence
};

/// What a report says of a comparison. @param findings  all that was found; @param further  which evidence would tell; null: that
/// was not asked
ReportCauses reportCauses(const CauseComparison& comparison, const Findings& findings, const TellingEvidence* further);

/// Everything that a report of one run says, as values that trace to the run: text and pictures are made from this.
struct ReportFacts {
    std::string title;
    std::string question;
    std::string author;
    OwnWords words;
    std::optional<ReportCauses> causes;  ///< unset: none were compared
    std::string when;                    ///< UTC
    std::string machine;

    std::string casePath;  ///< empty: made from the run alone
    std::string scenarioName;
    std::string scenarioNote;
    bool runKept = true;  ///< false: it was simulated for the report alone, and goes with it
    std::string fingerprint;
    std::string build;
    std::vector<ReportFile> files;
    ReportPlace place;
    std::vector<JournalEntry> journal;

    Scenario scenario;
    std::shared_ptr<const FeResult> fe;
    std::shared_ptr<const TerrainGrid> terrain;  ///< null: none
    std::shared_ptr<const Components> components;
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const Clustering> clustering;
    std::shared_ptr<const Sizing> sizing;
    std::shared_ptr<const SimulationResult> result;
    std::vector<LedgerRow> ledger;
    Findings findings;
    std::vector<Caution> cautions;  ///< of the run
    std::optional<Acknowledgement> acknowledged;

    DebrisFigures atRest;
    DebrisFigures atFeEnd;
    RunMap map;                            ///< at the end
    std::optional<RepeatFloor> floor;      ///< of repeats made for the report; unset: none were
    bool reproduced = false;               ///< the run was simulated again for the floor and came out bit for bit
    std::vector<KnownPoint> points;        ///< settings of this scene that were compared with the reference
    std::optional<RepeatFloor> reference;  ///< that reference with its repeats, as far as they were kept; unset: it was not
    std::vector<ReportPhoto> photographs;
    std::vector<ReportSurvey> surveys;
    std::shared_ptr<const EnsembleReport> ensemble;  ///< of the case, as far as its members were simulated; null: none was
    std::shared_ptr<const DebrisMap> probability;    ///< of its members; null: there are none
    std::vector<ValidationRecord> validation;        ///< measured falls that this build was held against; empty: none
    std::vector<ReportCheck> selfTest;               ///< empty: not run
    std::string selfTestScope;                       ///< "all", "closed-form"
    std::size_t selfTestLeft = 0;                    ///< cases of that scope that take too long for a report
};

/// Least and largest of a figure over a run and its repeats; equal without repeats.
struct FigureRange {
    double low = 0.0;
    double high = 0.0;
};
FigureRange rangeOver(const ReportFacts& facts, double DebrisFigures::* figure);

}  // namespace rubble
