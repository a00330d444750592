#include <array>
#include <numbers>
#include <utility>

#include "app/cli/evidence/scanned_site.h"
#include "app/cli/exports/map_subject.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/exports/survey_files.h"
#include "io/site/clouds/run_scan.h"
#include "io/site/site_place.h"

namespace rubble::cli {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// [SiteThing] as tables and JSON name them.
constexpr std::array<const char*, io::scannedThings> thingNames{"nothing", "debris", "fallen_structure", "structure", "ground"};

ScanSettings scanSettingsFrom(const Arguments& arguments) {
    ScanSettings settings;
    settings.step = degree * parseLength(arguments, "--step", 0.2);
    settings.range = parseLength(arguments, "--range", settings.range);
    settings.noise = parseLength(arguments, "--noise", settings.noise, true);
    settings.seed = static_cast<std::uint64_t>(parseCount(arguments, "--seed", 0, 1'000'000'000, 1));
    return settings;
}

io::RunScan scanOf(const Arguments& arguments, const MapSubject& subject, const io::SitePlace& place, const Execution& execution) {
    ScanSettings settings = scanSettingsFrom(arguments);
    for (const Vec3& at : scannersFrom(arguments)) {
        settings.scanners.push_back(place.toLocal(at));
    }
    const std::optional<double> instant = instantFrom(arguments);
    io::RunScan made = io::scanRun(
        scannedSite(*subject.run, subject.inputs, instant, parseLength(arguments, "--live-threshold", 1.0, true), execution),
        std::move(settings), execution);
    made.instant = instant;
    made.run = subject.run->origin().fingerprint.hex();
    return made;
}

Json scanJson(const io::RunScan& made, const io::SitePlace& place) {
    Json object;
    object["time_s"] = made.shape.time;
    object["at_rest"] = !made.instant.has_value();
    object["moving"] = made.moving.moving;
    object["bodies"] = made.moving.bodies;
    object["points"] = made.scan.places.size();
    object["step_deg"] = made.settings.step / degree;
    object["range_m"] = made.settings.range;
    object["noise_m"] = made.settings.noise;
    object["seed"] = made.settings.seed;
    object["scanners"] = Json::array();
    for (std::size_t s = 0; s < made.settings.scanners.size(); ++s) {
        const Vec3 at = place.toWorld(made.settings.scanners[s]);
        object["scanners"].push_back(
            {{"place_m", {at.x(), at.y(), at.z()}}, {"rays", made.scan.rays[s]}, {"points", made.scan.echoes[s]}});
    }
    for (std::size_t t = 1; t < thingNames.size(); ++t) {
        object["points_on"][thingNames[t]] = made.counts[t];
    }
    object["debris"] = sightedJson(made.debris);
    return object;
}

void printScan(std::ostream& out, const io::RunScan& made, const io::SitePlace& place) {
    const auto count = [](std::uint64_t points) { return englishInteger(static_cast<std::int64_t>(points)); };
    FactList facts;
    facts.add("time", englishNumber(made.shape.time) + (made.instant ? " s, told by LAS and PLY" : " s, the end"));
    facts.add("bodies", made.moving.moving == 0 ? std::string("all at rest then")
                                                : englishInteger(made.moving.moving) + " of " + englishInteger(made.moving.bodies) +
                                                      " still move then");
    facts.add("points", count(made.scan.places.size()) + ": " + count(made.counts[1]) + " on debris, " + count(made.counts[2]) +
                            " on fallen structure, " + count(made.counts[3]) + " on standing structure, " + count(made.counts[4]) +
                            " on the ground");
    facts.add("directions", "one to each square of " + englishNumber(made.settings.step / degree) + " degrees, at random, seed " +
                                count(made.settings.seed) + ", up to " + englishNumber(made.settings.range) + " m");
    facts.add("noise", englishNumber(made.settings.noise) + " m along the ray");
    facts.add("debris", sightedText(made.debris));
    for (std::size_t s = 0; s < made.settings.scanners.size(); ++s) {
        const Vec3 at = place.toWorld(made.settings.scanners[s]);
        facts.add("scanner " + std::to_string(s + 1), englishNumber(at.x()) + ", " + englishNumber(at.y()) + ", " +
                                                          englishNumber(at.z()) + ", " + count(made.scan.echoes[s]) + " points");
    }
    printHeading(out, "Scan of the run");
    facts.print(out);
}

ExitCode scan(const Arguments& arguments, Session& session) {
    const std::vector<std::string> files = arguments.values("--out");
    for (const std::string& path : files) {
        if (!io::namesScan(path)) {
            throw wrongValue("--out", path, "a path that ends in .las, .ply or .csv");
        }
        checkOutputPath(path, std::vector<std::string>{arguments.operand()});
    }
    instantFrom(arguments);
    scannersFrom(arguments);
    scanSettingsFrom(arguments);
    const MapSubject subject = openMapSubject(arguments, session);
    const io::SitePlace place(subject.inputs.frame, subject.run->origin().site);
    const io::RunScan made = scanOf(arguments, subject, place, session.execution());
    Findings findings = subject.findings;
    for (const std::string& path : files) {
        io::writeScan(path, made, place);
        io::writeProvenance(path, io::scanProvenance(*subject.run, made, place));
        io::tellUnsaidInstant(path, made, findings);
    }
    findings.append(made.findings);
    conclude(
        arguments, session, subject, findings, [&] { return scanJson(made, place); },
        [&](std::ostream& out) { printScan(out, made, place); });
    return ExitCode::Ok;
}

}  // namespace

Command scanCommand() {
    return {
        "scan",
        "RUN|FE|CASE",
        "a point cloud as laser scanners would take it of the simulated site",
        "Sends rays from the places of scanners at what a recorded run, or a case or FE file that is simulated first, leaves on "
        "the site, and writes where they meet debris, structure and ground, with noise. What is hidden has no points.",
        joined({{{"--out", "FILE", true, "a file to write: .las, .ply or .csv"},
                 scannerOption("where a scanner stands: easting, northing and height, m (default: four around the debris)"),
                 {"--step", "DEGREES", false, "one ray falls to each square of this side (default: 0.2)"},
                 {"--range", "M", false, "farthest that a ray goes (default: 100)"},
                 {"--noise", "M", false, "standard deviation along the ray (default: 0.005)"},
                 {"--seed", "N", false, "of directions and noise, 0 to 1000000000 (default: 1)"},
                 {"--time", "SECONDS", false, "instant on the file's clock, or end (default: end)"},
                 {"--live-threshold", "M", false, "live structure has fallen if it moved farther than this, m (default: 1)"}},
                siteOptions()}),
        scan};
}

}  // namespace rubble::cli
