#pragma once

#include <cstddef>
#include <vector>

#include "core/evidence/photographs/camera_match.h"
#include "core/evidence/photographs/lens.h"

namespace rubble {

/// Of the regions that are stated.
inline constexpr double matchConfidence = 0.95;

/// What a camera is sought from.
struct MatchTask {
    const std::vector<PointPair>& pairs;
    const CameraKnowledge& known;

    double diagonal() const;
    /// px, least spread of clicks when pairs are set aside: nobody clicks better.
    double leastSpread() const;
    /// How the radial terms are drawn back, by the spread of the clicks [px]; not at all where it was said what is to be found.
    LensPull pull(const CameraModel& camera, double sigma) const;
};

/// Numbers of the camera that are found, ascending, with or without the terms of an unknown lens.
std::vector<int> numbersToFind(const CameraKnowledge& known, bool lens);

/// The residuals of all pairs, and how those that are used spread.
void takeResiduals(CameraMatch& match, const MatchTask& task);

/// Covariance, and the spread of the clicks with its freedom. The camera of an unknown lens settles by them. False if the pairs
/// leave something open.
bool takeRegion(CameraMatch& match, const MatchTask& task);

/// Radii of the region, what the residuals say against the settings, verdict and words.
void takeVerdict(CameraMatch& match, const MatchTask& task);

}  // namespace rubble
