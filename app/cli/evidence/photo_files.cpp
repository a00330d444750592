#include "app/cli/evidence/photo_files.h"

#include <optional>
#include <string>
#include <vector>

#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/case/case_photographs.h"
#include "io/site/photograph_file.h"

namespace rubble::cli {

namespace {

std::vector<std::string> operandsFrom(const Arguments& arguments, std::size_t first) {
    std::vector<std::string> list;
    for (std::size_t i = first; !arguments.operand(i).empty(); ++i) {
        list.push_back(arguments.operand(i));
    }
    return list;
}

void checkOptions(const Arguments& arguments, std::string_view verb) {
    for (const Option& option : arguments.command().options) {
        if (option.name != "--json" && option.name != "--help" && arguments.has(option.name)) {
            throw UsageError({"cli.photo_option", "rubble-cli photo {0} cannot use {1}.", {verb, option.name}},
                             {"cli.photo_option.remedy", "It takes files and --json.", {}});
        }
    }
}

Json numberOrNull(const std::optional<double>& number) {
    return number ? Json(*number) : Json();
}

std::string unknownOr(const std::string& text) {
    return text.empty() ? "unknown" : text;
}

void printFacts(std::ostream& out, const std::string& path, const io::PhotographFile& file) {
    const PhotoFacts& facts = file.facts;
    const auto length = [](const std::optional<double>& number, std::string_view unit) {
        return number ? englishNumber(*number) + std::string(unit) : "unknown";
    };
    printHeading(out, "Photograph " + path);
    FactList list;
    list.add("size",
             englishInteger(facts.width) + " x " + englishInteger(facts.height) + " px" +
                 (facts.orientation == 1 ? "" : ", turned upright (orientation " + std::to_string(facts.orientation) + ")"));
    list.add("camera", unknownOr(facts.camera));
    list.add("taken", facts.taken.empty() ? "unknown" : facts.taken + " by the clock of the camera");
    list.add("focal length", length(facts.focalLength, " mm") + "; as on 36 x 24 mm: " + length(facts.focalLength35, " mm") +
                                 "; in pixels: " + length(focalFrom(facts), " px"));
    list.add("position", facts.position
                             ? std::to_string((*facts.position)[0]) + " N, " + std::to_string((*facts.position)[1]) + " E"
                             : "unknown");
    list.add("altitude", length(facts.altitude, " m"));
    list.add("SHA-256", file.sha256);
    list.print(out);
    printFindings(out, file.findings);
}

Json fileJson(const std::string& path, const io::PhotographFile& file) {
    return {
        {"file", path}, {"sha256", file.sha256}, {"facts", photoFactsJson(file.facts)}, {"warnings", findingsJson(file.findings)}};
}

}  // namespace

Json photoFactsJson(const PhotoFacts& facts) {
    Json object;
    object["width_px"] = facts.width;
    object["height_px"] = facts.height;
    object["orientation"] = facts.orientation;
    object["recorded_px"] = facts.recorded ? Json{(*facts.recorded)[0], (*facts.recorded)[1]} : Json();
    object["focal_length_mm"] = numberOrNull(facts.focalLength);
    object["focal_length_35_mm"] = numberOrNull(facts.focalLength35);
    object["focal_px"] = numberOrNull(focalFrom(facts));
    object["camera"] = facts.camera;
    const std::string taken = clockTime(facts.taken);
    object["taken"] = taken.empty() ? Json() : Json(taken);
    object["position_deg"] = facts.position ? Json{(*facts.position)[0], (*facts.position)[1]} : Json();
    object["altitude_m"] = numberOrNull(facts.altitude);
    return object;
}

ExitCode addPhotos(const Arguments& arguments, Session& session) {
    checkOptions(arguments, "add");
    const std::string& casePath = arguments.operand(1);
    const std::vector<std::string> paths = operandsFrom(arguments, 2);
    if (paths.empty()) {
        throw UsageError({"cli.photo_add", "rubble-cli photo add needs a case and photographs.", {}},
                         {"cli.photo_add.remedy", "Write rubble-cli photo add CASE PHOTO...", {}});
    }
    Case theCase = io::loadCase(casePath);
    Json object{{"case", casePath}, {"photographs", Json::array()}};
    Findings findings;
    std::string told;
    for (const std::string& path : paths) {
        session.execution().check();
        const io::PhotographFile file = io::readPhotograph(path);
        const auto id = io::addPhotograph(theCase, casePath, path, file.facts, file.sha256);
        for (const Finding& finding : file.findings.list()) {
            findings.add(finding.what, finding.remedy, path, finding.count);
        }
        Json entry = fileJson(path, file);
        entry["photograph"] = id ? Json(*id) : Json();
        object["photographs"].push_back(entry);
        told += path + (id ? ": added as " + *id : ": among the photographs already") + "\n";
    }
    io::saveCase(casePath, theCase);
    if (arguments.json()) {
        object["warnings"] = findingsJson(findings);
        printJson(session, object);
    } else {
        session.out() << told;
        printFindings(session.out(), findings);
    }
    return ExitCode::Ok;
}

ExitCode tellPhotoFacts(const Arguments& arguments, Session& session) {
    checkOptions(arguments, "facts");
    const std::vector<std::string> paths = operandsFrom(arguments, 1);
    if (paths.empty()) {
        throw UsageError({"cli.photo_facts", "rubble-cli photo facts needs a photograph.", {}},
                         {"cli.photo_facts.remedy", "Write rubble-cli photo facts PHOTO...", {}});
    }
    Json object{{"photographs", Json::array()}};
    for (const std::string& path : paths) {
        session.execution().check();
        const io::PhotographFile file = io::readPhotograph(path);
        if (arguments.json()) {
            object["photographs"].push_back(fileJson(path, file));
        } else {
            printFacts(session.out(), path, file);
        }
    }
    if (arguments.json()) {
        printJson(session, object);
    }
    return ExitCode::Ok;
}

}  // namespace rubble::cli
