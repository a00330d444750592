#include "io/jobs/slurm_jobs.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "core/analysis/accuracy/prediction.h"
#include "core/base/build.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/jobs/program.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr int attemptsMax = 3;
// What is expected is doubled, and no task asks for less than this.
constexpr double margin = 2.0;
constexpr std::int64_t minutesLeast = 10;
constexpr std::int64_t mebibytesLeast = 512;
// Of a pile of single fragments on one thread; a cluster takes less.
constexpr double secondsPerBodyStep = 14e-6;
constexpr double stepsPerSecond = 60.0;
constexpr double bytesPerBody = 16384.0;
/// A shared folder may show a new file to other machines after a while only.
constexpr std::chrono::seconds shownAfter{20};
constexpr std::chrono::milliseconds lookFirst{500};
constexpr std::chrono::milliseconds lookLast{10000};

/// One program at a time decides what is submitted.
class StoreLock {
public:
    explicit StoreLock(const std::string& store) {
        const fs::path path = fs::path(jobsFolder(store)) / "lock";
        std::error_code ignored;
        fs::create_directories(path.parent_path(), ignored);
        m_file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (m_file < 0 || ::flock(m_file, LOCK_EX) != 0) {
            throw WorldError({"io.jobs.lock", "{0} cannot be written.", {path.string()}},
                             {"io.jobs.lock.remedy", "Check the rights of the folder and whether its disk is full.", {}});
        }
    }
    ~StoreLock() {
        if (m_file >= 0) {
            ::close(m_file);
        }
    }
    StoreLock(const StoreLock&) = delete;
    StoreLock& operator=(const StoreLock&) = delete;

private:
    int m_file = -1;
};

std::string jobName(const std::string& id) {
    return "rubble-" + id;
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    std::tm utc{};
    ::gmtime_r(&time, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text.data();
}

bool underWay(SlurmState state) {
    return state == SlurmState::Waiting || state == SlurmState::Running;
}

std::optional<SlurmState> stateOf(const std::map<std::string, SlurmState>& states, const JobTask& task) {
    const auto found = states.find(task.slurm);
    return task.slurm.empty() || found == states.end() ? std::nullopt : std::optional(found->second);
}

/// sh reads the line of its task and runs it.
std::string scriptText(const std::string& listPath) {
    return "#!/bin/sh\nexec sh -c \"$(sed -n \"$((SLURM_ARRAY_TASK_ID + RUBBLE_FIRST_TASK + 1))p\" " + shellWord(listPath) +
           ")\"\n";
}

/// The longest that a world is predicted to take, s; unset if nothing can be said. What is known of more threads bounds what one
/// with fewer takes.
std::optional<double> predictedSeconds(const StudyTask& task, int threads, const std::string& machine,
                                       const std::vector<KnownPoint>& points, const std::optional<Calibration>& calibration) {
    std::set<int> measured{threads};
    for (const KnownPoint& point : points) {
        measured.insert(std::max(threads, point.threads));
    }
    if (calibration) {
        measured.insert(std::max(threads, calibration->threads));
    }
    for (const int with : measured) {
        const Prediction prediction =
            predict(Predicted::WallSeconds, openPoint(task, machine, with), points, calibration ? &*calibration : nullptr);
        if (prediction.known) {
            return prediction.high * with / threads;
        }
    }
    return {};
}

}  // namespace

JobNeeds expectedNeeds(const std::vector<StudyTask>& tasks, int threads, const StudyFiles& known, const std::string& machine) {
    Findings ignored;
    const std::optional<Calibration> calibration = known.calibration(machine, ignored);
    std::map<Digest, std::vector<KnownPoint>> points;
    JobNeeds needs;
    std::int64_t bodies = 0;
    for (const StudyTask& task : tasks) {
        const Digest scene = sceneDigest(task.reference, DebrisInstant::AtRest);
        const auto [earlier, first] = points.try_emplace(scene);
        if (first) {
            earlier->second = known.points(scene, ignored);
        }
        const std::optional<double> predicted = predictedSeconds(task, threads, machine, earlier->second, calibration);
        const double byRule = secondsPerBodyStep * stepsPerSecond * task.collapse * static_cast<double>(task.bodies) / threads;
        needs.seconds = std::max(needs.seconds, predicted.value_or(byRule));
        needs.predicted += predicted.has_value();
        bodies = std::max(bodies, task.bodies);
    }
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    needs.bytes = 1024.0 * static_cast<double>(usage.ru_maxrss) + bytesPerBody * static_cast<double>(bodies);
    return needs;
}

std::optional<SlurmJobs::States> SlurmJobs::states() const {
    std::vector<std::string> names;
    for (const std::string& id : jobIds(m_store)) {
        names.push_back(jobName(id));
    }
    return names.empty() ? States() : Slurm::states(names);
}

