#include "app/cli/exports/seal_options.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/output_file.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/seal/seal_addition.h"

namespace rubble::cli {

namespace {

void checkLongerBundle(const Arguments& arguments) {
    if (const auto out = arguments.value("--out")) {
        checkOutputPath(*out, {});
    }
}

std::optional<io::SignerFiles> signerGiven(const Arguments& arguments) {
    if (!arguments.has("--key")) {
        return {};
    }
    return signerOf(arguments);
}

/// The chain as it is now.
ExitCode tellRecords(const Arguments& arguments, Session& session, const std::string& bundle) {
    const io::SealCheck check = io::checkBundle(bundle, {}, session.execution());
    if (arguments.json()) {
        Json object;
        object["bundle"] = bundle;
        object["seal_sha256"] = check.sealSha256;
        object["head_sha256"] = check.head();
        object["ok"] = check.sound();
        object["faults"] = faultsJson(check.faults);
        object["records"] = recordsJson(check);
        printJson(session, object);
    } else {
        session.out() << bundle << ": sealed " << check.statement.sealedAt << '\n';
        session.out() << "     SHA-256 of the statement  " << check.sealSha256 << '\n';
        printRecords(session.out(), check);
        for (const io::SealFault& fault : check.faults) {
            session.out() << "  " << (fault.place.empty() ? "container" : fault.place) << ": " << englishText(fault.what) << '\n';
        }
    }
    return check.sound() ? ExitCode::Ok : ExitCode::Failed;
}

ExitCode custody(const Arguments& arguments, Session& session) {
    if (!arguments.has("--received-by")) {
        return tellRecords(arguments, session, arguments.operand());
    }
    if (!arguments.has("--received-from")) {
        throw UsageError({"cli.custody_from", "An entry of custody tells from whom the bundle was received.", {}},
                         {"cli.custody_from.remedy", "Add --received-from NAME.", {}});
    }
    checkLongerBundle(arguments);
    io::SealAddition addition;
    addition.by = *arguments.value("--received-by");
    addition.custody = io::CustodyEntry{*arguments.value("--received-from"),
                                        addition.by,
                                        arguments.value("--where").value_or(""),
                                        arguments.value("--why").value_or(""),
                                        {}};
    addition.signer = signerGiven(arguments);
    io::addRecord(arguments.operand(), longerBundle(arguments), addition, session.execution());
    return tellRecords(arguments, session, longerBundle(arguments));
}

ExitCode addendum(const Arguments& arguments, Session& session) {
    checkLongerBundle(arguments);
    io::SealAddition addition;
    addition.by = arguments.value("--by").value_or("");
    addition.signer = signerGiven(arguments);
    addition.casePath = arguments.operand(1);
    addition.runs = arguments.values("--runs");
    addition.note = arguments.value("--note").value_or("");
    io::addRecord(arguments.operand(), longerBundle(arguments), addition, session.execution());
    return tellRecords(arguments, session, longerBundle(arguments));
}

ExitCode tellWritten(const std::string& path, const Arguments& arguments, Session& session) {
    if (arguments.json()) {
        Json object;
        object["written"] = path;
        printJson(session, object);
    } else {
        session.out() << path << '\n';
    }
    return ExitCode::Ok;
}

ExitCode timeStamp(const Arguments& arguments, Session& session) {
    const auto request = arguments.value("--request"), answer = arguments.value("--answer");
    if (request.has_value() == answer.has_value()) {
        throw UsageError({"cli.stamp_what", "rubble-cli time-stamp writes a request or takes the answer to it.", {}},
                         {"cli.stamp_what.remedy", "Give either --request FILE or --answer FILE.", {}});
    }
    if (request) {
        checkOutputPath(*request, std::vector<std::string>{arguments.operand()});
        io::writeIn(*request, io::timeStampRequestOf(arguments.operand()));
        return tellWritten(*request, arguments, session);
    }
    checkLongerBundle(arguments);
    io::addTimeStamp(arguments.operand(), longerBundle(arguments), io::timeStampAnswer(*answer), session.execution());
    return tellWritten(longerBundle(arguments), arguments, session);
}

std::vector<Option> withSigner(std::vector<Option> options) {
    options.push_back(longerBundleOption());
    const std::vector<Option> signer = signerOptions();
    options.insert(options.end(), signer.begin(), signer.end());
    return options;
}

}  // namespace

Command custodyCommand() {
    return {
        "custody",
        "BUNDLE",
        "who received a sealed bundle from whom; adds an entry",
        "Lists what came to a bundle since it was sealed. With --received-by an entry is added: it holds the SHA-256 of the bundle "
        "as it was received and that of the entry before, so that none can be altered or left out. Note the SHA-256 of your entry.",
        withSigner({{"--received-by", "NAME", false, "who received it, now"},
                    {"--received-from", "NAME", false, "who handed it over"},
                    {"--where", "TEXT", false, "where, and on what medium"},
                    {"--why", "TEXT", false, "for what purpose, on whose authority"}}),
        custody};
}

Command addendumCommand() {
    return {"addendum",
            "BUNDLE CASE",
            "what another expert assumes otherwise, signed by them",
            "Adds a case that was changed, with its runs, to a sealed bundle. What was sealed stays; each difference is listed.",
            withSigner({{"--by", "NAME", false, "who makes it"},
                        {"--note", "TEXT", false, "why it is assumed otherwise"},
                        {"--runs", "RUN", true, "a run of the changed case"}}),
            addendum};
}

Command timeStampCommand() {
    return {
        "time-stamp",
        "BUNDLE",
        "request a time stamp for a sealed bundle, or add its answer",
        "Writes the request (RFC 3161) that a time-stamping service answers, or verifies an answer and puts it into the bundle. "
        "No network is used: send the request yourself.",
        {{"--request", "FILE", false, "write the request here (*.tsq)"},
         {"--answer", "FILE", false, "the answer of the service (*.tsr)"},
         longerBundleOption()},
        timeStamp};
}

}  // namespace rubble::cli
