#pragma once

#include <span>

#include "core/scenario/case.h"
#include "widgets/render/basics/view.h"

namespace rubble::figures {

/// A key that keeps a camera at an instant [s], and the camera of a key.
CameraKey keyOf(const render::Camera& camera, double time);
render::Camera cameraOf(const CameraKey& key);

/// The camera at an instant between keys. Centre, distance, direction and lens go smoothly through every key and rest at the first
/// and the last one, as they do before and after them. Turns take the shorter way, and the horizon stays level on the way.
/// @param keys  at least one, in the order of their times [s]
render::Camera cameraAlong(std::span<const CameraKey> keys, double time);

/// Gives all panes of a view but the plan the camera of an instant; without keys it stays as it is.
void lookAlong(render::View& view, std::span<const CameraKey> keys, double time);

}  // namespace rubble::figures
