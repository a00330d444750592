#include "core/engine/world/body_shapes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/convex_body.h"
#include "core/base/convex_hull.h"
#include "core/base/same_bits.h"
#include "core/engine/world/bricks.h"
#include "core/engine/world/bullet_shapes.h"
#include "core/engine/world/tight_box.h"

namespace rubble {

namespace {

/// Members whose own axes are tried for the box of a cluster.
constexpr std::size_t axesTried = 6;
/// m. Margin of a hull, or this share of its least half extent if that is less.
constexpr double hullMargin = 0.02;
constexpr double hullMarginShare = 0.1;

double leastHalf(const Vec3& halfExtents, const FragmentSettings& settings) {
    return std::max(settings.minimumHalfExtent, settings.minimumThicknessRatio * halfExtents.maxCoeff());
}

ConvexPart boxPart(OrientedBox box, const FragmentSettings& settings) {
    box.halfExtents = box.halfExtents.cwiseMax(leastHalf(box.halfExtents, settings));
    return {box, {}, 0.0};
}

/// A box around scattered members, drawn in towards the centre of mass until it holds at most `bulking` times their boxes.
OrientedBox drawnIn(OrientedBox box, const FragmentSet& fragments, std::span<const FragmentId> members, double bulking) {
    double material = 0.0;
    for (const FragmentId f : members) {
        material += fragments.list[at(f)].box.volume();
    }
    const double scale = cubeRootOf(bulking * material / box.volume());
    if (scale < 1.0) {
        box.centre *= scale;
        box.halfExtents *= scale;
    }
    return box;
}

std::vector<Vec3> verticesIn(const FragmentSet& fragments, std::span<const FragmentId> members, const Pose& frame) {
    const Quat inverse = frame.orientation.conjugate();
    std::vector<Vec3> points;
    for (const FragmentId f : members) {
        for (const Vec3& p : fragments.verticesOf(f)) {
            points.push_back(inverse * (p - frame.position));
        }
    }
    return points;
}

/// Axes of some members' boxes, evenly spread over them, in the frame of the body.
std::vector<Mat3> memberAxes(const FragmentSet& fragments, std::span<const FragmentId> members, const Pose& frame) {
    std::vector<Mat3> axes;
    const std::size_t count = std::min(members.size(), axesTried);
    for (std::size_t i = 0; i < count; ++i) {
        const Fragment& fragment = fragments.list[at(members[i * members.size() / count])];
        axes.push_back((frame.orientation.conjugate() * fragment.box.orientation).toRotationMatrix());
    }
    return axes;
}

/// Axes along each face of a hull and one of its edges: the tightest box lies along some face.
std::vector<Mat3> faceAxes(const ConvexHull& hull) {
    std::vector<Mat3> axes;
    for (const HullFace& face : hull.faces) {
        for (std::size_t k = 0; k < face.corners.size(); ++k) {
            Mat3 along;
            along.col(0) = face.normal;
            along.col(1) = (hull.corners[face.corners[(k + 1) % face.corners.size()]] - hull.corners[face.corners[k]]).normalized();
            along.col(2) = along.col(0).cross(along.col(1));
            axes.push_back(along);
        }
    }
    return axes;
}

/// The extreme points in directions spread over the sphere (Fibonacci spiral): a subset of the hull's vertices.
std::vector<Vec3> extremePoints(const std::vector<Vec3>& points, std::size_t directions) {
    std::vector<std::size_t> chosen;
    const double golden = M_PI * (3.0 - std::sqrt(5.0));
    for (std::size_t i = 0; i < directions; ++i) {
        const double z = 1.0 - 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(directions);
        const double r = std::sqrt(1.0 - z * z);
        const double angle = golden * static_cast<double>(i);
        const Vec3 direction(r * cosineOf(angle), r * sineOf(angle), z);
        const auto best = std::max_element(points.begin(), points.end(),
                                           [&](const Vec3& a, const Vec3& b) { return direction.dot(a) < direction.dot(b); });
        chosen.push_back(static_cast<std::size_t>(best - points.begin()));
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    std::vector<Vec3> extremes;
    for (const std::size_t i : chosen) {
        extremes.push_back(points[i]);
    }
    return extremes;
}

}  // namespace

OrientedBox boxIn(const Pose& frame, OrientedBox box) {
    box.centre = frame.orientation.conjugate() * (box.centre - frame.position);
    box.orientation = frame.orientation.conjugate() * box.orientation;
    return box;
}

CollisionShape bricksShape(std::span<const OrientedBox> bricks, const FragmentSettings& settings, double finest) {
    // Thin bricks are made thicker before they are joined: the least thickness goes by an element's length, not a whole span's.
    std::vector<OrientedBox> thick;
    for (const OrientedBox& brick : bricks) {
        thick.push_back(boxPart(brick, settings).box);
    }
    CollisionShape parts;
    JoinLimits limits;
    limits.finest = finest;
    for (const OrientedBox& box : joinedBricks(thick, limits)) {
        parts.push_back({box, {}, 0.0});
    }
    return parts;
}

BodyFrame bodyFrame(const Cluster& cluster) {
    return bodyFrame(cluster.centre, cluster.inertia);
}

BodyFrame bodyFrame(const Vec3& centre, const Mat3& inertia) {
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(inertia);
    Mat3 axes = principal.eigenvectors();
    if (axes.determinant() < 0.0) {
        axes.col(2) = -axes.col(2);
    }
    return {{centre, Quat(axes).normalized()}, principal.eigenvalues()};
}

ConvexPart hullOf(std::span<const Vec3> points, double leastHalfExtent) {
    OrientedBox box = tightBox(points, {}, false);
    if (box.halfExtents.minCoeff() < leastHalfExtent) {
        box.halfExtents = box.halfExtents.cwiseMax(leastHalfExtent);
        return {box, {}, 0.0};
    }
    const double margin = std::min(hullMargin, hullMarginShare * box.halfExtents.minCoeff());
    std::vector<Vec3> vertices = hullVertices(points, 0.0);
    // They come from a grid of integers: on their own points flat faces are flat.
    for (Vec3& vertex : vertices) {
        const Vec3 rough = vertex;
        vertex = *std::ranges::min_element(points, {}, [&](const Vec3& p) { return (p - rough).squaredNorm(); });
    }
    if (vertices.size() > hullCornersMax) {
        vertices = extremePoints(vertices, hullCornersMax);
    }
    if (vertices.size() < 4) {
        return {box, {}, 0.0};
    }
    // The smallest side of a body is that of the box around it: one that lies askew would make it thicker than it is.
    box = tightBox(vertices, faceAxes(hullFaces(vertices)), false);
    return {box, std::move(vertices), margin};
}

CollisionShape clusterShape(const FragmentSet& fragments, std::span<const FragmentId> members, const Pose& frame, ClusterShape kind,
                            double boxBulking, const FragmentSettings& settings, double finest) {
    if (kind == ClusterShape::Compound || (kind == ClusterShape::OrientedBox && members.size() == 1)) {
        CollisionShape parts;
        for (const FragmentId f : members) {
            parts.push_back(boxPart(boxIn(frame, fragments.list[at(f)].box), settings));
        }
        return parts;
    }
    if (kind == ClusterShape::Bricks) {
        std::vector<OrientedBox> bricks;
        for (const FragmentId f : members) {
            bricks.push_back(boxIn(frame, brickOf(fragments.solid[at(f)], fragments.verticesOf(f))));
        }
        return bricksShape(bricks, settings, finest);
    }
    const std::vector<Vec3> points = verticesIn(fragments, members, frame);
    if (kind == ClusterShape::AxisBox) {
        const OrientedBox box = boxWithAxes(points, frame.orientation.conjugate().toRotationMatrix());
        return {boxPart(drawnIn(box, fragments, members, boxBulking), settings)};
    }
    if (kind == ClusterShape::Hull) {
        return {hullOf(points, settings.minimumHalfExtent)};
    }
    const OrientedBox box = tightBox(points, memberAxes(fragments, members, frame));
    return {boxPart(drawnIn(box, fragments, members, boxBulking), settings)};
}

double smallestSide(const CollisionShape& shape) {
    double side = 0.0;
    for (const ConvexPart& part : shape) {
        side = std::max(side, 2.0 * part.box.halfExtents.minCoeff());
    }
    return side;
}

}  // namespace rubble
