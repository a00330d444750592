#pragma once

#include <span>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/photographs/camera_match.h"
#include "core/evidence/photographs/lens.h"

namespace rubble {

/// A camera to begin from, and how well the pairs agree with it.
struct CameraGuess {
    CameraModel camera;
    double cost = 0.0;  ///< sum of the squared residuals over the square of the tolerance, each at most 1
    std::size_t agree = 0;
};

/// Cost of a camera and the pairs within the tolerance [px].
CameraGuess judged(const CameraModel& camera, const std::vector<PointPair>& pairs, double tolerance);

/// Cameras from three pairs at a time, best first, at most `most` of them and no two alike. Triples are all there are, or else
/// spread over the pairs by a fixed sequence; a free focal length is tried in steps from wide angle to telephoto, an unknown lens
/// as one without distortion, a barrel and a cushion.
std::vector<CameraGuess> cameraGuesses(const std::vector<PointPair>& pairs, const CameraKnowledge& known, double tolerance,
                                       std::size_t most, const Execution& execution);

/// Changes some numbers of a camera until the weighted squared residuals of the pairs are least (Levenberg-Marquardt).
/// @param weights  [pairs]; 0: left out
/// @param found    which numbers
/// @param pull     of the radial terms, if they are among them
/// Returns false if it did not settle on a camera that has all these points ahead.
bool refine(CameraModel& camera, const std::vector<PointPair>& pairs, const std::vector<double>& weights,
            std::span<const int> found, const LensPull& pull = {});

}  // namespace rubble
