#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/exports/export_request.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/temporary_run.h"
#include "app/cli/run/run_report.h"
#include "app/cli/run/run_sinks.h"
#include "app/cli/run/run_summary.h"
#include "core/base/error.h"
#include "io/run/checkpoint_file.h"
#include "io/run/run_file.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

/// An existing file is replaced only if it is a run: what a slip of the keyboard names must survive it.
void checkRunPath(const std::string& path, const io::OpenedCase& subject) {
    checkOutputPath(path, subject.files);
    std::error_code ignored;
    if (!fs::exists(path, ignored) || fs::file_size(path, ignored) == 0) {
        return;
    }
    try {
        io::openRun(path);
    } catch (const ParseError&) {
        throw UsageError({"cli.out_not_a_run", "--out {0}: this file exists and is not a run.", {path}},
                         {"cli.out_not_a_run.remedy", "Choose another name, or delete the file first.", {}});
    }
}

/// Tells what a cancelled run leaves behind.
ExitCode reportPartial(const Arguments& arguments, Session& session, const LedgerRecorder& recorder) {
    const std::optional<std::string> out = arguments.value("--out");
    const bool kept = out && recorder.frames() > 0;
    std::error_code ignored;
    if (kept) {
        session.err() << "rubble-cli: cancelled; " << recorder.frames()
                      << " frames up to t = " << englishNumber(recorder.lastTime()) << " s are kept in " << *out << '\n';
        if (fs::exists(io::checkpointPathOf(*out), ignored)) {
            session.err() << "  The same command goes on from its latest checkpoint; --anew begins at the start.\n";
        }
    } else {
        session.err() << "rubble-cli: cancelled; nothing is kept (--out keeps the frames simulated so far)\n";
    }
    if (arguments.json()) {
        Json object;
        object["cancelled"] = true;
        object["run"] = kept ? Json(*out) : Json();
        object["frames"] = recorder.frames();
        object["time_s"] = recorder.lastTime();
        printJson(session, object);
    }
    return ExitCode::Cancelled;
}

/// For people: the summary, and the tables where they are asked for.
/// @param debris  of a run that no file took
void printReport(const Arguments& arguments, Session& session, const RunReport& report, const io::RunReader* recorded,
                 const DebrisRecorder& debris) {
    const Results& results = report.results;
    std::optional<DebrisFigures> figures;
    if (!results.fragments->list.empty()) {
        figures = figuresAtEnd(report.subject, results,
                               recorded ? debrisAt(*results.fragments, *results.components, *recorded, results.simulation->endTime)
                                        : debris.debris(DebrisInstant::AtRest));
    }
    printSummary(session.out(), report, figures);
    if (arguments.has("--tables")) {
        session.out() << '\n';
        report.print(session.out());
    }
}

ExitCode runScenario(const Arguments& arguments, Session& session) {
    const io::OpenedCase subject = openSubject(arguments, session);
    checkCsvPath(arguments, subject.files);
    const ExportRequest exports(arguments, subject.files);
    std::string runPath = arguments.value("--out").value_or("");
    if (arguments.has("--out")) {
        checkRunPath(runPath, subject);
    }
    // Without --out the trajectory goes to disk only if an export reads it, and never into memory.
    std::optional<TemporaryRun> temporary;
    if (runPath.empty() && !exports.empty()) {
        exports.checkKept();
        runPath = temporary.emplace().path();
    }
    std::optional<io::CheckpointFile> checkpoint;
    if (arguments.has("--out")) {
        checkpoint.emplace(io::checkpointPathOf(runPath));
    }
    if (checkpoint && arguments.has("--anew")) {
        checkpoint->remove();
    }
    std::unique_ptr<TrajectorySink> file;
    if (!runPath.empty()) {
        file = io::continueRun(runPath, io::originOf(subject));
    }
    DebrisRecorder debris;
    LedgerRecorder recorder(file ? file.get() : &debris);
    Results results;
    try {
        results = runTo(subject, Stage::Simulation, &recorder, session.execution(), checkpoint ? &*checkpoint : nullptr);
    } catch (const Cancelled&) {
        file.reset();
        return reportPartial(arguments, session, recorder);
    }
    file.reset();
    if (checkpoint) {
        checkpoint->remove();
    }
    if (!exports.empty()) {
        exports.perform(temporary ? temporary->open() : io::openRun(runPath), subject.inputs, {subject.casePath, subject.terrain},
                        session);
    }
    writeCsv(arguments, ledgerTable(recorder.ledger()));
    const std::shared_ptr<io::RunReader> recorded = runPath.empty() ? nullptr : io::openRun(runPath);
    const io::Taint taint = recorded ? io::taintOf(*recorded) : io::taintOf(results.simulation->health.breaches);
    const RunReport report{subject,
                           results,
                           recorder.ledger(),
                           recorder.islands(),
                           io::allFindings(subject, results),
                           temporary ? "" : runPath,
                           exports.paths(),
                           taint};
    if (arguments.json()) {
        printJson(session, report.json());
    } else {
        printReport(arguments, session, report, recorded.get(), debris);
    }
    warnIfTainted(session, temporary ? "" : runPath, taint);
    return ExitCode::Ok;
}

}  // namespace

Command runCommand() {
    const std::vector<Option> own{{"--out", "RUN.h5", false, "keep the run in this file"},
                                  {"--anew", "", false, "begin at the start, although a checkpoint of --out is there"},
                                  ExportRequest::option()};
    const std::vector<Option> tables{{"--tables", "", false, "print the tables of the run after its summary"},
                                     csvOption("write the ledger, one row for each FE state and each second after")};
    return {
        "run",
        "FE|CASE",
        "fragments, Basic Grid, clusters, and where they go",
        "Simulates the whole collapse and prints a summary; --tables adds the tables. Ctrl-C stops it: with --out what was "
        "simulated so far is kept, and the run file reopens at its last complete frame. With --out and solver = soft-step a "
        "checkpoint is kept beside the run "
        "once a minute; the same command goes on from it after Ctrl-C or a kill, and ends bit for bit as one that was not stopped.",
        joined({{scenarioOption()}, simulationOptions(), own, FigureRequest::options(), MapRequest::options(), tables}),
        runScenario};
}

}  // namespace rubble::cli
