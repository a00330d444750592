#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/base/geometry.h"

namespace rubble {

/// A point known both in the local frame of a case and in the world's coordinates.
struct ControlPoint {
    std::string name;
    Vec3 local = Vec3::Zero();  ///< m, as the views show it
    Vec3 world = Vec3::Zero();  ///< m: easting, northing and height
    bool used = true;           ///< takes part in the fit
    friend bool operator==(const ControlPoint&, const ControlPoint&) = default;
};

/// How a local frame lies in the world: world = scale R(angle) local + shift in plan, heights moved only.
struct SiteFit {
    double scale = 1.0;
    double angle = 0.0;                               ///< rad, from local x to the line of equal northing, counter-clockwise
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();  ///< m: easting and northing of the local zero
    double height = 0.0;                              ///< m, of the local zero
    std::vector<Vec3> residuals;                      ///< m, measured less fitted, in the world's axes [points]
    std::size_t used = 0;                             ///< points that took part
    double rmsPlan = 0.0;                             ///< m, of those
    double rmsHeight = 0.0;

    Vec3 toWorld(const Vec3& local) const;
    Vec3 toLocal(const Vec3& world) const;
};

/// The similarity of least squares in plan (Umeyama 1991 in two dimensions, without reflection) and the mean difference of heights.
/// Throws UsageError for fewer than two points that are used, numbers that are none, or points that lie in one place.
SiteFit fitControlPoints(const std::vector<ControlPoint>& points);

/// What speaks against control points, as findings: one that is used alone, a scale far from that of the system, a mirrored frame,
/// and residuals larger than half a percent of the greatest distance between points (10 cm at least, 25 cm in height).
/// Throws as fitControlPoints() where two or more are used.
/// @param scale  lengths in the world's system by lengths on the ground, there
Findings checkControlPoints(const std::vector<ControlPoint>& points, double scale = 1.0);

/// Points that take part.
std::size_t usedPoints(const std::vector<ControlPoint>& points);

}  // namespace rubble
