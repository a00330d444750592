#pragma once

#include <map>
#include <string>
#include <vector>

namespace rubble {

/// An option as a shell completes it.
struct CompletedOption {
    std::string name;  ///< "--set"
    bool takesValue = false;
    /// What its value can be; those that end in "=" or "[" go on. Empty: names of files.
    std::vector<std::string> values;
    /// What can follow "KEY=", by key; a key that is not here is followed by names of files.
    std::map<std::string, std::vector<std::string>> afterKey;
};

/// A command as a shell completes it; a program without commands is one command without a name.
struct CompletedCommand {
    std::string name;
    std::vector<CompletedOption> options;
    std::vector<std::string> operands;  ///< words that an operand can be; empty: names of files
};

/// Source text for bash that completes the command lines of a program. It needs no other file of completions.
/// @param options  that stand in place of a command
std::string bashCompletion(const std::string& program, const std::vector<CompletedCommand>& commands,
                           const std::vector<std::string>& options);

}  // namespace rubble
