#include "core/base/outline_cover.h"

#include <algorithm>

namespace rubble {

bool covers(const Outline& outline, const Eigen::Vector2d& place) {
    const auto within = [&](const OutlinePolygon& polygon) {
        bool odd = false;
        for (const OutlineRing& ring : polygon) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const Eigen::Vector2d& a = ring[k];
                const Eigen::Vector2d& b = ring[(k + 1) % ring.size()];
                const bool crosses = (a.y() > place.y()) != (b.y() > place.y());
                odd = odd != (crosses && place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
        }
        return odd;
    };
    return std::any_of(outline.polygons.begin(), outline.polygons.end(), within);
}

}  // namespace rubble
