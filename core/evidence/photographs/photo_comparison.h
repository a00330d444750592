#pragma once

#include <optional>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/photographs/camera_match.h"
#include "core/evidence/photographs/silhouette.h"

namespace rubble {

/// A number with what the uncertainty of the camera makes of it.
struct SpreadNumber {
    double best = 0.0;    ///< with the camera as found
    double mean = 0.0;    ///< over cameras drawn from its uncertainty
    double spread = 0.0;  ///< standard deviation over these
};

/// How a comparison is made.
struct ComparisonSettings {
    int longestSide = 800;       ///< px, of the pictures that are compared
    int cameras = 64;            ///< drawn from the uncertainty of the match
    std::uint64_t seed = 1;      ///< of the draws
    bool withFallen = true;      ///< fallen live structure is debris
    double liveThreshold = 1.0;  ///< m, farther than this live structure has fallen
};

/// The simulated debris held against the outline drawn on a photograph.
struct PhotoComparison {
    double time = 0.0;                                   ///< s, of the simulated debris
    bool withFallen = true;                              ///< fallen live structure counted as debris
    SpreadNumber iou;                                    ///< of the silhouettes
    SpreadNumber edgePixels;                             ///< px of the photograph, mean distance of the edges
    SpreadNumber edgeMetres;                             ///< m, the same at the mean distance of the debris that is seen
    double distance = 0.0;                               ///< m, that distance: depth ahead of the camera
    double pixelMetres = 0.0;                            ///< m, that a pixel of the photograph covers there
    int cameras = 0;                                     ///< drawn
    SilhouetteScore score;                               ///< with the camera as found, px of the grid
    double scale = 1.0;                                  ///< pixels of the grid per pixel of the photograph
    std::optional<std::array<double, 2>> iouOverTime;    ///< least and most over the time of the photograph and its uncertainty
    std::vector<std::vector<Eigen::Vector2d>> outlines;  ///< px of the photograph, of the simulated debris
    Message words;
};

/// Cameras drawn from the uncertainty of a match: a multivariate t distribution about it, with the covariance as scale and the
/// freedom of the match, as its 95 % regions have it. Deterministic.
std::vector<CameraModel> drawnCameras(const CameraMatch& match, int count, std::uint64_t seed);

/// Compares a site with what is drawn on a photograph. No result depends on the number of threads.
/// Throws UsageError if no outline of debris is drawn, or the camera sees no debris and none is drawn within what counts;
/// Cancelled.
PhotoComparison compareWithPhoto(const SiteShape& site, const Photograph& photograph, const CameraMatch& match,
                                 const ComparisonSettings& settings, const Execution& execution);

/// The same for a run at the time of the photograph, and at the ends of its uncertainty within the run. Throws as above and as
/// siteOfRun().
PhotoComparison compareRunWithPhoto(const MappedRun& run, const Photograph& photograph, const CameraMatch& match,
                                    const ComparisonSettings& settings, const Execution& execution);

}  // namespace rubble
