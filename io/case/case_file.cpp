#include "io/case/case_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "core/scenario/body_scenario.h"
#include "io/base/files.h"
#include "io/case/journal.h"
#include "io/fe/bodies/bodies_reader.h"
#include "io/fe/bodies/body_table.h"
#include "io/fe/fe_format.h"
#include "io/json/camera_key_json.h"
#include "io/json/case_migrations.h"
#include "io/json/ensemble_json.h"
#include "io/json/evidence_settings_json.h"
#include "io/json/json_cursor.h"
#include "io/json/photograph_json.h"
#include "io/json/registration_json.h"
#include "io/json/scenario_json.h"
#include "io/json/scope_json.h"
#include "io/json/site_json.h"
#include "io/site/input_files.h"

namespace rubble::io {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::string_view formatName = "rubble-case";
// No case comes near this; a larger file is something else and is not read into memory.
constexpr std::uintmax_t sizeLimit = std::uintmax_t{64} << 20;

constexpr std::array<std::pair<InputRole, std::string_view>, 6> roleNames{{
    {InputRole::Fe, "fe"},
    {InputRole::Terrain, "terrain"},
    {InputRole::Photograph, "photograph"},
    {InputRole::Survey, "survey"},
    {InputRole::Orthophoto, "orthophoto"},
    {InputRole::Surroundings, "surroundings"},
}};

std::string roleName(InputRole role) {
    return std::string(
        std::find_if(roleNames.begin(), roleNames.end(), [role](const auto& entry) { return entry.first == role; })->second);
}

InputRole roleFrom(const JsonCursor& cursor) {
    const std::string name = cursor.text();
    for (const auto& [role, known] : roleNames) {
        if (known == name) {
            return role;
        }
    }
    cursor.fail("fe, terrain, photograph, survey, orthophoto or surroundings");
}

bool isSha256(const std::string& text) {
    return text.empty() || (text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos);
}

// What is wrong with the ids of a case and where; an empty reason if nothing is.
struct Flaw {
    std::string place;
    std::string reason;
};

Flaw flawOf(const Case& theCase) {
    if (!(theCase.frame.metresPerUnit > 0.0) || !std::isfinite(theCase.frame.metresPerUnit)) {
        return {"/frame/metres_per_unit", "the unit must be a number above zero"};
    }
    std::set<std::string> feInputs;
    std::set<std::string> ids;
    for (std::size_t i = 0; i < theCase.inputs.size(); ++i) {
        const CaseInput& input = theCase.inputs[i];
        if (input.id.empty() || !ids.insert(input.id).second) {
            return {"/inputs/" + std::to_string(i) + "/id", "an id must not be empty and must be the only one of its kind"};
        }
        if (input.path.empty()) {
            return {"/inputs/" + std::to_string(i) + "/path", "an input needs a path"};
        }
        if (!isSha256(input.sha256)) {
            return {"/inputs/" + std::to_string(i) + "/sha256", "a SHA-256 has 64 lower-case hexadecimal digits"};
        }
        if (input.role == InputRole::Fe) {
            feInputs.insert(input.id);
        }
    }
    std::set<std::string> scenarios;
    for (std::size_t i = 0; i < theCase.scenarios.size(); ++i) {
        const CaseScenario& scenario = theCase.scenarios[i];
        const std::string place = "/scenarios/" + std::to_string(i);
        if (scenario.id.empty() || !scenarios.insert(scenario.id).second) {
            return {place + "/id", "an id must not be empty and must be the only one of its kind"};
        }
        if (!scenario.feInput.empty() && !feInputs.contains(scenario.feInput)) {
            return {place + "/fe_input", "there is no FE input \"" + scenario.feInput + "\""};
        }
    }
    std::set<std::string> photographs;
    for (std::size_t i = 0; i < theCase.photographs.size(); ++i) {
        const std::string& input = theCase.photographs[i].input;
        const bool isFile = std::any_of(theCase.inputs.begin(), theCase.inputs.end(), [&](const CaseInput& each) {
            return each.id == input && each.role == InputRole::Photograph;
        });
        if (!isFile || !photographs.insert(input).second) {
            return {"/photographs/" + std::to_string(i) + "/input",
                    "it must name a photograph among the inputs that no other names"};
        }
    }
    if (!theCase.activeScenario.empty() && !scenarios.contains(theCase.activeScenario)) {
        return {"/active_scenario", "there is no scenario \"" + theCase.activeScenario + "\""};
    }
    return {};
}

json inputJson(const CaseInput& input) {
    json object{{"id", input.id}, {"role", roleName(input.role)}, {"path", input.path}, {"sha256", input.sha256}};
    if (input.showsFallen) {
        object["shows_fallen"] = *input.showsFallen;
    }
    if (!input.scope.area.empty()) {
        object["area_m"] = outlineJson(input.scope.area);
    }
    if (!input.scope.leftOut.empty()) {
        object["left_out_m"] = outlineJson(input.scope.leftOut);
    }
    if (input.offset) {
        object["offset_m"] = jsonVector(*input.offset);
    }
    if (input.noise) {
        object["noise_m"] = jsonNumber(*input.noise);
    }
    if (input.groundNoise) {
        object["ground_noise_m"] = jsonNumber(*input.groundNoise);
    }
    if (input.offsetError) {
        object["offset_error_m"] = jsonNumber(*input.offsetError);
    }
    if (input.registration) {
        object["registration"] = registrationJson(*input.registration);
    }
    if (!input.taken.empty()) {
        object["taken"] = input.taken;
    }
    if (input.before) {
        object["before_collapse"] = true;
    }
    if (input.instant) {
        object["instant_s"] = jsonNumber(*input.instant);
    }
    putCloudRequest(object, input.read);
    if (input.kind) {
        object["holds"] = std::string(surveyKindNames[static_cast<std::size_t>(*input.kind)]);
    }
    if (input.held != PointsHeld::Section) {
        object["held_as"] = std::string(pointsHeldNames[static_cast<std::size_t>(input.held)]);
    }
    for (const Vec3& scanner : input.scanners) {
        object["scanners_m"].push_back(jsonVector(scanner));
    }
    return object;
}

SurveyKind kindFrom(const JsonCursor& value) {
    const auto found = std::find(surveyKindNames.begin(), surveyKindNames.end(), value.text());
    if (found == surveyKindNames.end()) {
        value.fail("heights, cloud, outline or points");
    }
    return static_cast<SurveyKind>(found - surveyKindNames.begin());
}

PointsHeld heldFrom(const JsonCursor& value) {
    const auto found = std::find(pointsHeldNames.begin(), pointsHeldNames.end(), value.text());
    if (found == pointsHeldNames.end()) {
        value.fail("section, outline or control");
    }
    return static_cast<PointsHeld>(found - pointsHeldNames.begin());
}

std::optional<double> noiseFrom(const JsonCursor& object, std::string_view key) {
    if (!object.has(key)) {
        return {};
    }
    const double noise = object[key].number();
    if (noise < 0.0) {
        object[key].fail("metres, not below zero");
    }
    return noise;
}

CaseInput inputFrom(const JsonCursor& object) {
    object.allowOnly({"id",         "role",    "path",           "sha256",         "shows_fallen", "offset_m",  "area_m",
                      "left_out_m", "noise_m", "ground_noise_m", "offset_error_m", "registration", "taken",     "before_collapse",
                      "instant_s",  "crs",     "columns",        "holds",          "held_as",      "scanners_m"});
    CaseInput input{object["id"].text(), roleFrom(object["role"]), object["path"].text(), object["sha256"].text()};
    if (object.has("shows_fallen")) {
        input.showsFallen = object["shows_fallen"].flag();
    }
    if (object.has("offset_m")) {
        input.offset = object["offset_m"].vector();
    }
    if (object.has("area_m")) {
        input.scope.area = outlineFromJson(object["area_m"]);
    }
    if (object.has("left_out_m")) {
        input.scope.leftOut = outlineFromJson(object["left_out_m"]);
    }
    input.noise = noiseFrom(object, "noise_m");
    input.groundNoise = noiseFrom(object, "ground_noise_m");
    input.offsetError = noiseFrom(object, "offset_error_m");
    if (object.has("registration")) {
        input.registration = registrationFromJson(object["registration"]);
    }
    if (object.has("taken")) {
        input.taken = clockTimeFromJson(object["taken"]);
    }
    input.before = object.has("before_collapse") && object["before_collapse"].flag();
    if (object.has("instant_s")) {
        input.instant = object["instant_s"].number();
    }
    input.read = cloudRequestFromJson(object);
    if (object.has("holds")) {
        input.kind = kindFrom(object["holds"]);
    }
    if (object.has("held_as")) {
        input.held = heldFrom(object["held_as"]);
    }
    if (object.has("scanners_m")) {
        for (const JsonCursor& scanner : object["scanners_m"].elements()) {
            input.scanners.push_back(scanner.vector());
        }
    }
    return input;
}

json caseJson(const Case& theCase) {
    json inputs = json::array();
    for (const CaseInput& input : theCase.inputs) {
        inputs.push_back(inputJson(input));
    }
    json scenarios = json::array();
    for (const CaseScenario& scenario : theCase.scenarios) {
        json entry = scenarioJson(scenario.scenario);
        entry["id"] = scenario.id;
        entry["name"] = scenario.name;
        entry["note"] = scenario.note;
        entry["fe_input"] = scenario.feInput;
        scenarios.push_back(std::move(entry));
    }
    json bookmarks = json::array();
    for (const Bookmark& bookmark : theCase.bookmarks) {
        bookmarks.push_back({{"time", bookmark.time}, {"note", bookmark.note}});
    }
    json object{{"format", formatName},
                {"version", caseVersion},
                {"title", theCase.title},
                {"frame", frameJson(theCase.frame)},
                {"inputs", std::move(inputs)},
                {"scenarios", std::move(scenarios)},
                {"active_scenario", theCase.activeScenario},
                {"bookmarks", std::move(bookmarks)},
                {"photographs", photographsJson(theCase.photographs)},
                {"ensemble", ensembleJson(theCase.ensemble)},
                {"journal", journalJson(theCase.journal)}};
    if (!theCase.cameraKeys.empty()) {
        object["camera_keys"] = cameraKeysJson(theCase.cameraKeys);
    }
    if (!(theCase.evidence == EvidenceSettings())) {
        object["evidence"] = evidenceSettingsJson(theCase.evidence);
    }
    if (!theCase.removals.empty()) {
        object["removals"] = removalsJson(theCase.removals);
    }
    if (!(theCase.site == Site())) {
        object["site"] = siteJson(theCase.site);
    }
    return object;
}

Case caseFromJson(const JsonCursor& top) {
    top.allowOnly({"format", "version", "title", "frame", "inputs", "scenarios", "active_scenario", "bookmarks", "camera_keys",
                   "photographs", "removals", "site", "ensemble", "evidence", "journal"});
    Case theCase;
    theCase.title = top["title"].text();
    theCase.frame = frameFromJson(top["frame"]);
    for (const JsonCursor& input : top["inputs"].elements()) {
        theCase.inputs.push_back(inputFrom(input));
    }
    for (const JsonCursor& entry : top["scenarios"].elements()) {
        entry.allowOnly({"id", "name", "note", "fe_input", "settings", "regrouping"});
        theCase.scenarios.push_back(
            {entry["id"].text(), entry["name"].text(), entry["note"].text(), entry["fe_input"].text(), scenarioFromJson(entry)});
    }
    theCase.activeScenario = top["active_scenario"].text();
    for (const JsonCursor& bookmark : top["bookmarks"].elements()) {
        bookmark.allowOnly({"time", "note"});
        theCase.bookmarks.push_back({bookmark["time"].number(), bookmark["note"].text()});
    }
    if (top.has("camera_keys")) {
        theCase.cameraKeys = cameraKeysFromJson(top["camera_keys"]);
    }
    theCase.photographs = photographsFromJson(top["photographs"]);
    if (top.has("evidence")) {
        theCase.evidence = evidenceSettingsFromJson(top["evidence"]);
    }
    if (top.has("removals")) {
        theCase.removals = removalsFromJson(top["removals"]);
    }
    if (top.has("site")) {
        theCase.site = siteFromJson(top["site"]);
    }
    theCase.ensemble = ensembleFromJson(top["ensemble"]);
    theCase.journal = journalFromJson(top["journal"]);
    return theCase;
}

// The version decides how everything else is read, so it is looked at before anything else.
void bringUpToDate(json& document, const std::string& file) {
    const JsonCursor top(document, file);
    const auto format = document.is_object() ? document.find("format") : document.end();
    if (!document.is_object() || format == document.end() || *format != formatName) {
        throw ParseError(Message{"io.case.not_a_case", "{0} is JSON, but not a case of Rubble", {file}},
                         Message{"io.case.not_a_case.remedy", "Open a *.rubble file or an FE result.", {}});
    }
    const std::int64_t version = top["version"].integer();
    if (version > caseVersion) {
        throw ParseError(Message{"io.case.newer",
                                 "{0} was written by a newer Rubble: case version {1}, this program reads up to {2}",
                                 {file, version, caseVersion}},
                         Message{"io.case.newer.remedy", "Open it with a newer Rubble; the file is unchanged.", {}});
    }
    if (version < 1 || !migrateCase(document, static_cast<int>(version), caseVersion, caseMigrations())) {
        top["version"].fail("a case version from 1 to " + std::to_string(caseVersion));
    }
}

}  // namespace

