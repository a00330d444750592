#include <filesystem>
#include <set>

#include "app/cli/exports/page_request.h"
#include "app/cli/exports/report_request.h"
#include "app/cli/exports/run_surroundings.h"
#include "app/cli/exports/seal_options.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/scenario/case_lookup.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/case/case_file.h"
#include "io/exports/report_notes.h"
#include "io/run/run_file.h"
#include "io/seal/run_repeat.h"
#include "io/seal/seal_case.h"
#include "io/seal/seal_offer.h"
#include "io/seal/unpacked_bundle.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

io::SealRequest requestOf(const Arguments& arguments) {
    io::SealRequest request;
    request.casePath = arguments.operand();
    request.runs = arguments.values("--runs");
    if (request.runs.empty()) {
        request.runs = io::newestRuns(request.casePath);
    }
    request.leftHome = arguments.values("--leave-out");
    for (const auto& [option, folder] : {std::pair{"--add", "exports"}, {"--report", "report"}, {"--page", "page"}}) {
        for (const std::string& path : arguments.values(option)) {
            request.extras.push_back({folder, path});
        }
    }
    request.by = arguments.value("--by").value_or("");
    request.note = arguments.value("--note").value_or("");
    request.signer = signerOf(arguments);
    request.stampRequest = arguments.has("--stamp-request");
    if (const auto command = arguments.value("--stamp-with")) {
        request.service = io::stampServiceBy(*command);
    }
    return request;
}

using PartKind = io::OfferedPart::Kind;

/// What --make asks for. Throws UsageError.
std::set<PartKind> wantedKinds(const Arguments& arguments) {
    std::set<PartKind> kinds;
    for (const std::string& value : arguments.values("--make")) {
        for (const std::string& word : splitAtCommas(value)) {
            if (word != "report" && word != "page") {
                throw wrongValue("--make", word, "report or page");
            }
            kinds.insert(word == "report" ? PartKind::Report : PartKind::Page);
        }
    }
    return kinds;
}

/// Makes reports and pages in a folder: of each run that is sealed those that are asked for and not given.
class Making {
public:
    Making(const io::SealRequest& request, const Arguments& arguments, Session& session)
        : m_request(request), m_session(session), m_report(arguments), m_kinds(wantedKinds(arguments)) {}

    std::vector<io::SealedExtra> make(const std::string& folder) {
        std::vector<io::SealedExtra> made;
        if (m_kinds.empty()) {
            return made;
        }
        std::vector<io::OfferedPart> given;
        for (const io::SealedExtra& extra : m_request.extras) {
            given.push_back(io::addedPart(extra.path));
        }
        m_case = io::loadCase(m_request.casePath);
        for (std::size_t i = 0; i < m_request.runs.size(); ++i) {
            const std::string& run = m_request.runs[i];
            io::OfferedPart sealed{PartKind::Run, {}, run};
            sealed.fingerprint = io::openRun(run)->origin().fingerprint.hex();
            for (const io::OfferedPart& missing : io::missingOf(sealed, given)) {
                if (m_kinds.contains(missing.kind)) {
                    made.push_back(io::placeOfMade(missing.kind, run, i + 1, folder));
                    makeOf(run, missing.kind, made.back().path);
                }
            }
        }
        return made;
    }

private:
    void makeOf(const std::string& path, PartKind kind, const std::string& out) {
        const std::shared_ptr<io::RunReader> run = io::openRun(path);
        // What is sealed stands on the files of the case.
        const io::RunOrigin origin = io::originInCase(*run, m_request.casePath, m_case, m_session.execution());
        Findings site, terrain;
        const Inputs inputs = io::openRunInputs(origin, site, terrain, m_session.execution());
        RunSurroundings around = surroundingsOfRun(m_case, m_request.casePath, run->origin(), inputs, m_session);
        if (kind == PartKind::Page) {
            printNotes(m_session, site);
            printNotes(m_session, terrain);
            around.shown.findings.append(site);
            around.shown.findings.append(terrain);
            writePage(out, run, inputs, around, m_session);
            return;
        }
        io::ReportRequest report;
        // What the author has said of the case lies beside it, and goes into the bundle too.
        const io::ReportNotes notes = io::readReportNotes(io::reportNotesPath(m_request.casePath));
        report.run = run;
        report.inputs = inputs;
        report.fePath = inputs.fe->contents().path;
        report.terrainPath = origin.terrainPath;
        report.siteFindings = site;
        report.siteFindings.append(terrain);
        report.theCase = &m_case;
        report.casePath = report.basePath = m_request.casePath;
        if (const CaseScenario* scenario = findScenario(m_case, run->origin().scenarioName)) {
            report.scenarioId = scenario->id;
        }
        report.question = notes.question;
        report.author = notes.author.empty() ? m_request.by : notes.author;
        report.words = notes.words;
        report.causesPath = notes.causes;
        report.repeats = m_report.repeats;
        report.studyFolder = io::cacheFolder();
        const WrittenReport written = writeReport(out, report, around, m_report, m_session);
        if (!written.lacks.empty()) {
            printFindings(m_session.err(), written.lacks);
        }
    }

