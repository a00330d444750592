#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/evidence/clouds/site_scan.h"
#include "core/evidence/photographs/site_picture.h"
#include "core/fe/frame.h"
#include "core/scenario/registration.h"
#include "core/scenario/site.h"
#include "core/scenario/survey_scope.h"
#include "io/site/clouds/cloud_comparison.h"

namespace rubble::io {

/// A cloud to be held against what a run says lies on the site.
struct RunDistanceRequest {
    std::string cloud;
    std::string run;               ///< its path, for people
    std::string fingerprint = {};  ///< of the run, hex; empty: not known
    CloudRequest read;             ///< how the cloud is read
    Frame frame;                   ///< of the case
    Site site;
    /// Where the scanners stood, as eastings, northings and heights in metres; empty: as the cloud says, else it was seen from
    /// above.
    std::vector<Vec3> scanners;
    SurveyScope scope;               ///< points beyond it are left out
    CloudDistanceSettings settings;  ///< m
    /// What did not move, m, local: the cloud is fitted to the simulated site there. Empty: everywhere. Unset: it lies where it
    /// lies.
    std::optional<Outline> stable = std::nullopt;
    std::optional<Registration> placed =
        std::nullopt;   ///< by which the cloud is moved once its coordinates were brought to the case
    double cell = 0.0;  ///< m, side of the cells that volumes are taken over; 0: none are
    std::uint64_t heldPoints = heldPointsMost;
};

/// What a cloud was seen from.
enum class SightsFrom { Cloud, Asked, Above };

/// Simulated debris, by whether a scan like that of the cloud would have seen it.
struct SightedDebris {
    std::int64_t seen = 0;  ///< fragments
    std::int64_t unseen = 0;
    double seenVolume = 0.0;  ///< m3
    double unseenVolume = 0.0;
};

/// Distances from a cloud to a run.
struct RunDistance {
    /// The cloud is the first. Cores and normals are in the system of the case.
    CloudComparison compared;
    double time = 0.0;  ///< s, on the file's clock, of the site
    SightsFrom sights = SightsFrom::Above;
    std::size_t scanners = 0;
    std::uint64_t taken = 0;  ///< points that were held against the run
    std::uint64_t plants = 0;
    std::uint64_t beyond = 0;  ///< out of the scope
    std::uint64_t stride = 1;  ///< one of so many was taken
    SightedDebris debris;
};

/// Measures from a cloud to the surfaces of a site by M3C2: the second cloud is the site as the scanners would have seen it, by the
/// ray of each point. What no point looks at is not seen; it is neither debris nor its absence. Vegetation and wires are left out.
/// @param site     without ground, which is added here
/// @param volumes  m3, [fragments]; empty: of no debris
/// Throws ParseError (as CloudPlace; no point, elsewhere than the site), UsageError (too many cores), WorldError, Cancelled.
RunDistance compareCloudWithSite(const RunDistanceRequest& request, SiteShape site, const SiteSurface& ground,
                                 std::span<const double> volumes, const Execution& execution);

/// The scales of a request that fits alone. @param radius  m, about a point: surfaces within it are what it is fitted to
CloudDistanceSettings scalesOfFit(double radius);

/// Fits a cloud to a site by what did not move, as compareCloudWithSite() does where that is asked for: the move goes on from that
/// of the request. Findings say what was left out. Throws as above, and as fitCloud().
CloudFit fitCloudToSite(const RunDistanceRequest& request, SiteShape site, const SiteSurface& ground, Findings& findings,
                        const Execution& execution);

/// What a scan met of the debris of a site. @param met  triangles, or noTriangle; @param volumes  m3, [fragments]
SightedDebris sightedDebris(const SiteShape& site, std::span<const std::uint32_t> met, std::span<const double> volumes);

/// Triangles of a terrain that a site is scanned with at most; one with more is taken coarser, which is a finding.
inline constexpr double scannedTriangles = 4e6;
/// Says by how much a terrain was taken coarser.
void addCoarseGround(Findings& findings, std::size_t step);

}  // namespace rubble::io
