#pragma once

#include <string>
#include <vector>

#include "core/pipeline/run_entry.h"

namespace rubble::io {

/// Where the history of a case is kept: CASE.rubble.runs.json beside it. The case itself does not change when it is run.
std::string runHistoryPath(const std::string& casePath);

/// All runs of a history file in the order in which they ended, a run that has only begun as one that was interrupted; empty if
/// there is none. Throws WorldError, ParseError naming file and place.
std::vector<RunEntry> readRunHistory(const std::string& file);

/// Writes it atomically. Throws WorldError; the old file is then unchanged.
void writeRunHistory(const std::string& file, const std::vector<RunEntry>& runs);

/// Brings grade and acknowledgement of a run up to what lies beside its file. It is opened only where that can have changed; one
/// that cannot be read stays as it was.
void takeVerdict(RunEntry& run);

}  // namespace rubble::io
