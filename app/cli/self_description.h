#pragma once

#include <string>

#include "app/cli/frame/command.h"

namespace rubble::cli {

// What the program says of itself to others; all of it comes from the command table, so that nothing of it can be out of date.

/// The program, a command and its operand: "rubble-cli run FE|CASE".
std::string usageOf(const Command& command);

/// Page for man(1) with every command and option.
std::string manPageText();
/// Completion for bash: commands, options, parameters with their choices, kinds of exports, else files.
std::string completionText();

}  // namespace rubble::cli
