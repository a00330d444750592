#include <cmath>
#include <memory>

#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_output.h"
#include "app/cli/run/drop_tables.h"
#include "core/base/error.h"
#include "core/fe/frame_transform.h"
#include "io/base/files.h"
#include "io/fe/bodies/body_table.h"
#include "io/run/run_file.h"

namespace rubble::cli {

namespace {

constexpr int dropRepeatsMax = 10000;
constexpr double samplesByDefault = 10.0;  // 1/s
/// Bodies that one may begin in: more are no pile but one place.
constexpr std::int64_t overlapsMax = 100;

/// A table of bodies as it was asked to be dropped.
struct DropSubject {
    io::OpenedCase opened;
    io::BodyTable table;
    DropSeries series;
    Vec3 zero = Vec3::Zero();  ///< m, of the local frame in the axes of the table
    Findings findings;

    std::string nameOf(std::size_t body) const {
        return table.bodies[body].id + " (line " + std::to_string(table.lines[body]) + ")";
    }
};

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

void checkPlaces(DropSubject& subject) {
    const std::string& path = subject.opened.fePath;
    const ReleaseCheck check = checkRelease(subject.series.bodies, surfaceOf(subject.series));
    if (check.outside.count > 0) {
        throw ParseError(
            {"drop.outside",
             "{0}: {1} bodies begin where the terrain {2} has no heights; one is {3}",
             {path, check.outside.count, subject.opened.terrain.path, subject.nameOf(check.outside.worst)}},
            {"drop.outside.remedy", "Give a terrain that covers them, in the same coordinates, or correct their x and y.", {}});
    }
    if (check.below.count > 0) {
        throw ParseError({"drop.below",
                          "{0}: {1} bodies begin with their centre below the surface, {2} by {3}",
                          {path, check.below.count, subject.nameOf(check.below.worst), {check.below.measure, "m"}}},
                         {"drop.below.remedy", "Correct z, or the datum of one of the two, or lift them out with --lift.", {}});
    }
    if (check.touching.count > 0) {
        subject.findings.add({"drop.touching",
                              "{0} bodies begin with a corner in the surface, at most {1} deep; it pushes them out",
                              {check.touching.count, {check.touching.measure, "m"}}},
                             {"drop.touching.remedy", "correct z, or lift them out with --lift", {}},
                             subject.nameOf(check.touching.worst), check.touching.count);
    }
}

void checkCrowd(const DropSubject& subject) {
    const ReleaseCount crowd = crowded(subject.series.bodies, overlapsMax);
    if (crowd.count > 0) {
        throw ParseError(
            {"drop.crowded",
             "{0}: {1} bodies begin within more than {2} others each; one is {3}",
             {subject.opened.fePath, crowd.count, overlapsMax, subject.nameOf(crowd.worst)}},
            {"drop.crowded.remedy", "Give them places or times of their own, or let them fall without meeting: --apart.", {}});
    }
}

DropSubject openDrop(const Arguments& arguments, Session& session) {
    DropSubject subject;
    subject.table = io::readBodyTable(arguments.operand());
    subject.opened = openSubject(arguments, session);
    DropSeries& series = subject.series;
    series.frame = subject.opened.inputs.frame;
    series.terrain = subject.opened.inputs.terrain;
    series.scenario = subject.opened.scenario;
    const FrameTransform frame(series.frame);
    subject.zero = frame.localZero();
    series.bodies = subject.table.bodies;
    for (LooseBody& body : series.bodies) {
        body.pose.position = frame.point(body.pose.position);
    }
    series.turned = arguments.has("--turn");
    series.lifted = arguments.has("--lift");
    series.apart = arguments.has("--apart");
    series.repeats = parseCount(arguments, "--repeats", 1, dropRepeatsMax, 1);
    series.seed = parseCount(arguments, "--seed", 0, 2147483647, 1);
    for (const std::string& text : arguments.values("--vary")) {
        const auto [key, distribution] = splitAssignment("--vary", text);
        series.varied.push_back(variationFrom(key, distribution));
    }
    checkEnsemble({series.varied, series.repeats, series.seed});
    series.watch.samplesPerSecond = samplesOf(arguments);
    if (!series.lifted) {
        checkPlaces(subject);
    }
    if (!series.apart) {
        checkCrowd(subject);
    }
    return subject;
}

/// A run that a file is to keep stands on the table as it is.
void checkKept(const Arguments& arguments, const DropSeries& series) {
    if (arguments.has("--out") && (series.turned || series.lifted || series.repeats > 1 || !series.varied.empty())) {
        throw UsageError({"drop.out_of_one", "--out keeps one run of the table as it stands.", {}},
                         {"drop.out_of_one.remedy", "Leave out --turn, --lift, --repeats and --vary, or leave out --out.", {}});
    }
}

DropRepeat keepRun(const DropSubject& subject, const std::string& path, Session& session) {
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

/// What is turned at random does not lie along the axes of the table.
Findings findingsOf(const DropSubject& subject, const std::vector<DropRepeat>& repeats) {
    Findings all = io::allFindings(subject.opened, repeats.front().result.results);
    for (std::size_t r = 1; r < repeats.size(); ++r) {
        all.append(repeats[r].result.results.simulation->findings);
    }
    Findings findings;
    for (const Finding& finding : all.list()) {
        if (!subject.series.turned || finding.what.id != "bodies.along_axes") {
            findings.add(finding.what, finding.remedy, finding.example, finding.count);
        }
    }
    return findings;
}

void addEndings(const std::vector<DropRepeat>& repeats, Findings& findings) {
    const auto add = [&](Ending ending, const char* id, const char* pattern, const char* remedy) {
        std::int64_t count = 0;
        for (const DropRepeat& repeat : repeats) {
            count += repeat.result.count(ending);
        }
        if (count > 0) {
            findings.add({id, pattern, {count}}, {std::string(id) + ".remedy", remedy, {}}, {}, count);
        }
    };
    add(Ending::Moving, "drop.moving", "{0} bodies still moved at the end; where they end is not known", "raise settle_time");
    add(Ending::Left, "drop.left", "{0} bodies left the terrain; they count in no figure",
        "give a terrain that covers where they run");
    add(Ending::Lost, "drop.lost", "{0} bodies were lost: their place became no number",
        "look at their size and mass, or raise step_rate");
    std::int64_t lifted = 0;
    double most = 0.0;
    for (const DropRepeat& repeat : repeats) {
        lifted += repeat.lifted.count;
        most = std::max(most, repeat.lifted.measure);
    }
    if (lifted > 0) {
        findings.add({"drop.lifted", "{0} bodies were lifted out of the surface, at most by {1}", {lifted, {most, "m"}}},
                     {"drop.lifted.remedy", "correct z where that is more than half a side", {}}, {}, lifted);
    }
}

std::int64_t breachesOf(const std::vector<DropRepeat>& repeats) {
    std::int64_t breaches = 0;
    for (const DropRepeat& repeat : repeats) {
        breaches += static_cast<std::int64_t>(repeat.result.results.simulation->health.breaches.size());
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
    DropSubject subject = openDrop(arguments, session);
    checkKept(arguments, subject.series);
    std::vector<DropRepeat> repeats;
    for (std::int64_t r = 0; r < subject.series.repeats; ++r) {
        const auto out = arguments.value("--out");
        repeats.push_back(out ? keepRun(subject, *out, session) : dropOnce(subject.series, r, session.execution()));
    }
    Findings findings = findingsOf(subject, repeats);
    findings.append(subject.findings);
    addEndings(repeats, findings);
    writeCsv(arguments, dropTable(repeats, subject.zero));
    if (const auto path = arguments.value("--path")) {
        const TextTable table = pathTable(repeats, subject.zero);
        io::writeAtomically(*path, [&](std::ostream& out) { table.writeCsv(out); });
    }
    if (arguments.json()) {
        Json object = dropJson(repeats, subject.zero);
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
