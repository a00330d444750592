#include "io/seal/seal_record.h"

#include <nlohmann/json.hpp>

#include "io/case/journal.h"
#include "io/json/json_cursor.h"
#include "io/json/json_text.h"
#include "io/seal/seal_json.h"

namespace rubble::io {

using nlohmann::json;

namespace {

constexpr std::string_view recordFormat = "rubble-seal-record";
constexpr std::int64_t recordVersion = 1;

json valueOf(const std::string& text) {
    return text.empty() ? json() : json::parse(text, nullptr, false);
}

json addendumJson(const SealAddendum& addendum) {
    json differences = json::array(), inputs = json::array(), runs = json::array();
    for (const JournalChange& change : addendum.differences) {
        differences.push_back({{"place", change.place}, {"before", valueOf(change.before)}, {"after", valueOf(change.after)}});
    }
    for (const SealedRun& run : addendum.runs) {
        runs.push_back(sealedRunJson(run));
    }
    for (const SealedInput& input : addendum.inputs) {
        inputs.push_back(sealedInputJson(input));
    }
    return {
        {"note", addendum.note}, {"case", addendum.casePlace}, {"differences", differences}, {"inputs", inputs}, {"runs", runs}};
}

SealAddendum addendumFrom(const JsonCursor& object) {
    object.allowOnly({"note", "case", "differences", "inputs", "runs"});
    SealAddendum addendum{object["note"].text(), object["case"].text(), {}, {}, {}};
    if (!isBagPlace(addendum.casePlace)) {
        object["case"].fail("a place in the bag");
    }
    for (const JsonCursor& row : object["differences"].elements()) {
        row.allowOnly({"place", "before", "after"});
        const auto text = [&](const char* key) { return row[key].value().is_null() ? std::string() : jsonLine(row[key].value()); };
        addendum.differences.push_back({row["place"].text(), text("before"), text("after")});
    }
    for (const JsonCursor& row : object["inputs"].elements()) {
        addendum.inputs.push_back(sealedInputFrom(row));
    }
    for (const JsonCursor& row : object["runs"].elements()) {
        addendum.runs.push_back(sealedRunFrom(row));
    }
    return addendum;
}

CustodyEntry custodyFrom(const JsonCursor& object) {
    object.allowOnly({"received_from", "received_by", "where", "why", "bundle_sha256"});
    return {object["received_from"].text(), object["received_by"].text(), object["where"].text(), object["why"].text(),
            object["bundle_sha256"].text()};
}

}  // namespace

std::string recordFolder(std::int64_t number, bool isAddendum) {
    std::string figures = std::to_string(number);
    figures.insert(0, figures.size() < 4 ? 4 - figures.size() : 0, '0');
    return bag::records + figures + (isAddendum ? "-addendum/" : "-custody/");
}

std::vector<JournalChange> assumptionChanges(const std::string& sealed, const std::string& sealedName, const std::string& theirs,
                                             const std::string& theirsName) {
    std::vector<JournalChange> changes =
        placeChanges(casePlaces(parseJson(sealed, sealedName)), casePlaces(parseJson(theirs, theirsName)));
    std::erase_if(changes, [](const JournalChange& change) {
        return change.place.starts_with("inputs/") && change.place.ends_with("/path");
    });
    for (JournalChange& change : changes) {
        for (std::string* value : {&change.before, &change.after}) {
            *value = *value == "null" ? "" : *value;
        }
    }
    return changes;
}

std::string recordText(const SealRecord& record) {
    json object = {{"format", recordFormat}, {"version", recordVersion}, {"number", record.number}, {"when", record.when},
                   {"by", record.by},        {"before", record.before},  {"seal", record.seal},     {"key_sha256", record.signer},
                   {"files", record.files}};
    if (record.isAddendum) {
        object["addendum"] = addendumJson(record.addendum);
    } else {
        const CustodyEntry& custody = record.custody;
        object["custody"] = {{"received_from", custody.from},
                             {"received_by", custody.to},
                             {"where", custody.where},
                             {"why", custody.why},
                             {"bundle_sha256", custody.bundleSha256}};
    }
    return jsonText(object);
}

SealRecord recordFrom(const std::string& text, const std::string& name) {
    const json document = parseJson(text, name);
    const JsonCursor top(document, name);
    top.allowOnly({"format", "version", "number", "when", "by", "before", "seal", "key_sha256", "files", "addendum", "custody"});
    if (top["format"].text() != recordFormat) {
        top["format"].fail("rubble-seal-record");
    }
    if (top["version"].integer() != recordVersion) {
        top["version"].refuse("it is of another version of the format", "Open it with the program that wrote it, or a newer one.");
    }
    SealRecord record;
    record.number = top["number"].integer();
    record.isAddendum = top.has("addendum");
    record.when = top["when"].text();
    record.by = top["by"].text();
    record.before = top["before"].text();
    record.seal = top["seal"].text();
    record.signer = top["key_sha256"].text();
    for (const auto& [place, digest] : top["files"].members()) {
        record.files[place] = digest.text();
    }
    if (record.isAddendum) {
        record.addendum = addendumFrom(top["addendum"]);
    } else {
        record.custody = custodyFrom(top["custody"]);
    }
    return record;
}

}  // namespace rubble::io
