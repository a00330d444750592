#include "io/jobs/slurm.h"

#include <array>
#include <charconv>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "io/base/trimmed.h"
#include "io/jobs/program.h"
#include "io/jobs/slurm_words.h"

namespace rubble::io {

namespace {

// What a cluster that says nothing of it allows.
constexpr std::size_t arrayLimitUsual = 1001;
constexpr const char* secondsToAnswer = "8";

ProgramOutcome outcomeOf(const std::vector<std::string>& words) {
    std::optional<ProgramOutcome> outcome = runProgram(words);
    if (!outcome) {
        throw WorldError({"io.no_slurm", "Slurm is not installed here: there is no program {0}.", {words.front()}},
                         {"io.no_slurm.remedy",
                          "Install Slurm's client programs (Debian: slurm-client) and its slurm.conf, or compute elsewhere "
                          "(--executor commands).",
                          {}});
    }
    return std::move(*outcome);
}

[[noreturn]] void refused(const ProgramOutcome& outcome) {
    const SlurmReason reason = slurmReason(outcome.err);
    throw WorldError(reason.what, reason.remedy);
}

/// States in the words of squeue. Those that come and go count as waiting or running.
SlurmState stateFrom(std::string_view word) {
    static constexpr std::array<std::pair<std::string_view, SlurmState>, 13> ended{{
        {"COMPLETED", SlurmState::Completed},
        {"CANCELLED", SlurmState::Cancelled},
        {"TIMEOUT", SlurmState::TimedOut},
        {"DEADLINE", SlurmState::TimedOut},
        {"OUT_OF_MEMORY", SlurmState::OutOfMemory},
        {"FAILED", SlurmState::Failed},
        {"NODE_FAIL", SlurmState::Lost},
        {"BOOT_FAIL", SlurmState::Lost},
        {"PREEMPTED", SlurmState::Lost},
        {"REVOKED", SlurmState::Lost},
        {"RUNNING", SlurmState::Running},
        {"COMPLETING", SlurmState::Running},
        {"SUSPENDED", SlurmState::Running},
    }};
    for (const auto& [name, state] : ended) {
        if (word == name) {
            return state;
        }
    }
    return SlurmState::Waiting;
}

}  // namespace

void Slurm::check() {
    outcomeOf({"sbatch", "--version"});
}

void Slurm::reach() {
    check();
    // A controller that is away is waited for up to minutes.
    const ProgramOutcome outcome = outcomeOf({"timeout", secondsToAnswer, "sinfo", "--noheader", "--format=%D"});
    if (outcome.exitCode != 0) {
        const SlurmReason reason = slurmReason(trimmed(outcome.err).empty() ? "sinfo waits in vain" : outcome.err);
        throw WorldError(reason.what, reason.remedy);
    }
}

std::size_t Slurm::arrayLimit() {
    std::istringstream lines(outcomeOf({"scontrol", "show", "config"}).out);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = line.find("= ");
        std::size_t limit = 0;
        if (line.starts_with("MaxArraySize") && equals != std::string::npos &&
            std::from_chars(line.data() + equals + 2, line.data() + line.size(), limit).ec == std::errc{} && limit > 1) {
            return limit;
        }
    }
    return arrayLimitUsual;
}

std::string Slurm::submit(const SlurmArray& array) {
    std::vector<std::string> words{"sbatch",
                                   "--parsable",
                                   "--requeue",
                                   "--open-mode=append",
                                   "--job-name=" + array.name,
                                   "--array=0-" + std::to_string(array.count - 1),
                                   "--ntasks=1",
                                   "--cpus-per-task=" + std::to_string(array.cpus),
                                   "--time=" + std::to_string(array.minutes),
                                   "--mem=" + std::to_string(array.mebibytes) + "M",
                                   "--export=ALL,RUBBLE_FIRST_TASK=" + std::to_string(array.first),
                                   "--chdir=" + array.folder,
                                   "--output=" + array.folder + "/%A_%a.log"};
    words.insert(words.end(), array.options.begin(), array.options.end());
    words.push_back(array.script);
    const ProgramOutcome outcome = outcomeOf(words);
    // "12" or "12;cluster"
    const std::string job = outcome.out.substr(0, outcome.out.find_first_of(";\n"));
    if (outcome.exitCode != 0 || job.empty() || job.find_first_not_of("0123456789") != std::string::npos) {
        refused(outcome);
    }
    return job;
}

std::optional<std::map<std::string, SlurmState>> Slurm::states(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) {
        list += (list.empty() ? "" : ",") + name;
    }
    const ProgramOutcome outcome =
        outcomeOf({"squeue", "--noheader", "--array", "--states=all", "--name=" + list, "--format=%i %T"});
    if (outcome.exitCode != 0) {
        return {};
    }
    std::map<std::string, SlurmState> states;
    std::istringstream lines(outcome.out);
    for (std::string task, word; lines >> task >> word;) {
        states[task] = stateFrom(word);
    }
    return states;
}

void Slurm::cancel(const std::string& name) {
    const ProgramOutcome outcome = outcomeOf({"scancel", "--name=" + name});
    if (outcome.exitCode != 0) {
        refused(outcome);
    }
}

std::string slurmStateName(SlurmState state) {
    static constexpr std::array<std::string_view, 8> names{"waiting",   "running",       "completed", "cancelled",
                                                           "timed out", "out of memory", "failed",    "lost with its node"};
    return std::string(names[static_cast<std::size_t>(state)]);
}

}  // namespace rubble::io
