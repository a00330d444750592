#include "io/seal/seal_statement.h"

#include <nlohmann/json.hpp>

#include "io/json/findings_json.h"
#include "io/json/json_cursor.h"
#include "io/json/json_text.h"
#include "io/seal/seal_json.h"

namespace rubble::io {

using nlohmann::json;

namespace {

constexpr std::string_view sealFormat = "rubble-seal";
constexpr std::int64_t sealVersion = 1;

std::string placeIn(const JsonCursor& cursor) {
    const std::string place = cursor.text();
    if (!isBagPlace(place)) {
        cursor.fail("a place in the bag");
    }
    return place;
}

}  // namespace

json sealedInputJson(const SealedInput& input) {
    json row = {{"id", input.id}, {"path", input.path}, {"sha256", input.sha256}, {"files", input.files}};
    if (!input.others.empty()) {
        row["others"] = input.others;
    }
    return row;
}

SealedInput sealedInputFrom(const JsonCursor& row) {
    row.allowOnly({"id", "path", "sha256", "files", "others"});
    SealedInput input{row["id"].text(), row["path"].text(), row["sha256"].text(), {}};
    for (const JsonCursor& file : row["files"].elements()) {
        input.files.push_back(placeIn(file));
    }
    if (row.has("others")) {
        for (const auto& [name, digest] : row["others"].members()) {
            input.others[name] = digest.text();
        }
    }
    return input;
}

json sealedRunJson(const SealedRun& run) {
    json row = {{"file", run.place},
                {"sha256", run.sha256},
                {"scenario", run.scenario},
                {"fingerprint", run.fingerprint},
                {"trajectory_hash", run.trajectoryHash},
                {"build", run.build}};
    for (const OtherSetting& setting : run.otherSettings) {
        row["other_settings"].push_back({{"key", setting.key}, {"run", setting.run}, {"case", setting.ofCase}});
    }
    for (const Message& caution : run.cautions) {
        row["cautions"].push_back(messageJson(caution));
    }
    return row;
}

SealedRun sealedRunFrom(const JsonCursor& row) {
    row.allowOnly({"file", "sha256", "scenario", "fingerprint", "trajectory_hash", "build", "other_settings", "cautions"});
    SealedRun run{placeIn(row["file"]),      row["sha256"].text(),          row["scenario"].text(),
                  row["fingerprint"].text(), row["trajectory_hash"].text(), row["build"].text()};
    if (row.has("other_settings")) {
        for (const JsonCursor& setting : row["other_settings"].elements()) {
            run.otherSettings.push_back({setting["key"].text(), setting["run"].text(), setting["case"].text()});
        }
    }
    if (row.has("cautions")) {
        for (const JsonCursor& caution : row["cautions"].elements()) {
            run.cautions.push_back(messageFromJson(caution));
        }
    }
    return run;
}

std::string statementText(const SealStatement& statement) {
    json inputs = json::array(), runs = json::array();
    for (const SealedInput& input : statement.inputs) {
        inputs.push_back(sealedInputJson(input));
    }
    for (const SealedRun& run : statement.runs) {
        runs.push_back(sealedRunJson(run));
    }
    return jsonText({{"format", sealFormat},
                     {"version", sealVersion},
                     {"sealed_at", statement.sealedAt},
                     {"sealed_by", statement.sealedBy},
                     {"note", statement.note},
                     {"case",
                      {{"title", statement.title},
                       {"file", statement.casePlace},
                       {"sha256", statement.caseSha256},
                       {"journal_entries", statement.journalEntries},
                       {"journal_head", statement.journalHead}}},
                     {"manifest", {{"sha256", statement.manifestSha256}, {"files", statement.files}, {"bytes", statement.bytes}}},
                     {"tag_files", statement.tags},
                     {"inputs", inputs},
                     {"runs", runs},
                     {"program", {{"version", statement.version}, {"build", statement.build}}},
                     {"signer", {{"key_sha256", statement.signer}, {"subject", statement.subject}}},
                     {"time_stamp_asked", statement.stampAsked}});
}

SealStatement statementFrom(const std::string& text, const std::string& name) {
    const json document = parseJson(text, name);
    const JsonCursor top(document, name);
    top.allowOnly({"format", "version", "sealed_at", "sealed_by", "note", "case", "manifest", "tag_files", "inputs", "runs",
                   "program", "signer", "time_stamp_asked"});
    if (top["format"].text() != sealFormat) {
        top["format"].fail("rubble-seal");
    }
    if (top["version"].integer() != sealVersion) {
        top["version"].refuse("it is of another version of the format", "Open it with the program that sealed it, or a newer one.");
    }
    SealStatement statement;
    statement.sealedAt = top["sealed_at"].text();
    statement.sealedBy = top["sealed_by"].text();
    statement.note = top["note"].text();
    const JsonCursor theCase = top["case"];
    statement.title = theCase["title"].text();
    statement.casePlace = placeIn(theCase["file"]);
    statement.caseSha256 = theCase["sha256"].text();
    statement.journalEntries = theCase["journal_entries"].integer();
    statement.journalHead = theCase["journal_head"].text();
    statement.manifestSha256 = top["manifest"]["sha256"].text();
    statement.files = top["manifest"]["files"].integer();
    statement.bytes = top["manifest"]["bytes"].integer();
    for (const auto& [place, digest] : top["tag_files"].members()) {
        statement.tags[place] = digest.text();
    }
    for (const JsonCursor& row : top["inputs"].elements()) {
        statement.inputs.push_back(sealedInputFrom(row));
    }
    for (const JsonCursor& row : top["runs"].elements()) {
        statement.runs.push_back(sealedRunFrom(row));
    }
    statement.version = top["program"]["version"].text();
    statement.build = top["program"]["build"].text();
    statement.signer = top["signer"]["key_sha256"].text();
    statement.subject = top["signer"]["subject"].text();
    statement.stampAsked = top["time_stamp_asked"].flag();
    return statement;
}

}  // namespace rubble::io
