#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/session.h"
#include "app/cli/frame/subject.h"
#include "core/analysis/accuracy/study_tasks.h"
#include "core/base/finding.h"
#include "io/jobs/distributed_study.h"

namespace rubble::cli {

/// Where the worlds of a study are made, as given by --executor, --tasks, --sbatch, --detach and --world.
class StudyPlace {
public:
    static std::vector<Option> options();
    /// Throws UsageError for a value or a combination that is none.
    explicit StudyPlace(const Arguments& arguments);

    /// Others are to make the worlds.
    bool elsewhere() const { return m_executor != Executor::Local; }
    /// This is one of the others: it makes one world and reports nothing.
    bool single() const { return m_world.has_value(); }
    /// What this process simulates.
    WorldChoice choice() const;

    /// A study as haveMade() needs it.
    struct Study {
        std::vector<StudyTask> tasks;
        std::string store;                                    ///< its folder
        bool islands = false;                                 ///< worlds count only with what is kept of released islands
        std::function<bool(const WorldOrigin& origin)> kept;  ///< the store has it, sound and of this origin
        std::vector<std::string> files;                       ///< that were read: never written over
    };
    /// Has the worlds made that are missing: writes the list of them, or submits and follows. Returns what the command ends with if
    /// there is nothing to report yet. Throws UsageError, WorldError, Cancelled.
    std::optional<ExitCode> haveMade(Study study, Session& session) const;

    /// Ends the command that made a single world. Throws WorldError if the store does not have it.
    /// @param failure  why it was not made, if that is known
    ExitCode endSingle(const std::string& store, bool islands, const std::string& failure, const Findings& findings,
                       Session& session) const;

private:
    enum class Executor { Local, Commands, Slurm };

    io::DistributedStudy distributed(const Study& study) const;
    ExitCode writeList(const Study& study, const std::vector<io::JobTask>& missing, Session& session) const;
    std::optional<ExitCode> submit(const io::DistributedStudy& study, Session& session) const;

    const Arguments& m_arguments;
    Executor m_executor = Executor::Local;
    std::optional<Digest> m_world;
};

/// What following a study on the cluster came to: says which worlds failed.
void printFailedTasks(const io::JobProgress& progress, Session& session);

}  // namespace rubble::cli
