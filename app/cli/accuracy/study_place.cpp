#include "app/cli/accuracy/study_place.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/cli/accuracy/ensemble_request.h"
#include "app/cli/accuracy/study_options.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_table.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/jobs/program.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

/// Options that decide no world: where worlds are made, what is timed, and what is written.
constexpr std::array<std::string_view, 18> decidingNone{
    "--executor", "--tasks", "--sbatch", "--detach",  "--world",  "--cache",  "--jobs",      "--csv",   "--json",
    "--errors",   "--out",   "--check",  "--predict", "--retime", "--no-fps", "--no-timing", "--blind", "--threads"};

/// The options of a command that say which worlds its study has.
std::vector<std::string> decidingWords(const Arguments& arguments) {
    std::vector<std::string> words;
    for (const Option& option : arguments.command().options) {
        if (std::find(decidingNone.begin(), decidingNone.end(), option.name) != decidingNone.end() || !arguments.has(option.name)) {
            continue;
        }
        for (const std::string& value : arguments.values(option.name)) {
            words.emplace_back(option.name);
            if (!option.value.empty()) {
                words.push_back(value);
            }
        }
    }
    return words;
}

/// The line of the shell that makes one world of a study: this command again, for that world alone.
std::string commandOf(const Arguments& arguments, const std::string& store, const std::string& key) {
    std::vector<std::string> words{io::programBeside("rubble-cli"), std::string(arguments.command().name)};
    const std::vector<std::string> deciding = decidingWords(arguments);
    words.insert(words.end(), deciding.begin(), deciding.end());
    words.insert(words.end(), {"--threads", arguments.value("--threads").value_or("1"), "--cache", store, "--world", key, "--"});
    for (const std::string& operand : operandsOf(arguments)) {
        words.push_back(operand);
    }
    return "cd " + io::shellWord(fs::current_path().string()) + " && " + io::shellLine(words);
}

}  // namespace

std::vector<Option> StudyPlace::options() {
    return {{"--executor", "local|slurm|commands", false,
             "who simulates: this program (default), a Slurm cluster, or whoever runs the list of --tasks"},
            {"--tasks", "FILE", false, "with --executor commands: where to write one command line for each world that is missing"},
            {"--sbatch", "OPTION", true, "with --executor slurm: one more option of sbatch, as --sbatch=--partition=long"},
            {"--detach", "", false, "with --executor slurm: submit and end; the same command follows"},
            {"--world", "KEY", false, "make this world alone into the cache, as the lines of --tasks do"}};
}

StudyPlace::StudyPlace(const Arguments& arguments) : m_arguments(arguments) {
    const std::string executor = arguments.value("--executor").value_or("local");
    if (executor != "local" && executor != "slurm" && executor != "commands") {
        throw wrongValue("--executor", executor, "local, slurm or commands");
    }
    m_executor = executor == "slurm" ? Executor::Slurm : executor == "commands" ? Executor::Commands : Executor::Local;
    const auto needs = [&](std::string_view option, bool given, std::string_view of) {
        if (given) {
            throw UsageError({"cli.executor_option", "{0} belongs to --executor {1}.", {option, of}},
                             {"cli.executor_option.remedy", "Leave it out, or add --executor {0}.", {of}});
        }
    };
    needs("--tasks", arguments.has("--tasks") && m_executor != Executor::Commands, "commands");
    needs("--sbatch", arguments.has("--sbatch") && m_executor != Executor::Slurm, "slurm");
    needs("--detach", arguments.has("--detach") && m_executor != Executor::Slurm, "slurm");
    needs("--world", arguments.has("--world") && m_executor != Executor::Local, "local");
    if (m_executor == Executor::Commands && !arguments.has("--tasks")) {
        throw UsageError({"cli.no_task_list", "--executor commands needs a file for the list.", {}},
                         {"cli.no_task_list.remedy", "Add --tasks FILE.", {}});
    }
    if (const auto world = arguments.value("--world")) {
        m_world = digestFromHex(*world);
        if (!m_world) {
            throw wrongValue("--world", *world, "the key of a world, 32 lower-case hexadecimal digits");
        }
    }
}

WorldChoice StudyPlace::choice() const {
    return m_world ? WorldChoice::only(*m_world) : elsewhere() ? WorldChoice::none() : WorldChoice();
}

