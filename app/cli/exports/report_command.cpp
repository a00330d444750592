#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/exports/figure_request.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/picture_options.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/temporary_run.h"
#include "app/cli/frame/text_output.h"
#include "app/cli/frame/virtual_display.h"
#include "core/base/error.h"
#include "core/evidence/report_gaps.h"
#include "core/scenario/case_lookup.h"
#include "core/selftest/report_checks.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "io/exports/report_facts.h"
#include "io/run/run_history.h"
#include "io/site/site_place.h"
#include "widgets/figures/report/report_language.h"
#include "widgets/figures/report/report_pictures.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

constexpr int mostRepeats = 100;

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
    subject.run = io::openRun(subject.runPath);
    return subject;
}

int repeatsOf(const Arguments& arguments) {
    const std::string text = arguments.value("--repeats").value_or("2");
    int repeats = 0;
    if (!parseNumber(text, repeats) || repeats < 0 || repeats > mostRepeats) {
        throw wrongValue("--repeats", text, "a number from 0 to 100");
    }
    return repeats;
}

/// The self-test that was asked for, on this machine, now.
void addSelfTest(ReportFacts& facts, const Arguments& arguments, Session& session) {
    const std::string scope = arguments.value("--self-test").value_or("closed-form");
    if (scope == "none") {
        return;
    }
    facts.selfTest = selftest::reportChecks(selftest::runSuite(selftest::reportCases(scope), {}, session.execution()));
    session.execution().check();
    facts.selfTestScope = scope;
}

void checkSelfTest(const Arguments& arguments) {
    const std::string scope = arguments.value("--self-test").value_or("closed-form");
    if (scope != "all" && scope != "closed-form" && scope != "none") {
        throw wrongValue("--self-test", scope, "all, closed-form or none");
    }
}

std::string languageOf(const Arguments& arguments) {
    const std::string code = arguments.value("--language").value_or("en");
    if (code != "en" && code != "zh_CN") {
        throw wrongValue("--language", code, "en or zh_CN");
    }
    return code;
}

io::ReportRequest requestOf(const Arguments& arguments, const ReportSubject& subject, const Inputs& inputs) {
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
    request.repeats = repeatsOf(arguments);
    request.studyFolder = arguments.value("--cache").value_or(io::cacheFolder());
    return request;
}

figures::MapPictureStyle mapStyle(const io::RunReader& run) {
    figures::MapPictureStyle style;
    style.place = io::SitePlace(run.origin().frame, run.origin().site).transform();
    style.system = run.origin().frame.crs;
    return style;
}

/// What the report would lack, in its language; nothing is repeated for it and nothing written.
ExitCode tellGaps(const Arguments& arguments, Session& session, io::ReportRequest request, const std::string& language) {
    const ReportPlan plan{request.repeats, arguments.value("--self-test").value_or("closed-form") != "none"};
    request.repeats = 0;
    const ReportFacts facts = io::reportFacts(request, session.execution());
    const Findings gaps = reportGaps(facts, plan);
    const std::vector<Message> words = reportOwnWords(facts);
    const Saying say = language == "en" ? Saying(englishText) : Saying(figures::chineseWords());
    if (arguments.json()) {
        Json object;
        object["run"] = request.run->path();
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
    checkSelfTest(arguments);
    const std::string language = languageOf(arguments);
    if (!checkOnly) {
        io::makeFolderOf(*folder);
    }
    const ReportSubject subject = openReportSubject(arguments, session);
    Findings site;
    const Inputs inputs = openInputsOfRun(subject.runPath, subject.run->origin(), arguments, session, &site);
    io::ReportRequest request = requestOf(arguments, subject, inputs);
    request.siteFindings = site;
    if (checkOnly) {
        return tellGaps(arguments, session, request, language);
    }
    ReportFacts facts = io::reportFacts(request, session.execution());
    addSelfTest(facts, arguments, session);
    quietQt();
    figures::ensureGuiApplication();
    const figures::WrittenLanguage written(language);
    const VirtualDisplay display;
    const RunSurroundings around =
        subject.theCase ? surroundingsOfRun(*subject.theCase, subject.casePath, subject.run->origin(), inputs, session)
                        : RunSurroundings();
    figures::ReportPictures pictures =
        figures::drawReportPictures(sceneOfRun(subject.run, inputs, around), facts, mapStyle(*subject.run), session.execution());
    pictures.say = written.say();
    const io::ExportRecord record{"report",
                                  {{"Debris at the end", facts.result->endTime, std::nullopt, "simulated"}},
                                  {},
                                  {},
                                  subject.casePath,
                                  io::shownFiles(around.shown)};
    Findings lacks;
    const std::vector<std::string> files =
        figures::writeReport(*folder, facts, pictures, io::exportProvenance(record, subject.run->origin(), subject.run.get()),
                             session.execution(), &lacks);
    if (!lacks.empty()) {
        printFindings(session.err(), lacks);
    }
    const io::Taint taint = io::taintOf(*subject.run);
    warnIfTainted(session, subject.runPath, taint);
    if (arguments.json()) {
        Json object;
        object["run"] = subject.runPath;
        object["fingerprint"] = facts.fingerprint;
        object["exports"] = files;
        object["tainted"] = taint.tainted();
        object["lacks"] = findingsJson(lacks);
        object["cautions"] = cautionsJson(facts.cautions);
        object["reproduced"] = facts.floor ? Json(facts.reproduced) : Json();
        printJson(session, object);
    } else {
        for (const std::string& path : files) {
            session.out() << path << '\n';
        }
    }
    return ExitCode::Ok;
}

}  // namespace

Command reportCommand() {
    return {"report",
            "RUN|CASE",
            "a report of a run as PDF and HTML",
            "Writes question, evidence, method, inputs, results with their spread, agreement with the reference, validation, "
            "effects, health, "
            "self-test and "
            "limits. A run that does not agree with its case or inputs is refused, and what is stale is named. Of a case the "
            "newest run "
            "that was kept is reported; if there is none it is simulated.",
            {{"--out", "FOLDER", false, "where report.html and report.pdf are written"},
             {"--check", "", false, "write nothing; list what the report lacks that standards for such reports ask for"},
             {"--case", "CASE", false, "of a run: the case that it must agree with"},
             {"--run", "RUN", false, "of a case: the run that is reported (default: the newest that was kept)"},
             scenarioOption(),
             {"--title", "TEXT", false, "title (default: that of the case)"},
             {"--question", "TEXT", false, "the question that the report answers"},
             {"--by", "NAME", false, "who makes it"},
             {"--causes", "FILE", false, "other causes that were compared: what rubble-cli compare --json printed"},
             {"--words", "FILE", false,
              "what only its author can say: text with # custody, # alternatives, # change, # summary, # qualification"},
             {"--repeats", "N", false, "repeats simulated for the spread of the results, 0 for none (default: 2)"},
             {"--language", "CODE", false, "language of the report and of --check: en (default) or zh_CN"},
             {"--self-test", "SCOPE", false, "all, closed-form (default) or none"},
             {"--cache", "FOLDER", false, "where studies of accuracy are kept (default: RUBBLE_CACHE, else the user's cache)"},
             cachedOption(),
             feOption(),
             runTerrainOption()},
            report};
}

}  // namespace rubble::cli
