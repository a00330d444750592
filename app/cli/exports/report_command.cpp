#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/exports/report_request.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/temporary_run.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/evidence/report_gaps.h"
#include "core/scenario/case_lookup.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/case/case_file.h"
#include "io/exports/report_facts.h"
#include "io/run/run_history.h"
#include "widgets/figures/report/report_language.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

/// The run that is reported, and the case that it must agree with.
struct ReportSubject {
    std::string runPath;
    std::shared_ptr<io::RunReader> run;
    std::optional<Case> theCase;
    std::string casePath;
    std::unique_ptr<TemporaryRun> temporary;
};

/// The newest complete run of a scenario whose file was kept; empty if there is none.
std::string keptRun(const std::string& casePath, const std::string& scenarioId) {
    std::string kept;
    for (const RunEntry& entry : io::readRunHistory(io::runHistoryPath(casePath))) {
        if (entry.complete && entry.scenarioId == scenarioId && !entry.file.empty() && fs::exists(entry.file)) {
            kept = entry.file;
        }
    }
    return kept;
}

std::string wantedScenario(const Arguments& arguments, const Case& theCase) {
    const std::optional<std::string> wanted = arguments.value("--scenario");
    const CaseScenario* found = findScenario(theCase, wanted);
    return found != nullptr ? found->id : wanted.value_or("");
}

/// The run of a case is the one named, else the newest that was kept, else one that is simulated now.
ReportSubject openReportSubject(const Arguments& arguments, Session& session) {
    ReportSubject subject;
    if (io::isCaseFile(arguments.operand())) {
        subject.casePath = arguments.operand();
    } else if (const auto path = arguments.value("--case")) {
        subject.casePath = *path;
    }
    if (!subject.casePath.empty()) {
        subject.theCase = io::loadCase(subject.casePath);
    }
    subject.runPath = arguments.operand();
    if (subject.casePath == arguments.operand()) {
        const std::string kept = keptRun(subject.casePath, wantedScenario(arguments, *subject.theCase));
        subject.runPath = arguments.value("--run").value_or(kept);
    }
    if (subject.runPath.empty()) {
        const io::OpenedCase opened = openSubject(arguments, session);
        subject.temporary = std::make_unique<TemporaryRun>();
        subject.runPath = subject.temporary->path();
        std::unique_ptr<TrajectorySink> file = io::createRun(subject.runPath, io::originOf(opened));
        runTo(opened, Stage::Simulation, file.get(), session.execution());
    }
    subject.run = subject.temporary != nullptr ? subject.temporary->open() : io::openRun(subject.runPath);
    return subject;
}

io::ReportRequest requestOf(const Arguments& arguments, const ReportSubject& subject, const Inputs& inputs,
                            const ReportMaking& making) {
    io::ReportRequest request;
    request.run = subject.run;
    request.inputs = inputs;
    request.fePath = inputs.fe->contents().path;
    request.terrainPath = arguments.value("--terrain").value_or(subject.run->origin().terrainPath);
    request.theCase = subject.theCase ? &*subject.theCase : nullptr;
    request.casePath = request.basePath = subject.casePath;
    request.scenarioId = arguments.value("--scenario").value_or("");
    request.title = arguments.value("--title").value_or("");
    request.question = arguments.value("--question").value_or("");
    request.author = arguments.value("--by").value_or("");
    request.causesPath = arguments.value("--causes").value_or("");
    request.wordsPath = arguments.value("--words").value_or("");
    request.repeats = making.repeats;
    request.studyFolder = arguments.value("--cache").value_or(io::cacheFolder());
    return request;
}

/// What the report would lack, in its language; nothing is repeated for it and nothing written.
ExitCode tellGaps(const Arguments& arguments, Session& session, io::ReportRequest request, const ReportMaking& making) {
    const ReportPlan plan{making.repeats, making.selfTest != "none"};
    request.repeats = 0;
    const ReportFacts facts = io::reportFacts(request, session.execution());
    const Findings gaps = reportGaps(facts, plan);
    const std::vector<Message> words = reportOwnWords(facts);
    const Saying say = making.language == "en" ? Saying(englishText) : Saying(figures::chineseWords());
    if (arguments.json()) {
        Json object;
        object["run"] = request.run->kept() ? Json(request.run->path()) : Json();
        object["fingerprint"] = facts.fingerprint;
        object["lacks"] = findingsJson(gaps, say);
        object["own_words"] = Json::array();
        for (const Message& own : words) {
            object["own_words"].push_back(say(own));
        }
        printJson(session, object);
    } else {
        const ReportGapWords about = reportGapWords(!gaps.empty());
        printFindings(session.out(), gaps, {about.lacks, about.example, about.remedy}, say);
        if (!words.empty()) {
            printHeading(session.out(), say(about.own) + " (--words FILE)");
        }
        for (const Message& own : words) {
            session.out() << "  " << say(own) << '\n';
        }
    }
    return gaps.empty() ? ExitCode::Ok : ExitCode::Failed;
}

