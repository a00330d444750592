#include <filesystem>
#include <optional>

#include "app/cli/exports/seal_options.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "io/seal/bundle_verdict.h"
#include "io/seal/seal_check.h"
#include "io/seal/unpacked_bundle.h"

namespace rubble::cli {

namespace {

/// The first figure or instant of a run that is not what it was.
std::string firstDifference(const io::RepeatedRun& run) {
    const std::string difference = englishText(run.difference());
    return run.notSimulated.empty() ? difference : "Not simulated: " + difference + ". " + englishText(run.remedy);
}

void printFaults(std::ostream& out, const char* heading, const std::vector<io::SealFault>& faults) {
    if (!faults.empty()) {
        printHeading(out, heading);
    }
    for (const io::SealFault& fault : faults) {
        out << "  " << (fault.place.empty() ? "container" : fault.place) << ": " << englishText(fault.what) << '\n';
    }
}

/// What must be known of the runs all the same.
std::vector<io::SealFault> knownOf(const io::SealCheck& check) {
    std::vector<io::SealFault> known;
    for (const io::CheckedPart& part : io::checkedParts(check)) {
        known.insert(known.end(), part.known.begin(), part.known.end());
    }
    return known;
}

void print(const std::string& path, const io::SealCheck& check, const std::vector<io::RepeatedRun>& repeats,
           const std::string& verdict, std::ostream& out) {
    const io::SealStatement& statement = check.statement;
    out << path << ": " << verdict << '\n';
    FactList facts;
    facts.add("title", statement.title);
    facts.add("sealed", statement.sealedAt + (statement.sealedBy.empty() ? "" : " by " + statement.sealedBy));
    if (!statement.note.empty()) {
        facts.add("note", statement.note);
    }
    facts.add("SHA-256 of the key", check.signature.signer.fingerprint);
    if (!check.signature.signer.subject.empty()) {
        facts.add("certificate", check.signature.signer.subject);
    }
    facts.add("time stamp",
              check.stamp && check.stamp->matches ? io::utcOfSeconds(check.stamp->time) + " by " + check.stamp->service : "none");
    facts.add("SHA-256 of the statement", check.sealSha256);
    facts.add("head of the journal", statement.journalHead.empty() ? "none" : statement.journalHead);
    facts.add("words of the report's author", check.notes.empty() ? "none" : check.notes);
    facts.print(out);
    printHeading(out, "Checked");
    FactList parts;
    for (const io::CheckedPart& part : io::checkedParts(check)) {
        parts.add(englishText(part.name), englishText(io::proofText(part.proof)) + ": " + englishText(part.meaning));
    }
    parts.print(out);
    printFaults(out, "Not as it was sealed", check.faults);
    printFaults(out, "Not proven", check.doubts);
    printFaults(out, "To be known of its runs", knownOf(check));
    if (!check.records.empty()) {
        printHeading(out, "Since it was sealed");
        printRecords(out, check);
    }
    for (const io::RepeatedRun& each : repeats) {
        out << each.run.place << ": " << (each.equal() ? "equal" : "not equal. " + firstDifference(each)) << '\n';
    }
}

Json asJson(const std::string& path, const io::SealCheck& check, const std::vector<io::RepeatedRun>& repeats,
            const std::string& verdict, bool good) {
    Json object;
    object["bundle"] = path;
    object["verdict"] = verdict;
    object["ok"] = good;
    object["sealed_at"] = check.statement.sealedAt;
    object["sealed_by"] = check.statement.sealedBy;
    object["seal_sha256"] = check.sealSha256;
    object["key_sha256"] = check.signature.signer.fingerprint;
    object["stamped_at"] = check.stamp && check.stamp->matches ? Json(io::utcOfSeconds(check.stamp->time)) : Json();
    object["report_notes"] = check.notes.empty() ? Json() : Json(check.notes);
    object["faults"] = faultsJson(check.faults);
    object["doubts"] = faultsJson(check.doubts);
    object["to_be_known"] = faultsJson(knownOf(check));
    object["records"] = recordsJson(check);
    object["runs"] = Json::array();
    for (const io::RepeatedRun& each : repeats) {
        object["runs"].push_back({{"file", each.run.place}, {"equal", each.equal()}, {"first_difference", firstDifference(each)}});
    }
    return object;
}

std::vector<io::RepeatedRun> openUnpacked(const io::SealCheck& check, const Arguments& arguments, Session& session) {
    std::optional<io::ScratchFolder> scratch;
    const auto into = arguments.value("--into");
    if (!into) {
        scratch.emplace();
    }
    io::UnpackedBundle unpacked(arguments.operand(), check, into ? *into : scratch->path(), session.execution());
    for (const std::string& text : arguments.values("--input")) {
        const auto [id, path] = splitAssignment("--input", text);
        unpacked.locate(id, path, session.execution());
    }
    if (into) {
        unpacked.writeWorkingCase(*into + "/" + std::filesystem::path(check.statement.casePlace).filename().string());
    }
    return arguments.has("--no-run") ? std::vector<io::RepeatedRun>() : io::repeatRuns(unpacked, session.execution());
}

ExitCode openSealed(const Arguments& arguments, Session& session) {
    const io::SealTrust trust{{arguments.value("--trust").value_or(""), arguments.value("--signer").value_or("")},
                              arguments.value("--stamp-trust").value_or(""),
                              arguments.value("--digest").value_or("")};
    const io::SealCheck check = io::checkBundle(arguments.operand(), trust, session.execution());
    std::vector<io::RepeatedRun> repeats;
    const bool opened = check.sound() && (arguments.has("--into") || !arguments.has("--no-run"));
    if (opened) {
        repeats = openUnpacked(check, arguments, session);
    }
    const std::string verdict = englishText(io::bundleVerdict(check, repeats, !arguments.has("--no-run")));
    bool good = check.sound();
    for (const io::RepeatedRun& each : repeats) {
        good = good && each.equal();
    }
    if (arguments.json()) {
        printJson(session, asJson(arguments.operand(), check, repeats, verdict, good));
    } else {
        print(arguments.operand(), check, repeats, verdict, session.out());
    }
    return good ? ExitCode::Ok : ExitCode::Failed;
}

}  // namespace

Command openSealedCommand() {
    return {"open-sealed",
            "BUNDLE",
            "is a sealed bundle what was sealed; do its runs repeat",
            "Checks every byte, the signature, the time stamp, the journal and each entry since. If all is as it was sealed, it is "
            "unpacked to be read only, each run is simulated again, and equal or the first difference is told.",
            {{"--into", "FOLDER", false, "unpack here and keep it, with a copy of the case to work on"},
             {"--no-run", "", false, "check only; simulate nothing"},
             {"--input", "ID=FILE", true, "where an input is that did not travel"},
             {"--signer", "KEY", false, "public key, certificate or fingerprint that must have signed"},
             {"--trust", "FILE", false, "certificates that vouch for signers, PEM"},
             {"--stamp-trust", "FILE", false, "certificates that vouch for the time-stamping service, PEM"},
             {"--digest", "SHA256", false, "digest of the statement or of an entry that the bundle must hold"}},
            openSealed};
}

}  // namespace rubble::cli
