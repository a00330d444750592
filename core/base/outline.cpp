#include "core/base/outline.h"

#include <limits>

namespace rubble {

std::pair<Eigen::Vector2d, Eigen::Vector2d> Outline::bounds() const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Eigen::Vector2d low(infinite, infinite);
    Eigen::Vector2d high(-infinite, -infinite);
    for (const OutlinePolygon& polygon : polygons) {
        for (const OutlineRing& ring : polygon) {
            for (const Eigen::Vector2d& corner : ring) {
                low = low.cwiseMin(corner);
                high = high.cwiseMax(corner);
            }
        }
    }
    return {low, high};
}

}  // namespace rubble
