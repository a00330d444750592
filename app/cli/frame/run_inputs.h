#pragma once

#include <optional>
#include <string>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/session.h"
#include "core/pipeline/pipeline.h"
#include "io/run/run_file.h"

namespace rubble::cli {

/// Path of the FE file that a run was made from: the path in the run file or, where that is gone or another file now, any file
/// with the right SHA-256 beside the run file.
/// @param given  a path from --fe, which must have the right SHA-256
/// Throws WorldError naming the file and the remedy, Cancelled.
std::string findFeOfRun(const std::string& runPath, const io::RunOrigin& origin, const std::optional<std::string>& given,
                        const Execution& execution);

/// FE result and terrain of the run that the operand names, opened with its settings; found as above, or where --fe and --terrain
/// say. What speaks against the place of the run is printed as notes.
Inputs openInputsOfRun(const io::RunOrigin& origin, const Arguments& arguments, Session& session);
/// The same for a run that is not the operand. @param site  gets that, and what reading the terrain found; null: as above
Inputs openInputsOfRun(const std::string& runPath, const io::RunOrigin& origin, const Arguments& arguments, Session& session,
                       Findings* site = nullptr);

}  // namespace rubble::cli
