#pragma once

#include <Eigen/Dense>

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/message.h"
#include "core/evidence/photographs/camera_model.h"
#include "core/scenario/photograph.h"

namespace rubble {

/// How a match came out.
enum class MatchVerdict : std::uint8_t { Good, Usable, Poor };

/// A camera that sees the points where the picture shows them.
struct CameraMatch {
    CameraModel camera;
    std::vector<bool> used;                  ///< false: the pair looks wrong [pairs]
    std::vector<Eigen::Vector2d> residuals;  ///< px, picture less projection; NaN behind the camera [pairs]
    double rms = 0.0;                        ///< px, length of the residuals of the pairs used
    double sigma = 0.0;                      ///< px, of one coordinate, freedom taken into account
    int freedom = 0;             ///< coordinates of the pairs used less numbers found; of an unknown lens what is told of it
    std::vector<int> found;      ///< which of the numbers of the camera were found, ascending
    Eigen::MatrixXd covariance;  ///< of these, in their order and their units (camera_model.h)
    double distance = 0.0;       ///< m, from the camera to the middle of the points used
    double placeRadius = 0.0;    ///< m, longest half axis of the 95 % ellipsoid of the place
    double turnRadius = 0.0;     ///< rad, likewise of the turn
    MatchVerdict verdict = MatchVerdict::Poor;
    Message words;      ///< the verdict as a sentence, with its numbers
    Findings findings;  ///< what the spread of the clicks does not explain, and what the points leave open

    /// Numbers of the pairs that look wrong.
    std::vector<std::size_t> wrong() const;
    /// Whether a pose (place, and turn about the camera's axes from this one) lies in the 95 % region of the pose: the ellipsoid of
    /// all six numbers together, by Fisher's F, since the spread of the clicks is itself taken from the residuals.
    bool holds(const CameraModel& other) const;
};

/// Finds the camera: poses of three pairs at a time (and of a row of focal lengths and lenses if these are free) are tried in a
/// fixed order, the one that most pairs agree with is refined by least squares (Levenberg-Marquardt), and pairs that lie farther
/// than four standard deviations off are set aside, until none changes; then those without which the others fit far better. The
/// covariance is that of linear theory at the solution. A lens of which nothing is said is found as far as the points tell it, and
/// is else taken for one of those that there are (lens.h): its part of the covariance is what they leave open. A match whose
/// residuals show that lens, focal length or principal point are others than was stated (F tests) is not good, and says so.
/// Deterministic. Throws UsageError naming the remedy for numbers that are none, too few pairs for what is to be found, points on
/// one line, points in one plane with a free focal length, pairs that no camera agrees with, sets that leave the pose or the focal
/// length open, and two poses that fit alike; Cancelled.
CameraMatch matchCamera(const std::vector<PointPair>& pairs, const CameraKnowledge& known, const Execution& execution);

/// How names of pairs begin that were made from the camera that a cloud states for its picture, not clicked by somebody.
inline constexpr std::string_view statedPairName = "pose of the cloud";
/// Whether the camera of a photograph is one that was stated: then its residuals say nothing of how well it is known.
bool cameraStated(const Photograph& photograph);

/// The camera of a photograph by its pairs. Of a stated one the radii of place and turn are not known (NaN).
CameraMatch matchPhotograph(const Photograph& photograph, const Execution& execution);

}  // namespace rubble
