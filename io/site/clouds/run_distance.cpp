#include "io/site/clouds/run_distance.h"

#include <algorithm>
#include <cmath>
#include <future>

#include "core/base/memory.h"
#include "core/base/outline_cover.h"
#include "core/evidence/no_evidence.h"
#include "core/scenario/scope_cover.h"
#include "io/base/file_words.h"
#include "io/site/clouds/cloud_place.h"
#include "io/site/clouds/cloud_summary.h"
#include "io/site/surveys/evidence_origin.h"
#include "io/site/surveys/survey_placing.h"

namespace rubble::io {

namespace {

/// A cloud in the local frame of a case, as much of it as is held.
class HeldCloud {
public:
    HeldCloud(const RunDistanceRequest& request, RunDistance& made, const Execution& execution)
        : m_request(request),
          m_made(made),
          m_cloud(openCloud(request.cloud, request.read)),
          m_place(*m_cloud, request.frame, request.site, made.compared.findings) {
        std::vector<Vec3> places;
        reserveLarge(points, std::min<std::uint64_t>(m_cloud->head().promised.value_or(0), request.heldPoints));
        ComparedCloud& told = made.compared.first;
        const CloudSummary summary = summariseCloud(*m_cloud, execution, [&](const CloudBlock& block) {
            places = block.places;
            m_place.toLocal(places);
            moveAsPlaced(places);
            take(block, places);
        });
        told.path = request.cloud;
        told.head = m_cloud->head();
        told.points = summary.points();
        told.near = points.size();
        made.taken = points.size();
        made.stride = m_stride;
        made.compared.findings.append(summary.findings);
        takeSights(summary.posed);
        tell();
    }

    std::vector<Vec3> points;  ///< m, local
    std::vector<std::uint16_t> scans;
    std::vector<Vec3> scanners;
    Aabb box;

private:
    void take(const CloudBlock& block, const std::vector<Vec3>& places) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!block.classes.empty() && isPlantOrWire(block.classes[i])) {
                ++m_made.plants;
                continue;
            }
            if (!places[i].allFinite()) {
                ++m_unplaced;
                continue;
            }
            if (!covers(m_request.scope, places[i].head<2>())) {
                ++m_made.beyond;
                continue;
            }
            if (m_seen++ % m_stride != 0) {
                continue;
            }
            box.extend(places[i]);
            points.push_back(places[i]);
            if (!block.scans.empty()) {
                scans.push_back(block.scans[i]);
            }
            if (points.size() > m_request.heldPoints) {
                halve();
            }
        }
    }

    void moveAsPlaced(std::vector<Vec3>& places) const {
        if (m_request.placed) {
            const Registration& placed = *m_request.placed;
            const Mat3 turn = placed.rotation();
            for (Vec3& place : places) {
                place = placed.about + placed.shift + turn * (place - placed.about);
            }
        }
    }

    void halve() {
        for (std::size_t k = 0; 2 * k < points.size(); ++k) {
            points[k] = points[2 * k];
            if (!scans.empty()) {
                scans[k] = scans[2 * k];
            }
        }
        points.resize((points.size() + 1) / 2);
        scans.resize((scans.size() + 1) / 2);
        m_stride *= 2;
    }

    /// @param posed  whether it is known where the scanner of each scan stood
    void takeSights(const std::vector<bool>& posed) {
        scanners = m_request.scanners;
        const std::vector<CloudScan>& told = m_cloud->head().scans;
        const bool stated = !posed.empty() && std::find(posed.begin(), posed.end(), false) == posed.end();
        if (!scanners.empty()) {
            m_made.sights = SightsFrom::Asked;
            const SitePlace place(m_request.frame, m_request.site);
            std::transform(scanners.begin(), scanners.end(), scanners.begin(), [&](const Vec3& at) { return place.toLocal(at); });
            scans.clear();
        } else if (stated) {
            m_made.sights = SightsFrom::Cloud;
            for (const CloudScan& scan : told) {
                scanners.push_back(scan.pose.position);
            }
            m_place.toLocal(scanners);
            moveAsPlaced(scanners);
        }
        m_made.scanners = scanners.size();
    }

    void tell() {
        noteOrigin(m_made.compared.findings, m_request.cloud, surveyOriginOf(m_request.cloud, m_request.read),
                   m_request.fingerprint);
        m_made.compared.findings = noEvidenceFirst(m_made.compared.findings);
        if (m_request.placed) {
            addPlacedFinding(m_made.compared.findings, m_request.cloud, *m_request.placed);
        }
        const auto find = [&](Message what, std::string_view remedy, std::uint64_t count) {
            if (count > 0) {
                addFinding(m_made.compared.findings, m_request.cloud, std::move(what), remedy, static_cast<std::int64_t>(count));
            }
        };
        find({"distance.plants", "points of vegetation and wires were left out", {}}, "none is needed", m_made.plants);
        addBeyond(m_made.compared.findings, m_request.cloud, m_made.beyond);
        find({"distance.unplaced", "points without a place in the system of the case were left out", {}},
             "check the coordinate systems of the cloud and of the case", m_unplaced);
        if (m_stride > 1) {
            find({"distance.thinned",
                  "the cloud does not fit into memory: one point in {0} was taken",
                  {static_cast<std::int64_t>(m_stride)}},
                 "name an area of interest (--area)", 1);
        }
        if (m_made.sights == SightsFrom::Above) {
            find({"distance.from_above",
                  "the cloud does not say where its scanners stood: the run is seen straight from above, as from an aircraft",
                  {}},
                 "name the places of the scanners (rubble-cli cloud --scanner) if it was taken from the ground", 1);
        } else if (scans.empty() && scanners.size() > 1) {
            find({"distance.nearest_scanner",
                  "which of {0} scanners saw a point is not known: the nearest one is taken",
                  {static_cast<std::int64_t>(scanners.size())}},
                 "give the scans with their poses (E57, PTX)", 1);
        }
    }

    const RunDistanceRequest& m_request;
    RunDistance& m_made;
    std::unique_ptr<PointCloud> m_cloud;
    CloudPlace m_place;
    std::uint64_t m_seen = 0;
    std::uint64_t m_stride = 1;
    std::uint64_t m_unplaced = 0;
};

