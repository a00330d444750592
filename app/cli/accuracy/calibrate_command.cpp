#include <cmath>

#include "app/cli/accuracy/study_options.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/live_display.h"
#include "app/cli/frame/measure_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "core/analysis/accuracy/calibration.h"
#include "core/analysis/accuracy/calibration_table.h"
#include "core/analysis/accuracy/published_results.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/run/study_files.h"

namespace rubble::cli {

namespace {

constexpr int threadsMax = 1024;
constexpr std::array<PileKind, 2> piles{PileKind::Typical, PileKind::Worst};
constexpr std::array<std::pair<LiveLoad, std::string_view>, 3> loads{
    {{LiveLoad::Physics, "physics"}, {LiveLoad::Drawing, "drawing"}, {LiveLoad::Both, "live"}}};

std::vector<std::int64_t> parseBodies(const Arguments& arguments, std::vector<std::int64_t> otherwise) {
    if (const auto text = arguments.value("--bodies")) {
        otherwise.clear();
        for (const std::string& part : splitAtCommas(*text)) {
            std::int64_t number = 0;
            if (!parseNumber(part, number) || number < 1) {
                throw wrongValue("--bodies", part, "numbers of bodies, separated by commas");
            }
            otherwise.push_back(number);
        }
    }
    return otherwise;
}

CalibrationSettings parseSettings(const Arguments& arguments) {
    CalibrationSettings settings;
    settings.bodies = parseBodies(arguments, settings.bodies);
    const std::vector<double> target = parsePositives(arguments, "--fps", "one number of frames per second");
    if (target.size() > 1 || (!target.empty() && target.front() > 1000.0)) {
        throw wrongValue("--fps", *arguments.value("--fps"), "one number of frames per second, at most 1000");
    }
    if (!target.empty()) {
        settings.target = target.front();
    }
    settings.machine = io::machineText();
    return settings;
}

/// Points of the curve: one row each.
TextTable pointTable(const Calibration& calibration) {
    TextTable table({{"pile", "pile"},
                     {"bodies", "bodies"},
                     {"physics alone [FPS]", "physics_fps"},
                     {"drawing alone [FPS]", "drawing_fps"},
                     {"live [FPS]", "live_fps"}});
    for (const CalibrationPoint& point : calibration.points) {
        table.add({textCell(std::string(pileName(point.pile))), integerCell(point.bodies), numberCell(point.physicsFps),
                   numberCell(point.drawingFps), numberCell(point.liveFps)});
    }
    return table;
}

std::string bodiesText(const std::optional<Calibration::BodiesMax>& most) {
    if (!most) {
        return "not known: fewer than three points";
    }
    return std::string(most->atLeast  ? "at least "
                       : most->atMost ? "at most "
                                      : "") +
           englishInteger(static_cast<std::int64_t>(most->bodies));
}

void printCalibration(std::ostream& out, const Calibration& calibration, const std::string& path) {
    FactList facts;
    facts.add("machine", calibration.machine);
    facts.add("drawn by", calibration.renderer.empty() ? "nothing could be drawn" : calibration.renderer);
    facts.add("threads", std::to_string(calibration.threads));
    facts.add("taken by others", percentOrDash(calibration.othersShare));
    facts.print(out);
    printHeading(out, "Frames per second of " + englishNumber(1.0 / calibration.target) +
                          " s of collapse each: typical pile in the mean, worst pile in its worst second");
    pointTable(calibration).print(out);
    printHeading(out, "Most bodies for " + englishNumber(calibration.target) +
                          " FPS, fragments alone: loose structure that the engine moves (loose_structure) comes on top");
    FactList most;
    for (const PileKind pile : piles) {
        for (const auto& [load, name] : loads) {
            const std::optional<double> exponent = calibration.exponent(pile, load);
            most.add(std::string(pileName(pile)) + ", " + std::string(name),
                     bodiesText(calibration.bodiesMax(pile, load, calibration.target)) +
                         (exponent ? "; a frame takes bodies to the power " + englishNumber(*exponent) : ""));
        }
    }
    most.print(out);
    printHeading(out, "As published, on a GTX 480");
    for (const PublishedRate& rate : publishedRates) {
        out << "  " << englishInteger(rate.bodies) << " bodies: " << englishNumber(rate.fps) << " FPS\n";
    }
    if (!path.empty()) {
        out << "  kept in " << path << '\n';
    }
    printFindings(out, calibration.findings);
}

Json bodiesJson(const std::optional<Calibration::BodiesMax>& most) {
    if (!most) {
        return {};
    }
    return {{"bodies", std::floor(most->bodies)}, {"at_least", most->atLeast}, {"at_most", most->atMost}};
}

Json calibrationJson(const Calibration& calibration, const std::string& path) {
    Json object;
    object["machine"] = calibration.machine;
    object["renderer"] = calibration.renderer.empty() ? Json() : Json(calibration.renderer);
    object["threads"] = calibration.threads;
    object["others_share"] = calibration.othersShare;
    object["fps_target"] = calibration.target;
    object["complete"] = calibration.complete;
    object["points"] = Json::array();
    for (const CalibrationPoint& point : calibration.points) {
        object["points"].push_back({{"pile", pileName(point.pile)},
                                    {"bodies", point.bodies},
                                    {"physics_fps", point.physicsFps},
                                    {"drawing_fps", point.drawingFps},
                                    {"live_fps", point.liveFps}});
    }
    for (const PileKind pile : piles) {
        for (const auto& [load, name] : loads) {
            const std::optional<double> exponent = calibration.exponent(pile, load);
            object["fit"][std::string(pileName(pile))][std::string(name)] = {
                {"bodies_max", bodiesJson(calibration.bodiesMax(pile, load, calibration.target))},
                {"exponent", exponent ? Json(*exponent) : Json()}};
        }
    }
    object["published"] = Json::array();
    for (const PublishedRate& rate : publishedRates) {
        object["published"].push_back({{"bodies", rate.bodies}, {"fps", rate.fps}});
    }
    object["kept"] = path.empty() ? Json() : Json(path);
    object["warnings"] = findingsJson(calibration.findings);
    return object;
}

ExitCode calibrateMachine(const Arguments& arguments, Session& session) {
    CalibrationSettings settings = parseSettings(arguments);
    const int threads = parseCount(arguments, "--threads", 1, threadsMax, 0);
    checkCsvPath(arguments, {});
    io::StudyFiles files(arguments.value("--cache").value_or(io::cacheFolder()));
    LiveDisplay display;
    if (!arguments.has("--no-drawing")) {
        settings.screen = display.screenMaker();
        settings.renderer = [&display] { return display.renderer(); };
    }
    const Execution& execution = session.execution();
    Calibration calibration = calibrate(settings, threads > 0 ? execution.withThreads(threads) : execution);
    std::string path;
    if (calibration.complete) {
        try {
            files.keep(calibration);
            path = files.calibrationPath(calibration.machine);
        } catch (const WorldError& error) {
            calibration.findings.add({"calibration.not_kept", "The calibration could not be kept.", {}}, error.remedy(),
                                     error.what());
        }
    }
    if (const auto csv = arguments.value("--csv")) {
        io::writeAtomically(*csv, [&](std::ostream& out) { writeCalibrationCsv(calibration, out); });
    }
    if (!calibration.complete) {
        session.err() << "rubble-cli: cancelled; what was measured is reported and not kept\n";
    }
    if (arguments.json()) {
        Json object = calibrationJson(calibration, path);
        if (!calibration.complete) {
            object["cancelled"] = true;
        }
        printJson(session, object);
    } else {
        printCalibration(session.out(), calibration, path);
    }
    return calibration.complete ? ExitCode::Ok : ExitCode::Cancelled;
}

}  // namespace

Command calibrateCommand() {
    return {
        "calibrate",
        "",
        "live frames per second against the number of bodies on this machine",
        "Simulates piles of several sizes, once with nothing drawn, once drawn from memory and once live, and fits a curve to the "
        "frames per second: how many bodies this machine carries. The result is kept for predictions and for the bodies that a "
        "frame "
        "rate allows.",
        {{"--bodies", "A,B", false, "about so many bodies in each pile (default: 250,500,1000,2000,4000)"},
         {"--fps", "RATE", false, "frames per second of the collapse (default: 24)"},
         {"--no-drawing", "", false, "measure the physics alone"},
         {"--threads", "N", false, "threads to simulate on (default: as many as the machine has)"},
         {"--cache", "FOLDER", false, "where the calibration is kept (default: RUBBLE_CACHE, else the user's cache)"},
         csvOption("write one row for each pile and number of bodies")},
        calibrateMachine};
}

}  // namespace rubble::cli
