#include <cassert>
#include <cmath>

#include "core/fe/components.h"

namespace rubble {

namespace {

// det J of a trilinear hexahedron is at most quadratic in each coordinate: two Gauss points per direction integrate it exactly.
const double gauss = 1.0 / std::sqrt(3.0);

double hexahedronVolume(std::span<const Vec3> x) {
    constexpr int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    double volume = 0.0;
    for (const auto& point : sign) {
        const double r = gauss * point[0], s = gauss * point[1], t = gauss * point[2];
        Mat3 jacobian = Mat3::Zero();
        for (std::size_t a = 0; a < 8; ++a) {
            const double fr = 1.0 + r * sign[a][0], fs = 1.0 + s * sign[a][1], ft = 1.0 + t * sign[a][2];
            jacobian.col(0) += x[a] * (0.125 * sign[a][0] * fs * ft);
            jacobian.col(1) += x[a] * (0.125 * sign[a][1] * fr * ft);
            jacobian.col(2) += x[a] * (0.125 * sign[a][2] * fr * fs);
        }
        volume += jacobian.determinant();
    }
    return volume;
}

// Linear in the triangle's coordinates, quadratic along the axis: one point times two.
double wedgeVolume(std::span<const Vec3> x) {
    double volume = 0.0;
    for (const double t : {-gauss, gauss}) {
        const double low = 0.5 * (1.0 - t), high = 0.5 * (1.0 + t);
        const Vec3 a = low * x[0] + high * x[3], b = low * x[1] + high * x[4], c = low * x[2] + high * x[5];
        const Vec3 along = (x[3] - x[0] + x[4] - x[1] + x[5] - x[2]) / 6.0;
        volume += 0.5 * (b - a).cross(c - a).dot(along);
    }
    return volume;
}

double quadrilateralArea(std::span<const Vec3> x) {
    double area = 0.0;
    for (const double s : {-gauss, gauss}) {
        const Vec3 alongR = 0.25 * ((1.0 - s) * (x[1] - x[0]) + (1.0 + s) * (x[2] - x[3]));
        for (const double r : {-gauss, gauss}) {
            const Vec3 alongS = 0.25 * ((1.0 - r) * (x[3] - x[0]) + (1.0 + r) * (x[2] - x[1]));
            area += alongR.cross(alongS).norm();
        }
    }
    return area;
}

}  // namespace

double elementVolume(ElementShape shape, std::span<const Vec3> corners, double section) {
    assert(corners.size() == static_cast<std::size_t>(cornerCount(shape)));
    const auto& x = corners;
    switch (shape) {
        case ElementShape::Hexahedron:
            return hexahedronVolume(x);
        case ElementShape::Wedge:
            return wedgeVolume(x);
        case ElementShape::Pyramid: {
            // A pyramid is the hexahedron whose upper four corners are its apex.
            const std::array<Vec3, 8> hexahedron{x[0], x[1], x[2], x[3], x[4], x[4], x[4], x[4]};
            return hexahedronVolume(hexahedron);
        }
        case ElementShape::Tetrahedron:
            return (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) / 6.0;
        case ElementShape::Quadrilateral:
            return section * quadrilateralArea(x);
        case ElementShape::Triangle:
            return section * 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm();
        case ElementShape::Beam:
            return section * (x[1] - x[0]).norm();
    }
    assert(false);
    return 0.0;
}

}  // namespace rubble
