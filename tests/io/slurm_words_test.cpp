#include "io/jobs/slurm_words.h"

#include <gtest/gtest.h>

#include <array>

namespace rubble::io {
namespace {

TEST(SlurmWords, WhatSlurmWritesBecomesASentenceAndStaysAtTheEndOfTheRemedy) {
    struct Said {
        const char* words;
        const char* id;
    };
    for (
        const auto& [words, id] : std::array<Said, 12>{{
            {"sinfo: error: slurm_load_partitions: Unable to contact slurm controller (connect failure)", "io.slurm_unreachable"},
            {"slurm_load_jobs error: Socket timed out on send/recv operation", "io.slurm_unreachable"},
            {"sinfo: error: resolve_ctls_from_dns_srv: res_nsearch error: Unknown host\nsinfo: fatal: Could not establish a "
             "configuration source",
             "io.slurm_unknown"},
            {"sbatch: error: If munged is up, restart with --num-threads=10\nsbatch: error: Munge encode failed: Failed to access "
             "\"/run/munge/munge.socket.2\"",
             "io.slurm_user"},
            {"sbatch: error: invalid partition specified: long\nsbatch: error: Batch job submission failed: Invalid partition name "
             "specified",
             "io.slurm_partition"},
            {"sbatch: error: Batch job submission failed: Invalid account or account/partition combination specified",
             "io.slurm_account"},
            {"sbatch: error: Batch job submission failed: Job violates accounting/QOS policy (job submit limit, user's size and/or "
             "time limits)",
             "io.slurm_limits"},
            {"sbatch: error: Batch job submission failed: Requested time limit is invalid (missing or exceeds some limit)",
             "io.slurm_time"},
            {"sbatch: error: Memory specification can not be satisfied\nsbatch: error: Batch job submission failed: Requested node "
             "configuration is not available",
             "io.slurm_nodes"},
            {"sbatch: unrecognized option '--particion=long'\nTry \"sbatch --help\" for more information", "io.slurm_option"},
            {"sbatch: error: something that nobody has seen", "io.slurm"},
            {"", "io.slurm"},
        }}) {
        const SlurmReason reason = slurmReason(words);
        EXPECT_EQ(reason.what.id, id) << words;
        const std::string what = englishText(reason.what);
        EXPECT_EQ(what.find("error:"), std::string::npos) << what;
        EXPECT_EQ(what.back(), '.');
        const std::string all = words;
        const std::string last = all.substr(all.rfind('\n') + 1);
        EXPECT_NE(englishText(reason.remedy).find(last.empty() ? "Slurm says: –" : "Slurm says: " + last), std::string::npos)
            << englishText(reason.remedy);
    }
}

TEST(SlurmWords, WhatBecameOfATaskIsASentenceToo) {
    JobTask task;
    for (const auto& [failure, id] :
         {std::pair<const char*, const char*>{"out of memory: slurmstepd: error: Detected 1 oom_kill event", "jobs.world_memory"},
          {"timed out", "jobs.world_timed_out"},
          {"cancelled", "jobs.world_cancelled"},
          {"lost with its node", "jobs.world_lost"},
          {"failed: rubble-cli: the disk is full", "jobs.world_failed"}}) {
        task.failure = failure;
        const SlurmReason reason = taskReason(task);
        EXPECT_EQ(reason.what.id, id);
        EXPECT_NE(englishText(reason.remedy).find(std::string("The cluster says: ") + failure), std::string::npos);
    }
}

}  // namespace
}  // namespace rubble::io
