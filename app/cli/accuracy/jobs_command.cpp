#include <algorithm>

#include "app/cli/accuracy/study_place.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_table.h"
#include "core/base/error.h"
#include "io/base/machine.h"
#include "io/jobs/slurm_jobs.h"

namespace rubble::cli {

namespace {

Json progressJson(const io::JobRecord& record, const io::JobProgress& progress) {
    Json object{{"job", record.id},
                {"study", record.study},
                {"subject", record.subject},
                {"build", record.build},
                {"submitted", record.submitted},
                {"worlds", progress.total},
                {"made", progress.made},
                {"running", progress.running},
                {"waiting", progress.waiting},
                {"reachable", progress.reachable}};
    object["failed"] = Json::array();
    for (const io::JobTask& task : progress.failed) {
        object["failed"].push_back({{"world", task.key}, {"name", task.name}, {"why", task.failure}});
    }
    return object;
}

TextTable progressTable() {
    return TextTable({{"job", "job"},
                      {"study", "study"},
                      {"submitted", "submitted"},
                      {"worlds", "worlds"},
                      {"made", "made"},
                      {"running", "running"},
                      {"waiting", "waiting"},
                      {"failed", "failed"},
                      {"of", "subject"}});
}

void addRow(TextTable& table, const io::JobRecord& record, const io::JobProgress& progress) {
    const auto count = [](std::size_t number) { return integerCell(static_cast<std::int64_t>(number)); };
    table.add({textCell(record.id), textCell(record.study), textCell(record.submitted), count(progress.total), count(progress.made),
               count(progress.running), count(progress.waiting), count(progress.failed.size()), textCell(record.subject)});
}

/// The job named, or the newest one.
std::string chosenJob(const Arguments& arguments, const std::string& store) {
    if (!arguments.operand(1).empty()) {
        return arguments.operand(1);
    }
    const std::vector<std::string> ids = io::jobIds(store);
    if (ids.empty()) {
        throw UsageError({"cli.no_jobs", "No study of {0} was given to Slurm.", {store}},
                         {"cli.no_jobs.remedy", "Start one with --executor slurm, or name its folder with --cache.", {}});
    }
    return ids.front();
}

ExitCode listJobs(const Arguments& arguments, const std::string& store, Session& session) {
    io::SlurmJobs jobs(store);
    TextTable table = progressTable();
    Json list = Json::array();
    bool reachable = true;
    for (const std::string& id : io::jobIds(store)) {
        try {
            const io::JobRecord record = io::loadJob(store, id);
            const io::JobProgress progress = jobs.look(id);
            reachable = reachable && progress.reachable;
            addRow(table, record, progress);
            list.push_back(progressJson(record, progress));
        } catch (const ParseError& error) {
            session.err() << "rubble-cli: " << error.what() << '\n';
        }
    }
    writeCsv(arguments, table);
    if (arguments.json()) {
        printJson(session, {{"store", store}, {"jobs", list}});
        return ExitCode::Ok;
    }
    session.out() << store << '\n';
    table.print(session.out());
    if (!reachable) {
        session.err() << "rubble-cli: Slurm does not answer; what runs is as it was known last\n";
    }
    return ExitCode::Ok;
}

ExitCode followJob(const Arguments& arguments, const std::string& store, Session& session) {
    const std::string id = chosenJob(arguments, store);
    io::SlurmJobs jobs(store);
    const io::JobProgress progress = jobs.follow(id, {}, session.execution());
    printFailedTasks(progress, session);
    if (arguments.json()) {
        printJson(session, progressJson(io::loadJob(store, id), progress));
    } else {
        TextTable table = progressTable();
        addRow(table, io::loadJob(store, id), progress);
        table.print(session.out());
    }
    return progress.made == progress.total ? ExitCode::Ok : ExitCode::Failed;
}

ExitCode jobs(const Arguments& arguments, Session& session) {
    const std::string& what = arguments.operand();
    const std::string store = arguments.value("--cache").value_or(io::cacheFolder());
    checkCsvPath(arguments, {});
    if (what == "list") {
        return listJobs(arguments, store, session);
    }
    if (what == "follow") {
        return followJob(arguments, store, session);
    }
    if (what != "cancel" && what != "clear") {
        throw wrongValue("jobs", what, "list, follow, cancel or clear");
    }
    std::vector<std::string> ids;
    if (what == "cancel") {
        ids.push_back(chosenJob(arguments, store));
        io::SlurmJobs(store).cancel(ids.front());
    } else {
        ids = io::SlurmJobs(store).clear();
    }
    if (arguments.json()) {
        printJson(session, {{what == "cancel" ? "cancelled_jobs" : "cleared_jobs", ids}});
    }
    for (const std::string& id : ids) {
        if (!arguments.json()) {
            session.out() << id << (what == "cancel" ? " is cancelled; what was made is kept\n" : " is forgotten\n");
        }
    }
    return ExitCode::Ok;
}

}  // namespace

Command jobsCommand() {
    return {
        "jobs",
        "list|follow|cancel|clear [JOB]",
        "studies that were given to a Slurm cluster with --executor slurm",
        "Lists them with how far each is, follows one to its end and submits again what was lost, cancels one, or forgets those "
        "of which nothing is under way. Without JOB the newest is meant. The worlds that were made stay in the cache.",
        {{"--cache", "FOLDER", false, "the cache they make worlds into (default: RUBBLE_CACHE, else the user's cache)"},
         csvOption("write the table of list")},
        jobs};
}

}  // namespace rubble::cli
