#include "io/jobs/slurm_words.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "io/base/trimmed.h"
#include "io/jobs/slurm.h"

namespace rubble::io {

namespace {

using Needles = std::vector<std::string_view>;

/// Whether the words hold one of these, whatever the case of the letters; blanks of the words are underscores there.
bool tell(std::string_view words, const Needles& needles) {
    std::string small(words);
    std::transform(small.begin(), small.end(), small.begin(), [](char c) {
        return c == ' ' ? '_' : c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    });
    return std::any_of(needles.begin(), needles.end(),
                       [&](std::string_view needle) { return small.find(needle) != std::string::npos; });
}

/// The last line is the reason; those before it lead there.
std::string lastLine(std::string_view words) {
    const std::string all(trimmed(words));
    return all.substr(all.rfind('\n') + 1);
}

/// Reasons that lie between this machine and the cluster.
std::vector<std::pair<Needles, SlurmReason>> reasonsOfTheWay(const std::string& said) {
    return {
        {{"configuration_source", "dns_srv", "resolve_ctls", "slurm.conf"},
         {{"io.slurm_unknown", "Slurm is installed here, but does not know its cluster.", {}},
          {"io.slurm_unknown.remedy",
           "Put the cluster's slurm.conf into /etc/slurm, or simulate on this machine. Slurm says: {0}",
           {said}}}},
        {{"unable_to_contact", "timed_out_on_send", "connection_refused", "connect_failure", "connection_timed_out",
          "waits_in_vain", "controller"},
         {{"io.slurm_unreachable", "The cluster's controller does not answer.", {}},
          {"io.slurm_unreachable.remedy", "Ask whoever runs the cluster, or simulate on this machine. Slurm says: {0}", {said}}}},
        {{"munge", "authentication", "invalid_user", "access/permission_denied"},
         {{"io.slurm_user", "The cluster does not accept this user or this machine.", {}},
          {"io.slurm_user.remedy",
           "See that munge runs here with the key of the cluster, and that it knows the user. Slurm says: {0}",
           {said}}}}};
}

/// Reasons that lie in what was asked of it.
std::vector<std::pair<Needles, SlurmReason>> reasonsOfTheRequest(const std::string& said) {
    return {{{"qos", "policy", "limit_reached", "maxsubmit", "maxarray"},
             {{"io.slurm_limits", "The cluster's limits do not let this user submit so much.", {}},
              {"io.slurm_limits.remedy",
               "Wait until other jobs have ended, or name another account or quality of service. Slurm says: {0}",
               {said}}}},
            {{"account"},
             {{"io.slurm_account", "The cluster does not take the account that the job is charged to.", {}},
              {"io.slurm_account.remedy",
               "Name one of yours among the options of sbatch (--account); sacctmgr lists them. Slurm says: {0}",
               {said}}}},
            {{"partition"},
             {{"io.slurm_partition", "The cluster has no such partition, or it takes no jobs now.", {}},
              {"io.slurm_partition.remedy",
               "Name another among the options of sbatch (--partition); sinfo lists them. Slurm says: {0}",
               {said}}}},
            {{"time_limit"},
             {{"io.slurm_time", "The cluster does not allow a world the time that it needs.", {}},
              {"io.slurm_time.remedy",
               "Name a partition for longer jobs among the options of sbatch (--partition). Slurm says: {0}",
               {said}}}},
            {{"node_configuration", "memory_specification", "cpu_count", "can_not_be_satisfied"},
             {{"io.slurm_nodes", "No machine of the cluster has the processors and the memory that a world asks for.", {}},
              {"io.slurm_nodes.remedy",
               "Use fewer threads, or name a partition with larger machines (--partition). Slurm says: {0}",
               {said}}}},
            {{"unrecognized_option", "invalid_option", "unrecognised_option", "requires_an_argument"},
             {{"io.slurm_option", "sbatch does not know one of the options that it was given.", {}},
              {"io.slurm_option.remedy", "Check the options of sbatch against its manual. Slurm says: {0}", {said}}}}};
}

}  // namespace

SlurmReason slurmReason(std::string_view words) {
    const std::string said = lastLine(words);
    for (const auto& reasons : {reasonsOfTheWay(said), reasonsOfTheRequest(said)}) {
        for (const auto& [needles, reason] : reasons) {
            if (tell(words, needles)) {
                return reason;
            }
        }
    }
    return {{"io.slurm", "The cluster did not take this, for a reason of its own.", {}},
            {"io.slurm.remedy",
             "Ask sinfo whether the cluster answers and has nodes for it, or ask whoever runs it. Slurm says: {0}",
             {said.empty() ? std::string("–") : said}}};
}

SlurmReason taskReason(const JobTask& task) {
    const std::string& said = task.failure;
    const auto is = [&](SlurmState state) { return said.starts_with(slurmStateName(state)); };
    if (is(SlurmState::Cancelled)) {
        return {{"jobs.world_cancelled", "A world was cancelled on the cluster.", {}},
                {"jobs.world_cancelled.remedy", "Start again: only what is missing is submitted. The cluster says: {0}", {said}}};
    }
    if (is(SlurmState::TimedOut)) {
        return {{"jobs.world_timed_out", "A world took longer than the cluster gave it.", {}},
                {"jobs.world_timed_out.remedy",
                 "Name a partition for longer jobs among the options of sbatch, or use more threads. The cluster says: {0}",
                 {said}}};
    }
    if (is(SlurmState::OutOfMemory)) {
        return {{"jobs.world_memory", "A world needed more memory than the cluster gave it.", {}},
                {"jobs.world_memory.remedy",
                 "Name a partition with larger machines among the options of sbatch. The cluster says: {0}",
                 {said}}};
    }
    if (is(SlurmState::Lost)) {
        return {{"jobs.world_lost", "A machine of the cluster failed while it made a world.", {}},
                {"jobs.world_lost.remedy", "Start again: only what is missing is submitted. The cluster says: {0}", {said}}};
    }
    return {{"jobs.world_failed", "A world ended with an error on the cluster.", {}},
            {"jobs.world_failed.remedy",
             "Mend what the error names, then start again: only what is missing is submitted. The cluster says: {0}",
             {said}}};
}

}  // namespace rubble::io
