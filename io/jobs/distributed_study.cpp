#include "io/jobs/distributed_study.h"

#include <filesystem>

#include "io/base/machine.h"
#include "io/jobs/program.h"

namespace rubble::io {

namespace fs = std::filesystem;

std::vector<JobTask> DistributedStudy::jobTasks() const {
    std::vector<JobTask> made;
    for (const StudyTask& task : distinctTasks(tasks)) {
        JobTask& next = made.emplace_back();
        next.key = task.origin.key.hex();
        next.name = task.name;
        next.bodies = task.bodies;
        next.command = command ? command(next.key) : std::string();
    }
    return made;
}

void DistributedStudy::setCommand(const std::string& program, const std::string& casePath) {
    std::vector<std::string> words{program, name};
    words.insert(words.end(), request.begin(), request.end());
    words.insert(words.end(), {"--threads", std::to_string(cpus), "--cache", store, "--world"});
    command = [words, casePath](const std::string& key) {
        std::vector<std::string> line = words;
        line.insert(line.end(), {key, "--", casePath});
        return shellLine(line);
    };
}

std::vector<JobTask> missingTasks(const DistributedStudy& study, const Execution& execution) {
    const std::vector<StudyTask> distinct = distinctTasks(study.tasks);
    std::vector<JobTask> all = study.jobTasks();
    std::vector<JobTask> missing;
    for (std::size_t i = 0; i < distinct.size(); ++i) {
        execution.check();
        if (!study.kept(distinct[i].origin)) {
            std::error_code ignored;
            // What lies there is of no use and must not count as made.
            if (study.islands) {
                fs::remove(fs::path(study.store) / "islands" / (all[i].key + ".json"), ignored);
            } else {
                fs::remove(fs::path(study.store) / "worlds" / (all[i].key + ".world"), ignored);
            }
            missing.push_back(std::move(all[i]));
        }
    }
    return missing;
}

std::string submitStudy(const DistributedStudy& study, std::size_t& submitted) {
    JobRecord record;
    record.study = study.name;
    record.subject = study.subject;
    record.islands = study.islands;
    record.cpus = study.cpus;
    record.sbatchOptions = study.sbatchOptions;
    record.request = study.request;
    record.tasks = study.jobTasks();
    const JobNeeds needs = expectedNeeds(study.tasks, study.cpus, StudyFiles(study.store), machineText());
    return SlurmJobs(study.store).submit(std::move(record), needs, submitted);
}

}  // namespace rubble::io
