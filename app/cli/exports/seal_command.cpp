#include <filesystem>

#include "app/cli/exports/page_request.h"
#include "app/cli/exports/run_surroundings.h"
#include "app/cli/exports/seal_options.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/run/run_file.h"
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

/// Makes a page of each run in a folder, to be sealed as well.
void addPages(io::SealRequest& request, const std::string& folder, const Arguments& arguments, Session& session) {
    const Case theCase = io::loadCase(request.casePath);
    for (std::size_t i = 0; i < request.runs.size(); ++i) {
        const std::string& path = request.runs[i];
        const std::shared_ptr<io::RunReader> run = io::openRun(path);
        const Inputs inputs = openInputsOfRun(path, run->origin(), arguments, session);
        const RunSurroundings around = surroundingsOfRun(theCase, request.casePath, run->origin(), inputs, session);
        const std::string page = folder + "/" + std::to_string(i + 1) + "-" + fs::path(path).stem().stem().string() + ".html";
        writePage(page, run, inputs, around, session);
        request.extras.push_back({"page", page});
    }
}

void print(const io::SealReport& report, const std::string& out, Session& session) {
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
    const io::ScratchFolder pages;
    if (arguments.has("--with-pages")) {
        addPages(request, pages.path(), arguments, session);
    }
    const io::SealReport report = io::sealCase(*out, request, session.execution());
    if (const auto path = arguments.value("--stamp-request")) {
        io::writeIn(*path, report.stampRequest);
    }
    if (!arguments.json()) {
        print(report, *out, session);
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
        {"--with-pages", "", false, "make a page of each run and seal it as well"},
        {"--by", "NAME", false, "who seals"},
        {"--note", "TEXT", false, "why, or what is to be known of it"},
        {"--stamp-request", "FILE", false, "write the request for a time stamp (RFC 3161) here too, to be answered later"},
        {"--stamp-with", "COMMAND", false, "ask a service now: a command in which {request} and {answer} are files"}};
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
