#include "core/validation/voussoir_arch.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/validation/standing_world.h"

namespace rubble {

namespace {

constexpr double voussoirDensity = 2400.0;  // kg/m3
constexpr double archDepth = 1.0;           // m, along y
constexpr double archSeconds = 6.0;
constexpr double archFinest = 0.01;  // of the thickness
constexpr double archMoved = 0.2;    // of the thickness

/// Area, place of the centre and second moments about it of a trapezoid with its axis of symmetry along z.
struct Trapezoid {
    double low = 0.0, high = 0.0;    ///< m, half widths
    double bottom = 0.0, top = 0.0;  ///< m

    double height() const { return top - bottom; }
    double area() const { return (low + high) * height(); }
    double centre() const { return bottom + height() * (low + 2.0 * high) / (3.0 * (low + high)); }
    /// m4, of z about the centre
    double alongZ() const { return std::pow(height(), 3) * (low * low + 4.0 * low * high + high * high) / (18.0 * (low + high)); }
    /// m4, of x about the axis
    double alongX() const { return height() * (low + high) * (low * low + high * high) / 6.0; }
};

/// A voussoir in a frame with z along the middle of its wedge, y along the depth.
NewBody voussoirOf(double radius, double thickness, double halfAngle, double middle) {
    const double inner = radius - 0.5 * thickness, outer = radius + 0.5 * thickness;
    const Trapezoid face{inner * std::sin(halfAngle), outer * std::sin(halfAngle), inner * std::cos(halfAngle),
                         outer * std::cos(halfAngle)};
    NewBody body;
    body.volume = face.area() * archDepth;
    body.mass = voussoirDensity * body.volume;
    const double perArea = body.mass / face.area();
    const double depth = body.mass * archDepth * archDepth / 12.0;
    body.inertia = {depth + perArea * face.alongZ(), perArea * (face.alongZ() + face.alongX()), depth + perArea * face.alongX()};
    ConvexPart part;
    for (const double y : {-0.5 * archDepth, 0.5 * archDepth}) {
        for (const double side : {-1.0, 1.0}) {
            part.points.emplace_back(side * face.low, y, face.bottom - face.centre());
            part.points.emplace_back(side * face.high, y, face.top - face.centre());
        }
    }
    part.box.halfExtents = {face.high, 0.5 * archDepth, 0.5 * face.height()};
    part.box.centre = {0.0, 0.0, 0.5 * (face.bottom + face.top) - face.centre()};
    body.shape = {part};
    body.smallestSide = 2.0 * part.box.halfExtents.minCoeff();
    const Quat turn(Eigen::AngleAxisd(middle, Vec3::UnitY()));
    body.pose = {turn * Vec3(0.0, 0.0, face.centre()), turn};
    return body;
}

bool archStands(const VoussoirArch& arch, double thickness, const Execution& execution) {
    const std::unique_ptr<RigidWorld> world = standingWorld(arch.friction, execution);
    for (const double side : {-1.0, 1.0}) {
        ConvexPart abutment;
        abutment.box.halfExtents = {2.0 * thickness, archDepth, 0.5};
        world->addPiece({abutment}, {Vec3(side * arch.radius, 0.0, -0.5), Quat::Identity()});
    }
    const double halfAngle = 0.5 * std::numbers::pi / arch.voussoirs;
    std::vector<Vec3> places;
    for (int i = 0; i < arch.voussoirs; ++i) {
        const NewBody body = voussoirOf(arch.radius, thickness, halfAngle, (2 * i + 1) * halfAngle - 0.5 * std::numbers::pi);
        places.push_back(body.pose.position);
        world->addBody(body);
    }
    return staysInPlace(*world, places, archMoved * thickness, archSeconds, arch.stepRate, execution);
}

}  // namespace

double leastArchThickness(const VoussoirArch& arch, const Execution& execution) {
    double falling = 0.05, standing = 0.3;
    while (standing - falling > archFinest * falling) {
        const double middle = 0.5 * (standing + falling);
        (archStands(arch, middle * arch.radius, execution) ? standing : falling) = middle;
    }
    return 0.5 * (standing + falling);
}

}  // namespace rubble
