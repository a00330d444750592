#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rubble::io {

/// A world of a study that another process makes into the store.
struct JobTask {
    std::string key;  ///< of the world, as in its name in the store
    std::string name;
    std::int64_t bodies = 0;
    std::string command;       ///< one line for sh
    std::string slurm;         ///< "12_3", of its latest submission; empty: none yet
    int attempts = 0;          ///< submissions since somebody asked for it
    std::int64_t minutes = 0;  ///< asked for in the latest submission
    std::int64_t mebibytes = 0;
    std::string failure;  ///< why it is not submitted again; empty: it may be
};

/// A study that was given to Slurm: kept beside the store as jobs/ID/record.json, so that whoever starts the same study again
/// follows the first.
struct JobRecord {
    std::string id;         ///< of the keys of all worlds of the study
    std::string study;      ///< "accuracy"
    std::string subject;    ///< the files it is of
    std::string build;      ///< buildText()
    std::string submitted;  ///< UTC, "2026-01-31T12:00:00Z"
    bool islands = false;   ///< worlds count only with what is kept of released islands
    int cpus = 1;           ///< of each task
    std::vector<std::string> sbatchOptions;
    std::vector<std::string> request;  ///< options of its command that say which worlds it has, in words
    std::vector<JobTask> tasks;
};

/// Names a study by its worlds: 12 hexadecimal digits, the same whatever the order.
std::string jobId(const std::vector<JobTask>& tasks);

/// Where records lie in a store.
std::string jobsFolder(const std::string& store);
/// Writes a record atomically. Throws WorldError.
void keepJob(const std::string& store, const JobRecord& record);
/// Throws WorldError if there is no such record, ParseError naming file and place if it is damaged or of a newer version.
JobRecord loadJob(const std::string& store, const std::string& id);
/// Names of all records, the newest first.
std::vector<std::string> jobIds(const std::string& store);

/// The newest record of a kind of study and of this build that `wanted` says yes to; unset if there is none. Damaged ones are
/// passed over.
std::optional<JobRecord> newestJob(const std::string& store, const std::string& study,
                                   const std::function<bool(const JobRecord&)>& wanted);

/// The world is in the store, whole.
bool isMade(const std::string& store, const JobRecord& record, const JobTask& task);
/// All worlds of the study are.
bool allMade(const std::string& store, const JobRecord& record);

}  // namespace rubble::io