bool SlurmJobs::underWayElsewhere(const JobTask& task, const std::string& id, const States& states) const {
    for (const std::string& other : jobIds(m_store)) {
        if (other == id) {
            continue;
        }
        try {
            const JobRecord record = loadJob(m_store, other);
            for (const JobTask& theirs : record.tasks) {
                const auto state = stateOf(states, theirs);
                if (theirs.key == task.key && state && underWay(*state)) {
                    return true;
                }
            }
        } catch (const Error&) {
            // A record that cannot be read has nothing that could be waited for.
        }
    }
    return false;
}

void SlurmJobs::submitTasks(JobRecord& record, const std::vector<std::size_t>& which, const JobNeeds& least) {
    const fs::path folder = fs::path(jobsFolder(m_store)) / record.id;
    SlurmArray array;
    array.name = jobName(record.id);
    array.folder = folder.string();
    array.cpus = record.cpus;
    array.options = record.sbatchOptions;
    array.minutes = std::max(minutesLeast, static_cast<std::int64_t>(std::ceil(margin * least.seconds / 60.0)));
    array.mebibytes = std::max(mebibytesLeast, static_cast<std::int64_t>(std::ceil(margin * least.bytes / 1048576.0)));
    std::size_t submission = 1;
    while (fs::exists(folder / ("tasks-" + std::to_string(submission)))) {
        ++submission;
    }
    const std::string list = (folder / ("tasks-" + std::to_string(submission))).string();
    array.script = (folder / ("array-" + std::to_string(submission) + ".sh")).string();
    for (const std::size_t i : which) {
        array.minutes = std::max(array.minutes, record.tasks[i].minutes);
        array.mebibytes = std::max(array.mebibytes, record.tasks[i].mebibytes);
    }
    writeAtomically(list, [&](std::ostream& out) {
        for (const std::size_t i : which) {
            out << record.tasks[i].command << '\n';
        }
    });
    writeAtomically(array.script, [&](std::ostream& out) { out << scriptText(list); });
    const std::size_t limit = Slurm::arrayLimit();
    for (array.first = 0; array.first < which.size(); array.first += limit) {
        array.count = std::min(limit, which.size() - array.first);
        const std::string job = Slurm::submit(array);
        for (std::size_t n = 0; n < array.count; ++n) {
            JobTask& task = record.tasks[which[array.first + n]];
            task.slurm = job + "_" + std::to_string(n);
            task.minutes = array.minutes;
            task.mebibytes = array.mebibytes;
            task.failure.clear();
            ++task.attempts;
        }
        // At once: what Slurm has must be known, whatever becomes of this program.
        keepJob(m_store, record);
    }
}

std::string SlurmJobs::submit(JobRecord wanted, const JobNeeds& needs, std::size_t& submitted) {
    Slurm::check();
    const StoreLock lock(m_store);
    wanted.id = jobId(wanted.tasks);
    wanted.build = std::string(buildText());
    wanted.submitted = now();
    try {
        const JobRecord first = loadJob(m_store, wanted.id);
        wanted.submitted = first.submitted;
        for (JobTask& task : wanted.tasks) {
            const auto known =
                std::find_if(first.tasks.begin(), first.tasks.end(), [&](const JobTask& other) { return other.key == task.key; });
            if (known != first.tasks.end()) {
                task.slurm = known->slurm;
                task.minutes = known->minutes;
                task.mebibytes = known->mebibytes;
            }
        }
    } catch (const Error&) {
        // There is no earlier record, or none that says anything.
    }
    keepJob(m_store, wanted);
    const std::optional<States> known = states();
    if (!known) {
        throw WorldError({"io.slurm_silent", "Slurm does not answer.", {}},
                         {"io.slurm_silent.remedy", "Ask sinfo whether the cluster is up, and start the same command again.", {}});
    }
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < wanted.tasks.size(); ++i) {
        const JobTask& task = wanted.tasks[i];
        const auto state = stateOf(*known, task);
        if (!isMade(m_store, wanted, task) && !(state && underWay(*state)) && !underWayElsewhere(task, wanted.id, *known)) {
            open.push_back(i);
        }
    }
    submitted = open.size();
    if (!open.empty()) {
        submitTasks(wanted, open, needs);
    }
    return wanted.id;
}

std::string SlurmJobs::logPath(const std::string& id, const JobTask& task) const {
    return (fs::path(jobsFolder(m_store)) / id / (task.slurm + ".log")).string();
}

bool SlurmJobs::toldOutOfMemory(const std::string& id, const JobTask& task) const {
    std::ifstream stream(logPath(id, task));
    for (std::string line; std::getline(stream, line);) {
        // In the words of the kernel, of Slurm and of the program itself.
        const auto has = [&line](std::string_view word) { return line.find(word) != std::string::npos; };
        if (has("oom_kill") || has("oom-kill") || (has("memory") && (has("xceeded") || has("enough")))) {
            return true;
        }
    }
    return false;
}

std::string SlurmJobs::lastWords(const std::string& id, const JobTask& task) const {
    std::ifstream stream(logPath(id, task));
    std::string last;
    for (std::string line; std::getline(stream, line);) {
        if (line.find_first_not_of(' ') != std::string::npos) {
            last = line.substr(line.find_first_not_of(' '));
        }
    }
    return last;
}

