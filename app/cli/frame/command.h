#pragma once

#include <string_view>
#include <vector>

namespace rubble::cli {

class Arguments;
class Session;

/// How the program ends; documented in the manual.
enum class ExitCode { Ok = 0, Failed = 1, Usage = 2, Cancelled = 3 };

/// One option of a command.
struct Option {
    std::string_view name;   ///< "--set"
    std::string_view value;  ///< what follows it, "KEY=VALUE"; empty for a switch
    bool repeated = false;   ///< may be given more than once
    std::string_view help;
};

/// One row of the command table: parser, help text and manual test all read it.
struct Command {
    std::string_view name;     ///< "inspect"
    std::string_view operand;  ///< "FE|CASE", "FE|CASE OUT" for two; empty if the command takes none
    std::string_view summary;  ///< one line
    std::string_view details;  ///< a few sentences for the command's own help
    std::vector<Option> options;
    ExitCode (*perform)(const Arguments& arguments, Session& session);
};

}  // namespace rubble::cli
