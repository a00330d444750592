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

}  // namespace rubble
