#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/fe/frame_transform.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// Heights of the structure around it that fragments may reach.
inline constexpr double windowHeights = 10.0;

/// What is read of a site, m in the local frame: around the structure, and as far as debris went.
struct SiteWindow {
    Aabb structure;    ///< at rest; empty: everything is read
    Aabb debris = {};  ///< that is known to lie farther off; empty: none is

    // What only knows the structure asks for the window about it.
    SiteWindow(const Aabb& structure_ = {}, const Aabb& debris_ = {}) : structure(structure_), debris(debris_) {}
    bool whole() const { return structure.isEmpty(); }
    /// Ten times the height of the structure, or its length, whichever is more.
    double margin() const;
    /// The structure with its margin, and the debris with two heights of the structure around it.
    Eigen::AlignedBox2d plan() const;
};

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
    /// The coordinate system that places are in, as placedSystem().
    const std::string& system() const { return m_system; }
    /// How places came to be, for people: "metres, z up, origin of the frame added".
    std::string_view words() const;

private:
    SiteFit m_transform;
    std::string m_system;
    bool m_unplaced = false;  ///< the case names a system without a place in it
};

}  // namespace rubble::io
