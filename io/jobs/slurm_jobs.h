#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/analysis/accuracy/study_tasks.h"
#include "core/base/execution.h"
#include "io/jobs/job_record.h"
#include "io/jobs/slurm.h"
#include "io/run/study_files.h"

namespace rubble::io {

/// How far the worlds of a study are.
struct JobProgress {
    std::string id;
    std::size_t total = 0;
    std::size_t made = 0;  ///< in the store
    std::size_t running = 0;
    std::size_t waiting = 0;
    bool reachable = true;  ///< Slurm answers
    std::vector<JobTask> failed;

    std::size_t underWay() const { return running + waiting; }
};

/// What a task of a study may take. Twice the time or memory is asked for where that was too little.
struct JobNeeds {
    double seconds = 0.0;       ///< expected of the longest world
    double bytes = 0.0;         ///< expected of the largest
    std::size_t predicted = 0;  ///< tasks whose time was predicted; that of the others is a rule of thumb
};

/// What the worlds of a study may take at most. Time: the upper end of what predict() says from earlier points of the same scene
/// and from the calibration of this machine, else by rule of thumb from bodies and steps. Memory: that of this process, which has
/// read and clustered the same, and what each body takes.
/// @param threads  of each task
/// @param known  has points and calibration; @param machine  in words
JobNeeds expectedNeeds(const std::vector<StudyTask>& tasks, int threads, const StudyFiles& known, const std::string& machine);

/// Studies on Slurm: an array of one task a world, with a record beside the store. All that decides is in the record and the store,
/// so any number of programs may submit, follow and end; a lock lets one at a time decide what is submitted again. A task that
/// ended without its world is submitted again, up to three times; one that somebody cancelled is not.
class SlurmJobs {
public:
    explicit SlurmJobs(std::string store) : m_store(std::move(store)) {}

    /// Submits the worlds that are neither made nor under way, in this study or another one of the store.
    /// @param wanted  tasks with key, name, bodies and command; id, build and times are filled in
    /// @param submitted  set to how many were
    /// @return  the id. Throws WorldError without Slurm and where it does not take them
    std::string submit(JobRecord wanted, const JobNeeds& needs, std::size_t& submitted);
    /// Looks once, and submits again what was lost. Throws WorldError, ParseError for the record.
    JobProgress look(const std::string& id);
    /// Looks until nothing is under way. Throws Cancelled, and what look() throws; the tasks go on.
    /// @param looked  called after each look
    JobProgress follow(const std::string& id, const std::function<void(const JobProgress&)>& looked, const Execution& execution);
    /// Takes the tasks of a study from Slurm. Throws WorldError.
    void cancel(const std::string& id);
    /// Forgets studies of which nothing is under way. @return  their ids
    std::vector<std::string> clear();

private:
    using States = std::map<std::string, SlurmState>;

    std::optional<States> states() const;
    bool underWayElsewhere(const JobTask& task, const std::string& id, const States& states) const;
    void submitTasks(JobRecord& record, const std::vector<std::size_t>& which, const JobNeeds& least);
    /// What is to become of a task that ended without its world: true if it is submitted again.
    bool again(const std::string& id, JobTask& task, std::optional<SlurmState> state);
    std::string logPath(const std::string& id, const JobTask& task) const;
    std::string lastWords(const std::string& id, const JobTask& task) const;
    /// Its log says that memory was short: only with control groups does Slurm say so itself.
    bool toldOutOfMemory(const std::string& id, const JobTask& task) const;

    std::string m_store;
    std::map<std::string, std::chrono::steady_clock::time_point> m_ended;  ///< tasks whose world may still be on its way here
};

}  // namespace rubble::io
