#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/cli/evidence/scanned_site.h"
#include "app/cli/exports/map_subject.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "core/base/csv_text.h"
#include "core/base/error.h"
#include "io/base/file_words.h"
#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/site/clouds/point_writer.h"
#include "io/site/site_place.h"

namespace rubble::cli {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Class and colour of a point, by what it lies on: LAS knows none for debris.
struct ThingLook {
    const char* name;
    std::uint8_t kind;
    std::array<std::uint8_t, 3> colour;
};
constexpr std::array<ThingLook, 5> looks{{{"nothing", 0, {0, 0, 0}},
                                          {"debris", 1, {196, 98, 45}},
                                          {"fallen_structure", 1, {150, 80, 120}},
                                          {"structure", 6, {120, 130, 150}},
                                          {"ground", 2, {150, 140, 110}}}};

ScanSettings scanSettingsFrom(const Arguments& arguments) {
    ScanSettings settings;
    settings.step = degree * parseLength(arguments, "--step", 0.2);
    settings.range = parseLength(arguments, "--range", settings.range);
    settings.noise = parseLength(arguments, "--noise", settings.noise, true);
    settings.seed = static_cast<std::uint64_t>(parseCount(arguments, "--seed", 0, 1'000'000'000, 1));
    return settings;
}

Aabb debrisBox(const SiteShape& shape) {
    Aabb debris;
    Aabb all;
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        for (const std::uint32_t corner : shape.triangles[t]) {
            if (shape.points[corner].allFinite()) {
                all.extend(shape.points[corner]);
                if (shape.things[t] == SiteThing::Debris || shape.things[t] == SiteThing::FallenStructure) {
                    debris.extend(shape.points[corner]);
                }
            }
        }
    }
    return debris.isEmpty() ? all : debris;
}

/// Four scanners at eye's height around the debris, one to each corner. @return  m, local
std::vector<Vec3> usualScanners(const ScannedSite& site) {
    const Aabb box = debrisBox(site.shape);
    std::vector<Vec3> places;
    if (box.isEmpty()) {
        return places;
    }
    const double away = std::max(10.0, box.sizes().z());
    for (const auto& [x, y] : {std::pair(-1.0, -1.0), std::pair(1.0, -1.0), std::pair(1.0, 1.0), std::pair(-1.0, 1.0)}) {
        const Eigen::Vector2d at =
            box.center().head<2>() + Eigen::Vector2d(x * (0.5 * box.sizes().x() + away), y * (0.5 * box.sizes().y() + away));
        places.emplace_back(at.x(), at.y(), site.ground.height(at.x(), at.y()) + 1.8);
    }
    return places;
}

/// A scan of a run, and what it was made with.
struct RunScan {
    ScanSettings settings;  ///< m, local
    SiteScan scan;
    SiteShape shape;
    io::SightedDebris debris;
    std::array<std::uint64_t, looks.size()> counts{};  ///< points by what they lie on
    Findings findings;
};

RunScan scanRun(const Arguments& arguments, const MapSubject& subject, const io::SitePlace& place, const Execution& execution) {
    RunScan made;
    made.settings = scanSettingsFrom(arguments);
    ScannedSite site = scannedSite(*subject.run, subject.inputs, instantFrom(arguments),
                                   parseLength(arguments, "--live-threshold", 1.0, true), execution);
    for (const Vec3& at : scannersFrom(arguments)) {
        made.settings.scanners.push_back(place.toLocal(at));
    }
    if (made.settings.scanners.empty()) {
        made.settings.scanners = usualScanners(site);
    }
    Aabb around;
    std::int64_t below = 0;
    for (const Vec3& at : made.settings.scanners) {
        around.extend(Vec3(at + Vec3::Constant(made.settings.range)));
        around.extend(Vec3(at - Vec3::Constant(made.settings.range)));
        below += site.ground.depth(at) > 0.0 ? 1 : 0;
    }
    if (below > 0) {
        io::addFinding(made.findings, "", {"scan.below_ground", "scanners stand below the ground", {}},
                       "check their heights, and that they are in the system of the case", below);
    }
    io::addCoarseGround(made.findings, addGround(site.shape, site.ground, around, io::scannedTriangles));
    made.scan = scanSite(SurfaceTree(site.shape.points, site.shape.triangles), made.settings, execution);
    made.shape = std::move(site.shape);
    made.debris = io::sightedDebris(made.shape, made.scan.triangles, site.volumes);
    for (const std::uint32_t t : made.scan.triangles) {
        ++made.counts[static_cast<std::size_t>(made.shape.things[t])];
    }
    if (made.scan.places.empty()) {
        throw UsageError({"scan.nothing", "The scanners see nothing within {0}", {{made.settings.range, "m"}}},
                         {"scan.nothing.remedy", "Check their places, or give a greater range.", {}});
    }
    return made;
}

void writeScan(const std::string& path, const RunScan& made, const io::SitePlace& place, const std::string& crs) {
    const SiteScan& scan = made.scan;
    const auto lookOf = [&](std::size_t k) { return looks[static_cast<std::size_t>(made.shape.things[scan.triangles[k]])]; };
    if (!io::namesWrittenCloud(path)) {
        io::writeAtomically(path, [&](std::ostream& out) {
            out << "x,y,z,class,scan\n";
            for (std::size_t k = 0; k < scan.places.size(); ++k) {
                const Vec3 at = place.toWorld(scan.places[k]);
                out << exactNumber(at.x()) << ',' << exactNumber(at.y()) << ',' << exactNumber(at.z()) << ',' << int{lookOf(k).kind}
                    << ',' << scan.scanners[k] << '\n';
            }
        });
        return;
    }
    io::WrittenCloud cloud;
    cloud.points = scan.places.size();
    cloud.crs = crs;
    cloud.classes = true;
    for (std::size_t s = 0; s < made.settings.scanners.size(); ++s) {
        cloud.scanners.push_back({place.toWorld(made.settings.scanners[s]), scan.echoes[s]});
    }
    for (const Vec3& at : scan.places) {
        cloud.box.extend(place.toWorld(at));
    }
    io::writePoints(path, cloud, [&](std::size_t k, io::WrittenPoint& point) {
        const ThingLook& look = lookOf(k);
        point.place = place.toWorld(scan.places[k]);
        point.colour = look.colour;
        point.kind = look.kind;
        point.scanner = scan.scanners[k];
    });
}

Json scanJson(const RunScan& made, const io::SitePlace& place) {
    Json object;
    object["time_s"] = made.shape.time;
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
    for (std::size_t t = 1; t < looks.size(); ++t) {
        object["points_on"][looks[t].name] = made.counts[t];
    }
    object["debris"] = sightedJson(made.debris);
    return object;
}

void printScan(std::ostream& out, const RunScan& made, const io::SitePlace& place) {
    const auto count = [](std::uint64_t points) { return englishInteger(static_cast<std::int64_t>(points)); };
    FactList facts;
    facts.add("time", englishNumber(made.shape.time) + " s");
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
        if (!io::namesWrittenCloud(path) && !io::hasEnding(path, ".csv")) {
            throw wrongValue("--out", path, "a path that ends in .las, .ply or .csv");
        }
        checkOutputPath(path, std::vector<std::string>{arguments.operand()});
    }
    instantFrom(arguments);
    scannersFrom(arguments);
    scanSettingsFrom(arguments);
    const MapSubject subject = openMapSubject(arguments, session);
    const io::SitePlace place(subject.inputs.frame, subject.run->origin().site);
    const RunScan made = scanRun(arguments, subject, place, session.execution());
    for (const std::string& path : files) {
        writeScan(path, made, place, subject.inputs.frame.crs);
        io::writeProvenance(path, io::provenanceText(*subject.run));
    }
    Findings findings = subject.findings;
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
