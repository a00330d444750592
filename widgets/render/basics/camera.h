#pragma once

#include <optional>
#include <span>

#include "core/base/geometry.h"
#include "widgets/render/basics/view.h"

namespace rubble::render {

/// Standard directions of view: from the side along +y and slightly from above; straight along +y, -y, +x and -x; straight down and
/// up; from a corner above.
enum class Preset : std::uint8_t { Side, Front, Back, Left, Right, Top, Bottom, Corner };

/// A camera that shows a box whole, with a small margin.
/// @param bounds  m; an empty box gives the default camera
/// @param aspect  width over height of the pane
Camera fitCamera(const Aabb& bounds, double aspect, Preset preset = Preset::Side);
/// The same direction, moved so that the box fits.
/// @param heightShare  of the height of the view that the model may take, about its middle: captions take the rest
Camera refit(const Camera& camera, const Aabb& bounds, double aspect, double heightShare = 1.0);
/// The same of points, m: closer than their box would be. As fitCamera() of a box without any.
Camera fitCamera(std::span<const Vec3> points, double aspect, Preset preset);

/// Half-line from the eye (or the parallel picture plane) through a point of a pane.
struct Ray {
    Vec3 origin = Vec3::Zero();
    Vec3 direction = Vec3::UnitY();  ///< unit length
};
/// @param u, v  place in the pane, from its left and top edge, in [0, 1]
Ray rayThrough(const Camera& camera, double u, double v, double aspect);

/// Where a point lies in the picture of a pane.
struct Projected {
    double u = 0.0;  ///< from the left edge, 0 to 1 within the pane
    double v = 0.0;  ///< from the top edge
};
/// The inverse of rayThrough(); nothing for a point at or behind the eye.
std::optional<Projected> project(const Camera& camera, const Vec3& point, double aspect);

/// The same picture in parallel or perspective projection: what lies in the plane of the focal point keeps its size.
Camera withProjection(const Camera& camera, bool parallel);

/// Turns about the focal point: yaw about z, then pitch about the camera's right; stops short of straight up and down. Radians.
Camera orbit(const Camera& camera, double yaw, double pitch);
/// Moves with the mouse, so that what lies in the plane of the focal point stays under the cursor.
/// @param dx, dy  pixels, y downwards
Camera pan(const Camera& camera, double dx, double dy, double paneHeight);
/// Zooms by a factor (> 1 nears) keeping the point under the cursor in place. Place of the cursor as in rayThrough().
Camera zoom(const Camera& camera, double factor, double u, double v, double aspect);
/// Makes a point the new focal point, keeping direction and distance.
Camera centreOn(const Camera& camera, const Vec3& point);
/// They show the same, but for what rounding leaves: a billionth of the distance to the focal point.
bool showsAlike(const Camera& a, const Camera& b);
/// Between two cameras, for moves of the view; t in [0, 1].
Camera between(const Camera& from, const Camera& to, double t);

/// Metres that one pixel covers in the plane of the focal point.
double metresPerPixel(const Camera& camera, double paneHeight);

}  // namespace rubble::render
