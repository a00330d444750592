#pragma once

#include <optional>
#include <string_view>

#include "core/fe/frame_transform.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// Between the local frame of a case and easting, northing and height in metres: by control points where two or more are used,
/// else by the origin of the frame.
/// What is read into a case and what is written from it go through it alike.
class SitePlace {
public:
    /// Throws UsageError as fitControlPoints() and FrameTransform do.
    SitePlace(const Frame& frame, const Site& site);

    Vec3 toWorld(const Vec3& local) const { return m_transform.toWorld(local); }
    Vec3 toLocal(const Vec3& world) const { return m_transform.toLocal(world); }
    /// The same in plan.
    Eigen::Vector2d planToWorld(const Eigen::Vector2d& local) const { return toWorld(Vec3(local.x(), local.y(), 0.0)).head<2>(); }
    Eigen::Vector2d planToLocal(const Eigen::Vector2d& world) const { return toLocal(Vec3(world.x(), world.y(), 0.0)).head<2>(); }
    /// Of control points, or of the origin alone: then without points, and neither turned nor scaled.
    const SiteFit& transform() const { return m_transform; }
    /// The two frames only differ by a shift.
    bool upright() const { return m_transform.used == 0; }
    std::optional<SiteFit> fit() const { return upright() ? std::nullopt : std::optional(m_transform); }
    /// How places came to be, for people: "metres, z up, origin of the frame added".
    std::string_view words() const;

private:
    SiteFit m_transform;
};

}  // namespace rubble::io
