#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/analysis/accuracy/study_tasks.h"
#include "core/base/execution.h"
#include "io/jobs/job_record.h"
#include "io/jobs/slurm_jobs.h"

namespace rubble::io {

/// A study whose worlds other processes make into its store.
struct DistributedStudy {
    std::string name;     ///< "accuracy"
    std::string subject;  ///< the files it is of
    std::string store;    ///< its folder, absolute
    std::vector<StudyTask> tasks;
    bool islands = false;                                        ///< worlds count only with what is kept of released islands
    std::function<bool(const WorldOrigin& origin)> kept;         ///< the store has it, sound and of this origin
    std::function<std::string(const std::string& key)> command;  ///< the line of sh that makes a world
    std::vector<std::string> request;                            ///< options of the command that say which worlds it has
    int cpus = 1;                                                ///< of each task
    std::vector<std::string> sbatchOptions;

    /// Worlds are made by a rubble-cli of this name with this case and the options of the request.
    void setCommand(const std::string& program, const std::string& casePath);
    /// Its worlds for others, each once.
    std::vector<JobTask> jobTasks() const;
};

/// What others are to make: worlds that the store lacks. What lies there under their names, damaged or of something else, is
/// removed, since it would be taken for them. Throws Cancelled.
std::vector<JobTask> missingTasks(const DistributedStudy& study, const Execution& execution);

/// Submits a study to Slurm. @param submitted  set to how many of its worlds were
/// @return  the id of its job. Throws what SlurmJobs::submit() throws.
std::string submitStudy(const DistributedStudy& study, std::size_t& submitted);

}  // namespace rubble::io
