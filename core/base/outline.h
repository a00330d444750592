#pragma once

#include <utility>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// A closed line in a plane; the last corner is joined to the first.
using OutlineRing = std::vector<Eigen::Vector2d>;
/// A place within an odd number of the rings lies in the polygon.
using OutlinePolygon = std::vector<OutlineRing>;

/// What polygons cover, each for itself: where they overlap they cover no less.
struct Outline {
    std::vector<OutlinePolygon> polygons;  ///< m, in the local frame

    bool empty() const { return polygons.empty(); }
    /// Least and greatest corner; inverted and infinite without any.
    std::pair<Eigen::Vector2d, Eigen::Vector2d> bounds() const;
    friend bool operator==(const Outline&, const Outline&) = default;
};

}  // namespace rubble
