#include "core/fragments/solids.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/same_bits.h"

namespace rubble {

namespace {

/// Direction of a vector and the rate at which that direction turns; the fallback where it has no length.
struct Director {
    Vec3 direction;
    Vec3 rate = Vec3::Zero();
};

Director directorOf(const Vec3& vector, const Vec3& rate, const Vec3& fallback) {
    const double length = vector.norm();
    if (!(length > 0.0)) {
        return {fallback};
    }
    const Vec3 direction = vector / length;
    return {direction, (rate - direction * direction.dot(rate)) / length};
}

/// Normal of the mean plane of a shell and its rate: from the area vector, half the cross product of two edges or diagonals.
Director shellNormal(int corners, const Corners& x, const Corners& v) {
    const int last = corners - 1;
    const int opposite = corners == 4 ? 2 : 1;
    const int start = corners == 4 ? 1 : 0;
    const Vec3 a = x.col(opposite) - x.col(0);
    const Vec3 b = x.col(last) - x.col(start);
    const Vec3 aRate = v.col(opposite) - v.col(0);
    const Vec3 bRate = v.col(last) - v.col(start);
    return directorOf(a.cross(b), aRate.cross(b) + a.cross(bRate), Vec3::UnitZ());
}

MovingSolid extrudedShell(int corners, const Corners& x, const Corners& v, double thickness) {
    const Director normal = shellNormal(corners, x, v);
    MovingSolid solid;
    solid.shape = corners == 4 ? ElementShape::Hexahedron : ElementShape::Wedge;
    for (int a = 0; a < corners; ++a) {
        for (const int side : {0, 1}) {
            const double height = (side == 0 ? -0.5 : 0.5) * thickness;
            solid.positions.col(a + side * corners) = x.col(a) + height * normal.direction;
            solid.velocities.col(a + side * corners) = v.col(a) + height * normal.rate;
        }
    }
    return solid;
}

MovingSolid extrudedBeam(const Corners& x, const Corners& v, double area) {
    const Director axis = directorOf(x.col(1) - x.col(0), v.col(1) - v.col(0), Vec3::UnitX());
    const Vec3 spin = axis.direction.cross(axis.rate);
    // The section lies level where it can; a vertical beam's along x.
    const bool upright = std::abs(axis.direction.z()) > 0.9;
    const Vec3 across = axis.direction.cross(upright ? Vec3::UnitX() : Vec3::UnitZ()).normalized();
    const Vec3 other = axis.direction.cross(across);
    const double half = 0.5 * std::sqrt(area);
    MovingSolid solid;
    for (int a = 0; a < 8; ++a) {
        const int end = a / 4;
        const Vec3 arm = half * ((a % 4 == 0 || a % 4 == 3 ? -1.0 : 1.0) * across + (a % 4 < 2 ? -1.0 : 1.0) * other);
        solid.positions.col(a) = x.col(end) + arm;
        solid.velocities.col(a) = v.col(end) + spin.cross(arm);
    }
    return solid;
}

Mat3 nearestRotationBySvd(const Mat3& matrix) {
    const Eigen::JacobiSVD<Mat3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0.0) {
        u.col(2) *= -1.0;  // the smallest singular value pays for the reflection
    }
    return u * svd.matrixV().transpose();
}

/// Share of its box that the leanest sound solid fills; what fills less is flat across the box and wants other axes.
constexpr double leanFill = 0.02;

Mat3 principalAxes(const Corners& corners, int count) {
    const Corners centred = corners.colwise() - corners.leftCols(count).rowwise().mean();
    const Mat3 spread = centred.leftCols(count) * centred.leftCols(count).transpose();
    return nearestRotation(Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors());
}

void becomeBox(SoundSolid& solid) {
    solid.shape = ElementShape::Hexahedron;
    solid.boxed = true;
    for (int a = 0; a < 8; ++a) {
        const Vec3 sign(a % 4 == 0 || a % 4 == 3 ? -1.0 : 1.0, a % 4 < 2 ? -1.0 : 1.0, a < 4 ? -1.0 : 1.0);
        solid.corners.col(a) = solid.box.centre + solid.box.orientation * sign.cwiseProduct(solid.box.halfExtents);
    }
}

/// Beyond this stretch a shape is noise.
constexpr double mostStretch = 1e4;

double boxVolume(const Corners& corners, const Mat3& axes) {
    const Corners local = axes.transpose() * corners;
    return (local.rowwise().maxCoeff() - local.rowwise().minCoeff()).prod();
}

/// How much smaller a box must be to win: the even-handed frame keeps every tie.
constexpr double leaner = 1.0 - 1e-6;

/// The frame along the given unit edge directions whose box around the corners is smallest: between all three, or along one edge
/// and in the plane of another, which fits sheared elements better.
Mat3 leanestFrame(const Corners& corners, const Mat3& edges) {
    Mat3 best = nearestRotation(edges);
    double least = boxVolume(corners, best);
    for (int along = 0; along < 3; ++along) {
        for (int across = 0; across < 3; ++across) {
            if (across == along) {
                continue;
            }
            Mat3 frame;
            frame.col(0) = edges.col(along);
            frame.col(2) = edges.col(along).cross(edges.col(across)).normalized();
            frame.col(1) = frame.col(2).cross(frame.col(0));
            const double volume = boxVolume(corners, frame);
            if (volume < leaner * least) {
                least = volume;
                best = frame;
            }
        }
    }
    return best;
}

}  // namespace