io::DistributedStudy StudyPlace::distributed(const Study& study) const {
    io::DistributedStudy made;
    made.name = std::string(m_arguments.command().name);
    for (const std::string& operand : operandsOf(m_arguments)) {
        made.subject += (made.subject.empty() ? "" : ", ") + fs::absolute(operand).lexically_normal().string();
    }
    made.store = fs::absolute(study.store).lexically_normal().string();
    made.tasks = study.tasks;
    made.islands = study.islands;
    made.kept = study.kept;
    made.command = [this, store = made.store](const std::string& key) { return commandOf(m_arguments, store, key); };
    made.request = decidingWords(m_arguments);
    made.cpus = parseCount(m_arguments, "--threads", 1, 1024, 1);
    made.sbatchOptions = m_arguments.values("--sbatch");
    return made;
}

std::optional<ExitCode> StudyPlace::haveMade(Study study, Session& session) const {
    study.tasks = distinctTasks(std::move(study.tasks));
    const io::DistributedStudy distributed = this->distributed(study);
    const std::vector<io::JobTask> missing = io::missingTasks(distributed, session.execution());
    if (missing.empty()) {
        return {};
    }
    return m_executor == Executor::Commands ? writeList(study, missing, session) : submit(distributed, session);
}

ExitCode StudyPlace::writeList(const Study& study, const std::vector<io::JobTask>& missing, Session& session) const {
    const std::string path = *m_arguments.value("--tasks");
    checkOutputPath(path, study.files);
    io::writeAtomically(path, [&](std::ostream& out) {
        for (const io::JobTask& task : missing) {
            out << task.command << '\n';
        }
    });
    if (m_arguments.json()) {
        printJson(session, {{"executor", "commands"},
                            {"tasks", path},
                            {"worlds", study.tasks.size()},
                            {"kept", study.tasks.size() - missing.size()},
                            {"complete", false}});
        return ExitCode::Ok;
    }
    session.out() << path << ": " << englishInteger(static_cast<std::int64_t>(missing.size())) << " of "
                  << englishInteger(static_cast<std::int64_t>(study.tasks.size()))
                  << " worlds are to be made, one command line each\n"
                  << "  Run them all, as with parallel <" << io::shellWord(path)
                  << ", and start this command again: it collects.\n";
    return ExitCode::Ok;
}

std::optional<ExitCode> StudyPlace::submit(const io::DistributedStudy& study, Session& session) const {
    std::size_t submitted = 0;
    const std::string id = io::submitStudy(study, submitted);
    io::SlurmJobs jobs(study.store);
    session.err() << "job " << id << ": "
                  << (submitted == 0 ? std::string("was submitted before")
                                     : englishInteger(static_cast<std::int64_t>(submitted)) + " of " +
                                           englishInteger(static_cast<std::int64_t>(study.tasks.size())) + " worlds submitted")
                  << (m_arguments.has("--detach") ? "" : "; following it (Ctrl-C leaves it running)") << '\n';
    if (m_arguments.has("--detach")) {
        if (m_arguments.json()) {
            printJson(session, {{"executor", "slurm"},
                                {"job", id},
                                {"worlds", study.tasks.size()},
                                {"submitted", submitted},
                                {"complete", false}});
        }
        return ExitCode::Ok;
    }
    try {
        printFailedTasks(jobs.follow(id, {}, session.execution()), session);
    } catch (const Cancelled&) {
        session.err() << "rubble-cli: no longer following; the job goes on: rubble-cli jobs follow " << id << '\n';
        throw;
    }
    return {};
}

ExitCode StudyPlace::endSingle(const std::string& store, bool islands, const std::string& failure, const Findings& findings,
                               Session& session) const {
    session.execution().check();
    io::JobRecord record;
    record.islands = islands;
    io::JobTask task;
    task.key = m_world->hex();
    if (!io::isMade(store, record, task)) {
        std::string why = failure;
        for (const Finding& finding : findings.list()) {
            if (why.empty()) {
                why = finding.example;
            }
        }
        throw WorldError({"cli.world_not_made", "The world {0} was not made: {1}", {m_world->hex(), why}},
                         {"cli.world_not_made.remedy", "See to the cause and run this line again; what is made is kept.", {}});
    }
    if (m_arguments.json()) {
        printJson(session, {{"world", m_world->hex()}, {"complete", true}});
    } else {
        session.out() << "world " << m_world->hex() << " is made\n";
    }
    return ExitCode::Ok;
}

void printFailedTasks(const io::JobProgress& progress, Session& session) {
    for (const io::JobTask& task : progress.failed) {
        session.err() << "rubble-cli: " << task.name << " was not made: " << task.failure << '\n';
    }
}

}  // namespace rubble::cli
