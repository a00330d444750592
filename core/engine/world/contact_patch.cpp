#include "core/engine/world/contact_patch.h"

#include <utility>

namespace rubble {

namespace {

/// m2. A candidate must score better than this to take the place of an earlier one, so that rounding decides nothing.
constexpr double clearlyBetter = 1e-12;

template <class Score>
void bringBest(std::span<PlanePoint> points, std::size_t slot, Score score) {
    std::size_t best = slot;
    double most = score(points[slot]);
    for (std::size_t i = slot + 1; i < points.size(); ++i) {
        const double s = score(points[i]);
        if (s > most + clearlyBetter) {
            most = s;
            best = i;
        }
    }
    std::swap(points[slot], points[best]);
}

}  // namespace

int reduceToFour(std::span<PlanePoint> points) {
    if (points.size() <= 4) {
        return static_cast<int>(points.size());
    }
    bringBest(points, 0, [](const PlanePoint& p) { return -p.height; });
    const PlanePoint a = points[0];
    bringBest(points, 1, [&](const PlanePoint& p) { return (p.u - a.u) * (p.u - a.u) + (p.v - a.v) * (p.v - a.v); });
    const PlanePoint b = points[1];
    const auto side = [&](const PlanePoint& p) { return (b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u); };
    bringBest(points, 2, side);
    bringBest(points, 3, [&](const PlanePoint& p) { return -side(p); });
    return 4;
}

}  // namespace rubble