bool SlurmJobs::again(const std::string& id, JobTask& task, std::optional<SlurmState> state) {
    if (state == SlurmState::Completed) {
        const auto [seen, first] = m_ended.try_emplace(task.slurm, std::chrono::steady_clock::now());
        if (first || std::chrono::steady_clock::now() - seen->second < shownAfter) {
            return false;
        }
    }
    if (state == SlurmState::Failed && toldOutOfMemory(id, task)) {
        state = SlurmState::OutOfMemory;
    }
    if (state == SlurmState::Cancelled || task.attempts >= attemptsMax) {
        const std::string words = lastWords(id, task);
        task.failure = slurmStateName(state.value_or(SlurmState::Lost)) + (words.empty() ? "" : ": " + words);
        return false;
    }
    task.minutes *= state == SlurmState::TimedOut ? 2 : 1;
    task.mebibytes *= state == SlurmState::OutOfMemory ? 2 : 1;
    return true;
}

JobProgress SlurmJobs::look(const std::string& id) {
    const StoreLock lock(m_store);
    JobRecord record = loadJob(m_store, id);
    JobProgress progress;
    progress.id = id;
    progress.total = record.tasks.size();
    const std::optional<States> known = states();
    progress.reachable = known.has_value();
    std::vector<std::size_t> lost;
    std::size_t givenUp = 0;
    for (std::size_t i = 0; i < record.tasks.size(); ++i) {
        JobTask& task = record.tasks[i];
        const bool failedBefore = !task.failure.empty();
        const auto state = known ? stateOf(*known, task) : SlurmState::Waiting;
        if (isMade(m_store, record, task)) {
            ++progress.made;
        } else if (state == SlurmState::Running) {
            ++progress.running;
        } else if (state == SlurmState::Waiting || underWayElsewhere(task, id, *known)) {
            ++progress.waiting;
        } else if (task.failure.empty() && again(id, task, state)) {
            lost.push_back(i);
        } else if (task.failure.empty()) {
            ++progress.waiting;  // for its file to show
        } else if (!failedBefore) {
            ++givenUp;
        }
    }
    if (!lost.empty()) {
        try {
            submitTasks(record, lost, {});
        } catch (const WorldError&) {
            progress.reachable = false;
        }
        progress.waiting += lost.size();
    }
    if (givenUp > 0) {
        keepJob(m_store, record);
    }
    std::copy_if(record.tasks.begin(), record.tasks.end(), std::back_inserter(progress.failed),
                 [&](const JobTask& task) { return !task.failure.empty() && !isMade(m_store, record, task); });
    return progress;
}

JobProgress SlurmJobs::follow(const std::string& id, const std::function<void(const JobProgress&)>& looked,
                              const Execution& execution) {
    std::chrono::milliseconds pause = lookFirst;
    for (;;) {
        JobProgress progress = look(id);
        const double share = static_cast<double>(progress.made) / static_cast<double>(std::max<std::size_t>(1, progress.total));
        execution.report(progress.reachable
                             ? Message{"jobs.following",
                                       "{0} of {1} worlds are made on the cluster; {2} run, {3} wait, {4} failed",
                                       {progress.made, progress.total, progress.running, progress.waiting, progress.failed.size()}}
                             : Message{"jobs.silent",
                                       "{0} of {1} worlds are made; the cluster does not answer",
                                       {progress.made, progress.total}},
                         share);
        if (looked) {
            looked(progress);
        }
        if (progress.underWay() == 0) {
            return progress;
        }
        const auto until = std::chrono::steady_clock::now() + pause;
        while (std::chrono::steady_clock::now() < until) {
            execution.check();
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        pause = std::min(lookLast, pause * 3 / 2);
    }
}

void SlurmJobs::cancel(const std::string& id) {
    const StoreLock lock(m_store);
    JobRecord record = loadJob(m_store, id);
    Slurm::cancel(jobName(id));
    for (JobTask& task : record.tasks) {
        if (!isMade(m_store, record, task)) {
            task.failure = slurmStateName(SlurmState::Cancelled);
        }
    }
    keepJob(m_store, record);
}

std::vector<std::string> SlurmJobs::clear() {
    const StoreLock lock(m_store);
    const std::optional<States> known = states();
    std::vector<std::string> cleared;
    for (const std::string& id : jobIds(m_store)) {
        bool busy = !known;
        try {
            for (const JobTask& task : loadJob(m_store, id).tasks) {
                const auto state = known ? stateOf(*known, task) : std::nullopt;
                busy = busy || (state && underWay(*state));
            }
        } catch (const ParseError&) {
            // Nothing can be learned from it.
        }
        std::error_code failed;
        if (!busy && fs::remove_all(fs::path(jobsFolder(m_store)) / id, failed) > 0 && !failed) {
            cleared.push_back(id);
        }
    }
    return cleared;
}

}  // namespace rubble::io