ExitCode report(const Arguments& arguments, Session& session) {
    const std::optional<std::string> folder = arguments.value("--out");
    const bool checkOnly = arguments.has("--check");
    if (!folder && !checkOnly) {
        throw UsageError({"cli.no_report", "rubble-cli report does not know where to write.", {}},
                         {"cli.no_report.remedy", "Name a folder: --out FOLDER; it gets report.html and report.pdf.", {}});
    }
    const ReportMaking making(arguments);
    if (!checkOnly) {
        io::makeFolderOf(*folder);
    }
    const ReportSubject subject = openReportSubject(arguments, session);
    Findings site;
    const Inputs inputs = openInputsOfRun(subject.runPath, subject.run->origin(), arguments, session, &site);
    io::ReportRequest request = requestOf(arguments, subject, inputs, making);
    request.siteFindings = site;
    if (checkOnly) {
        return tellGaps(arguments, session, request, making);
    }
    const RunSurroundings around =
        subject.theCase ? surroundingsOfRun(*subject.theCase, subject.casePath, subject.run->origin(), inputs, session)
                        : RunSurroundings();
    const WrittenReport written = writeReport(*folder, request, around, making, session);
    if (!written.lacks.empty()) {
        printFindings(session.err(), written.lacks);
    }
    const io::Taint taint = io::taintOf(*subject.run);
    warnIfTainted(session, subject.temporary == nullptr ? subject.runPath : std::string(), taint);
    if (arguments.json()) {
        Json object;
        object["run"] = subject.temporary == nullptr ? Json(subject.runPath) : Json();
        object["fingerprint"] = written.facts.fingerprint;
        object["exports"] = written.files;
        object["tainted"] = taint.tainted();
        object["lacks"] = findingsJson(written.lacks);
        object["cautions"] = cautionsJson(written.facts.cautions);
        object["reproduced"] = written.facts.floor ? Json(written.facts.reproduced) : Json();
        printJson(session, object);
    } else {
        for (const std::string& path : written.files) {
            session.out() << path << '\n';
        }
    }
    return ExitCode::Ok;
}

}  // namespace

Command reportCommand() {
    std::vector<Option> options{
        {"--out", "FOLDER", false, "where report.html and report.pdf are written"},
        {"--check", "", false, "write nothing; list what the report lacks that standards for such reports ask for"},
        {"--case", "CASE", false, "of a run: the case that it must agree with"},
        {"--run", "RUN", false, "of a case: the run that is reported (default: the newest that was kept)"},
        scenarioOption(),
        {"--title", "TEXT", false, "title (default: that of the case)"},
        {"--question", "TEXT", false, "the question that the report answers"},
        {"--by", "NAME", false, "who makes it"},
        {"--causes", "FILE", false, "other causes that were compared: what rubble-cli compare --json printed"},
        {"--words", "FILE", false,
         "what only its author can say: text with # custody, # alternatives, # change, # summary, # qualification"}};
    const std::vector<Option> making = ReportMaking::options();
    options.insert(options.end(), making.begin(), making.end());
    options.push_back(
        {"--cache", "FOLDER", false, "where studies of accuracy are kept (default: RUBBLE_CACHE, else the user's cache)"});
    options.push_back(cachedOption());
    options.push_back(feOption());
    options.push_back(runTerrainOption());
    return {"report",
            "RUN|CASE",
            "a report of a run as PDF and HTML",
            "Writes question, evidence, method, inputs, results with their spread, agreement with the reference, validation, "
            "effects, health, "
            "self-test and "
            "limits. A run that does not agree with its case or inputs is refused, and what is stale is named. Of a case the "
            "newest run "
            "that was kept is reported; if there is none it is simulated.",
            options,
            report};
}

}  // namespace rubble::cli
