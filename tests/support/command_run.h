#pragma once

#include <sys/types.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/places.h"

namespace rubble::cli {

/// What a program did.
struct Outcome {
    int exitCode = -1;  ///< -1 if a signal ended it
    int signal = 0;     ///< the signal, or 0
    std::string out;
    std::string err;

    /// The one JSON object on stdout. Throws if stdout holds anything else.
    nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// Runs programs as a user does: own process, own folder, own environment.
class CommandRun {
public:
    CommandRun& in(std::string folder);
    /// Sets a variable of the environment, or takes it away.
    CommandRun& with(const std::string& variable, std::optional<std::string> value);
    /// Files larger than this cannot be written, as on a full disk.
    CommandRun& fileSizeLimit(std::size_t bytes);
    /// Standard error is a terminal.
    CommandRun& errorsToTerminal();
    /// Called again and again while the program runs, with its process id.
    CommandRun& meanwhile(std::function<void(pid_t)> act);

    /// Runs a program found by path or PATH.
    Outcome run(const std::vector<std::string>& words);
    /// Runs the shipped rubble-cli.
    Outcome cli(std::vector<std::string> words);

private:
    void prepareChild(int outDescriptor, int errDescriptor) const;

    std::string m_folder;
    std::map<std::string, std::optional<std::string>> m_environment;
    std::size_t m_fileSizeLimit = 0;
    bool m_terminal = false;
    std::function<void(pid_t)> m_meanwhile;
};

/// The shipped rubble-cli with these words.
Outcome cli(std::vector<std::string> words);

/// Whether a process has come so far that it answers a signal itself, as programs do a while after their start.
bool catches(pid_t process, int signal);

/// Path of the shipped rubble-cli.
std::string cliPath();
/// The whole content of a file. Throws if it cannot be read.
std::string textOf(const std::string& path);

}  // namespace rubble::cli