bool isCaseFile(const std::string& path) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
        return false;
    }
    std::ifstream in(path, std::ios::binary);
    if (in.peek() == 0xEF) {
        in.ignore(3);
    }
    in >> std::ws;
    if (in.peek() != '{') {
        return false;
    }
    // A list of files that ParaView writes (.vtu.series) is JSON as well, and an FE result.
    std::string head(4096, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head.find("\"file-series-version\"") == std::string::npos;
}

Case caseFromText(const std::string& text, const std::string& nameForErrors) {
    json document = parseJson(text, nameForErrors);
    bringUpToDate(document, nameForErrors);
    const JsonCursor top(document, nameForErrors);
    Case theCase = caseFromJson(top);
    if (const Flaw flaw = flawOf(theCase); !flaw.reason.empty()) {
        const JsonCursor place(document, nameForErrors, flaw.place);
        place.refuse(flaw.reason, "Correct it in the file, or take the last good copy.");
    }
    return theCase;
}

std::string caseText(const Case& theCase) {
    if (const Flaw flaw = flawOf(theCase); !flaw.reason.empty()) {
        throw UsageError(Message{"io.case.flawed", "The case cannot be saved: at {0}: {1}", {flaw.place, flaw.reason}},
                         Message{"io.case.flawed.remedy", "Correct the inputs and scenarios of the case.", {}});
    }
    try {
        return caseJson(theCase).dump(2) + "\n";
    } catch (const json::type_error&) {
        throw UsageError(Message{"io.case.not_utf8", "The case cannot be saved: a name or a path in it is not valid UTF-8", {}},
                         Message{"io.case.not_utf8.remedy", "Rename the file or the component in question.", {}});
    }
}