Aabb boxOf(const SiteShape& site) {
    Aabb box;
    for (const Vec3& point : site.points) {
        if (point.allFinite()) {
            box.extend(point);
        }
    }
    return box;
}

void checkMeeting(const RunDistanceRequest& request, const Aabb& cloud, const Aabb& site) {
    if (cloud.isEmpty()) {
        refuseContent({"distance.no_points", "{0} has no point that could be compared", {request.cloud}},
                      "Give a cloud of the site, and an area of interest that it covers.");
    }
    Aabb plan = site;
    plan.min().z() = -1e300;
    plan.max().z() = 1e300;
    if (!site.isEmpty() && !plan.intersects(cloud)) {
        const Vec3 away = cloud.center() - site.center();
        refuseContent({"distance.elsewhere",
                       "{0} lies elsewhere: its middle is {1} from that of the site in plan",
                       {request.cloud, {away.head<2>().norm(), "m"}}},
                      "Check the coordinate systems of the cloud and of the case, and its control points.");
    }
}

/// The move that brings the cloud onto the simulated site, by what neither simulation nor collapse moved.
CloudFit fitOf(const RunDistanceRequest& request, const SurfaceTree& tree, const HeldCloud& held, const Execution& execution) {
    std::vector<Vec3> stable;
    std::vector<std::uint16_t> scans;
    CubeThinning thinning(0.25 * request.settings.normalRadius);
    for (std::size_t k = 0; k < held.points.size(); ++k) {
        const bool counts = request.stable->empty() || covers(*request.stable, held.points[k].head<2>());
        if (counts && thinning.takes(held.points[k])) {
            stable.push_back(held.points[k]);
            if (!held.scans.empty()) {
                scans.push_back(held.scans[k]);
            }
        }
    }
    std::vector<Vec3> met = seenAlike(tree, stable, {held.scanners, scans}, execution).places;
    std::erase_if(met, [](const Vec3& place) { return !place.allFinite(); });
    const PointIndex site(std::move(met), request.settings.projectionRadius);
    CloudFitSettings settings;
    settings.radius = request.settings.normalRadius;
    return fitCloud(site, stable, settings, execution);
}

/// Adds the ground about site and cloud, and checks that they meet.
void addGroundAbout(const RunDistanceRequest& request, const HeldCloud& held, SiteShape& site, const SiteSurface& ground,
                    Findings& findings) {
    Aabb around = boxOf(site);
    checkMeeting(request, held.box, around);
    around.extend(held.box);
    const Vec3 margin = Vec3::Constant(request.settings.depth + 2.0 * request.settings.projectionRadius);
    around = Aabb(around.min() - margin, around.max() + margin);
    addCoarseGround(findings, addGround(site, ground, around, scannedTriangles));
}

/// Straight up at each cell that either has points in, in a cylinder of its area, as between two clouds.
void takeVolumes(const RunDistanceRequest& request, const PointIndex& first, const SeenSite& second,
                 const CloudDistanceSettings& settings, CloudComparison& made, const Execution& execution) {
    CellMiddles middles(request.cell);
    middles.add(first.places(), 0);
    middles.add(second.others.places(), 1);
    std::vector<Vec3> cores = middles.places();
    const CloudDistanceSettings upwards = volumeSettings(settings, request.cell);
    orderByCubes(cores, upwards.projectionRadius);
    const std::vector<CoreDistance> cells = siteDistances(cores, first, second, upwards, execution);
    made.volumes = cloudVolumes(cells, request.cell, settings.registrationError);
    made.cubicMetres = 1.0;
    addCellsLeft(made);
}

