#pragma once

#include <optional>

#include "core/fe/frame_transform.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// Between the local frame of a case and easting, northing and height in metres: by control points where two or more are used,
/// else by the origin of the frame.
class SitePlace {
public:
    /// Throws UsageError as fitControlPoints() and FrameTransform do.
    SitePlace(const Frame& frame, const Site& site);

    Vec3 toWorld(const Vec3& local) const { return m_fit ? m_fit->toWorld(local) : Vec3(local - m_shift); }
    Vec3 toLocal(const Vec3& world) const { return m_fit ? m_fit->toLocal(world) : Vec3(world + m_shift); }
    /// The two frames only differ by a shift.
    bool upright() const { return !m_fit; }
    const Vec3& shift() const { return m_shift; }  ///< m, world to local, of an upright one
    const std::optional<SiteFit>& fit() const { return m_fit; }

private:
    Vec3 m_shift;
    std::optional<SiteFit> m_fit;
};

}  // namespace rubble::io
