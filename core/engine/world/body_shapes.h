#pragma once

#include <span>
#include <vector>

#include "core/clusters/clustering.h"
#include "core/engine/world/rigid_world.h"
#include "core/fragments/fragment_set.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// Frame of the body that carries a cluster: centre of mass and principal axes, and the inertia about them. Mass properties come
/// from the elements only, never from a collision shape or its margin.
struct BodyFrame {
    Pose pose;
    Vec3 inertia = Vec3::Zero();  ///< kg m2, all positive unless the cluster's tensor is broken
};
BodyFrame bodyFrame(const Cluster& cluster);
/// @param inertia  kg m2 about the centre, world axes; all finite
BodyFrame bodyFrame(const Vec3& centre, const Mat3& inertia);

/// A box in world axes, as it lies in a frame.
OrientedBox boxIn(const Pose& frame, OrientedBox box);

/// Bricks (bricks.h), joined, as the parts of a collision shape.
/// @param settings  least half extents
/// @param finest    m, of the boxes (JoinLimits)
CollisionShape bricksShape(std::span<const OrientedBox> bricks, const FragmentSettings& settings, double finest);

/// Collision shape of a cluster in the frame of its body.
/// @param boxBulking  a box is drawn in until it holds at most this many times its fragments' boxes (SimulationSettings)
/// @param settings  least half extents, for flat and needle-like clusters
/// @param finest    m, of bricks
CollisionShape clusterShape(const FragmentSet& fragments, std::span<const FragmentId> members, const Pose& frame, ClusterShape kind,
                            double boxBulking, const FragmentSettings& settings, double finest = 0.0);

/// The hull of points with at most a few dozen vertices, and how Bullet's solver rounds it; a box around
/// them where they span no volume.
ConvexPart hullOf(std::span<const Vec3> points, double leastHalfExtent);

/// Smallest side of a shape as a whole, m: of its only part, or of the thickest part of several.
double smallestSide(const CollisionShape& shape);

}  // namespace rubble
