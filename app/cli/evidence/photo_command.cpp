#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "app/cli/evidence/camera_output.h"
#include "app/cli/evidence/photo_files.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/evidence/evidence_list.h"
#include "core/evidence/photographs/confidence.h"
#include "core/evidence/photographs/photo_comparison.h"
#include "io/case/case_file.h"
#include "io/run/run_cautions.h"
#include "io/run/run_file.h"
#include "io/site/photograph_file.h"

namespace rubble::cli {

namespace {

/// One photograph of a case, and what comes of it.
struct Seen {
    const Photograph* photograph = nullptr;
    std::string path;
    bool unchanged = false;  // the file is the one that the case names
    std::optional<CameraMatch> match;
    std::optional<PhotoComparison> comparison;
    std::vector<Caution> cautions;
};

/// The run that debris is taken from, with what it was made of.
struct ComparedRun {
    std::shared_ptr<io::RunReader> reader;
    Inputs inputs;

    MappedRun mapped() const {
        return {inputs.fe.get(), reader.get(), reader->fragments(), reader->result(), inputs.terrain, reader->origin().scenario};
    }
};

const CaseInput& inputOf(const Case& theCase, const Photograph& photograph) {
    return *std::find_if(theCase.inputs.begin(), theCase.inputs.end(),
                         [&](const CaseInput& input) { return input.id == photograph.input; });
}

std::vector<const Photograph*> choose(const Case& theCase, const Arguments& arguments) {
    const auto wanted = arguments.value("--photograph");
    std::vector<const Photograph*> chosen;
    std::string names;
    for (const Photograph& photograph : theCase.photographs) {
        const std::string& path = inputOf(theCase, photograph).path;
        names += (names.empty() ? "" : ", ") + photograph.input + " (" + path + ")";
        if (!wanted || *wanted == photograph.input || *wanted == path) {
            chosen.push_back(&photograph);
        }
    }
    if (theCase.photographs.empty()) {
        throw UsageError({"cli.no_photographs", "{0} has no photographs.", {arguments.operand()}},
                         {"cli.no_photographs.remedy",
                          "Add them with rubble-cli photo add {0} PHOTO, or in the window under Evidence.",
                          {arguments.operand()}});
    }
    if (chosen.empty()) {
        throw UsageError({"cli.no_photograph", "{0} has no photograph {1}.", {arguments.operand(), *wanted}},
                         {"cli.no_photograph.remedy", "Its photographs: {0}.", {names}});
    }
    return chosen;
}

/// What is asked for, else as the case has it.
ComparisonSettings comparisonSettingsFrom(const Arguments& arguments, const Case& theCase) {
    ComparisonSettings settings = photographSettingsOf(theCase);
    settings.withFallen = parseOnOff(arguments, "--live", settings.withFallen);
    if (const auto cameras = arguments.value("--cameras")) {
        if (!parseNumber(*cameras, settings.cameras) || settings.cameras < 2 || settings.cameras > 10000) {
            throw wrongValue("--cameras", *cameras, "a whole number from 2 to 10000");
        }
    }
    return settings;
}

Seen look(const Case& theCase, const Photograph& photograph, const std::string& casePath, const ComparedRun* run,
          const ComparisonSettings& settings, Findings& findings, const Execution& execution) {
    const CaseInput& input = inputOf(theCase, photograph);
    Seen seen{&photograph, io::inputPath(casePath, input), false, std::nullopt, std::nullopt, {}};
    const auto find = [&](const Error& error) { findings.add(error.message(), error.remedy(), input.path); };
    try {
        const io::PhotographFile file = io::readPhotograph(seen.path);
        seen.unchanged = file.sha256 == input.sha256;
        if (!seen.unchanged) {
            findings.add({"photo.changed", "The photograph {0} is another file than the case names.", {input.path}},
                         {"photo.changed.remedy", "Put the file back, or add it as another photograph.", {}}, input.path);
        }
    } catch (const Error& error) {
        find(error);
    }
    try {
        seen.match = matchPhotograph(photograph, execution);
        for (const Finding& finding : seen.match->findings.list()) {
            findings.add(finding.what, finding.remedy, input.path, finding.count);
        }
        if (run != nullptr) {
            seen.comparison = compareRunWithPhoto(run->mapped(), photograph, *seen.match, settings, execution);
        }
    } catch (const UsageError& error) {
        find(error);
    }
    const std::optional<RunStanding> standing = run != nullptr ? std::optional(io::standingOf(*run->reader)) : std::nullopt;
    seen.cautions = photographCautions(photograph, seen.match ? &*seen.match : nullptr, standing ? &*standing : nullptr);
    return seen;
}

Json spreadJson(const SpreadNumber& number) {
    return {{"best", number.best}, {"mean", number.mean}, {"spread", number.spread}};
}

Json comparisonJson(const PhotoComparison& made) {
    Json object;
    object["time_s"] = made.time;
    object["fallen_structure"] = made.withFallen;
    object["iou"] = spreadJson(made.iou);
    object["iou_over_time"] = made.iouOverTime ? Json{(*made.iouOverTime)[0], (*made.iouOverTime)[1]} : Json();
    object["edge_distance_px"] = spreadJson(made.edgePixels);
    object["edge_distance_m"] = spreadJson(made.edgeMetres);
    object["distance_m"] = made.distance;
    object["pixel_m"] = made.pixelMetres;
    object["cameras"] = made.cameras;
    object["words"] = englishText(made.words);
    return object;
}

Json seenJson(const Seen& seen) {
    const Photograph& photograph = *seen.photograph;
    Json object;
    object["photograph"] = photograph.input;
    object["file"] = seen.path;
    object["unchanged"] = seen.unchanged;
    object["facts"] = photoFactsJson(photograph.facts);
    object["time_s"] = photograph.time ? Json(*photograph.time) : Json();
    object["time_uncertainty_s"] = photograph.timeUncertainty;
    object["masks"] = photograph.masks.size();
    object["match"] = seen.match ? matchJson(*seen.match, photograph.pairs) : Json();
    object["comparison"] = seen.comparison ? comparisonJson(*seen.comparison) : Json();
    object["cautions"] = cautionsJson(seen.cautions);
    return object;
}

std::string overCameras(const SpreadNumber& number, const std::string& unit, const char* none) {
    if (!std::isfinite(number.best)) {
        return none;
    }
    return englishNumber(roundedToSpread(number.best, number.spread).first) + unit + ", " + spreadText(number.mean, number.spread) +
           unit + " over the cameras that the match allows";
}

void printSeen(std::ostream& out, const Seen& seen) {
    const Photograph& photograph = *seen.photograph;
    printHeading(out, "Photograph " + photograph.input);
    FactList facts;
    facts.add("file", seen.path + (seen.unchanged ? ", as the case names it" : ""));
    facts.add("size", englishInteger(photograph.facts.width) + " x " + englishInteger(photograph.facts.height) + " px");
    const std::string taken = clockTime(photograph.facts.taken);
    facts.add("taken", taken.empty() ? "unknown" : taken + " by the clock of the camera");
    facts.add("shows", photograph.time ? englishNumber(*photograph.time) + " ± " + englishNumber(photograph.timeUncertainty) + " s"
                                       : "all at rest");
    facts.print(out);
    if (seen.match) {
        printMatch(out, *seen.match, photograph.pairs);
    }
    if (seen.comparison) {
        const PhotoComparison& made = *seen.comparison;
        FactList scores;
        scores.add("debris at", englishNumber(made.time) + " s, fallen live structure " + (made.withFallen ? "with it" : "apart"));
        scores.add("overlap", overCameras(made.iou, "", "none: neither silhouette lies in the picture"));
        if (made.iouOverTime) {
            scores.add("over the time", englishNumber((*made.iouOverTime)[0]) + " to " + englishNumber((*made.iouOverTime)[1]));
        }
        scores.add("edges apart", overCameras(made.edgePixels, " px", "not known: there are no two edges to compare"));
        if (std::isfinite(made.edgeMetres.best)) {
            scores.add("", overCameras(made.edgeMetres, " m", ""));
        }
        scores.print(out);
        out << englishText(made.words) << '\n';
    }
    printCautions(out, seen.cautions);
}

TextTable scoreTable(const std::vector<Seen>& list) {
    TextTable table({{"photograph", "photograph"},
                     {"RMS [px]", "rms_px"},
                     {"place within [m]", "place_radius_95_m"},
                     {"overlap", "iou"},
                     {"± ", "iou_spread"},
                     {"edges apart [m]", "edge_distance_m"},
                     {"± [m]", "edge_distance_spread_m"}});
    const double none = std::nan("");
    for (const Seen& seen : list) {
        const PhotoComparison* made = seen.comparison ? &*seen.comparison : nullptr;
        table.add({textCell(seen.photograph->input), numberCell(seen.match ? seen.match->rms : none),
                   numberCell(seen.match ? seen.match->placeRadius : none), numberCell(made != nullptr ? made->iou.best : none),
                   numberCell(made != nullptr ? made->iou.spread : none),
                   numberCell(made != nullptr ? made->edgeMetres.best : none),
                   numberCell(made != nullptr ? made->edgeMetres.spread : none)});
    }
    return table;
}

ExitCode photo(const Arguments& arguments, Session& session) {
    const std::string& path = arguments.operand();
    if (path == "add") {
        return addPhotos(arguments, session);
    }
    if (path == "facts") {
        return tellPhotoFacts(arguments, session);
    }
    if (!arguments.operand(1).empty()) {
        throw UsageError(
            {"cli.photo_one_case",
             "rubble-cli photo compares the photographs of one case, not \"{0}\" besides.",
             {arguments.operand(1)}},
            {"cli.photo_one_case.remedy", "Write photo add CASE PHOTO to add a photograph, photo facts PHOTO to look at one.", {}});
    }
    comparisonSettingsFrom(arguments, {});  // what is wrong is said before anything is read
    checkCsvPath(arguments, std::vector<std::string>{path});
    const Case theCase = io::loadCase(path);
    const ComparisonSettings settings = comparisonSettingsFrom(arguments, theCase);
    const std::vector<const Photograph*> chosen = choose(theCase, arguments);
    std::optional<ComparedRun> run;
    if (const auto runPath = arguments.value("--run")) {
        run.emplace();
        run->reader = io::openRun(*runPath);
        run->inputs = openInputsOfRun(*runPath, run->reader->origin(), arguments, session);
    }
    std::vector<Seen> list;
    Findings findings;
    for (const Photograph* photograph : chosen) {
        list.push_back(look(theCase, *photograph, path, run ? &*run : nullptr, settings, findings, session.execution()));
    }
    writeCsv(arguments, scoreTable(list));
    if (arguments.json()) {
        Json object;
        object["photographs"] = Json::array();
        for (const Seen& seen : list) {
            object["photographs"].push_back(seenJson(seen));
        }
        object["tainted"] = run ? Json(io::taintOf(*run->reader).tainted()) : Json();
        object["cautions"] = run ? cautionsOf(*run->reader) : Json::array();
        object["warnings"] = findingsJson(findings);
        printJson(session, object);
    } else {
        for (const Seen& seen : list) {
            printSeen(session.out(), seen);
        }
        printFindings(session.out(), findings);
    }
    if (run) {
        warnIfTainted(session, *arguments.value("--run"), io::taintOf(*run->reader));
    }
    const bool all = std::all_of(list.begin(), list.end(),
                                 [&](const Seen& seen) { return seen.unchanged && seen.match && (!run || seen.comparison); });
    return all ? ExitCode::Ok : ExitCode::Failed;
}

}  // namespace

Command photoCommand() {
    return {"photo",
            "[add|facts] CASE|PHOTO...",
            "photographs of a case: cameras, and how far the simulated debris agrees; adding them, and what a file says",
            "With add CASE PHOTO... photographs are added to the case file, as in the window; with facts PHOTO... it is told what "
            "files say "
            "of camera, time and place. Else it matches the camera of every photograph of a case. With --run, the silhouette of "
            "the simulated debris is held against the "
            "outline drawn on it; what the camera leaves open is carried into the score.",
            {{"--photograph", "ID", false, "only this one, by its id or file (default: all)"},
             {"--run", "FILE", false, "the run whose debris is compared"},
             {"--live", "on|off", false, "fallen live structure counts as debris (default: as the case has it, else on)"},
             {"--cameras", "N", false, "cameras drawn from the uncertainty of the match (default: 64)"},
             feOption(),
             runTerrainOption(),
             csvOption("write the scores, one row for each photograph")},
            photo};
}

}  // namespace rubble::cli