MovingSolid solidOf(ElementShape element, const Corners& positions, const Corners& velocities, double section) {
    if (isShell(element)) {
        return extrudedShell(cornerCount(element), positions, velocities, section);
    }
    if (element == ElementShape::Beam) {
        return extrudedBeam(positions, velocities, section);
    }
    return {element, positions, velocities};
}

Mat3 nearestRotation(const Mat3& matrix) {
    const double size = matrix.norm();
    const double determinant = matrix.determinant();
    if (!(determinant > 1e-3 * size * size * size)) {
        return nearestRotationBySvd(matrix);
    }
    // Newton's iteration for the polar factor (Higham 1986), quadratic from here on.
    Mat3 rotation = matrix / cubeRootOf(determinant);
    for (int i = 0; i < 30; ++i) {
        const Mat3 next = 0.5 * (rotation + rotation.inverse().transpose());
        const double change = (next - rotation).squaredNorm();
        rotation = next;
        if (change < 1e-24) {
            return rotation;
        }
    }
    return nearestRotationBySvd(matrix);
}

Mat3 boxAxes(const Corners& reference, const Corners& present) {
    Mat3 atRest = centreJacobian(reference);
    const Mat3 now = centreJacobian(present);
    const double scale = atRest.norm();
    if (!(std::abs(atRest.determinant()) > 1e-9 * scale * scale * scale)) {
        return nearestRotation(now);
    }
    const Mat3 deformation = now * atRest.inverse();
    atRest.colwise().normalize();
    return nearestRotation(deformation) * leanestFrame(reference, atRest);
}

OrientedBox boxAround(const Corners& corners, int count, const Mat3& axes) {
    const auto local = (axes.transpose() * corners.leftCols(count)).eval();
    const Vec3 low = local.rowwise().minCoeff();
    const Vec3 high = local.rowwise().maxCoeff();
    return {axes * (0.5 * (low + high)), Quat(axes).normalized(), 0.5 * (high - low)};
}

void unmirror(ElementShape shape, Corners& corners) {
    const auto swap = [&](int a, int b) { corners.col(a).swap(corners.col(b)); };
    switch (shape) {
        case ElementShape::Pyramid:
            swap(1, 3);
            break;
        case ElementShape::Tetrahedron:
            swap(1, 2);
            break;
        default:
            for (int a = 0; a < cornerCount(shape) / 2; ++a) {
                swap(a, a + cornerCount(shape) / 2);
            }
    }
}

double minimumHalfExtent(const Vec3& halfExtents, double ratio, double least) {
    return std::max(least, ratio * halfExtents.maxCoeff());
}

SoundSolid soundSolid(const MovingSolid& solid, SolidState state, double volume, const Mat3& axes, double ratio, double least) {
    const int count = cornerCount(solid.shape);
    SoundSolid sound{solid.shape, solid.positions, boxAround(solid.positions, count, axes)};
    if (std::abs(volume) < leanFill * sound.box.volume() || state == SolidState::Collapsed) {
        const OrientedBox principal = boxAround(solid.positions, count, principalAxes(solid.positions, count));
        if (principal.volume() <= sound.box.volume()) {
            sound.box = principal;
        }
    }
    const double minimum = minimumHalfExtent(sound.box.halfExtents, ratio, least);
    const Vec3 extents = sound.box.halfExtents.cwiseMax(minimum);
    // A box that already has the minimum may miss it by rounding.
    sound.thickened = sound.box.halfExtents.minCoeff() < minimum * (1.0 - 1e-9);
    const bool ownShape = (state == SolidState::Sound || state == SolidState::Mirrored) &&
                          (extents.array() <= mostStretch * sound.box.halfExtents.array()).all();
    if (state == SolidState::Mirrored) {
        unmirror(sound.shape, sound.corners);
    }
    if (ownShape && sound.thickened) {
        const Mat3 turn = sound.box.orientation.toRotationMatrix();
        const Vec3 stretch = extents.cwiseQuotient(sound.box.halfExtents);
        sound.corners =
            ((turn * stretch.asDiagonal() * turn.transpose()) * (sound.corners.colwise() - sound.box.centre)).colwise() +
            sound.box.centre;
    }
    sound.box.halfExtents = extents;
    if (!ownShape) {
        becomeBox(sound);
    }
    return sound;
}

}  // namespace rubble
