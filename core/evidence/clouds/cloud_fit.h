#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/clouds/point_index.h"
#include "core/scenario/registration.h"

namespace rubble {

/// How one cloud is fitted to another. Lengths are in units of the places.
struct CloudFitSettings {
    /// Points of the first cloud within it about a point of the second give the plane that it belongs on. What is out of place by
    /// more does not find its way.
    double radius = 0.0;
    /// Share of the pairs that count: the others may have moved, or lie on what one cloud alone has. Of the surfaces that look
    /// along one axis half always counts.
    double kept = 0.8;
    int rounds = 60;  ///< at most
};

/// A rigid move that brings the second cloud onto the first, and how well it is known.
struct CloudFit {
    Mat3 turn = Mat3::Identity();
    Vec3 about = Vec3::Zero();  ///< middle of the points that were fitted; the turn is about it
    Vec3 shift = Vec3::Zero();
    double cube = 0.0;       ///< side of the cubes that one point each was taken of: the radius, or more where they are too many
    std::int64_t pairs = 0;  ///< points with a plane
    int rounds = 0;
    bool settled = false;
    double before = 0.0;             ///< root mean square of the distances to their planes of the pairs that count
    double after = 0.0;              ///< the same once moved
    Vec3 shiftError = Vec3::Zero();  ///< standard deviation of the shift along each axis
    Vec3 turnError = Vec3::Zero();   ///< rad, of the turn about each axis
    double unevenness = 0.0;         ///< standard deviation of the mean distance from patch to patch, beyond that of noise
    /// Standard deviation along the normals that the place of the second cloud then has: of the fit and of unevenness.
    double error = 0.0;

    Vec3 operator()(const Vec3& place) const { return about + shift + turn * (place - about); }
    /// m, rad: how far it moves and turns.
    double distance() const { return shift.norm(); }
    double angle() const;
    /// Standard deviation that a place may be off by along its worst axis: where surfaces tell little about a direction or a turn,
    /// it is more than that along the normals. @param place  once moved
    double errorAt(const Vec3& place) const;
};

/// Fits by trimmed iterated closest planes (Chen & Medioni 1992; Chetverikov et al. 2002): each point of the second cloud is held
/// against the plane through the points of the first about it, and the nearest share of them decides.
/// @param second  points of what did not move; one to each cube of the radius is used, or of greater cubes, so that they are no
/// more than 200,000 and lie everywhere
/// Throws UsageError (fewer than 50 points have a plane; planes that leave a direction or a turn open), Cancelled.
CloudFit fitCloud(const PointIndex& first, const std::vector<Vec3>& second, const CloudFitSettings& settings,
                  const Execution& execution);

/// How a cloud lies that was fitted from where a case had placed it. What is known of the pairs stays.
/// @param before  unset: it lay as its coordinates say; @param around  what the error holds for, at its worst corner
Registration fittedOn(const std::optional<Registration>& before, const CloudFit& fit, const Aabb& around);

}  // namespace rubble
