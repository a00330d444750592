#include <algorithm>

#include "app/cli/accuracy/accuracy_report.h"
#include "app/cli/accuracy/published_tables.h"
#include "app/cli/accuracy/study_options.h"
#include "app/cli/accuracy/study_place.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/live_display.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "core/analysis/accuracy/sweep_table.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/run/study_files.h"

namespace rubble::cli {

namespace {

constexpr int settingRepeatsMax = 100;

std::vector<std::string> parseMultiples(const Arguments& arguments) {
    const auto text = arguments.value("--multiples");
    return text && !text->empty() ? splitAtCommas(*text) : std::vector<std::string>{};
}

std::vector<VariedParameter> parseVaried(const Arguments& arguments) {
    std::vector<VariedParameter> varied;
    for (const std::string& text : arguments.values("--vary")) {
        const auto [key, values] = splitAssignment("--vary", text);
        varied.push_back({std::string(key), splitAtCommas(values)});
    }
    return varied;
}

/// The settings that are asked for; none where earlier points alone are to be checked.
std::vector<AccuracySetting> parseSettings(const Arguments& arguments, const Scenario& scenario) {
    std::vector<std::string> multiples = parseMultiples(arguments);
    const std::vector<VariedParameter> varied = parseVaried(arguments);
    if (!arguments.has("--multiples") && varied.empty()) {
        if (arguments.has("--check")) {
            return {};
        }
        multiples = usualMultiples();
    }
    return sweepSettings(scenario, multiples, varied);
}

AccuracyOptions parseOptions(const Arguments& arguments) {
    AccuracyOptions options;
    options.study = parseStudySettings(arguments, 1);
    // The columns of the published table are there whatever else is asked for.
    std::vector<double>& tolerances = options.study.measures.tolerances;
    tolerances.insert(tolerances.end(), publishedTolerances.begin(), publishedTolerances.end());
    std::sort(tolerances.begin(), tolerances.end());
    tolerances.erase(std::unique(tolerances.begin(), tolerances.end()), tolerances.end());
    options.settingRepeats = parseCount(arguments, "--setting-repeats", 0, settingRepeatsMax, 0);
    options.jobs = parseCount(arguments, "--jobs", 1, jobsMax, 0);
    options.timed = !arguments.has("--no-timing");
    options.retimed = arguments.has("--retime");
    options.simulated = !arguments.has("--predict");
    options.machine = io::machineText();
    return options;
}

/// What each setting would have been said to be, had nobody simulated it: its own earlier point does not count.
std::vector<Predictions> predictAll(const AccuracyReport& report, const std::string& machine, std::span<const KnownPoint> known,
                                    const std::optional<Calibration>& calibration) {
    std::vector<Predictions> all;
    const Digest scene = sceneDigest(report.reference.origin, report.instant);
    for (const AccuracyPoint& point : report.points) {
        KnownPoint open = openPoint(scene, machine, point.cost.threads, point.scenario, point.fragments, point.bodies);
        open.span = report.span;
        open.carries = open.carries && report.comesLoose;
        const std::vector<KnownPoint> others = pointsBut(open, known);
        Predictions& predictions = all.emplace_back();
        for (std::size_t w = 0; w < predictedCount; ++w) {
            predictions[w] = predict(static_cast<Predicted>(w), open, others, calibration ? &*calibration : nullptr);
        }
    }
    return all;
}

void writeErrors(const Arguments& arguments, const AccuracyOutput& output) {
    if (const auto path = arguments.value("--errors")) {
        const TextTable table = output.errorTable();
        io::writeAtomically(*path, [&](std::ostream& out) { table.writeCsv(out); });
    }
}

/// Why a world that was to be made alone was not.
std::string failureOf(const AccuracyReport& report) {
    std::string text = englishText(report.reference.failure);
    for (const AccuracyPoint& point : report.points) {
        if (text.empty()) {
            text = englishText(point.failure);
        }
    }
    return text;
}

ExitCode exitCodeOf(const AccuracyReport& report, Session& session) {
    if (report.complete) {
        return ExitCode::Ok;
    }
    if (session.execution().cancelled()) {
        session.err() << "rubble-cli: cancelled; what is done is kept, and the same command goes on from there\n";
        return ExitCode::Cancelled;
    }
    session.err() << "rubble-cli: some settings failed; what is done is kept, and the same command goes on from there\n";
    return ExitCode::Failed;
}

ExitCode measureAccuracy(const Arguments& arguments, Session& session) {
    const StudyPlace place(arguments);
    AccuracyOptions options = parseOptions(arguments);
    options.choice = place.choice();
    const io::OpenedCase subject = openSubject(arguments, session);
    checkCsvPath(arguments, subject.files);
    if (const auto path = arguments.value("--errors")) {
        checkOutputPath(*path, subject.files);
    }
    const std::vector<AccuracySetting> settings = parseSettings(arguments, subject.scenario);
    options.simulated = options.simulated && !settings.empty();
    io::StudyFiles files(arguments.value("--cache").value_or(io::cacheFolder()));
    options.store = &files;
    LiveDisplay display;
    if (!arguments.has("--no-fps") && options.choice.all()) {
        options.screen = display.screenMaker();
    }
    Findings kept;
    const std::optional<Calibration> calibration = files.calibration(options.machine, kept);
    const WorldOrigin reference = originOf(subject.inputs, referenceScenario(subject.scenario), 0, 0.0, options.machine);
    const Digest scene = sceneDigest(reference, options.study.instant);
    const std::vector<KnownPoint> earlier = files.points(scene, kept);
    if (place.elsewhere() && options.simulated) {
        StudyPlace::Study study{accuracyTasks(subject.inputs, subject.scenario, settings, options, session.execution()),
                                files.folder(), false, [&](const WorldOrigin& origin) { return files.keeps(origin); },
                                subject.files};
        if (const auto ended = place.haveMade(std::move(study), session)) {
            return *ended;
        }
    }
    AccuracyReport report = accuracyStudy(subject.inputs, subject.scenario, settings, options, session.execution());
    if (place.single()) {
        return place.endSingle(files.folder(), false, failureOf(report), report.findings, session);
    }
    io::keepPoints(files, report);
    report.findings.append(kept);

    AccuracyOutput output{subject, report, options,       predictAll(report, options.machine, earlier, calibration),
                          {},      0,      files.folder()};
    if (arguments.has("--check")) {
        Findings ignored;
        const std::vector<KnownPoint> all = files.points(scene, ignored);
        output.knownPoints = all.size();
        output.checks = checkPredictions(all);
    }
    if (const auto path = arguments.value("--csv")) {
        io::writeAtomically(*path, [&](std::ostream& out) { writeSweepCsv(report, out); });
    }
    writeErrors(arguments, output);
    if (arguments.json()) {
        Json object = output.json();
        if (session.execution().cancelled()) {
            object["cancelled"] = true;
        }
        printJson(session, object);
    } else {
        output.print(session.out());
    }
    return exitCodeOf(report, session);
}

}  // namespace

Command accuracyCommand() {
    const std::vector<Option> own{
        {"--multiples", "A,B", false,
         "multiples of the mean distance to sweep, auto among them (default: 1,1.5,2,2.5,3,4); empty: the grid as set"},
        {"--vary", "KEY=A,B", true, "values of a parameter to sweep, in every combination with the others"},
        {"--setting-repeats", "N", false,
         "repeats of every setting, births shifted as for the floor: how far its own accuracy scatters (default: 0)"},
        {"--jobs", "N", false, "worlds at a time for the accuracy (default: one for each thread); no accuracy depends on it"},
        {"--no-fps", "", false, "leave live FPS out: saves drawing each setting once"},
        {"--no-timing", "", false, "leave wall time and ms per step out: saves simulating each setting once more"},
        {"--retime", "", false, "measure times anew, although they are kept: on a machine that is quiet now"},
        {"--predict", "", false, "simulate nothing: say what earlier points let expect of the settings"},
        {"--check", "", false, "say how well the predicted intervals hold; with no settings named, of earlier points alone"},
        {"--cache", "FOLDER", false, "where worlds and costs are kept (default: RUBBLE_CACHE, else the user's cache)"},
        {"--errors", "FILE", false, "write the error of every fragment in every setting"},
    };
    return {
        "accuracy",
        "FE|CASE",
        "what accuracy costs in time, against the repeat floor",
        "Simulates the reference (each fragment its own body), its repeats with births shifted by a micrometre, and every setting, "
        "on request with repeats of its own; compares each with the reference, and then times each alone. Worlds that were "
        "simulated before are taken from the cache: "
        "after Ctrl-C the same command goes on from there.",
        joined({{scenarioOption()},
                simulationOptions(),
                own,
                studyOptions(),
                StudyPlace::options(),
                {csvOption("write one row for the reference, the floor and each setting")}}),
        measureAccuracy};
}

}  // namespace rubble::cli
