#include "io/validation/drop_source.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/fe/frame_transform.h"

namespace rubble::io {

namespace {

/// Bodies that one may begin in: more are no pile but one place.
constexpr std::int64_t overlapsMax = 100;

std::string nameIn(const DropSource& source, std::size_t body) {
    return source.table.bodies[body].id + " (line " + std::to_string(source.table.lines[body]) + ")";
}

void checkDropPlaces(DropSource& source) {
    const std::string& path = source.opened.fePath;
    const ReleaseCheck check = checkRelease(source.series.bodies, surfaceOf(source.series));
    if (check.outside.count > 0) {
        throw ParseError(
            {"drop.outside",
             "{0}: {1} bodies begin where the terrain {2} has no heights; one is {3}",
             {path, check.outside.count, source.opened.terrain.path, nameIn(source, check.outside.worst)}},
            {"drop.outside.remedy", "Give a terrain that covers them, in the same coordinates, or correct their x and y.", {}});
    }
    if (check.below.count > 0) {
        throw ParseError(
            {"drop.below",
             "{0}: {1} bodies begin with their centre below the surface, {2} by {3}",
             {path, check.below.count, nameIn(source, check.below.worst), {check.below.measure, "m"}}},
            {"drop.below.remedy", "Correct z, or the datum of one of the two, or lift them out: rubble-cli drop --lift.", {}});
    }
    if (check.touching.count > 0) {
        source.findings.add({"drop.touching",
                             "{0} bodies begin with a corner in the surface, at most {1} deep; it pushes them out",
                             {check.touching.count, {check.touching.measure, "m"}}},
                            {"drop.touching.remedy", "correct z, or lift them out: rubble-cli drop --lift", {}},
                            nameIn(source, check.touching.worst), check.touching.count);
    }
}

void checkCrowd(const DropSource& source) {
    const ReleaseCount crowd = crowded(source.series.bodies, overlapsMax);
    if (crowd.count > 0) {
        throw ParseError({"drop.crowded",
                          "{0}: {1} bodies begin within more than {2} others each; one is {3}",
                          {source.opened.fePath, crowd.count, overlapsMax, nameIn(source, crowd.worst)}},
                         {"drop.crowded.remedy",
                          "Give them places or times of their own, or let them fall without meeting: rubble-cli drop --apart.",
                          {}});
    }
}

void addEndings(const std::vector<DropRepeat>& repeats, Findings& findings) {
    const auto add = [&](Ending ending, const Message& what, const Message& remedy) {
        std::int64_t count = 0;
        for (const DropRepeat& repeat : repeats) {
            count += repeat.result.count(ending);
        }
        if (count > 0) {
            findings.add({what.id, what.pattern, {count}}, remedy, {}, count);
        }
    };
    add(Ending::Moving, {"drop.moving", "{0} bodies still moved at the end; where they end is not known", {}},
        {"drop.moving.remedy", "raise settle_time", {}});
    add(Ending::Left, {"drop.left", "{0} bodies left the terrain; they count in no figure", {}},
        {"drop.left.remedy", "give a terrain that covers where they run", {}});
    add(Ending::Lost, {"drop.lost", "{0} bodies were lost: their place became no number", {}},
        {"drop.lost.remedy", "look at their size and mass, or raise step_rate", {}});
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

}  // namespace

DropSource openDrop(const DropRequest& request, const Execution& execution) {
    checkEnsemble({request.varied, request.repeats, request.seed});
    DropSource source;
    source.table = readBodyTable(request.opening.path);
    source.opened = openCase(request.opening, execution);
    DropSeries& series = source.series;
    series.frame = source.opened.inputs.frame;
    series.terrain = source.opened.inputs.terrain;
    series.scenario = source.opened.scenario;
    const FrameTransform frame(series.frame);
    source.zero = frame.localZero();
    series.bodies = source.table.bodies;
    for (LooseBody& body : series.bodies) {
        body.pose.position = frame.point(body.pose.position);
    }
    series.turned = request.turned;
    series.lifted = request.lifted;
    series.apart = request.apart;
    series.repeats = request.repeats;
    series.seed = request.seed;
    series.varied = request.varied;
    series.watch.samplesPerSecond = request.samplesPerSecond;
    if (!series.lifted) {
        checkDropPlaces(source);
    }
    if (!series.apart) {
        checkCrowd(source);
    }
    return source;
}

Findings findingsOf(const DropSource& source, const std::vector<DropRepeat>& repeats) {
    Findings all = allFindings(source.opened, repeats.front().result.results);
    for (std::size_t r = 1; r < repeats.size(); ++r) {
        all.append(repeats[r].result.results.simulation->findings);
    }
    Findings findings;
    for (const Finding& finding : all.list()) {
        // What is turned at random does not lie along the axes of the table.
        if (!source.series.turned || finding.what.id != "bodies.along_axes") {
            findings.add(finding.what, finding.remedy, finding.example, finding.count);
        }
    }
    findings.append(source.findings);
    addEndings(repeats, findings);
    return findings;
}

}  // namespace rubble::io
