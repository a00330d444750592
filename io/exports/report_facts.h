#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/cautions.h"
#include "core/evidence/report_facts.h"
#include "core/pipeline/pipeline.h"
#include "core/scenario/case.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// What a report is to be made of.
struct ReportRequest {
    std::shared_ptr<const RunReader> run;
    Inputs inputs;                  ///< of the run
    std::string fePath;             ///< where its FE result is now
    std::string terrainPath;        ///< likewise; empty: none
    Findings siteFindings{};        ///< of reading terrain and surroundings
    const Case* theCase = nullptr;  ///< that the run must agree with; null: the run alone
    std::string casePath;           ///< of a case that lies in a file, empty otherwise
    std::string basePath;           ///< file that the paths of the case are relative to: the case, unsaved its FE result
    std::string scenarioId;         ///< of the case; empty: its active one
    std::string title;              ///< empty: that of the case
    std::string question;
    std::string author;
    std::string causesPath;                 ///< of a comparison of causes, as readComparedCauses() reads it; empty: `causes`
    std::string wordsPath;                  ///< of what the author says, as readOwnWords() reads it; empty: `words`
    OwnWords words{};                       ///< that no file holds
    std::optional<ReportCauses> causes{};   ///< that were compared in this program; unset: none
    std::vector<ReportFile> causesFiles{};  ///< that `causes` rests on
    int repeats = 2;                        ///< simulated anew for the uncertainty; 0: none
    std::string studyFolder;                ///< where studies are kept; empty: no accuracy and no ensemble
};

/// The photographs of a case held against a run: those that something was drawn on.
/// @param basePath  file that the paths of the case are relative to
/// @param standing  of the run, for what is said beside each
/// Throws Cancelled; what keeps a photograph from being read or compared stands beside it.
std::vector<ReportPhoto> photographsOfCase(const MappedRun& run, const Case& theCase, const std::string& basePath,
                                           const RunStanding& standing, const Execution& execution);

/// What makes a run too old to be reported: a setting that the case has changed since, an input that is another file now, a run
/// that is not complete or not what was written. One line each; empty: nothing does.
std::vector<Message> staleParts(const ReportRequest& request, const Execution& execution);

/// Collects everything that a report says but the self-test. Throws UsageError naming all that is stale, what the files throw, and
/// Cancelled.
ReportFacts reportFacts(const ReportRequest& request, const Execution& execution);

}  // namespace rubble::io
