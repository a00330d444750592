#include "app/cli/exports/seal_options.h"

#include "app/cli/frame/text_output.h"
#include "app/cli/frame/text_table.h"
#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::cli {

std::vector<Option> signerOptions() {
    return {{"--key", "FILE", false, "private key of whoever signs, PEM: Ed25519, RSA or elliptic curve"},
            {"--certificate", "FILE", false, "X.509 certificate of that key, PEM, with those above it"},
            {"--passphrase-file", "FILE", false, "file whose first line is the passphrase of the key"}};
}

io::SignerFiles signerOf(const Arguments& arguments) {
    io::SignerFiles files{arguments.value("--key").value_or(""), arguments.value("--certificate").value_or(""), {}};
    if (const auto path = arguments.value("--passphrase-file")) {
        const std::optional<std::string> text = io::contentOf(*path);
        if (!text) {
            throw WorldError({"cli.passphrase", "The passphrase cannot be read from {0}.", {*path}},
                             {"cli.passphrase.remedy", "Check that the file exists and that you may read it.", {}});
        }
        files.passphrase = text->substr(0, text->find_first_of("\r\n"));
    }
    return files;
}

std::string longerBundle(const Arguments& arguments) {
    return arguments.value("--out").value_or(arguments.operand());
}

Option longerBundleOption() {
    return {"--out", "FILE", false, "where the longer bundle is written (default: in place of the bundle)"};
}

Json faultsJson(const std::vector<io::SealFault>& faults) {
    Json list = Json::array();
    for (const io::SealFault& fault : faults) {
        list.push_back({{"place", fault.place}, {"what", englishText(fault.what)}});
    }
    return list;
}

Json recordsJson(const io::SealCheck& check) {
    Json list = Json::array();
    for (const io::CheckedRecord& checked : check.records) {
        const io::SealRecord& record = checked.record;
        Json row;
        row["number"] = record.number;
        row["kind"] = record.isAddendum ? "addendum" : "custody";
        row["when"] = record.when;
        row["by"] = record.by;
        row["sha256"] = checked.sha256;
        row["key_sha256"] = record.signer;
        if (record.isAddendum) {
            row["note"] = record.addendum.note;
            row["differences"] = Json::array();
            for (const JournalChange& change : record.addendum.differences) {
                row["differences"].push_back({{"place", change.place}, {"before", change.before}, {"after", change.after}});
            }
        } else {
            row["received_from"] = record.custody.from;
            row["received_by"] = record.custody.to;
            row["where"] = record.custody.where;
            row["why"] = record.custody.why;
            row["bundle_sha256"] = record.custody.bundleSha256;
        }
        list.push_back(row);
    }
    return list;
}

void printRecords(std::ostream& out, const io::SealCheck& check) {
    for (const io::CheckedRecord& checked : check.records) {
        const io::SealRecord& record = checked.record;
        out << "  " << record.number << ". " << record.when << ' ';
        if (!record.isAddendum) {
            const io::CustodyEntry& custody = record.custody;
            out << custody.to << " received it from " << custody.from << (custody.where.empty() ? "" : ", " + custody.where)
                << (custody.why.empty() ? "" : ": " + custody.why) << '\n';
            out << "     SHA-256 of the bundle then  " << custody.bundleSha256 << '\n';
        } else {
            out << "addendum of " << record.by << (record.addendum.note.empty() ? "" : ": " + record.addendum.note) << '\n';
            for (const JournalChange& change : record.addendum.differences) {
                out << "     " << change.place << ": " << (change.before.empty() ? "nothing" : change.before) << " became "
                    << (change.after.empty() ? "nothing" : change.after) << '\n';
            }
        }
        out << "     SHA-256 of the entry  " << checked.sha256 << (record.signer.empty() ? "  (not signed)" : "") << '\n';
    }
}

}  // namespace rubble::cli
