#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/session.h"
#include "core/base/finding.h"
#include "core/pipeline/pipeline.h"
#include "core/scenario/case.h"
#include "io/run_file.h"
#include "io/terrain_reader.h"

namespace rubble::cli {

/// What a command works on: an FE file, or one scenario of a case with its FE file.
struct Subject {
    Inputs inputs;
    Scenario scenario;
    std::string casePath;            ///< empty: the FE file alone
    std::string fePath;              ///< absolute
    io::TerrainInput terrain;        ///< as read; its grid is that of `inputs`, null without one
    Site site;                       ///< how it was brought to the local frame
    std::string scenarioName;        ///< "As computed" for a plain FE file
    std::vector<std::string> files;  ///< everything that was read: never written over
    double openSeconds = 0.0;        ///< wall time of opening the FE file
    Findings findings;               ///< of opening: an input that changed since the case was saved
};

/// Opens the operand of a command, recognised by content, and applies --scenario and --set in the order given. The terrain is that
/// of --terrain, else that of the case.
/// Throws UsageError, WorldError, ParseError, Cancelled.
Subject openSubject(const Arguments& arguments, Session& session);

/// Runs the pipeline on a subject up to a stage, with the time of opening as the time of its first stage.
Results runTo(const Subject& subject, Stage last, TrajectorySink* sink, const Execution& execution,
              CheckpointStore* checkpoints = nullptr);

/// What the run file of a subject says of where it came from.
io::RunOrigin originOf(const Subject& subject);

/// Findings of the file, the subject and every stage that ran, in the order data flows; one row for each kind.
Findings allFindings(const Subject& subject, const Results& results);

}  // namespace rubble::cli