/// Cores and normals as the system of the case has them.
void bringToWorld(CloudComparison& made, const SitePlace& place) {
    const double scale = place.transform().scale;
    for (std::size_t k = 0; k < made.cores.size(); ++k) {
        Vec3& normal = made.distances[k].normal;
        const Vec3 tip = place.toWorld(made.cores[k] + normal);
        made.cores[k] = place.toWorld(made.cores[k]);
        if (!place.upright()) {
            const Vec3 turned = tip - made.cores[k];
            normal = Vec3(turned.x() / scale, turned.y() / scale, turned.z());
        }
    }
}

}  // namespace

void addCoarseGround(Findings& findings, std::size_t step) {
    if (step > 1) {
        addFinding(findings, "",
                   {"scan.coarse_ground",
                    "the terrain has too many nodes to be scanned: one in {0} was taken each way",
                    {static_cast<std::int64_t>(step)}},
                   "give a shorter range, or an area of interest");
    }
}

SightedDebris sightedDebris(const SiteShape& site, std::span<const std::uint32_t> met, std::span<const double> volumes) {
    std::vector<bool> seen(volumes.size());
    std::vector<bool> there(volumes.size());
    for (std::size_t t = 0; t < site.things.size(); ++t) {
        if (site.things[t] == SiteThing::Debris) {
            there[site.parts[t]] = true;
        }
    }
    for (const std::uint32_t t : met) {
        if (t != noTriangle && site.things[t] == SiteThing::Debris) {
            seen[site.parts[t]] = true;
        }
    }
    SightedDebris made;
    for (std::size_t f = 0; f < volumes.size(); ++f) {
        if (there[f]) {
            ++(seen[f] ? made.seen : made.unseen);
            (seen[f] ? made.seenVolume : made.unseenVolume) += volumes[f];
        }
    }
    return made;
}

CloudDistanceSettings scalesOfFit(double radius) {
    return {radius, 0.5 * radius, radius, std::nullopt, false};
}

CloudFit fitCloudToSite(const RunDistanceRequest& request, SiteShape site, const SiteSurface& ground, Findings& findings,
                        const Execution& execution) {
    RunDistance made;
    const HeldCloud held(request, made, execution);
    addGroundAbout(request, held, site, ground, made.compared.findings);
    const CloudFit fit = fitOf(request, SurfaceTree(site.points, site.triangles), held, execution);
    findings.append(made.compared.findings);
    addFitFindings(findings, fit, request.settings.normalRadius);
    return fit;
}

RunDistance compareCloudWithSite(const RunDistanceRequest& request, SiteShape site, const SiteSurface& ground,
                                 std::span<const double> volumes, const Execution& execution) {
    RunDistance made;
    made.time = site.time;
    HeldCloud held(request, made, execution);
    addGroundAbout(request, held, site, ground, made.compared.findings);
    const double radius = request.settings.projectionRadius;
    std::vector<std::uint32_t> before;
    // Rays side by side go through the same boxes, which is twice as fast. A fit moves the points first.
    const auto order = [&] { before = orderByCubes(held.points, radius); };
    std::future<void> ordering;
    if (!request.stable) {
        ordering = std::async(std::launch::async, order);
    }
    const SurfaceTree tree(site.points, site.triangles);
    if (request.stable) {
        made.compared.fit = fitOf(request, tree, held, execution);
        for (std::vector<Vec3>* places : {&held.points, &held.scanners}) {
            std::transform(places->begin(), places->end(), places->begin(), *made.compared.fit);
        }
        order();
    } else {
        ordering.get();
    }
    CloudDistanceSettings asked = request.settings;
    if (!asked.registrationError && !request.stable && request.placed) {
        asked.registrationError = request.placed->error;
    }
    const CloudDistanceSettings settings = settingsAfterFit(made.compared, asked);
    std::vector<std::uint16_t> scans(held.scans.size());
    for (std::size_t k = 0; k < scans.size(); ++k) {
        scans[k] = held.scans[before[k]];
    }
    CloudComparison& compared = made.compared;
    compared.cores = firstOfCubes(held.points, radius);
    MetAlike met = seenAlike(tree, held.points, {held.scanners, scans}, execution);
    made.debris = sightedDebris(site, met.triangles, volumes);
    const auto seen =
        met.triangles.size() - static_cast<std::size_t>(std::count(met.triangles.begin(), met.triangles.end(), noTriangle));
    compared.second.path = request.run;
    compared.second.head.format = "run";
    compared.second.points = compared.second.near = seen;
    compared.unit = 1.0;
    compared.metresStated = true;
    compared.againstRun = true;
    compared.parts = 1;
    checkCores(compared.cores.size());
    const SeenSite second(held.points, std::move(met.places), radius);
    const PointIndex first(std::move(held.points), radius);
    compared.distances = siteDistances(compared.cores, first, second, settings, execution);
    judgeDistances(compared, settings);
    if (request.cell > 0.0) {
        takeVolumes(request, first, second, settings, compared, execution);
    }
    bringToWorld(compared, SitePlace(request.frame, request.site));
    compared.first.head.crs = request.frame.crs;
    compared.first.head.units.metres = compared.first.head.units.heightMetres = 1.0;
    return made;
}

}  // namespace rubble::io
