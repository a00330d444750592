#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rubble::io {

/// What Slurm says of a task of an array.
enum class SlurmState : std::uint8_t { Waiting, Running, Completed, Cancelled, TimedOut, OutOfMemory, Failed, Lost };

/// An array of tasks for sbatch.
struct SlurmArray {
    std::string name;
    std::string script;  ///< file that sh reads; finds its number in SLURM_ARRAY_TASK_ID
    std::string folder;  ///< for what the tasks write to their terminals: JOB_NUMBER.log
    std::size_t first = 0;
    std::size_t count = 0;
    std::int64_t minutes = 0;
    std::int64_t mebibytes = 0;
    int cpus = 1;
    std::vector<std::string> options;  ///< of the user's, the last word
};

/// Slurm as its own programs offer it (slurm.schedmd.com): sbatch, squeue, scancel, scontrol. Each call runs one of them.
class Slurm {
public:
    /// Throws WorldError where Slurm is not installed.
    static void check();
    /// Throws WorldError where it is not installed or does not answer within seconds, as slurmReason() says.
    static void reach();
    /// Tasks that one array may have.
    static std::size_t arrayLimit();
    /// @return  the number of the job. Throws WorldError with the reason behind what sbatch said
    static std::string submit(const SlurmArray& array);
    /// What it knows of all tasks of the jobs of these names, "12_3"; unset if it does not answer.
    static std::optional<std::map<std::string, SlurmState>> states(const std::vector<std::string>& names);
    /// Throws WorldError with the reason behind what scancel said.
    static void cancel(const std::string& name);
};

/// "out of memory"
std::string slurmStateName(SlurmState state);

}  // namespace rubble::io