    const io::SealRequest& m_request;
    Session& m_session;
    const ReportMaking m_report;
    const std::set<PartKind> m_kinds;
    Case m_case;
};

void print(const io::SealReport& report, const std::vector<io::SealedExtra>& made, const std::string& out, Session& session) {
    const io::SealStatement& statement = report.statement;
    session.out() << out << '\n';
    FactList facts;
    facts.add("files", englishInteger(statement.files));
    facts.add("bytes", englishInteger(statement.bytes));
    facts.add("runs", englishInteger(static_cast<std::int64_t>(statement.runs.size())));
    facts.add("head of the journal", statement.journalHead.empty() ? "none" : statement.journalHead);
    facts.add("SHA-256 of the statement", report.sealSha256);
    facts.add("SHA-256 of the key", statement.signer);
    if (!statement.subject.empty()) {
        facts.add("certificate", statement.subject);
    }
    for (const io::SealedExtra& each : made) {
        facts.add("made for it", io::placeInBag(each));
    }
    facts.print(session.out());
    printFindings(session.out(), report.findings);
}

ExitCode seal(const Arguments& arguments, Session& session) {
    const auto out = arguments.value("--out");
    if (!out || !arguments.has("--key")) {
        throw UsageError(
            {"cli.seal_incomplete", "rubble-cli seal needs a file to write and a key to sign with.", {}},
            {"cli.seal_incomplete.remedy",
             "Give --out FILE.rubblecase --key KEY.pem; a key is made with: openssl genpkey -algorithm ed25519 -out KEY.pem",
             {}});
    }
    if (!io::isCaseFile(arguments.operand())) {
        io::loadCase(arguments.operand());
    }
    checkOutputPath(*out, std::vector<std::string>{arguments.operand()});
    io::SealRequest request = requestOf(arguments);
    const io::ScratchFolder scratch;
    const std::vector<io::SealedExtra> made = Making(request, arguments, session).make(scratch.path());
    request.extras.insert(request.extras.end(), made.begin(), made.end());
    const io::SealReport report = io::sealCase(*out, request, session.execution());
    if (const auto path = arguments.value("--stamp-request")) {
        io::writeIn(*path, report.stampRequest);
    }
    if (!arguments.json()) {
        print(report, made, *out, session);
        return ExitCode::Ok;
    }
    const io::SealStatement& statement = report.statement;
    Json object;
    object["bundle"] = *out;
    object["seal_sha256"] = report.sealSha256;
    object["key_sha256"] = statement.signer;
    object["journal_head"] = statement.journalHead;
    object["files"] = statement.files;
    object["bytes"] = statement.bytes;
    object["runs"] = Json::array();
    for (const io::SealedRun& run : statement.runs) {
        object["runs"].push_back(run.place);
    }
    object["made"] = Json::array();
    for (const io::SealedExtra& each : made) {
        object["made"].push_back(io::placeInBag(each));
    }
    object["findings"] = findingsJson(report.findings);
    printJson(session, object);
    return ExitCode::Ok;
}

}  // namespace

Command sealCommand() {
    std::vector<Option> options{
        {"--out", "FILE", false, "the bundle that is written (*.rubblecase)"},
        {"--runs", "RUN", true, "a run that is sealed with the case (default: the newest of each scenario that was kept)"},
        {"--leave-out", "ID", true, "an input whose file must not travel; its digest does"},
        {"--add", "FILE", true, "an export that is sealed as well, with its provenance"},
        {"--report", "FOLDER", false, "a report that is sealed as well, as rubble-cli report wrote it"},
        {"--page", "FILE", true, "a page of a run that is sealed as well"},
        {"--make", "KINDS", true, "report, page or both with a comma: made of each run of which none is given, and sealed as well"},
        {"--by", "NAME", false, "who seals"},
        {"--note", "TEXT", false, "why, or what is to be known of it"},
        {"--stamp-request", "FILE", false, "write the request for a time stamp (RFC 3161) here too, to be answered later"},
        {"--stamp-with", "COMMAND", false, "ask a service now: a command in which {request} and {answer} are files"}};
    const std::vector<Option> report = ReportMaking::options();
    options.insert(options.end(), report.begin(), report.end());
    const std::vector<Option> signer = signerOptions();
    options.insert(options.end(), signer.begin(), signer.end());
    return {"seal",
            "CASE",
            "a case with all it stands on as one signed bundle",
            "Packs the case with its journal, its inputs, runs and what was made of them by the rules of BagIt (RFC 8493) into one "
            "zip container, and signs a statement that names the SHA-256 of every file, the head of the journal and the build. A "
            "README in it tells how to check it with sha256sum and openssl alone.",
            options,
            seal};
}

}  // namespace rubble::cli
