#include "io/site/clouds/run_scan.h"

#include <algorithm>
#include <utility>

#include "core/base/csv_text.h"
#include "core/base/error.h"
#include "io/base/file_words.h"
#include "io/base/files.h"
#include "io/site/clouds/point_cloud.h"
#include "io/site/clouds/point_writer.h"

namespace rubble::io {

namespace {

/// Class and colour of a point, by what it lies on: LAS knows none for debris.
struct ThingLook {
    std::uint8_t kind;
    std::array<std::uint8_t, 3> colour;
};
constexpr std::array<ThingLook, scannedThings> looks{
    {{0, {0, 0, 0}}, {1, {196, 98, 45}}, {1, {150, 80, 120}}, {6, {120, 130, 150}}, {2, {150, 140, 110}}}};

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

}  // namespace

RunScan scanRun(ScannedSite site, ScanSettings settings, const Execution& execution) {
    RunScan made;
    made.settings = std::move(settings);
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
        addFinding(made.findings, "", {"scan.below_ground", "scanners stand below the ground", {}},
                   "check their heights, and that they are in the system of the case", below);
    }
    addCoarseGround(made.findings, addGround(site.shape, site.ground, around, scannedTriangles));
    made.scan = scanSite(SurfaceTree(site.shape.points, site.shape.triangles), made.settings, execution);
    made.shape = std::move(site.shape);
    made.moving = site.moving;
    made.debris = sightedDebris(made.shape, made.scan.triangles, site.volumes);
    for (const std::uint32_t t : made.scan.triangles) {
        ++made.counts[static_cast<std::size_t>(made.shape.things[t])];
    }
    if (made.scan.places.empty()) {
        throw UsageError({"scan.nothing", "The scanners see nothing within {0}", {{made.settings.range, "m"}}},
                         {"scan.nothing.remedy", "Check their places, or give a greater range.", {}});
    }
    return made;
}

bool namesScan(const std::string& path) {
    return namesWrittenCloud(path) || hasEnding(path, ".csv");
}

void writeScan(const std::string& path, const RunScan& made, const SitePlace& place) {
    const SiteScan& scan = made.scan;
    const auto lookOf = [&](std::size_t k) { return looks[static_cast<std::size_t>(made.shape.things[scan.triangles[k]])]; };
    if (!namesWrittenCloud(path)) {
        writeAtomically(path, [&](std::ostream& out) {
            out << "x,y,z,class,scan\n";
            for (std::size_t k = 0; k < scan.places.size(); ++k) {
                const Vec3 at = place.toWorld(scan.places[k]);
                out << exactNumber(at.x()) << ',' << exactNumber(at.y()) << ',' << exactNumber(at.z()) << ',' << int{lookOf(k).kind}
                    << ',' << scan.scanners[k] << '\n';
            }
        });
        return;
    }
    WrittenCloud cloud;
    cloud.points = scan.places.size();
    cloud.crs = place.system();
    cloud.classes = true;
    cloud.instant = made.instant;
    cloud.run = made.run;
    for (std::size_t s = 0; s < made.settings.scanners.size(); ++s) {
        cloud.scanners.push_back({place.toWorld(made.settings.scanners[s]), scan.echoes[s]});
    }
    for (const Vec3& at : scan.places) {
        cloud.box.extend(place.toWorld(at));
    }
    writePoints(path, cloud, [&](std::size_t k, WrittenPoint& point) {
        const ThingLook& look = lookOf(k);
        point.place = place.toWorld(scan.places[k]);
        point.colour = look.colour;
        point.kind = look.kind;
        point.scanner = scan.scanners[k];
    });
}

void tellUnsaidInstant(const std::string& path, const RunScan& made, Findings& findings) {
    if (made.instant && !namesWrittenCloud(path)) {
        addFinding(findings, path,
                   {"scan.instant_unsaid", "a table does not keep which instant it shows: {0}", {{*made.instant, "s"}}},
                   "say it where the table becomes a survey, or write a LAS or a PLY, which keep it");
    }
}

std::optional<double> scannedInstant(const std::string& path, const CloudRequest& read) {
    try {
        return openCloud(path, read)->head().instant;
    } catch (const Error&) {
        return std::nullopt;  // what is wrong with it is said where it is read
    }
}

}  // namespace rubble::io
