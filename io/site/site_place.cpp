#include "io/site/site_place.h"

#include <algorithm>
#include <cmath>

#include "core/fe/north.h"

namespace rubble::io {

double SiteWindow::margin() const {
    const Vec3 size = structure.sizes();
    return std::max({windowHeights * size.z(), size.x(), size.y()});
}

Eigen::AlignedBox2d SiteWindow::plan() const {
    Eigen::AlignedBox2d plan;
    const auto add = [&plan](const Aabb& box, double around) {
        if (!box.isEmpty()) {
            plan.extend(Eigen::Vector2d(box.min().head<2>().array() - around));
            plan.extend(Eigen::Vector2d(box.max().head<2>().array() + around));
        }
    };
    add(structure, margin());
    add(debris, 0.2 * margin());
    return plan;
}

SitePlace::SitePlace(const Frame& frame, const Site& site) {
    if (usedPoints(site.controlPoints) >= 2) {
        m_transform = fitControlPoints(site.controlPoints);
        // A millionth of a metre at a kilometre is rounding, no turn.
        m_transform.angle = std::abs(m_transform.angle) < 1e-9 ? 0.0 : m_transform.angle;
    } else {
        const Vec3 zero = FrameTransform(frame).localZero();
        m_transform.shift = zero.head<2>();
        m_transform.height = zero.z();
    }
    m_system = placedSystem(m_transform, frame.crs);
    m_unplaced = m_system.empty() && !frame.crs.empty();
}

std::string_view SitePlace::words() const {
    if (m_unplaced) {
        return "metres, z up, axes of the model: it has no place in the coordinate system that the case names";
    }
    return upright() ? "metres, z up, origin of the frame added"
                     : "metres, z up, easting, northing and height by the control points of the site";
}

}  // namespace rubble::io
