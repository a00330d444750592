#pragma once

#include <ostream>
#include <span>
#include <string>

#include "app/cli/frame/command.h"

namespace rubble::cli {

/// Performs a whole command line without the program's name. Nothing escapes: every error is written to err (and, with --json, as
/// an object to out) and becomes an exit code.
/// @param progress  show progress on err
ExitCode performCommandLine(std::span<const std::string> words, std::ostream& out, std::ostream& err, bool progress);

}  // namespace rubble::cli
