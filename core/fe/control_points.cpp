#include "core/fe/control_points.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/base/error.h"

namespace rubble {

namespace {

using Plan = std::complex<double>;

Plan plan(const Vec3& p) {
    return {p.x(), p.y()};
}

void check(const std::vector<ControlPoint>& points) {
    for (const ControlPoint& point : points) {
        if (!point.local.allFinite() || !point.world.allFinite()) {
            throw UsageError(
                {"control_points.number", "The control point \"{0}\" has a coordinate that is no number", {point.name}},
                {"control_points.number.remedy", "Give it coordinates in metres, or remove it.", {}});
        }
    }
    if (usedPoints(points) < 2) {
        throw UsageError({"control_points.few", "{0} control points are used; a similarity takes two", {usedPoints(points)}},
                         {"control_points.few.remedy", "Add points, three or more so that a wrong one shows.", {}});
    }
}

void addResiduals(SiteFit& fit, const std::vector<ControlPoint>& points) {
    double plane = 0.0;
    double height = 0.0;
    for (const ControlPoint& point : points) {
        const Vec3 off = point.world - fit.toWorld(point.local);
        fit.residuals.push_back(off);
        if (point.used) {
            plane += off.head<2>().squaredNorm();
            height += off.z() * off.z();
        }
    }
    fit.rmsPlan = std::sqrt(plane / static_cast<double>(fit.used));
    fit.rmsHeight = std::sqrt(height / static_cast<double>(fit.used));
}

}  // namespace

std::size_t usedPoints(const std::vector<ControlPoint>& points) {
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [](const ControlPoint& p) { return p.used; }));
}

Vec3 SiteFit::toWorld(const Vec3& local) const {
    const Plan at = std::polar(scale, angle) * plan(local);
    return {at.real() + shift.x(), at.imag() + shift.y(), local.z() + height};
}

Vec3 SiteFit::toLocal(const Vec3& world) const {
    const Plan at = (plan(world) - Plan(shift.x(), shift.y())) / std::polar(scale, angle);
    return {at.real(), at.imag(), world.z() - height};
}

SiteFit fitControlPoints(const std::vector<ControlPoint>& points) {
    check(points);
    SiteFit fit;
    fit.used = usedPoints(points);
    const double share = 1.0 / static_cast<double>(fit.used);
    Vec3 local = Vec3::Zero();
    Vec3 world = Vec3::Zero();
    for (const ControlPoint& point : points) {
        if (point.used) {
            local += share * point.local;
            world += share * point.world;
        }
    }
    // Moved to the means, the factor that turns and stretches is a quotient of sums over complex numbers.
    Plan across = 0.0;
    double spread = 0.0;
    double extent = 0.0;
    for (const ControlPoint& point : points) {
        if (point.used) {
            const Plan from = plan(point.local - local);
            across += plan(point.world - world) * std::conj(from);
            spread += std::norm(from);
            extent = std::max(extent, point.local.head<2>().norm());
        }
    }
    if (!(spread > 1e-12 * (1.0 + extent * extent)) || !(std::abs(across) > 1e-9 * spread)) {
        throw UsageError({"control_points.one_place", "The control points lie in one place in plan", {}},
                         {"control_points.one_place.remedy", "Choose points as far apart as the site allows.", {}});
    }
    const Plan factor = across / spread;
    fit.scale = std::abs(factor);
    fit.angle = std::arg(factor);
    const Plan shift = plan(world) - factor * plan(local);
    fit.shift = {shift.real(), shift.imag()};
    fit.height = world.z() - local.z();
    addResiduals(fit, points);
    return fit;
}

namespace {

constexpr double scaleExpected = 0.005;     ///< share by which a scale may depart
constexpr double residualExpected = 0.005;  ///< share of the distance between points
constexpr double leastInPlan = 0.1;         ///< m
constexpr double leastInHeight = 0.25;      ///< m

double farthestApart(const std::vector<ControlPoint>& points) {
    double most = 0.0;
    for (const ControlPoint& a : points) {
        for (const ControlPoint& b : points) {
            if (a.used && b.used) {
                most = std::max(most, (a.world - b.world).head<2>().norm());
            }
        }
    }
    return most;
}

/// Whether the points fit well once one axis of the frame is turned against itself.
bool mirrored(std::vector<ControlPoint> points, const SiteFit& fit) {
    for (ControlPoint& point : points) {
        point.local.y() = -point.local.y();
    }
    return fitControlPoints(points).rmsPlan < 0.2 * fit.rmsPlan;
}

/// The used point that is farthest off.
template <class Off>
std::size_t worstOf(const std::vector<ControlPoint>& points, Off off) {
    std::size_t worst = 0;
    double most = -1.0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (points[p].used && off(p) > most) {
            most = off(p);
            worst = p;
        }
    }
    return worst;
}

void checkPlan(Findings& findings, const std::vector<ControlPoint>& points, const SiteFit& fit, double apart, double scale) {
    const auto off = [&](std::size_t p) { return fit.residuals[p].head<2>().norm(); };
    const std::size_t worst = worstOf(points, off);
    const bool far = off(worst) > std::max(leastInPlan, residualExpected * apart);
    if (far && fit.used > 2 && mirrored(points, fit)) {
        findings.add({"site.mirrored",
                      "the control points fit only a mirrored frame: they are {0} off in plan (RMS), where they are {1} apart",
                      {{fit.rmsPlan, "m"}, {apart, "m"}}},
                     {"site.mirrored.remedy",
                      "look for x and y, or easting and northing, that were changed for each other, or an axis against its sign",
                      {}},
                     points[worst].name);
        return;
    }
    if (std::abs(fit.scale / scale - 1.0) > scaleExpected) {
        findings.add(
            {"site.scale",
             "by the control points the model is {0} times as large as it should be there: a point is wrong, or the two sides "
             "have different units",
             {scale / fit.scale}},
            {"site.scale.remedy",
             "give all coordinates in metres, also in a system that counts in feet; else leave points out one by one and look at "
             "the residuals",
             {}},
            points[worst].name);
    }
    if (far) {
        findings.add(
            {"site.residual",
             "the control point \"{0}\" is {1} off in plan, where the points are {2} apart; maps are off by as much",
             {points[worst].name, {off(worst), "m"}, {apart, "m"}}},
            {"site.residual.remedy", "look at its coordinates, or leave it out and look at the residuals of the others", {}},
            points[worst].name);
    }
}

}  // namespace

Findings checkControlPoints(const std::vector<ControlPoint>& points, double scale) {
    Findings findings;
    const std::size_t used = usedPoints(points);
    if (used == 1) {
        findings.add(
            {"site.one_point", "one control point is used, which says nothing: the origin of the frame places everything", {}},
            {"site.one_point.remedy", "use two control points or more, or none", {}});
    }
    if (used < 2) {
        return findings;
    }
    const SiteFit fit = fitControlPoints(points);
    const double apart = farthestApart(points);
    checkPlan(findings, points, fit, apart, scale);
    const auto off = [&](std::size_t p) { return std::abs(fit.residuals[p].z()); };
    const std::size_t worst = worstOf(points, off);
    if (off(worst) > std::max(leastInHeight, residualExpected * apart)) {
        findings.add(
            {"site.height_residual",
             "the control point \"{0}\" is {1} off in height, where the points are {2} apart; heights of terrain and surveys are "
             "off "
             "by as much",
             {points[worst].name, {off(worst), "m"}, {apart, "m"}}},
            {"site.height_residual.remedy", "look at its heights, or leave it out and look at the residuals of the others", {}},
            points[worst].name);
    }
    return findings;
}

}  // namespace rubble