Case loadCase(const std::string& path) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) {
        failToRead(path);
    }
    if (size > sizeLimit) {
        throw ParseError(Message{"io.case.too_large", "{0} is too large for a case", {path}},
                         Message{"io.case.not_a_case.remedy", "Open a *.rubble file or an FE result.", {}});
    }
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in || in.bad()) {
        failToRead(path);
    }
    Case theCase = caseFromText(text.str(), path);
    noteOutsideChanges(theCase.journal, parseJson(text.str(), path));
    return theCase;
}

Case saveCase(const std::string& path, const Case& theCase) {
    Case complete = theCase;
    for (CaseInput& input : complete.inputs) {
        std::error_code ignored;
        const std::string file = inputPath(path, input);
        if (input.sha256.empty() && fs::is_regular_file(file, ignored)) {
            input.sha256 = digestOfInput(file, input.role, Execution()).sha256;
        }
    }
    // What cannot be saved is refused before anything is written of it.
    caseText(complete);
    continueJournal(complete.journal, caseJson(complete));
    const std::string text = caseText(complete);
    writeAtomically(path, [&text](std::ostream& out) { out << text; });
    return complete;
}

namespace {

/// A table of bodies says itself how it is to be simulated. One that cannot be read is refused where it is opened.
void prepareForTable(Scenario& scenario, const std::string& fePath) {
    try {
        if (recognisesBodies(readHead(fePath))) {
            prepareForBodies(scenario, readBodyTable(fePath).bodies);
        }
    } catch (const Error&) {
        return;
    }
}

}  // namespace

Case caseForFe(const std::string& fePath, const std::string& casePath) {
    const fs::path folder = fs::absolute(casePath.empty() ? fs::path("case") : fs::path(casePath)).parent_path();
    const fs::path relative = fs::absolute(fePath).lexically_normal().lexically_relative(folder.lexically_normal());
    Case theCase;
    theCase.title = fs::path(fePath).stem().string();
    theCase.inputs.push_back({"fe-1", InputRole::Fe, relative.generic_string(), {}});
    theCase.scenarios.push_back({"scenario-1", "As computed", {}, "fe-1", Scenario{}});
    prepareForTable(theCase.scenarios.front().scenario, fePath);
    theCase.activeScenario = "scenario-1";
    return theCase;
}

std::string inputPath(const std::string& casePath, const CaseInput& input) {
    return (fs::absolute(casePath.empty() ? fs::path("case") : fs::path(casePath)).parent_path() / input.path)
        .lexically_normal()
        .string();
}

}  // namespace rubble::io
