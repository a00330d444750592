#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubble::io {

/// What another program did.
struct ProgramOutcome {
    int exitCode = -1;  ///< -1 if a signal ended it
    std::string out;
    std::string err;
};

/// Runs a program of the path to its end, with nothing to read; nothing if there is no such program. Throws WorldError if it
/// cannot be started.
std::optional<ProgramOutcome> runProgram(const std::vector<std::string>& words);

/// Where a program lies that was installed beside the one that runs; its bare name if that is not known.
std::string programBeside(const std::string& name);

/// A text as one word of the shell: as it is where it is plain, else in quotes.
std::string shellWord(std::string_view text);
/// Words as one line of the shell.
std::string shellLine(const std::vector<std::string>& words);

}  // namespace rubble::io
