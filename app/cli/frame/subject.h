#pragma once

#include <string>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/session.h"
#include "io/case/open_case.h"

namespace rubble::cli {

/// How a case or FE file is to be opened: --scenario, --set in the order given, --terrain, --mesh-offset and --cached.
/// Throws UsageError for a setting without "=" and an offset that is none.
io::CaseRequest caseRequest(const Arguments& arguments, const std::string& path);

/// Opens the operand of a command. Throws as caseRequest() and io::openCase().
io::OpenedCase openSubject(const Arguments& arguments, Session& session);

/// Runs the pipeline on a subject up to a stage, with the time of opening as the time of its first stage.
Results runTo(const io::OpenedCase& subject, Stage last, TrajectorySink* sink, const Execution& execution,
              CheckpointStore* checkpoints = nullptr);

}  // namespace rubble::cli
