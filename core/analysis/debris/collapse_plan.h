#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "core/fe/mesh.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

using Vec2 = Eigen::Vector2d;

/// The part of the structure that collapsed as seen from above before the collapse: the convex hull of the corners at rest of all
/// elements that became fragments. What never fails (a mesh of the ground, say) is no part of it. Where the hull encloses open
/// space (a curved or L-shaped plan, a courtyard) that space counts as within.
class CollapsePlan {
public:
    /// @param points  m, in any order; those that are not numbers are left out
    explicit CollapsePlan(std::vector<Vec2> points);
    CollapsePlan(const FragmentSet& fragments, const Mesh& mesh);

    /// Horizontal distance from the nearest point of the hull, m: 0 within it and on its edge. NaN if there is no hull.
    double distance(const Vec2& place) const;
    /// Corners counter-clockwise; one point or two if the hull has no area.
    const std::vector<Vec2>& outline() const { return m_outline; }

private:
    std::vector<Vec2> m_outline;
};

}  // namespace rubble
