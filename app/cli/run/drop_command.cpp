#include <memory>

#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_output.h"
#include "app/cli/run/drop_tables.h"
#include "core/base/error.h"
#include "core/simulation/health/passed_limits.h"
#include "io/base/files.h"
#include "io/run/run_file.h"
#include "io/validation/drop_source.h"

namespace rubble::cli {

namespace {

constexpr double samplesByDefault = 10.0;  // 1/s

double samplesOf(const Arguments& arguments) {
    if (!arguments.has("--path")) {
        if (arguments.has("--samples")) {
            throw UsageError({"drop.samples_alone", "--samples goes with --path.", {}},
                             {"drop.samples_alone.remedy", "Name the file of the paths, or leave --samples out.", {}});
        }
        return 0.0;
    }
    const std::vector<double> given = parsePositives(arguments, "--samples", "samples a second, such as 10");
    return given.empty() ? samplesByDefault : given.front();
}

io::DropSource openTable(const Arguments& arguments, Session& session) {
    io::DropRequest request;
    request.opening = caseRequest(arguments, arguments.operand());
    request.turned = arguments.has("--turn");
    request.lifted = arguments.has("--lift");
    request.apart = arguments.has("--apart");
    request.repeats = parseCount(arguments, "--repeats", 1, io::dropRepeatsMax, 1);
    request.seed = parseCount(arguments, "--seed", 0, 2147483647, 1);
    for (const std::string& text : arguments.values("--vary")) {
        const auto [key, distribution] = splitAssignment("--vary", text);
        request.varied.push_back(variationFrom(key, distribution));
    }
    request.samplesPerSecond = samplesOf(arguments);
    return io::openDrop(request, session.execution());
}

/// A run that a file is to keep stands on the table as it is.
void checkKept(const Arguments& arguments, const DropSeries& series) {
    if (arguments.has("--out") && (series.turned || series.lifted || series.repeats > 1 || !series.varied.empty())) {
        throw UsageError({"drop.out_of_one", "--out keeps one run of the table as it stands.", {}},
                         {"drop.out_of_one.remedy", "Leave out --turn, --lift, --repeats and --vary, or leave out --out.", {}});
    }
}

DropRepeat keepRun(const io::DropSource& subject, const std::string& path, Session& session) {
    DropRepeat made;
    made.bodies = subject.series.bodies;
    io::OpenedCase opened = subject.opened;
    if (subject.series.apart) {
        opened.scenario.effects.of(EffectKind::FragmentContact) = EffectSwitch::Off;
    }
    const std::unique_ptr<TrajectorySink> file = io::createRun(path, io::originOf(opened));
    made.result = drop(opened.inputs, opened.scenario, subject.series.watch, file.get(), session.execution());
    return made;
}

/// Values that are drawn anew show in the spread of the repeats; without them all is of one set of values.
std::vector<Caution> cautionsOf(const DropSeries& series) {
    return series.varied.empty() ? std::vector{singleRunCaution()} : std::vector<Caution>();
}

/// Limits that were passed, each once a repeat however often, as a run counts them.
std::int64_t breachesOf(const std::vector<DropRepeat>& repeats) {
    std::int64_t breaches = 0;
    for (const DropRepeat& repeat : repeats) {
        breaches += static_cast<std::int64_t>(passedLimits(repeat.result.results.simulation->health.breaches).size());
    }
    return breaches;
}

ExitCode dropBodies(const Arguments& arguments, Session& session) {
    const std::vector<std::string> inputs{arguments.operand()};
    checkCsvPath(arguments, inputs);
    for (const char* option : {"--out", "--path"}) {
        if (const auto path = arguments.value(option)) {
            checkOutputPath(*path, inputs);
        }
    }
    const io::DropSource subject = openTable(arguments, session);
    checkKept(arguments, subject.series);
    std::vector<DropRepeat> repeats;
    if (const auto out = arguments.value("--out")) {
        repeats.push_back(keepRun(subject, *out, session));
    } else {
        repeats = dropAll(subject.series, session.execution());
    }
    const Findings findings = io::findingsOf(subject, repeats);
    writeCsv(arguments, dropTable(repeats, subject.zero));
    if (const auto path = arguments.value("--path")) {
        const TextTable table = pathTable(repeats, subject.zero);
        io::writeAtomically(*path, [&](std::ostream& out) { table.writeCsv(out); });
    }
    if (arguments.json()) {
        Json object = dropJson(repeats, subject.zero);
        object["cautions"] = cautionsJson(cautionsOf(subject.series));
        object["health_breaches"] = breachesOf(repeats);
        object["trajectory_hash"] = repeats.front().result.results.simulation->trajectoryHash.hex();
        object["steps"] = repeats.front().result.results.simulation->steps;
        object["step_rate"] = repeats.front().result.results.simulation->stepRate;
        object["step_rate_reason"] = englishText(repeats.front().result.results.simulation->stepRateReason);
        object["warnings"] = findingsJson(findings);
        printJson(session, object);
    } else {
        printHeading(session.out(), englishInteger(static_cast<std::int64_t>(subject.series.bodies.size())) + " bodies, " +
                                        englishInteger(subject.series.repeats) + " times");
        session.out() << stepsText(*repeats.front().result.results.simulation) << '\n';
        dropSummary(repeats, subject.zero).print(session.out());
        printCautions(session.out(), cautionsOf(subject.series));
        printFindings(session.out(), findings);
    }
    return ExitCode::Ok;
}

}  // namespace

Command dropCommand() {
    return {
        "drop",
        "BODIES.csv",
        "bodies from a table, let go and followed to rest",
        "Lets bodies of a table fall on level ground or a terrain, in the same world and with the same settings as a collapse. The "
        "heading of the table names quantity and unit of each column: mass_kg, side_x_m, x_m, vx_m_s, wx_body_rad_s and so on.",
        {terrainOption(),
         groundClassOption(),
         columnsOption(terrainColumns),
         systemOption(terrainSystem),
         setOption(),
         {"--apart", "", false, "the bodies never meet: each falls as if it were alone"},
         {"--turn", "", false, "each body is turned at random, anew in every repeat"},
         {"--lift", "", false, "bodies that begin in the ground are lifted out of it"},
         {"--repeats", "N", false, "how often they are let go (default: 1)"},
         {"--vary", "KEY=DIST", true, "what is drawn anew in every repeat: uniform:A:B, normal:MEAN:DEV or choice:A:B"},
         {"--seed", "N", false, "of what is drawn and turned (default: 1)"},
         {"--out", "RUN.h5", false, "keep the run in this file"},
         {"--path", "FILE", false, "write the way of each body, one row for each sample"},
         {"--samples", "HZ", false, "samples a second of --path (default: 10)"},
         csvOption("write one row for each body and repeat")},
        dropBodies};
}

}  // namespace rubble::cli
